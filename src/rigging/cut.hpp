// SPDX-License-Identifier: MIT
// Limbs that touch: the mesh is cut between parts that are far apart along the skeleton (thesis 6.3,
// Fig. 6.9; ERRATA 22).
#pragma once

#include <vector>

#include "pantin/rigging.hpp"
#include "rigging/limbs.hpp"
#include "rigging/ownership.hpp"

namespace pantin {

// Owner of every mesh vertex: that of the pixel below it.
std::vector<Owner> vertex_owners(const Mesh& mesh, const Grid<Owner>& pixels);

// Whether two places that are neighbours on the mesh are far apart along the skeleton.
bool far_apart(const Owner& a, const Owner& b, const Limbs& limbs, double cell);

// A face whose corners are far apart goes to the side on which its middle lies; corners of the other side are
// doubled at the same place, so the picture at rest has no gap. `owners` is extended and reordered along with
// the vertices. Vertices that no face uses any more are removed. Returns the number of faces that changed.
int cut_touching_parts(Mesh& mesh, std::vector<Owner>& owners, const Grid<Owner>& pixels, const Limbs& limbs,
                       double cell);

} // namespace pantin
