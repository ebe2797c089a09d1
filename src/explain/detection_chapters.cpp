// SPDX-License-Identifier: MIT
// Step 1: the page with its characters; the silhouette of one of them.
#include <algorithm>
#include <cmath>

#include "core/plural.hpp"
#include "explain/chapters.hpp"
#include "explain/palette.hpp"
#include "explain/svg.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace {

constexpr int page_side = 900; // of the page's picture, at most

// Ink in black, half transparent where only a share of a smaller pixel is ink.
GreyImage ink_picture(const Mask& ink, int width, int height) {
    Grid<float> share(ink.width(), ink.height());
    std::transform(ink.begin(), ink.end(), share.begin(),
                   [](std::uint8_t v) { return v != 0 ? 1.0f : 0.0f; });
    const Grid<float> small = resize(share, width, height);
    GreyImage grey(width, height);
    std::transform(small.begin(), small.end(), grey.begin(),
                   [](float v) { return static_cast<std::uint8_t>(std::lrint(255 * (1 - v))); });
    return grey;
}

std::string row_of(const PageCharacter& c) {
    const Box b = c.box;
    return "<tr><td><a href=\"#" + c.folder + "\">" + c.folder + "</a></td><td>" + std::to_string(b.x) +
           ", " + std::to_string(b.y) + ", " + std::to_string(b.width) + ", " + std::to_string(b.height) +
           "</td><td>" + decimal(c.score, 3) + "</td><td>" + decimal(c.scale, 3) + "</td><td>" +
           escaped(c.status) + "</td></tr>";
}

} // namespace

Values page_chapter(const AnimatedPage& animated) {
    const Page& page = animated.page;
    const double factor = std::min(1.0, page_side / static_cast<double>(std::max(page.width, page.height)));
    const int width = std::max(1, static_cast<int>(std::lrint(page.width * factor))),
              height = std::max(1, static_cast<int>(std::lrint(page.height * factor)));
    Svg boxes(width, height, "The page with a box around each character that was found");
    boxes.image(picture_uri(resize(animated.picture, width, height)), width, height);
    const double size = std::max(width, height) / 40.0;
    std::string rows;
    for (std::size_t i = 0; i < page.characters.size(); ++i) {
        const PageCharacter& c = page.characters[i];
        const std::string colour = css(category(i));
        const Point2d low = {c.box.x * factor, c.box.y * factor},
                      high = {(c.box.x + c.box.width) * factor, (c.box.y + c.box.height) * factor};
        boxes.polyline({low, {high.x, low.y}, high, {low.x, high.y}}, colour, size / 7, true);
        boxes.text({low.x + size / 3, low.y + size}, std::to_string(i + 1) + ": " + decimal(c.score, 2), size,
                   colour);
        rows += row_of(c);
    }
    Values values = {{"boxes", boxes.str()},
                     {"rows", rows},
                     {"source", escaped(page.source)},
                     {"width", std::to_string(page.width)},
                     {"height", std::to_string(page.height)},
                     {"count", count_of(static_cast<long>(page.characters.size()), "character")},
                     {"detector", page.detector}};
    values["ink"] = "";
    if (!animated.ink.empty()) {
        Svg ink(width, height, "The pixels that count as ink");
        ink.image(picture_uri(ink_picture(animated.ink, width, height)), width, height);
        values["ink"] =
            "<figure>" + ink.str() + "<figcaption>Ink: darker than its surroundings.</figcaption></figure>";
    }
    return values;
}

Values silhouette_chapter(const ChapterInput& input) {
    const Mask& mask = input.character.mask;
    RgbaImage tint(mask.width(), mask.height());
    long area = 0;
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (mask.data()[i]) tint.data()[i] = {38, 98, 214, 110}, ++area;
    Svg picture(mask.width(), mask.height(), "The silhouette, tinted, on the drawing");
    picture.underlay(input.drawing()).image(picture_uri(tint), mask.width(), mask.height());
    const Box box = input.entry.box;
    return {{"picture", picture.str()},
            {"box", std::to_string(box.width) + " × " + std::to_string(box.height)},
            {"size", std::to_string(mask.width()) + " × " + std::to_string(mask.height())},
            {"scale", decimal(input.entry.scale, 3)},
            {"score", decimal(input.entry.score, 3)},
            {"area", std::to_string(area)},
            {"share", percent(static_cast<double>(area) / static_cast<double>(mask.size()))}};
}

} // namespace pantin
