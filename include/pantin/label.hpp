// SPDX-License-Identifier: MIT
// The parts of a character (thesis 4.3), with the values that they have in `labels.png`.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace pantin {

enum class Label : std::uint8_t { background = 0, head = 1, body = 2, limb = 3, tail = 4, wing = 5 };

inline constexpr int label_count = 6; // background included
inline constexpr std::array<std::string_view, label_count> label_names = {"background", "head", "body",
                                                                          "limb",       "tail", "wing"};

inline constexpr std::string_view name_of(Label label) { return label_names[static_cast<int>(label)]; }

// The label of that name; `background` when there is none.
inline constexpr Label label_from_name(std::string_view name) {
    for (int i = 0; i < label_count; ++i)
        if (label_names[i] == name) return static_cast<Label>(i);
    return Label::background;
}

} // namespace pantin
