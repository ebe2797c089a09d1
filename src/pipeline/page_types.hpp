// SPDX-License-Identifier: MIT
// What page.json says of a character's identification.
#pragma once

#include <filesystem>
#include <vector>

#include "pantin/identification.hpp"
#include "pantin/page.hpp"

namespace pantin {

// Type, confidence and second choice of the character, from its identification.
void set_type(PageCharacter& entry, const Identification& identification,
              const std::vector<ReferenceSkeleton>& references);

// The same in the page.json beside the character's folder, if there is one. Error(input), Error(output).
void update_type(const std::filesystem::path& folder, const Identification& identification,
                 const std::vector<ReferenceSkeleton>& references);

} // namespace pantin
