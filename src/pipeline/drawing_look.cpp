// SPDX-License-Identifier: MIT
// Areas in, the network's labels of their picture out (docs/modeling.md, "Drawings without names").
#include "pipeline/drawing_look.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pantin/detection.hpp"
#include "pantin/error.hpp"
#include "pipeline/page_picture.hpp"

namespace pantin {
namespace {

constexpr int picture_side = 1000;  // pixels of the drawing that the network sees
constexpr double margin = 0.06;     // of its longer side, on each side
constexpr double found_share = 0.7; // of what is drawn, that a detected character has at least
constexpr double line_share = 0.5;  // of a hole's border is lines when the hole is the inside of an outline

struct PictureFrame {
    CanvasView view;
    int width = 0, height = 0;
};
PictureFrame frame_for(const Painting& painting, const std::string& name) {
    Point2d low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
    for (const PaintedShape& shape : painting)
        for (const std::vector<Point2d>& outline : shape.outlines)
            for (const Point2d p : outline) {
                low = {std::min(low.x, p.x), std::min(low.y, p.y)};
                high = {std::max(high.x, p.x), std::max(high.y, p.y)};
            }
    const double longer = std::max(high.x - low.x, high.y - low.y);
    if (!(longer > 0) || !std::isfinite(longer))
        throw Error(ErrorKind::input, name + ": there is nothing to be seen");
    PictureFrame frame;
    frame.view.scale = picture_side * (1 - 2 * margin) / longer;
    const double pad = picture_side * margin;
    frame.view.offset = Point2d{pad, pad} - frame.view.scale * low;
    frame.width = static_cast<int>(std::ceil((high.x - low.x) * frame.view.scale + 2 * pad));
    frame.height = static_cast<int>(std::ceil((high.y - low.y) * frame.view.scale + 2 * pad));
    return frame;
}

// The character of the picture: as detection finds it in a picture that was cut out, or else all that is
// drawn.
DetectedCharacter character_in(const PagePicture& page, const Mask& opaque, Context& context) {
    const DetectionOptions& options = context.options().detection;
    const long drawn = pixel_count(opaque);
    try {
        const CharacterFinder* finder = options.detector == Detector::mask_rcnn ? &context.finder() : nullptr;
        Detection detection = detect(page.picture, page.ink, options, finder);
        DetectedCharacter* best = nullptr;
        for (DetectedCharacter& c : detection.characters)
            if (!best || static_cast<long>(c.box.width) * c.box.height >
                             static_cast<long>(best->box.width) * best->box.height)
                best = &c;
        long inside = 0;
        for (int y = 0; best && y < best->box.height; ++y)
            for (int x = 0; x < best->box.width; ++x)
                inside += opaque(best->box.x + x, best->box.y + y) &&
                          best->mask.value_or(static_cast<int>(x * best->scale),
                                              static_cast<int>(y * best->scale), 0);
        if (best && static_cast<double>(inside) >= found_share * static_cast<double>(drawn))
            return std::move(*best);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::no_character) throw;
    }
    return character_of(page.picture, page.ink, fill_holes(opaque), options);
}

// The inside of outlines that are drawn as lines alone is white, as it is on paper; a hole in an area stays
// one.
void fill_outlines(RgbaImage& figure, const Painting& painting, const CanvasView& view) {
    Painting kinds = painting;
    for (PaintedShape& shape : kinds) shape.colour = shape.line ? Rgb8{255, 255, 255} : Rgb8{0, 0, 0};
    const RgbaImage lines = paint(kinds, view, figure.width(), figure.height());
    const Components regions = background_components(opaque_pixels(figure));
    std::vector<long> border(regions.list.size() + 1, 0), lined = border;
    constexpr int dx[] = {1, 0, -1, 0}, dy[] = {0, 1, 0, -1};
    for (int y = 0; y < figure.height(); ++y)
        for (int x = 0; x < figure.width(); ++x)
            for (int k = 0; k < 4; ++k) {
                const int id = regions.ids(x, y), u = x + dx[k], v = y + dy[k];
                if (id == 0 || !figure.contains(u, v) || regions.ids(u, v) == id) continue;
                ++border[static_cast<std::size_t>(id)];
                lined[static_cast<std::size_t>(id)] += lines(u, v).r >= 128;
            }
    for (int y = 0; y < figure.height(); ++y)
        for (int x = 0; x < figure.width(); ++x) {
            const int id = regions.ids(x, y);
            if (id == 0 || touches_border(regions.list[static_cast<std::size_t>(id) - 1], figure.width(),
                                          figure.height()))
                continue;
            const auto at = static_cast<std::size_t>(id);
            if (static_cast<double>(lined[at]) >= line_share * static_cast<double>(border[at]))
                figure(x, y) = {255, 255, 255, 255};
        }
}

} // namespace

long pixel_count(const Mask& mask) { return std::count(mask.begin(), mask.end(), 1); }

Mask opaque_pixels(const RgbaImage& image) {
    Mask mask(image.width(), image.height());
    std::transform(image.begin(), image.end(), mask.begin(),
                   [](Rgba8 p) -> std::uint8_t { return is_opaque(p); });
    return mask;
}

DrawingLook look_at(const Painting& painting, const std::string& name, Context& context) {
    const PictureFrame frame = frame_for(painting, name);
    RgbaImage figure = paint(painting, frame.view, frame.width, frame.height);
    fill_outlines(figure, painting, frame.view);
    const Mask opaque = opaque_pixels(figure);
    if (pixel_count(opaque) == 0) throw Error(ErrorKind::input, name + ": there is nothing to be seen");
    const PagePicture page = cut_out_picture(figure);
    DetectedCharacter character = character_in(page, opaque, context);
    const Segmentation seen = context.segmenter().segment(
        character.ink, character.mask, context.options().segmentation, character.exact_mask);
    const Point2d corner = to_double(Point2i{character.box.x, character.box.y});
    // Pixel centres: page pixel p is at (p + ½ − corner) · scale − ½ of the labels.
    CanvasView view;
    view.scale = character.scale * frame.view.scale;
    view.offset = character.scale * (frame.view.offset + Point2d{0.5, 0.5} - corner) - Point2d{0.5, 0.5};
    return {{std::move(character.drawing), seen.labels}, view};
}

} // namespace pantin
