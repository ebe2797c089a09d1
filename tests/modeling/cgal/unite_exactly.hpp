// SPDX-License-Identifier: MIT
// The union of solids by exact arithmetic, to compare unite() with.
#pragma once

#include <vector>

#include "pantin/model.hpp"

namespace pantin {

// Whether the tests were built with CGAL.
bool exact_union_available();

// As unite(), by CGAL's polygon mesh processing on the parts' own surfaces; coordinates are rounded at the
// end, SolidMesh::parts stays empty. Error(usage) in a build without CGAL; Error(input) when parts touch
// without overlapping, so that their union is no manifold.
SolidMesh unite_exactly(const std::vector<InflatedPart>& parts);

} // namespace pantin
