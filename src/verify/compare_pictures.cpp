// SPDX-License-Identifier: MIT
// Pixels side by side, and a picture of where they differ.
#include <algorithm>
#include <cmath>

#include "core/plural.hpp"
#include "export/decode_film.hpp"
#include "pantin/export.hpp"
#include "verify/bytes.hpp"
#include "verify/values.hpp"

namespace pantin {

namespace {

constexpr int lightest = 255, darkest = 150; // greys of the picture below the differences
constexpr int least_red = 150;               // how strongly the smallest difference shows, 0 to 255

std::string size_text(const RgbaImage& image) {
    return std::to_string(image.width()) + "x" + std::to_string(image.height());
}

int luma_on_white(Rgba8 p) {
    const int luma = (299 * p.r + 587 * p.g + 114 * p.b + 500) / 1000;
    return (luma * p.a + 255 * (255 - p.a)) / 255;
}

int largest_difference(Rgba8 a, Rgba8 b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b), std::abs(a.a - b.a)});
}

RgbImage picture_of_differences(const RgbaImage& first, const RgbaImage& second) {
    RgbImage image(first.width(), first.height());
    Grid<int> luma(first.width(), first.height());
    std::transform(first.begin(), first.end(), luma.begin(), luma_on_white);
    const auto [low, high] =
        std::minmax_element(luma.begin(), luma.end()); // label maps have values up to 5 only
    const int range = std::max(1, *high - *low);
    for (std::size_t i = 0; i < image.size(); ++i) {
        const int grey = darkest + (luma.data()[i] - *low) * (lightest - darkest) / range,
                  difference = largest_difference(first.data()[i], second.data()[i]);
        const int red = difference == 0 ? 0 : least_red + difference * (255 - least_red) / 255;
        const auto faded = static_cast<std::uint8_t>(grey * (255 - red) / 255);
        image.data()[i] = {static_cast<std::uint8_t>(std::max<int>(faded, red == 0 ? grey : 225)), faded,
                           faded};
    }
    return image;
}

} // namespace

void compare_pictures(Differences& differences, const std::string& place, const RgbaImage& first,
                      const RgbaImage& second) {
    if (first.width() != second.width() || first.height() != second.height())
        return differences.text(place + "size", size_text(first), size_text(second));
    const std::size_t before = differences.count();
    for (int y = 0; y < first.height(); ++y)
        for (int x = 0; x < first.width(); ++x) {
            const Rgba8 a = first(x, y), b = second(x, y);
            if (a == b) continue;
            const std::string pixel =
                place + "pixel (" + std::to_string(x) + ", " + std::to_string(y) + "), ";
            differences.number(pixel + "red", a.r, b.r);
            differences.number(pixel + "green", a.g, b.g);
            differences.number(pixel + "blue", a.b, b.b);
            differences.number(pixel + "alpha", a.a, b.a);
        }
    if (differences.count() > before) differences.picture(picture_of_differences(first, second));
}

namespace {

void compare_frames(Differences& differences, const DecodedFilm& first, const DecodedFilm& second) {
    const std::size_t frames = std::min(first.frames.size(), second.frames.size());
    if (first.frames.size() != second.frames.size())
        differences.text("", count_of(static_cast<long>(first.frames.size()), "frame"),
                         count_of(static_cast<long>(second.frames.size()), "frame"));
    for (std::size_t i = 0; i < frames; ++i) {
        const std::string place = "frame " + std::to_string(i + 1) + ", ";
        differences.number(place + "delay", first.delays[i], second.delays[i]);
        compare_pictures(differences, place, first.frames[i], second.frames[i]);
    }
}

} // namespace

void compare_films(Differences& differences, const std::string& name, const std::string& first,
                   const std::string& second) {
    if (name.ends_with(".webp") && webp_available())
        return compare_frames(differences, decode_webp(as_bytes(first), name),
                              decode_webp(as_bytes(second), name));
    if (name.ends_with(".gif") && gif_available())
        return compare_frames(differences, decode_gif(as_bytes(first), name),
                              decode_gif(as_bytes(second), name));
    compare_bytes(differences, first, second); // no decoder in this build
}

} // namespace pantin
