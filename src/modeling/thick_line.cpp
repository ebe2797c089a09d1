// SPDX-License-Identifier: MIT
// A polyline and its width in, the outline or the pieces of the stroke out (SVG 2, 13.5).
#include "modeling/thick_line.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "geometry/extent.hpp"

namespace pantin {
namespace {

constexpr double arc_step = math::pi / 10; // of a chord of a round cap or join
constexpr double least_turn = 0.05;        // radians; gentler bends, as of a curve's chords, are one point

Point2d left_of(Point2d v) { return {-v.y, v.x}; }

std::vector<Point2d> without_repeats(std::vector<Point2d> way, bool closed) {
    way.erase(std::unique(way.begin(), way.end()), way.end());
    while (closed && way.size() > 1 && way.front() == way.back()) way.pop_back();
    return way;
}

Point2d direction(Point2d from, Point2d to) { return 1 / distance(from, to) * (to - from); }

// From centre + `from` to centre + `to`, turned in the sense of `sense`; the ends are left out.
void add_arc(std::vector<Point2d>& out, Point2d centre, Point2d from, Point2d to, double sense) {
    double angle = math::atan2(cross(from, to), dot(from, to));
    if (angle * sense < 0) angle += sense > 0 ? 2 * math::pi : -2 * math::pi;
    const int chords = static_cast<int>(std::ceil(std::abs(angle) / arc_step));
    for (int k = 1; k < chords; ++k) {
        const double a = angle * k / chords;
        const double c = math::cos(a), s = math::sin(a);
        out.push_back(centre + Point2d{c * from.x - s * from.y, s * from.x + c * from.y});
    }
}

// The outer corner between two edges, whose normals of half a width are given.
void add_join(std::vector<Point2d>& out, Point2d p, Point2d n0, Point2d n1, const LineStyle& style) {
    const double half = style.width / 2;
    const Point2d sum = n0 + n1;
    const double square = dot(sum, sum);
    // Length of the miter in widths: 1 / cos of half the turn.
    const double ratio = square > 0 ? 2 * half / std::sqrt(square) : style.miter_limit + 1;
    const bool gentle = square > 0 && std::abs(cross(n0, n1)) < least_turn * half * half && dot(n0, n1) > 0;
    if (gentle || (style.join == LineJoin::miter && ratio <= style.miter_limit)) {
        out.push_back(p + 2 * half * half / square * sum);
        return;
    }
    out.push_back(p + n0);
    if (style.join == LineJoin::round) add_arc(out, p, n0, n1, cross(n0, n1) >= 0 ? 1 : -1);
    out.push_back(p + n1);
}

// The corner on the inner side: where the offset edges meet, while they are long enough.
void add_inner(std::vector<Point2d>& out, Point2d p, Point2d n0, Point2d n1, double shorter, double half) {
    const Point2d sum = n0 + n1;
    const double square = dot(sum, sum);
    const double reach = square > 0 ? std::abs(cross(n0, n1)) * 2 / square * half : shorter + 1;
    if (reach <= shorter) {
        out.push_back(p + 2 * half * half / square * sum);
        return;
    }
    out.push_back(p + n0);
    out.push_back(p + n1);
}

// The border on the left of the way, for x to the right and y up, from its beginning to its end.
std::vector<Point2d> left_side(const std::vector<Point2d>& way, const LineStyle& style) {
    const double half = style.width / 2;
    std::vector<Point2d> side;
    Point2d before = half * left_of(direction(way[0], way[1]));
    side.push_back(way[0] + before);
    for (std::size_t i = 1; i + 1 < way.size(); ++i) {
        const Point2d after = half * left_of(direction(way[i], way[i + 1]));
        const double shorter = std::min(distance(way[i - 1], way[i]), distance(way[i], way[i + 1]));
        if (cross(before, after) > 0)
            add_inner(side, way[i], before, after, shorter, half);
        else
            add_join(side, way[i], before, after, style);
        before = after;
    }
    side.push_back(way.back() + before);
    return side;
}

std::vector<Point2d> dot_of(Point2d p, const LineStyle& style) {
    const double half = style.width / 2;
    if (style.cap == LineCap::butt) return {};
    if (style.cap == LineCap::square)
        return {p + Point2d{-half, -half}, p + Point2d{half, -half}, p + Point2d{half, half},
                p + Point2d{-half, half}};
    std::vector<Point2d> circle = {p + Point2d{half, 0}};
    add_arc(circle, p, {half, 0}, {-half, 0}, 1);
    circle.push_back(p + Point2d{-half, 0});
    add_arc(circle, p, {-half, 0}, {half, 0}, 1);
    return circle;
}

void make_positive(std::vector<Point2d>& loop) {
    if (area_of(loop) < 0) std::reverse(loop.begin(), loop.end());
}

// Square ends are half a width longer.
void lengthen(std::vector<Point2d>& way, double half) {
    const Point2d first = direction(way[1], way[0]), last = direction(way[way.size() - 2], way.back());
    way.front() = way.front() + half * first;
    way.back() = way.back() + half * last;
}

} // namespace

std::vector<Point2d> thick_line(const std::vector<Point2d>& given, const LineStyle& style) {
    std::vector<Point2d> way = without_repeats(given, false);
    if (way.empty()) return {};
    if (way.size() == 1) return dot_of(way[0], style);
    if (style.cap == LineCap::square) lengthen(way, style.width / 2);
    std::vector<Point2d> outline = left_side(way, style);
    std::reverse(way.begin(), way.end());
    const std::vector<Point2d> back = left_side(way, style);
    const bool round = style.cap == LineCap::round;
    if (round) add_arc(outline, way.front(), outline.back() - way.front(), back.front() - way.front(), -1);
    outline.insert(outline.end(), back.begin(), back.end());
    if (round) add_arc(outline, way.back(), back.back() - way.back(), outline.front() - way.back(), -1);
    return outline;
}

std::vector<std::vector<Point2d>> line_pieces(const std::vector<Point2d>& given, bool closed,
                                              const LineStyle& style) {
    std::vector<Point2d> way = without_repeats(given, closed);
    if (way.empty()) return {};
    if (way.size() == 1) {
        std::vector<Point2d> dot = dot_of(way[0], style);
        if (dot.empty()) return {};
        return {std::move(dot)};
    }
    const double half = style.width / 2;
    std::vector<std::vector<Point2d>> pieces;
    if (!closed && style.cap == LineCap::square) lengthen(way, half);
    if (!closed && style.cap == LineCap::round)
        for (const Point2d end : {way.front(), way.back()}) pieces.push_back(dot_of(end, style));
    const std::size_t n = way.size(), edges = closed ? n : n - 1;
    const auto normal = [&](std::size_t i) {
        return half * left_of(direction(way[i % n], way[(i + 1) % n]));
    };
    for (std::size_t i = 0; i < edges; ++i) {
        const Point2d a = way[i], b = way[(i + 1) % n], m = normal(i);
        pieces.push_back({a + m, a - m, b - m, b + m});
        if (!closed && i + 1 == edges) break;
        const Point2d after = normal(i + 1);
        const bool bends_left = cross(m, after) > 0; // then the outer corner is on the right
        std::vector<Point2d> corner = {b};
        add_join(corner, b, bends_left ? -1 * m : m, bends_left ? -1 * after : after, style);
        if (corner.size() == 2) corner.insert(corner.begin() + 1, b + (bends_left ? -1 * m : m));
        if (corner.size() == 3) corner.push_back(b + (bends_left ? -1 * after : after));
        pieces.push_back(std::move(corner));
    }
    for (std::vector<Point2d>& piece : pieces) make_positive(piece);
    return pieces;
}

} // namespace pantin
