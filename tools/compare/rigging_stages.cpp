// SPDX-License-Identifier: MIT
#include "compare.hpp"

namespace pantin::compare {

void rigging_stages(const std::filesystem::path&, const std::vector<Figure>&, Report&) {}

} // namespace pantin::compare
