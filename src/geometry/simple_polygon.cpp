// SPDX-License-Identifier: MIT
// Ma et al. 2021, section 3.1, "Simple polygon acquisition": a stroke in, a polygon that does not cross
// itself out.
#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/extent.hpp"
#include "pantin/error.hpp"
#include "pantin/geometry.hpp"

namespace pantin {
namespace {

constexpr double no_area = 1e-9;   // of the diagonal squared
constexpr double parallel = 1e-12; // sine of an angle
// A strip: its area, of the diagonal squared, and the share of its diagonal that cutting a loop off must
// leave.
constexpr int most_uncrossed = 1000; // rounding could undo what it did
constexpr double thin = 0.02, least_left = 0.95;
constexpr double finer = 0.1; // of a tolerance that flattens the stroke, the next one

[[noreturn]] void fail(const char* what) { throw Error(ErrorKind::input, std::string("stroke: ") + what); }

// Share of the way from a to b at which c–d crosses it, ends of both included; −1: it does not.
double crossing(Point2d a, Point2d b, Point2d c, Point2d d) {
    const Point2d u = b - a, v = d - c;
    const double sine = cross(u, v);
    if (std::abs(sine) <= parallel * length(u) * length(v)) return -1; // on one line: rounding would decide
    const double s = cross(c - a, v) / sine, t = cross(c - a, u) / sine;
    return s >= 0 && s <= 1 && t >= 0 && t <= 1 ? s : -1;
}

// A strip that crosses itself is still one strip: a loop cut off would be a piece of its length. Its sides
// are exchanged from there on instead (the 2-opt move of Croes 1958), which takes the crossing out and makes
// it shorter, so that it ends.
bool is_strip(const std::vector<Point2d>& loop, const std::vector<Point2d>& larger, double area) {
    const double diagonal = diagonal_of(loop);
    return area < thin * diagonal * diagonal && diagonal_of(larger) < least_left * diagonal;
}

struct Crossing {
    std::size_t first = 0, second = 0; // edges, by the corners where they begin
    Point2d place;
};

// Of all crossings of two edges that with the shortest loop between them, so that this loop is simple.
std::optional<Crossing> innermost_crossing(const std::vector<Point2d>& loop) {
    const std::size_t n = loop.size();
    std::optional<Crossing> found;
    std::size_t shortest = n;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = i + 2; k < n; ++k) {
            const std::size_t between = std::min(k - i, n - (k - i));
            if (between >= shortest || (i == 0 && k == n - 1)) continue;
            const double s = crossing(loop[i], loop[i + 1], loop[k], loop[(k + 1) % n]);
            if (s < 0) continue;
            shortest = between;
            found = Crossing{i, k, loop[i] + s * (loop[i + 1] - loop[i])};
        }
    return found;
}

// How often the loop goes around p.
int winding(const std::vector<Point2d>& loop, Point2d p) {
    int turns = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Point2d a = loop[i], b = loop[(i + 1) % loop.size()];
        const double side = cross(b - a, p - a);
        if (a.y <= p.y && b.y > p.y && side > 0) ++turns;
        if (a.y > p.y && b.y <= p.y && side < 0) --turns;
    }
    return turns;
}

// Whether the lobe lies beyond the rest, and is no slip of the pen. Both begin at the crossing.
bool is_lobe(const std::vector<Point2d>& lobe, const std::vector<Point2d>& rest,
             const SimplePolygonOptions& options) {
    if (std::abs(area_of(lobe)) < options.lobe_area * std::abs(area_of(rest)) &&
        diagonal_of(lobe) < options.lobe_size * diagonal_of(rest))
        return false;
    std::size_t covered = 0;
    for (std::size_t i = 1; i < lobe.size(); ++i) covered += winding(rest, lobe[i]) != 0;
    return 2 * covered < lobe.size() - 1;
}

// So far along the loop, from its first corner on.
Point2d point_along(const std::vector<Point2d>& loop, double way) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Point2d a = loop[i], b = loop[(i + 1) % loop.size()];
        const double step = distance(a, b);
        if (way < step) return a + (way / step) * (b - a);
        way -= step;
    }
    return loop.front();
}

// Without the crossing, where the loop begins: it is left out, equally far on both sides, until the mouth is
// so wide, at most half of the loop.
void open_mouth(std::vector<Point2d>& loop, double width) {
    constexpr double growth = 1.1, farthest = 0.25;
    double around = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) around += distance(loop[i], loop[(i + 1) % loop.size()]);
    double back = std::min(0.5 * width, farthest * around);
    while (back < farthest * around &&
           distance(point_along(loop, back), point_along(loop, around - back)) < width)
        back = std::min(growth * back, farthest * around);
    std::vector<Point2d> open = {point_along(loop, back)};
    double way = 0;
    for (std::size_t i = 1; i < loop.size(); ++i) {
        way += distance(loop[i - 1], loop[i]);
        if (way > back && way < around - back) open.push_back(loop[i]);
    }
    open.push_back(point_along(loop, around - back));
    loop = std::move(open);
}

// Takes one crossing of two edges out. False when there is none.
bool take_crossing_out(std::vector<Point2d>& loop, double diagonal, const SimplePolygonOptions& options,
                       SimplePolygon& polygon) {
    const std::size_t n = loop.size();
    const std::optional<Crossing> found = innermost_crossing(loop);
    if (!found) return false;
    const auto [i, k, at] = *found;
    std::vector<Point2d> inner = {at}, outer = {at};
    for (std::size_t j = i + 1; j <= k; ++j) inner.push_back(loop[j]);
    for (std::size_t j = k + 1; j < n + i + 1; ++j) outer.push_back(loop[j % n]);
    const double inside = std::abs(area_of(inner)), outside = std::abs(area_of(outer));
    std::vector<Point2d>& larger = inside > outside ? inner : outer;
    std::vector<Point2d>& smaller = inside > outside ? outer : inner;
    const bool may_exchange = polygon.uncrossed + polygon.joined < most_uncrossed;
    if (may_exchange && is_strip(loop, larger, inside + outside)) {
        std::reverse(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     loop.begin() + static_cast<std::ptrdiff_t>(k) + 1);
        ++polygon.uncrossed;
    } else if (may_exchange && is_lobe(smaller, larger, options)) {
        for (std::vector<Point2d>* half : {&smaller, &larger}) open_mouth(*half, options.neck * diagonal);
        loop = std::move(larger);
        loop.insert(loop.end(), smaller.rbegin(), smaller.rend());
        ++polygon.joined;
    } else {
        loop = std::move(larger);
        ++polygon.cut;
    }
    return true;
}

// Douglas–Peucker on a closed line: from the first point to the one farthest from it, and back.
std::vector<Point2d> simplified(const std::vector<Point2d>& loop, double tolerance) {
    std::size_t far = 0;
    for (std::size_t i = 1; i < loop.size(); ++i)
        if (distance(loop[i], loop[0]) > distance(loop[far], loop[0])) far = i;
    std::vector<Point2d> there(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(far) + 1);
    std::vector<Point2d> back(loop.begin() + static_cast<std::ptrdiff_t>(far), loop.end());
    back.push_back(loop.front());
    std::vector<Point2d> result;
    for (const std::vector<Point2d>& half : {there, back}) {
        const std::vector<int> kept = douglas_peucker(half, tolerance);
        for (std::size_t i = 0; i + 1 < kept.size(); ++i) result.push_back(half[kept[i]]);
    }
    return result;
}

// Without crossings, interior on the left; no corners when nothing of its area is left.
SimplePolygon uncrossed_polygon(std::vector<Point2d> loop, double diagonal,
                                const SimplePolygonOptions& options) {
    SimplePolygon polygon;
    while (loop.size() > 3 && take_crossing_out(loop, diagonal, options, polygon)) {
    }
    const double area = loop.size() < 3 ? 0 : area_of(loop);
    if (std::abs(area) <= no_area * diagonal * diagonal) return {};
    if (area < 0) std::reverse(loop.begin(), loop.end());
    polygon.corners = std::move(loop);
    return polygon;
}

} // namespace

SimplePolygon simple_polygon(const std::vector<Point2d>& stroke, const SimplePolygonOptions& options) {
    for (const Point2d& p : stroke)
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) fail("a coordinate is not a number");
    if (stroke.size() < 3) fail("has fewer than three points");
    const double diagonal = diagonal_of(stroke);
    std::vector<Point2d> closed = stroke;
    if (!(closed.back() == closed.front())) closed.push_back(closed.front());
    std::vector<Point2d> loop = options.samples > 0 ? resample(closed, options.samples + 1) : closed;
    loop.pop_back();
    double tolerance = options.tolerance * diagonal;
    for (int k = 0; k <= options.finer; ++k, tolerance *= finer)
        if (SimplePolygon polygon = uncrossed_polygon(simplified(loop, tolerance), diagonal, options);
            !polygon.corners.empty())
            return polygon;
    fail("has no area");
}

std::vector<Point2d> coarser_polygon(const std::vector<Point2d>& polygon, double tolerance) {
    constexpr int tries = 5;
    constexpr double least_area = 0.9, most_area = 1.1;
    const double area = area_of(polygon);
    for (int k = 0; k < tries; ++k, tolerance *= 0.25) {
        std::vector<Point2d> fewer = simplified(polygon, tolerance);
        const double left = fewer.size() < 3 ? 0 : area_of(fewer) / area;
        if (left > least_area && left < most_area && !innermost_crossing(fewer)) return fewer;
    }
    return polygon;
}

} // namespace pantin
