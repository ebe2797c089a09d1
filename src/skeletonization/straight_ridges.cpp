// SPDX-License-Identifier: MIT
// In come the borders of a mask, out goes a raster of the inner arcs of their straight skeleton (Ma et al.
// 2021, 3.1), in place of the thesis's Voronoi edges (4.4).
#include "skeletonization/straight_ridges.hpp"

#include <cmath>
#include <optional>

#include "geometry/extent.hpp"
#include "image/nearest_pixel.hpp"
#include "pantin/error.hpp"
#include "pantin/straight_skeleton.hpp"
#include "skeletonization/voronoi_skeleton.hpp"

namespace pantin {
namespace {

constexpr double tolerance = 1; // pixels

std::optional<std::vector<Point2d>> loop_of(const Border& border) {
    std::vector<Point2d> points;
    for (const Point2i& p : border.points) points.push_back(to_double(p));
    SimplePolygonOptions options;
    options.samples = 0;
    options.tolerance = tolerance / std::max(1.0, diagonal_of(points));
    options.finer = 0; // pixels say no more than a pixel
    try {
        return simple_polygon(points, options).corners;
    } catch (const Error&) {
        return std::nullopt; // a line or a dot
    }
}

} // namespace

Mask straight_ridges(const std::vector<Border>& borders, const Mask& mask) {
    Mask ridges(mask.width(), mask.height());
    std::vector<std::vector<Point2d>> loops;
    for (const Border& border : borders) {
        const auto loop = loop_of(border);
        if (loop && (border.outer ? loops.empty() : !loops.empty())) loops.push_back(*loop);
    }
    if (loops.empty()) return ridges;
    const StraightSkeleton skeleton = straight_skeleton(loops);
    const int corners = static_cast<int>(skeleton.corners.size());
    for (const StraightSkeleton::Arc& arc : skeleton.arcs) {
        if (arc.from < corners) continue;
        for (const Point2i p :
             straight_line(pixel_at(skeleton.nodes[arc.from].place), pixel_at(skeleton.nodes[arc.to].place)))
            if (mask.value_or(p.x, p.y, 0)) ridges(p.x, p.y) = 1;
    }
    return ridges;
}

} // namespace pantin
