// SPDX-License-Identifier: MIT
// Labels, numbers and shares in, colours out; heat() after matplotlib's viridis.
#include "explain/palette.hpp"

#include <algorithm>
#include <cmath>

namespace pantin {

std::string css(Rgb8 colour) {
    constexpr char digits[] = "0123456789abcdef";
    std::string text = "#";
    for (const int v : {int(colour.r), int(colour.g), int(colour.b)}) {
        text += digits[v / 16];
        text += digits[v % 16];
    }
    return text;
}

Rgb8 heat(double share) {
    // Five of its colours; linear in between.
    constexpr std::array<Rgb8, 5> stops = {
        {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};
    const double at = 4 * std::clamp(share, 0.0, 1.0);
    const int i = std::min(3, static_cast<int>(at));
    const auto mix = [&](int a, int b) {
        return static_cast<std::uint8_t>(std::rint(a + (at - i) * (b - a)));
    };
    return {mix(stops[i].r, stops[i + 1].r), mix(stops[i].g, stops[i + 1].g),
            mix(stops[i].b, stops[i + 1].b)};
}

std::string label_styles() {
    std::string variables, classes;
    for (const LabelRow& row : label_table) {
        const std::string name(row.name);
        variables += " --" + name + ": " + css(row.colour) + ";";
        classes += ".part-" + name + " { background: var(--" + name + "); }\n";
    }
    return ":root {" + variables + " }\n" + classes;
}

} // namespace pantin
