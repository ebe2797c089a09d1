// SPDX-License-Identifier: MIT
// How a character moves, as a network sees it in the picture (step 2) and as evidence for the reference (step
// 4). Own: the thesis decides by the skeleton graph alone.
#pragma once

#include <array>
#include <optional>

namespace pantin {

// `other`: none of the three, such as a fish, an insect, a head alone, a thing.
inline constexpr std::array<const char*, 4> type_names = {"humanoid", "quadruped", "flying", "other"};

// Probability per type_names; they add up to 1. Nothing where no network with a type head has seen the
// picture.
using TypeProbabilities = std::optional<std::array<double, type_names.size()>>;

} // namespace pantin
