// SPDX-License-Identifier: MIT
// The first half of rigging: optimal subsequence bijection and end-effector mapping.
#pragma once

#include "compare.hpp"

namespace pantin::compare {

// osb_random.json in both forms; the figures' end-effectors: order, costs, pairs.
void mapping_stages(const std::filesystem::path& reference, const std::vector<Figure>& figures,
                    Report& report);

} // namespace pantin::compare
