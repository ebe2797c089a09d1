// SPDX-License-Identifier: MIT
// From the ink of one character to its filled silhouette: what it encloses is filled, single strokes are
// thickened, pieces are joined. Takes the place of the dilation and the filled contour of thesis 4.2.
#include "detection/ink_silhouette.hpp"

#include <algorithm>
#include <cmath>

#include "image/distance.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace {

// The distances of the ridge: pixels not nearer to the background than any of their 8 neighbours.
std::vector<int> ridge_distances(const Mask& ink) {
    const Grid<int> distance = squared_distance_transform(ink);
    std::vector<int> ridge;
    for (int y = 0; y < ink.height(); ++y) {
        for (int x = 0; x < ink.width(); ++x) {
            if (!ink(x, y)) continue;
            bool highest = true;
            for (int v = y - 1; v <= y + 1 && highest; ++v)
                for (int u = x - 1; u <= x + 1 && highest; ++u)
                    highest = distance.value_or(u, v, 0) <= distance(x, y);
            if (highest) ridge.push_back(distance(x, y));
        }
    }
    return ridge;
}

// Strokes that enclose nothing: what an opening wider than the pen removes, but for the crumbs that it leaves
// at the corners of thick parts.
Mask single_strokes(const Mask& shape, const Mask& ink, double pen) {
    const Mask thick = open_disc(shape, pen);
    Mask thin(shape.width(), shape.height());
    for (std::size_t i = 0; i < thin.size(); ++i) thin.data()[i] = shape.data()[i] && !thick.data()[i];
    const Components pieces = connected_components(thin);
    for (std::size_t i = 0; i < thin.size(); ++i) {
        const int id = pieces.ids.data()[i];
        if (id == 0) continue;
        const Box& box = pieces.list[id - 1].box;
        thin.data()[i] = ink.data()[i] && std::max(box.width, box.height) > 1.5 * pen;
    }
    return thin;
}

// Whether what the ink encloses is next to nothing of its box. Figures of lines are hollow, and so is an
// outline whose gap is too wide for the usual rule.
bool is_hollow(const Mask& ink, const Mask& regions, double share) {
    const Components pieces = connected_components(ink);
    int left = ink.width(), top = ink.height(), right = 0, bottom = 0;
    for (const Component& piece : pieces.list) {
        left = std::min(left, piece.box.x), right = std::max(right, piece.box.x + piece.box.width);
        top = std::min(top, piece.box.y), bottom = std::max(bottom, piece.box.y + piece.box.height);
    }
    const auto area = std::count(regions.begin(), regions.end(), 1);
    return static_cast<double>(area) < share * std::max(0, right - left) * std::max(0, bottom - top);
}

// Sets all pixels within `radius` of the segment from a to b.
void draw_segment(Mask& mask, Point2i a, Point2i b, double radius) {
    const Point2d p = to_double(a), along = to_double(b) - p;
    const double squared = dot(along, along);
    const int reach = static_cast<int>(std::ceil(radius));
    for (int y = std::max(0, std::min(a.y, b.y) - reach);
         y <= std::min(mask.height() - 1, std::max(a.y, b.y) + reach); ++y) {
        for (int x = std::max(0, std::min(a.x, b.x) - reach);
             x <= std::min(mask.width() - 1, std::max(a.x, b.x) + reach); ++x) {
            const Point2d q = Point2d{1.0 * x, 1.0 * y} - p;
            const double t = squared == 0 ? 0 : std::clamp(dot(q, along) / squared, 0.0, 1.0);
            const Point2d off = q - t * along;
            if (dot(off, off) <= radius * radius) mask(x, y) = 1;
        }
    }
}

// The shortest segment between the component `id` and any other (first in raster order among equals).
std::pair<Point2i, Point2i> shortest_bridge(const Components& pieces, int id) {
    const int w = pieces.ids.width();
    Mask others(w, pieces.ids.height());
    for (std::size_t i = 0; i < others.size(); ++i)
        others.data()[i] = pieces.ids.data()[i] != 0 && pieces.ids.data()[i] != id;
    const Grid<int> nearest = nearest_seed(others);
    std::pair<Point2i, Point2i> bridge;
    int shortest = std::numeric_limits<int>::max();
    const Box& box = pieces.list[id - 1].box;
    for (int y = box.y; y < box.y + box.height; ++y) {
        for (int x = box.x; x < box.x + box.width; ++x) {
            if (pieces.ids(x, y) != id) continue;
            const int u = nearest(x, y) % w, v = nearest(x, y) / w;
            const int squared = (u - x) * (u - x) + (v - y) * (v - y);
            if (squared < shortest) shortest = squared, bridge = {{x, y}, {u, v}};
        }
    }
    return bridge;
}

// Bridges from the smallest piece to its nearest neighbour, until one piece is left.
void join_pieces(Mask& shape, double width) {
    while (true) {
        const Components pieces = connected_components(shape);
        if (pieces.list.size() < 2) return;
        const auto smallest =
            std::min_element(pieces.list.begin(), pieces.list.end(),
                             [](const Component& a, const Component& b) { return a.area < b.area; });
        const auto [from, to] = shortest_bridge(pieces, smallest->id);
        draw_segment(shape, from, to, width / 2);
    }
}

} // namespace

double pen_width(const Mask& ink) {
    std::vector<int> ridge = ridge_distances(ink);
    if (ridge.empty()) return 1;
    const auto median = ridge.begin() + static_cast<std::ptrdiff_t>(ridge.size() / 2);
    std::nth_element(ridge.begin(), median, ridge.end());
    const double widest = 0.025 * (ink.width() + ink.height()) / 2;
    return std::clamp(2 * std::sqrt(static_cast<double>(*median)) - 1, 1.0, std::max(1.0, widest));
}

Mask silhouette_of(const Mask& ink, const InkSilhouetteOptions& options) {
    Mask shape = find_enclosed_regions(ink, options.enclosed);
    if (is_hollow(ink, shape, options.hollow_share)) shape = find_enclosed_regions(ink, options.last_resort);
    for (std::size_t i = 0; i < shape.size(); ++i) shape.data()[i] |= ink.data()[i];
    const double pen = pen_width(ink);
    const Mask thickened = dilate_disc(single_strokes(shape, ink, pen), (options.stroke_width - 1) / 2 * pen);
    for (std::size_t i = 0; i < shape.size(); ++i) shape.data()[i] |= thickened.data()[i];
    join_pieces(shape, options.stroke_width * pen);
    return fill_holes(shape);
}

} // namespace pantin
