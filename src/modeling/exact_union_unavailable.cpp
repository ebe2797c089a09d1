// SPDX-License-Identifier: MIT
// Built without CGAL (`make CGAL=0`): the union on a lattice serves alone.
#include "pantin/error.hpp"
#include "pantin/model.hpp"

namespace pantin {

bool exact_union_available() { return false; }

SolidMesh unite_exactly(const std::vector<InflatedPart>&) {
    throw Error(ErrorKind::usage, "this program was built without CGAL: solids cannot be united exactly");
}

} // namespace pantin
