// SPDX-License-Identifier: MIT
// The text of a colour in, its bytes and alpha out (CSS Color Module Level 4, W3C 2022).
#include "modeling/svg_colour.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "modeling/svg_path.hpp"
#include "pantin/error.hpp"

namespace pantin {
namespace {

struct NamedColour {
    std::string_view name;
    int value; // 0xrrggbb
};
// CSS Color 4, 6.1; sorted.
constexpr auto named_colours = std::to_array<NamedColour>({
    {"aliceblue", 0xf0f8ff},
    {"antiquewhite", 0xfaebd7},
    {"aqua", 0x00ffff},
    {"aquamarine", 0x7fffd4},
    {"azure", 0xf0ffff},
    {"beige", 0xf5f5dc},
    {"bisque", 0xffe4c4},
    {"black", 0x000000},
    {"blanchedalmond", 0xffebcd},
    {"blue", 0x0000ff},
    {"blueviolet", 0x8a2be2},
    {"brown", 0xa52a2a},
    {"burlywood", 0xdeb887},
    {"cadetblue", 0x5f9ea0},
    {"chartreuse", 0x7fff00},
    {"chocolate", 0xd2691e},
    {"coral", 0xff7f50},
    {"cornflowerblue", 0x6495ed},
    {"cornsilk", 0xfff8dc},
    {"crimson", 0xdc143c},
    {"cyan", 0x00ffff},
    {"darkblue", 0x00008b},
    {"darkcyan", 0x008b8b},
    {"darkgoldenrod", 0xb8860b},
    {"darkgray", 0xa9a9a9},
    {"darkgreen", 0x006400},
    {"darkgrey", 0xa9a9a9},
    {"darkkhaki", 0xbdb76b},
    {"darkmagenta", 0x8b008b},
    {"darkolivegreen", 0x556b2f},
    {"darkorange", 0xff8c00},
    {"darkorchid", 0x9932cc},
    {"darkred", 0x8b0000},
    {"darksalmon", 0xe9967a},
    {"darkseagreen", 0x8fbc8f},
    {"darkslateblue", 0x483d8b},
    {"darkslategray", 0x2f4f4f},
    {"darkslategrey", 0x2f4f4f},
    {"darkturquoise", 0x00ced1},
    {"darkviolet", 0x9400d3},
    {"deeppink", 0xff1493},
    {"deepskyblue", 0x00bfff},
    {"dimgray", 0x696969},
    {"dimgrey", 0x696969},
    {"dodgerblue", 0x1e90ff},
    {"firebrick", 0xb22222},
    {"floralwhite", 0xfffaf0},
    {"forestgreen", 0x228b22},
    {"fuchsia", 0xff00ff},
    {"gainsboro", 0xdcdcdc},
    {"ghostwhite", 0xf8f8ff},
    {"gold", 0xffd700},
    {"goldenrod", 0xdaa520},
    {"gray", 0x808080},
    {"green", 0x008000},
    {"greenyellow", 0xadff2f},
    {"grey", 0x808080},
    {"honeydew", 0xf0fff0},
    {"hotpink", 0xff69b4},
    {"indianred", 0xcd5c5c},
    {"indigo", 0x4b0082},
    {"ivory", 0xfffff0},
    {"khaki", 0xf0e68c},
    {"lavender", 0xe6e6fa},
    {"lavenderblush", 0xfff0f5},
    {"lawngreen", 0x7cfc00},
    {"lemonchiffon", 0xfffacd},
    {"lightblue", 0xadd8e6},
    {"lightcoral", 0xf08080},
    {"lightcyan", 0xe0ffff},
    {"lightgoldenrodyellow", 0xfafad2},
    {"lightgray", 0xd3d3d3},
    {"lightgreen", 0x90ee90},
    {"lightgrey", 0xd3d3d3},
    {"lightpink", 0xffb6c1},
    {"lightsalmon", 0xffa07a},
    {"lightseagreen", 0x20b2aa},
    {"lightskyblue", 0x87cefa},
    {"lightslategray", 0x778899},
    {"lightslategrey", 0x778899},
    {"lightsteelblue", 0xb0c4de},
    {"lightyellow", 0xffffe0},
    {"lime", 0x00ff00},
    {"limegreen", 0x32cd32},
    {"linen", 0xfaf0e6},
    {"magenta", 0xff00ff},
    {"maroon", 0x800000},
    {"mediumaquamarine", 0x66cdaa},
    {"mediumblue", 0x0000cd},
    {"mediumorchid", 0xba55d3},
    {"mediumpurple", 0x9370db},
    {"mediumseagreen", 0x3cb371},
    {"mediumslateblue", 0x7b68ee},
    {"mediumspringgreen", 0x00fa9a},
    {"mediumturquoise", 0x48d1cc},
    {"mediumvioletred", 0xc71585},
    {"midnightblue", 0x191970},
    {"mintcream", 0xf5fffa},
    {"mistyrose", 0xffe4e1},
    {"moccasin", 0xffe4b5},
    {"navajowhite", 0xffdead},
    {"navy", 0x000080},
    {"oldlace", 0xfdf5e6},
    {"olive", 0x808000},
    {"olivedrab", 0x6b8e23},
    {"orange", 0xffa500},
    {"orangered", 0xff4500},
    {"orchid", 0xda70d6},
    {"palegoldenrod", 0xeee8aa},
    {"palegreen", 0x98fb98},
    {"paleturquoise", 0xafeeee},
    {"palevioletred", 0xdb7093},
    {"papayawhip", 0xffefd5},
    {"peachpuff", 0xffdab9},
    {"peru", 0xcd853f},
    {"pink", 0xffc0cb},
    {"plum", 0xdda0dd},
    {"powderblue", 0xb0e0e6},
    {"purple", 0x800080},
    {"rebeccapurple", 0x663399},
    {"red", 0xff0000},
    {"rosybrown", 0xbc8f8f},
    {"royalblue", 0x4169e1},
    {"saddlebrown", 0x8b4513},
    {"salmon", 0xfa8072},
    {"sandybrown", 0xf4a460},
    {"seagreen", 0x2e8b57},
    {"seashell", 0xfff5ee},
    {"sienna", 0xa0522d},
    {"silver", 0xc0c0c0},
    {"skyblue", 0x87ceeb},
    {"slateblue", 0x6a5acd},
    {"slategray", 0x708090},
    {"slategrey", 0x708090},
    {"snow", 0xfffafa},
    {"springgreen", 0x00ff7f},
    {"steelblue", 0x4682b4},
    {"tan", 0xd2b48c},
    {"teal", 0x008080},
    {"thistle", 0xd8bfd8},
    {"tomato", 0xff6347},
    {"turquoise", 0x40e0d0},
    {"violet", 0xee82ee},
    {"wheat", 0xf5deb3},
    {"white", 0xffffff},
    {"whitesmoke", 0xf5f5f5},
    {"yellow", 0xffff00},
    {"yellowgreen", 0x9acd32},
});

std::uint8_t byte_of(double value) {
    return static_cast<std::uint8_t>(std::floor(std::clamp(value, 0.0, 255.0) + 0.5));
}

std::optional<SvgColour> of_hex(const std::string& text) {
    if (text.find_first_not_of("0123456789abcdef", 1) != std::string::npos) return {};
    const std::size_t digits = text.size() - 1;
    if (digits != 3 && digits != 4 && digits != 6 && digits != 8) return {};
    const bool brief = digits < 6;
    const auto digit = [&](std::size_t i) {
        const char c = text[1 + i];
        return c <= '9' ? c - '0' : c - 'a' + 10;
    };
    const auto channel = [&](std::size_t i) {
        return static_cast<std::uint8_t>(brief ? 17 * digit(i) : 16 * digit(2 * i) + digit(2 * i + 1));
    };
    SvgColour result{{channel(0), channel(1), channel(2)}, 1};
    if (digits == 4 || digits == 8) result.alpha = channel(3) / 255.0;
    return result;
}

// CSS Color 4, 7.1; hue in degrees, the others in percent.
Rgb8 of_hsl(double hue, double saturation, double lightness) {
    const double h = hue - 360 * std::floor(hue / 360);
    const double s = std::clamp(saturation / 100, 0.0, 1.0), l = std::clamp(lightness / 100, 0.0, 1.0);
    const auto channel = [&](int n) {
        const double k = std::fmod(n + h / 30, 12);
        return byte_of(255 * (l - s * std::min(l, 1 - l) * std::max(-1.0, std::min({k - 3, 9 - k, 1.0}))));
    };
    return {channel(0), channel(8), channel(4)};
}

// "rgb(1, 2, 3)", "rgb(10% 20% 30% / 0.5)", "hsla(120, 50%, 50%, 50%)".
std::optional<SvgColour> of_function(const std::string& text) {
    const std::size_t open = text.find('('), close = text.find(')');
    if (open == std::string::npos || close != text.size() - 1) return {};
    const bool hsl = text.starts_with("hsl");
    std::string inside = text.substr(open + 1, close - open - 1);
    while (inside.ends_with(' ')) inside.pop_back();
    const std::size_t last = inside.find_last_of(",/ ");
    const std::string final_part = last == std::string::npos ? "" : inside.substr(last + 1);
    const double most = inside.substr(0, last).find('%') == std::string::npos ? 255 : 100;
    if (const std::size_t unit = inside.find("deg"); unit != std::string::npos) inside.erase(unit, 3);
    for (char& c : inside)
        if (c == '%' || c == '/') c = ' ';
    std::vector<double> v;
    try {
        v = svg_numbers(inside, "");
    } catch (const Error&) { // a colour is no reason to give up on a drawing
        return {};
    }
    if (v.size() != 3 && v.size() != 4) return {};
    SvgColour result;
    result.colour =
        hsl ? of_hsl(v[0], v[1], v[2])
            : Rgb8{byte_of(v[0] * 255 / most), byte_of(v[1] * 255 / most), byte_of(v[2] * 255 / most)};
    if (v.size() == 4) result.alpha = svg_opacity(final_part);
    return result;
}

} // namespace

std::optional<SvgColour> svg_colour(const std::string& text) {
    if (text.starts_with('#')) return of_hex(text);
    if (text.starts_with("rgb") || text.starts_with("hsl")) return of_function(text);
    if (text == "transparent") return SvgColour{{0, 0, 0}, 0};
    const auto found =
        std::lower_bound(named_colours.begin(), named_colours.end(), text,
                         [](const NamedColour& c, const std::string& t) { return c.name < t; });
    if (found == named_colours.end() || found->name != text) return {};
    const auto byte = [&](int shift) { return static_cast<std::uint8_t>(found->value >> shift & 255); };
    return SvgColour{{byte(16), byte(8), byte(0)}, 1};
}

double svg_opacity(const std::string& text, double missing) {
    std::string number = text;
    const bool percent = number.ends_with('%');
    if (percent) number.pop_back();
    try {
        const std::vector<double> v = svg_numbers(number, "");
        if (v.size() == 1) return std::clamp(percent ? v[0] / 100 : v[0], 0.0, 1.0);
    } catch (const Error&) { // as good as not given
    }
    return missing;
}

} // namespace pantin
