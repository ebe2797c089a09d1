// SPDX-License-Identifier: MIT
// The true silhouette: one piece, closed and filled, every pixel with a part.
#include <algorithm>
#include <cstdlib>
#include <limits>

#include "doodle/canvas.hpp"

namespace pantin::doodle {
namespace {

// Marks the 4-connected paper that reaches the border.
Grid<std::uint8_t> outside_of(const LabelMap& labels) {
    Grid<std::uint8_t> outside(labels.width(), labels.height());
    std::vector<Point2i> stack;
    const auto visit = [&](int x, int y) {
        if (!labels.contains(x, y) || labels(x, y) != 0 || outside(x, y)) return;
        outside(x, y) = 1;
        stack.push_back({x, y});
    };
    for (int x = 0; x < labels.width(); ++x) visit(x, 0), visit(x, labels.height() - 1);
    for (int y = 0; y < labels.height(); ++y) visit(0, y), visit(labels.width() - 1, y);
    while (!stack.empty()) {
        const Point2i p = stack.back();
        stack.pop_back();
        visit(p.x - 1, p.y), visit(p.x + 1, p.y), visit(p.x, p.y - 1), visit(p.x, p.y + 1);
    }
    return outside;
}

// Holes take the part that grows into them first, ring by ring.
void fill_label_holes(LabelMap& labels) {
    const Grid<std::uint8_t> outside = outside_of(labels);
    std::vector<Point2i> open;
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x)
            if (labels(x, y) == 0 && !outside(x, y)) open.push_back({x, y});
    while (!open.empty()) {
        std::vector<Point2i> rest;
        std::vector<std::pair<Point2i, std::uint8_t>> ring;
        for (Point2i p : open) {
            std::uint8_t label = 0;
            for (const auto& [dx, dy] : {std::pair{0, -1}, {-1, 0}, {1, 0}, {0, 1}})
                if (label == 0) label = labels.value_or(p.x + dx, p.y + dy, 0);
            if (label != 0)
                ring.push_back({p, label});
            else
                rest.push_back(p);
        }
        if (ring.empty()) return; // a hole always touches labels
        for (const auto& [p, label] : ring) labels(p.x, p.y) = label;
        open = std::move(rest);
    }
}

// The 8-connected pieces, each as its pixels in raster order of the first.
std::vector<std::vector<Point2i>> pieces_of(const LabelMap& labels) {
    Grid<std::uint8_t> seen(labels.width(), labels.height());
    std::vector<std::vector<Point2i>> pieces;
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x) {
            if (labels(x, y) == 0 || seen(x, y)) continue;
            std::vector<Point2i> piece = {{x, y}};
            seen(x, y) = 1;
            for (std::size_t i = 0; i < piece.size(); ++i)
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx) {
                        const Point2i q{piece[i].x + dx, piece[i].y + dy};
                        if (labels.value_or(q.x, q.y, 0) == 0 || seen(q.x, q.y)) continue;
                        seen(q.x, q.y) = 1;
                        piece.push_back(q);
                    }
            pieces.push_back(std::move(piece));
        }
    return pieces;
}

std::vector<Point2i> border_of(const std::vector<Point2i>& piece, const LabelMap& labels) {
    std::vector<Point2i> border;
    for (Point2i p : piece)
        if (labels.value_or(p.x - 1, p.y, 0) == 0 || labels.value_or(p.x + 1, p.y, 0) == 0 ||
            labels.value_or(p.x, p.y - 1, 0) == 0 || labels.value_or(p.x, p.y + 1, 0) == 0)
            border.push_back(p);
    return border;
}

// A bridge as thick as a pen between a piece and the main one, where they are nearest.
void bridge(LabelMap& labels, const std::vector<Point2i>& piece, const std::vector<Point2i>& main,
            double pen) {
    const std::vector<Point2i> from = border_of(piece, labels), to = border_of(main, labels);
    int best = std::numeric_limits<int>::max();
    Point2i a{}, b{};
    for (Point2i p : from)
        for (Point2i q : to) {
            const int d = (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
            if (d < best) best = d, a = p, b = q;
        }
    const std::uint8_t label = labels(a.x, a.y);
    const Patch<float> line =
        cover_line({to_double(a), to_double(b)}, {std::max(1.0, 0.5 * pen), std::max(1.0, 0.5 * pen)},
                   labels.width(), labels.height());
    for (int y = 0; y < line.box.height; ++y)
        for (int x = 0; x < line.box.width; ++x) {
            std::uint8_t& value = labels(line.box.x + x, line.box.y + y);
            if (line.values(x, y) >= 0.5f && value == 0) value = label;
        }
}

} // namespace

void complete_silhouette(LabelMap& labels, double pen) {
    fill_label_holes(labels);
    for (;;) {
        std::vector<std::vector<Point2i>> pieces = pieces_of(labels);
        if (pieces.size() < 2) break;
        std::stable_sort(pieces.begin(), pieces.end(),
                         [](const auto& p, const auto& q) { return p.size() > q.size(); });
        if (pieces[1].size() * 50 < pieces[0].size() || pieces[1].size() < 12) { // specks
            for (std::size_t i = 1; i < pieces.size(); ++i)
                for (Point2i p : pieces[i]) labels(p.x, p.y) = 0;
            break;
        }
        bridge(labels, pieces[1], pieces[0], pen);
    }
    fill_label_holes(labels);
}

Box label_box(const LabelMap& labels) {
    int x0 = labels.width(), y0 = labels.height(), x1 = -1, y1 = -1;
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x)
            if (labels(x, y) != 0)
                x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
    if (x1 < 0) return {};
    return {x0, y0, x1 - x0 + 1, y1 - y0 + 1};
}

} // namespace pantin::doodle
