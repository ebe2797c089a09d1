// SPDX-License-Identifier: MIT
// Boxes and digits drawn on the reduced page.
#include "pipeline/overview.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "pantin/image.hpp"

namespace pantin {

namespace {

constexpr int longest = 1024;
constexpr Rgb8 frame{20, 90, 200}, figure{255, 255, 255};

// 3×5 pixels, a row in three bits.
constexpr std::array<std::array<int, 5>, 10> digits{{{7, 5, 5, 5, 7},
                                                     {2, 6, 2, 2, 7},
                                                     {7, 1, 7, 4, 7},
                                                     {7, 1, 7, 1, 7},
                                                     {5, 5, 7, 1, 1},
                                                     {7, 4, 7, 1, 7},
                                                     {7, 4, 7, 5, 7},
                                                     {7, 1, 2, 2, 2},
                                                     {7, 5, 7, 5, 7},
                                                     {7, 5, 7, 1, 7}}};

void fill(RgbImage& image, int left, int top, int width, int height, Rgb8 colour) {
    for (int y = std::max(0, top); y < std::min(image.height(), top + height); ++y)
        for (int x = std::max(0, left); x < std::min(image.width(), left + width); ++x) image(x, y) = colour;
}

// White on a plate of the frame's colour, `dot` pixels a pixel of the digits.
void draw_number(RgbImage& image, int left, int top, int number, int dot) {
    const std::string text = std::to_string(number);
    fill(image, left, top, dot * (4 * static_cast<int>(text.size()) + 1), 7 * dot, frame);
    for (std::size_t i = 0; i < text.size(); ++i)
        for (int row = 0; row < 5; ++row)
            for (int column = 0; column < 3; ++column)
                if (digits[static_cast<std::size_t>(text[i] - '0')][static_cast<std::size_t>(row)] >>
                        (2 - column) &
                    1)
                    fill(image, left + dot * (1 + 4 * static_cast<int>(i) + column), top + dot * (1 + row),
                         dot, dot, figure);
}

} // namespace

RgbImage draw_overview(const RgbImage& picture, const Page& page) {
    const double scale =
        std::min(1.0, static_cast<double>(longest) / std::max(picture.width(), picture.height()));
    const auto scaled = [&](int pixels) { return static_cast<int>(pixels * scale + 0.5); };
    RgbImage image = scale == 1 ? picture
                                : resize(picture, std::max(1, scaled(picture.width())),
                                         std::max(1, scaled(picture.height())));
    const int line = std::max(1, std::max(image.width(), image.height()) / 400);
    const int dot = std::max(2, std::max(image.width(), image.height()) / 250);
    for (std::size_t i = 0; i < page.characters.size(); ++i) {
        const Box& box = page.characters[i].box;
        const int left = scaled(box.x), top = scaled(box.y), width = scaled(box.width),
                  height = scaled(box.height);
        fill(image, left, top, width, line, frame);
        fill(image, left, top + height - line, width, line, frame);
        fill(image, left, top, line, height, frame);
        fill(image, left + width - line, top, line, height, frame);
        draw_number(image, left, top, static_cast<int>(i) + 1, dot);
    }
    return image;
}

} // namespace pantin
