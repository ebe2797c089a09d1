// SPDX-License-Identifier: MIT
// A picture of a mask to the mask, however it says what the figure is.
#include "pipeline/given_mask.hpp"

#include <algorithm>
#include <vector>

#include "core/file.hpp"

namespace pantin {

namespace {

constexpr int inside = 128;           // least value of the figure
constexpr double white_border = 0.98; // of the border of an inverted mask, …
constexpr double least_figure = 0.01; // … in which so much of the picture is black

// Of a picture whose colours are all one: what is opaque, when something else is not.
Mask opaque_part(const RgbaImage& picture) {
    Mask mask = opaque_pixels(picture);
    if (std::count(mask.begin(), mask.end(), 1) == std::ssize(mask)) std::fill(mask.begin(), mask.end(), 0);
    return mask;
}

bool is_empty(const Mask& mask) { return std::count(mask.begin(), mask.end(), 1) == 0; }

// Of a mask that was written as 0 and 1: the ones; none when a value is larger.
Mask ones_of(const GreyImage& grey, const RgbaImage& picture) {
    Mask mask(grey.width(), grey.height());
    if (*std::max_element(grey.begin(), grey.end()) > 1) return mask;
    std::transform(grey.begin(), grey.end(), picture.begin(), mask.begin(),
                   [](std::uint8_t value, Rgba8 p) -> std::uint8_t { return value == 1 && is_opaque(p); });
    return mask;
}

bool is_inverted(const Mask& mask) {
    const auto black = std::count(mask.begin(), mask.end(), 0);
    return share_of_frame(mask) >= white_border &&
           static_cast<double>(black) >= least_figure * static_cast<double>(mask.size());
}

} // namespace

GivenMask load_given_mask(const std::filesystem::path& file, int rotate) {
    const std::vector<unsigned char> bytes = read_file(file);
    const GreyImage grey = turned(decode_grey(bytes, file.string()), rotate);
    const RgbaImage picture = turned(decode_rgba(bytes, file.string()), rotate);
    GivenMask given{Mask(grey.width(), grey.height()), ""};
    std::transform(grey.begin(), grey.end(), picture.begin(), given.mask.begin(),
                   [](std::uint8_t value, Rgba8 p) -> std::uint8_t { return value * p.a >= inside * 255; });
    if (is_empty(given.mask)) given.mask = opaque_part(picture);
    std::vector<std::string> facts;
    if (is_empty(given.mask)) {
        given.mask = ones_of(grey, picture);
        if (!is_empty(given.mask)) facts.push_back("has no value above 1; 1 is taken for white");
    }
    if (is_inverted(given.mask)) {
        for (std::uint8_t& pixel : given.mask) pixel = !pixel;
        facts.push_back("is white around a black figure; the black is taken for the figure");
    }
    for (const std::string& fact : facts)
        given.remark += given.remark.empty() ? file.string() + ": " + fact : "; it " + fact;
    return given;
}

} // namespace pantin
