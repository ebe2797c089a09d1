// SPDX-License-Identifier: MIT
// Part labels of a scanned drawing as strokes (include/pantin/model_view.hpp).
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/extent.hpp"
#include "image/label_map.hpp"
#include "pantin/error.hpp"
#include "pantin/geometry.hpp"
#include "pantin/image.hpp"
#include "pantin/model_view.hpp"

namespace pantin {
namespace {

// The trunk first, that the other parts meet.
constexpr std::array<Label, part_labels.size()> modelling_order = [] {
    std::array<Label, part_labels.size()> order{};
    std::size_t next = 0;
    for (const bool trunk : {true, false})
        for (const Label label : part_labels)
            if ((role_of(label) == PartRole::trunk) == trunk) order[next++] = label;
    return order;
}();
constexpr double least_share = 0.002; // of the silhouette: smaller pieces are left out
constexpr double hair = 0.2;          // of a border's pixels: an area below it is a hair's
constexpr int smoothing = 2;          // border pixels to each side whose mean is a point of the stroke
constexpr double least_reach = 2;     // pixels that a part extends into its neighbour

// Pieces of a label as masks of the map's size, from left to right.
std::vector<Mask> piece_masks(const LabelMap& labels, Label label, long least_area) {
    std::vector<LabelPiece> pieces = pieces_of(part_mask(labels, {label}), static_cast<int>(least_area));
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const LabelPiece& a, const LabelPiece& b) { return a.box.x < b.box.x; });
    std::vector<Mask> masks;
    for (const LabelPiece& piece : pieces) {
        Mask& mask = masks.emplace_back(labels.width(), labels.height());
        for (const Point2i p : piece.pixels) mask(p.x, p.y) = 1;
    }
    return masks;
}

// The piece and what lies within reach of its seams with parts that come before it.
Mask extended(const Mask& piece, const Mask& before, const Grid<int>& silhouette_distance) {
    Mask result = piece;
    for (int y = 0; y < piece.height(); ++y)
        for (int x = 0; x < piece.width(); ++x) {
            if (!piece(x, y)) continue;
            const bool seam = before.value_or(x - 1, y, 0) || before.value_or(x + 1, y, 0) ||
                              before.value_or(x, y - 1, 0) || before.value_or(x, y + 1, 0);
            if (!seam) continue;
            const double reach =
                std::max(least_reach, std::sqrt(static_cast<double>(silhouette_distance(x, y))));
            const int r = static_cast<int>(reach);
            for (int dy = -r; dy <= r; ++dy)
                for (int dx = -r; dx <= r; ++dx)
                    if (dx * dx + dy * dy <= reach * reach && before.value_or(x + dx, y + dy, 0))
                        result(x + dx, y + dy) = 1;
        }
    return result;
}

// The outer border, its steps smoothed.
std::vector<Point2d> border_of(const Mask& mask) {
    const Mask padded = pad(largest_component(mask), 1);
    const std::vector<Border> borders = follow_borders(padded);
    const std::vector<Point2i>& border = borders.front().points;
    const int n = static_cast<int>(border.size());
    std::vector<Point2d> stroke;
    for (int i = 0; i < n; ++i) {
        Point2d sum;
        for (int k = -smoothing; k <= smoothing; ++k) sum = sum + to_double(border[((i + k) % n + n) % n]);
        stroke.push_back(1.0 / (2 * smoothing + 1) * sum - Point2d{1, 1}); // without the padding
    }
    return stroke;
}

// Of a piece that is a pixel wide the border goes out and comes back the same way: it is taken a pixel wider.
std::vector<Point2d> stroke_of(const Mask& mask) {
    const std::vector<Point2d> stroke = border_of(mask);
    if (std::abs(area_of(stroke)) >= hair * static_cast<double>(stroke.size())) return stroke;
    return border_of(dilate_square(mask, 1));
}

} // namespace

Strokes strokes_from_labels(const LabelMap& labels) {
    const Mask silhouette = fill_holes(largest_component(foreground(labels)));
    const long least_area =
        std::max(16L, static_cast<long>(least_share * static_cast<double>(std::count(silhouette.begin(),
                                                                                     silhouette.end(), 1))));
    const Grid<int> distances = squared_distance_transform(silhouette);
    Strokes strokes;
    Mask before(labels.width(), labels.height());
    for (const Label label : modelling_order) {
        const std::vector<Mask> pieces = piece_masks(labels, label, least_area);
        Mask own = before;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            PartStroke part;
            part.name = std::string(name_of(label)) + (pieces.size() > 1 ? "_" + std::to_string(i + 1) : "");
            part.label = label;
            part.stroke = stroke_of(extended(pieces[i], before, distances));
            strokes.calls.emplace_back(part);
            for (std::size_t k = 0; k < own.size(); ++k) own.data()[k] |= pieces[i].data()[k];
        }
        before = own;
    }
    if (strokes.calls.empty()) throw Error(ErrorKind::input, "labels: no part is large enough for a stroke");
    return strokes;
}

} // namespace pantin
