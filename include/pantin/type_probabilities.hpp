// SPDX-License-Identifier: MIT
// How a character moves, as a network sees it in the picture (step 2) and as evidence for the reference (step
// 4). Own: the thesis decides by the skeleton graph alone.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace pantin {

// `other`: none of the three, such as a fish, an insect, a head alone, a thing.
inline constexpr std::array<const char*, 4> type_names = {"humanoid", "quadruped", "flying", "other"};

// Probability per type_names; they add up to 1. Nothing where no network with a type head has seen the
// picture.
using TypeProbabilities = std::optional<std::array<double, type_names.size()>>;

// Of the type with this name, one of type_names. No error. Own.
inline double probability_of(const TypeProbabilities::value_type& types, std::string_view name) {
    return types[static_cast<std::size_t>(std::find(type_names.begin(), type_names.end(), name) -
                                          type_names.begin())];
}

} // namespace pantin
