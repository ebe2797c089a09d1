// SPDX-License-Identifier: MIT
// The optional libraries, by the names that tags [needs-...] have.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace pantin::test {

// Name, and whether this build has it.
std::vector<std::pair<std::string, bool>> optional_libraries();

} // namespace pantin::test
