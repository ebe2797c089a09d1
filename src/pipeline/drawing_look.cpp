// SPDX-License-Identifier: MIT
// Areas in, the network's labels of their picture out (docs/modeling.md, "Drawings without names").
#include "pipeline/drawing_look.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "pantin/detection.hpp"
#include "pantin/error.hpp"
#include "pipeline/page_picture.hpp"

namespace pantin {
namespace {

constexpr int picture_side = 1000;    // pixels of the drawing that the network sees
constexpr double margin = 0.06;       // of its longer side, on each side
constexpr double found_share = 0.85;  // of what is drawn, that a detected character has at least
constexpr double detail_share = 0.03; // of what is drawn: larger holes are gaps between parts
constexpr double piece_share = 0.01;  // of the largest piece, that one has at least to be joined
constexpr double bridge_length = 0.1; // of the picture's longer side, at most
constexpr double bridge_width = 0.03; // of the same
constexpr int most_bridges = 20;
constexpr double pen = 3;          // half a line's width, pixels
constexpr int colour_step = 60;    // sum over the channels, between areas of two colours
constexpr double few_limbs = 0.04; // of the silhouette: with fewer a second look is worth it
constexpr double line_share = 0.5; // of a hole's border is lines when the hole is the inside of an outline

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
            if (!best || c.box.area() > best->box.area()) best = &c;
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

// Details that are cut out of an area (eyes) are what shows through them: paper, or dark in a pale figure.
void fill_details(RgbaImage& figure) {
    const Mask opaque = opaque_pixels(figure);
    long drawn = 0, luma = 0;
    for (const Rgba8& p : figure)
        if (is_opaque(p)) ++drawn, luma += (299 * p.r + 587 * p.g + 114 * p.b) / 1000;
    const Rgba8 ground = luma >= pale * drawn ? Rgba8{dark_ground.r, dark_ground.g, dark_ground.b, 255}
                                              : Rgba8{255, 255, 255, 255};
    const Mask filled = fill_holes(opaque, static_cast<long>(detail_share * static_cast<double>(drawn)));
    for (std::size_t i = 0; i < filled.size(); ++i)
        if (filled.data()[i] && !opaque.data()[i]) figure.data()[i] = ground;
}

// The pair of pixels, of the largest piece and of another one, that are nearest, when they are near enough.
struct Gap {
    Point2i from, to;
    double distance = 0;
};
std::optional<Gap> nearest_gap(const Mask& opaque, double reach) {
    const Components pieces = connected_components(opaque);
    if (pieces.list.size() < 2) return {};
    const auto largest =
        std::max_element(pieces.list.begin(), pieces.list.end(),
                         [](const Component& a, const Component& b) { return a.area < b.area; });
    const Grid<int> nearest = nearest_seed(component_mask(pieces, largest->id));
    std::optional<Gap> best;
    for (int y = 0; y < opaque.height(); ++y)
        for (int x = 0; x < opaque.width(); ++x) {
            const int id = pieces.ids(x, y);
            if (id == 0 || id == largest->id) continue;
            if (pieces.list[static_cast<std::size_t>(id) - 1].area < piece_share * largest->area) continue;
            const Point2i to = {nearest(x, y) % opaque.width(), nearest(x, y) / opaque.width()};
            const double gap = distance(to_double({x, y}), to_double(to));
            if (gap <= reach && (!best || gap < best->distance)) best = {{x, y}, to, gap};
        }
    return best;
}

// Pieces with a narrow gap between them (a head over its body) are joined by a bridge in the colour of the
// larger.
void join_pieces(RgbaImage& figure) {
    const double side = std::max(figure.width(), figure.height());
    const double half = bridge_width / 2 * side;
    const int r = static_cast<int>(half);
    for (int round = 0; round < most_bridges; ++round) {
        const std::optional<Gap> gap = nearest_gap(opaque_pixels(figure), bridge_length * side);
        if (!gap) return;
        const Rgba8 colour = figure(gap->to.x, gap->to.y);
        const int steps = static_cast<int>(gap->distance) + 1;
        for (int k = 0; k <= steps; ++k) {
            const double t = static_cast<double>(k) / steps;
            const Point2d p = to_double(gap->from) + t * (to_double(gap->to) - to_double(gap->from));
            const int cx = static_cast<int>(p.x + 0.5), cy = static_cast<int>(p.y + 0.5);
            for (int dy = -r; dy <= r; ++dy)
                for (int dx = -r; dx <= r; ++dx)
                    if (dx * dx + dy * dy <= half * half && figure.contains(cx + dx, cy + dy) &&
                        !is_opaque(figure(cx + dx, cy + dy)))
                        figure(cx + dx, cy + dy) = {colour.r, colour.g, colour.b, 255};
        }
    }
}

// The drawing as a pen would draw it: dark lines where colours meet and around everything, pale areas.
RgbaImage as_lines(const RgbaImage& figure) {
    const auto differs = [](Rgba8 a, Rgba8 b) {
        if (is_opaque(a) != is_opaque(b)) return true;
        return is_opaque(a) && std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) > colour_step;
    };
    Mask edge(figure.width(), figure.height());
    for (int y = 0; y < figure.height(); ++y)
        for (int x = 0; x < figure.width(); ++x)
            for (const auto& [dx, dy] : {std::pair{2, 0}, {-2, 0}, {0, 2}, {0, -2}})
                edge(x, y) |= differs(figure(x, y), figure.value_or(x + dx, y + dy, Rgba8{}));
    edge = dilate_disc(edge, pen);
    RgbaImage lines = figure;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        Rgba8& p = lines.data()[i];
        const auto faint = [](std::uint8_t v) { return static_cast<std::uint8_t>(215 + v * 40 / 255); };
        if (is_opaque(p))
            p = edge.data()[i] ? Rgba8{20, 20, 20, 255} : Rgba8{faint(p.r), faint(p.g), faint(p.b), 255};
    }
    return lines;
}

// Of limbs and wings in the silhouette.
double limb_share(const LabelMap& labels) {
    long all = 0, own = 0;
    for (const std::uint8_t label : labels) all += label != 0, own += row_of(static_cast<Label>(label)).sided;
    return all == 0 ? 0 : static_cast<double>(own) / static_cast<double>(all);
}

} // namespace

long pixel_count(const Mask& mask) { return std::count(mask.begin(), mask.end(), 1); }

RgbImage without_paper(RgbImage drawing, const Mask& opaque, const LabelMap& labels) {
    const Grid<int> nearest = nearest_seed(opaque);
    const double sx = static_cast<double>(labels.width()) / drawing.width(),
                 sy = static_cast<double>(labels.height()) / drawing.height();
    const RgbImage drawn = drawing;
    for (int y = 0; y < drawing.height(); ++y)
        for (int x = 0; x < drawing.width(); ++x) {
            const int u = static_cast<int>((x + 0.5) * sx), v = static_cast<int>((y + 0.5) * sy);
            if (opaque(x, y) || nearest(x, y) < 0 || labels.value_or(u, v, 0) == 0) continue;
            drawing(x, y) = drawn.data()[static_cast<std::size_t>(nearest(x, y))];
        }
    return drawing;
}

DrawingLook look_at(const Painting& painting, const std::string& name, Context& context) {
    const PictureFrame frame = frame_for(painting, name);
    RgbaImage figure = paint(painting, frame.view, frame.width, frame.height);
    fill_outlines(figure, painting, frame.view);
    fill_details(figure);
    join_pieces(figure);
    const Mask opaque = opaque_pixels(figure);
    if (pixel_count(opaque) == 0) throw Error(ErrorKind::input, name + ": there is nothing to be seen");
    const PagePicture page = cut_out_picture(figure);
    DetectedCharacter character = character_in(page, opaque, context);
    const SegmentationOptions& options = context.options().segmentation;
    Segmentation seen =
        context.segmenter().segment(character.ink, character.mask, options, character.exact_mask);
    if (limb_share(seen.labels) < few_limbs) {
        const Grid<float> lines = find_cut_out_ink(as_lines(figure)).darkness;
        Segmentation again = context.segmenter().segment(ink_of_crop(crop(lines, character.box)),
                                                         character.mask, options, character.exact_mask);
        if (limb_share(again.labels) > limb_share(seen.labels)) seen = std::move(again);
    }
    const Point2d corner = to_double(Point2i{character.box.x, character.box.y});
    // Pixel centres: page pixel p is at (p + ½ − corner) · scale − ½ of the labels.
    CanvasView view;
    view.scale = character.scale * frame.view.scale;
    view.offset = character.scale * (frame.view.offset + Point2d{0.5, 0.5} - corner) - Point2d{0.5, 0.5};
    RgbImage drawing = without_paper(std::move(character.drawing), crop(opaque, character.box), seen.labels);
    return {{std::move(drawing), seen.labels}, view};
}

} // namespace pantin
