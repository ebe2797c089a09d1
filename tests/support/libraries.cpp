// SPDX-License-Identifier: MIT
#include "support/libraries.hpp"

#include "core/yaml.hpp"
#include "modeling/cgal/unite_exactly.hpp"
#include "pantin/export.hpp"
#include "pantin/identification.hpp"
#include "pantin/strokes.hpp"

namespace pantin::test {

std::vector<std::pair<std::string, bool>> optional_libraries() {
    return {{"glpk", ilp_available()},  {"webp", webp_available()},   {"gif", gif_available()},
            {"yaml", yaml_available()}, {"pugixml", svg_available()}, {"cgal", exact_union_available()}};
}

} // namespace pantin::test
