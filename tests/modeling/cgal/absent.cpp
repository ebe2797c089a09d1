// SPDX-License-Identifier: MIT
// Built without CGAL (`make CGAL=0`): our own union serves alone.
#include "modeling/cgal/unite_exactly.hpp"
#include "pantin/error.hpp"

namespace pantin {

bool exact_union_available() { return false; }

SolidMesh unite_exactly(const std::vector<InflatedPart>&) {
    throw Error(ErrorKind::usage, "these tests were built without CGAL: solids cannot be united exactly");
}

} // namespace pantin
