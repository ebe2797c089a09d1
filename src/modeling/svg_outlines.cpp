// SPDX-License-Identifier: MIT
// Subpaths and the fill rule in, outlines of parts and holes out (SVG 2, 13.4.2). A subpath's inside is
// filled by its own turn and those of the subpaths around it.
#include "modeling/svg_outlines.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/extent.hpp"

namespace pantin {
namespace {

constexpr double flat = 1e-7;        // of the squared diagonal: an area is none
constexpr double speck = 1.0 / 1000; // of the largest part's area

struct Box2 {
    Point2d low, high;
    bool holds(Point2d p) const { return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y; }
};
Box2 box_of(const std::vector<Point2d>& points) {
    Box2 box{points.front(), points.front()};
    for (const Point2d p : points) {
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    return box;
}

// Most of a handful of its points.
bool lies_inside(const std::vector<Point2d>& inner, const std::vector<Point2d>& outer, const Box2& box) {
    constexpr std::size_t probes = 9;
    const std::size_t n = inner.size(), count = std::min(n, probes);
    std::size_t inside = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = k * n / count;
        const Point2d p = 0.5 * (inner[i] + inner[(i + 1) % n]);
        inside += box.holds(p) && winding(outer, p) != 0;
    }
    return 2 * inside > count;
}

bool is_filled(int windings, int crossings, FillRule rule) {
    return rule == FillRule::nonzero ? windings != 0 : crossings % 2 != 0;
}

} // namespace

int winding(const std::vector<Point2d>& outline, Point2d p) {
    int count = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point2d a = outline[i], b = outline[(i + 1) % outline.size()];
        if ((a.y <= p.y) == (b.y <= p.y)) continue;
        const double side = cross(b - a, p - a);
        if (b.y > a.y && side > 0) ++count;
        if (b.y < a.y && side < 0) --count;
    }
    return count;
}

bool has_area(const std::vector<Point2d>& outline) {
    if (outline.size() < 3) return false;
    const double diagonal = diagonal_of(outline);
    // A figure of eight has area without having it in sum: the largest distance from the line counts, too.
    if (std::abs(area_of(outline)) > flat * diagonal * diagonal) return true;
    const auto farthest = std::max_element(outline.begin(), outline.end(), [&](Point2d a, Point2d b) {
        return distance(a, outline[0]) < distance(b, outline[0]);
    });
    const Point2d along = *farthest - outline[0];
    return std::any_of(outline.begin(), outline.end(), [&](Point2d p) {
        return std::abs(cross(along, p - outline[0])) > 2 * flat * diagonal * diagonal;
    });
}

FilledOutlines filled_outlines(const std::vector<Subpath>& subpaths, FillRule rule) {
    const std::size_t n = subpaths.size();
    FilledOutlines result;
    std::vector<double> areas(n, 0);
    std::vector<Box2> boxes(n);
    for (std::size_t i = 0; i < n; ++i) {
        boxes[i] = box_of(subpaths[i].points);
        if (has_area(subpaths[i].points)) areas[i] = area_of(subpaths[i].points);
    }
    double largest = 0;
    std::vector<std::size_t> hollows;
    for (std::size_t i = 0; i < n; ++i) {
        if (areas[i] == 0 && !has_area(subpaths[i].points)) {
            ++result.empty;
            continue;
        }
        int windings = 0, crossings = 0;
        for (std::size_t j = 0; j < n; ++j) {
            const bool larger = std::abs(areas[j]) > std::abs(areas[i]) ||
                                (std::abs(areas[j]) == std::abs(areas[i]) && j < i);
            if (j == i || !larger || !lies_inside(subpaths[i].points, subpaths[j].points, boxes[j])) continue;
            windings += areas[j] > 0 ? 1 : -1;
            ++crossings;
        }
        const bool outside = is_filled(windings, crossings, rule);
        const bool inside = is_filled(windings + (areas[i] > 0 ? 1 : -1), crossings + 1, rule);
        if (inside && !outside) {
            result.parts.push_back(i);
            largest = std::max(largest, std::abs(areas[i]));
        } else if (inside) {
            ++result.inner;
        } else {
            hollows.push_back(i);
        }
    }
    result.specks =
        std::erase_if(result.parts, [&](std::size_t i) { return std::abs(areas[i]) < speck * largest; });
    for (const std::size_t hollow : hollows) {
        std::optional<std::size_t> around;
        for (std::size_t k = 0; k < result.parts.size(); ++k) {
            const std::size_t part = result.parts[k];
            if (lies_inside(subpaths[hollow].points, subpaths[part].points, boxes[part]) &&
                (!around || std::abs(areas[part]) < std::abs(areas[result.parts[*around]])))
                around = k;
        }
        if (around && std::abs(areas[hollow]) >= speck * std::abs(areas[result.parts[*around]]))
            result.holes.emplace_back(hollow, *around);
        else
            ++result.specks;
    }
    return result;
}

double share_inside(const std::vector<Point2d>& outline, const std::vector<Point2d>& other) {
    const auto inside =
        std::count_if(outline.begin(), outline.end(), [&](Point2d p) { return winding(other, p) != 0; });
    return outline.empty() ? 0 : static_cast<double>(inside) / static_cast<double>(outline.size());
}

} // namespace pantin
