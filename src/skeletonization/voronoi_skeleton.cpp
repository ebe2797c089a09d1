// SPDX-License-Identifier: MIT
// Voronoi skeletons with residuals: Ogniewicz & Ilg, "Voronoi skeletons: theory and applications", 1992; the
// thesis, section 3.4 and Figure 3.14. Departures: a border may pass a pixel twice, and borders of holes take
// part (ERRATA 1 to 4).
#include "skeletonization/voronoi_skeleton.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

namespace pantin {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double shorter_way(const Visit& a, const Visit& b, const std::vector<double>& lengths) {
    if (a.border != b.border) return infinity;
    const double forth = std::abs(a.position - b.position);
    return std::min(forth, lengths[a.border] - forth);
}

// Arc length at every point of a border, counted in whole steps, so that it does not depend on rounding.
std::vector<double> positions(const std::vector<Point2i>& border) {
    std::vector<double> result;
    long straight = 0, diagonal = 0;
    for (std::size_t i = 0; i < border.size(); ++i) {
        if (i > 0) {
            const bool along_axis = border[i].x == border[i - 1].x || border[i].y == border[i - 1].y;
            (along_axis ? straight : diagonal) += 1;
        }
        result.push_back(static_cast<double>(straight) + static_cast<double>(diagonal) * std::sqrt(2.0));
    }
    return result;
}

// The pixel that a Voronoi vertex lies in (halves upwards), if the mask has it.
std::optional<Point2i> pixel_of(Point2d p, const Mask& mask) {
    const double x = std::floor(p.x + 0.5), y = std::floor(p.y + 0.5);
    if (!(x >= 0 && y >= 0 && x < mask.width() && y < mask.height())) return std::nullopt;
    const Point2i pixel = {static_cast<int>(x), static_cast<int>(y)};
    if (!mask(pixel.x, pixel.y)) return std::nullopt;
    return pixel;
}

} // namespace

BorderSites border_sites(const std::vector<Border>& borders, int width, int height) {
    BorderSites sites;
    Grid<int> index(width, height, -1);
    for (std::size_t b = 0; b < borders.size(); ++b) {
        const std::vector<Point2i>& points = borders[b].points;
        const std::vector<double> position = positions(points);
        sites.lengths.push_back(closed_length(points));
        for (std::size_t i = 0; i < points.size(); ++i) {
            int& site = index(points[i].x, points[i].y);
            if (site < 0) {
                site = static_cast<int>(sites.points.size());
                sites.points.push_back(points[i]);
                sites.visits.emplace_back();
            }
            sites.visits[site].push_back({static_cast<int>(b), position[i]});
        }
    }
    return sites;
}

double border_arc(const BorderSites& sites, int a, int b) {
    double smallest = infinity;
    for (const Visit& va : sites.visits[a])
        for (const Visit& vb : sites.visits[b])
            smallest = std::min(smallest, shorter_way(va, vb, sites.lengths));
    return smallest;
}

double residual_between(const BorderSites& sites, int a, int b, Residual kind) {
    const double arc = border_arc(sites, a, b);
    if (kind == Residual::arc) return arc;
    return arc - distance(to_double(sites.points[a]), to_double(sites.points[b]));
}

double neck_residual(const std::vector<Visit>& visits, const std::vector<double>& lengths) {
    if (visits.size() < 2) return -1;
    double smallest = infinity;
    for (std::size_t i = 0; i < visits.size(); ++i)
        for (std::size_t j = i + 1; j < visits.size(); ++j)
            smallest = std::min(smallest, shorter_way(visits[i], visits[j], lengths));
    return smallest;
}

bool edge_inside(const VoronoiEdge& edge, const Mask& mask) {
    return pixel_of(edge.from, mask) && pixel_of(edge.to, mask);
}

std::vector<Point2i> straight_line(Point2i a, Point2i b) {
    const int dx = std::abs(b.x - a.x), dy = std::abs(b.y - a.y);
    const int sx = a.x < b.x ? 1 : -1, sy = a.y < b.y ? 1 : -1;
    const bool steep = dy > dx;
    const int major = std::max(dx, dy), minor = std::min(dx, dy);
    std::vector<Point2i> line = {a};
    int error = 2 * minor - major;
    for (int i = 0; i < major; ++i) {
        if (error >= 0) { // a tie steps aside early
            (steep ? a.x : a.y) += steep ? sx : sy;
            error -= 2 * major;
        }
        (steep ? a.y : a.x) += steep ? sy : sx;
        error += 2 * minor;
        line.push_back(a);
    }
    return line;
}

Mask rasterise(const std::vector<VoronoiEdge>& edges, const std::vector<double>& residuals,
               const BorderSites& sites, const Mask& mask, double threshold) {
    Mask raster(mask.width(), mask.height());
    for (std::size_t e = 0; e < edges.size(); ++e) {
        if (residuals[e] < threshold) continue;
        std::optional<Point2i> a = pixel_of(edges[e].from, mask), b = pixel_of(edges[e].to, mask);
        if (!a || !b) continue;
        // From the upper end (of equals the left one), so that a line does not depend on the edge's
        // direction.
        if (b->y < a->y || (b->y == a->y && b->x < a->x)) std::swap(a, b);
        for (const Point2i p : straight_line(*a, *b))
            if (mask(p.x, p.y)) raster(p.x, p.y) = 1;
    }
    for (std::size_t s = 0; s < sites.points.size(); ++s)
        if (sites.visits[s].size() > 1 && neck_residual(sites.visits[s], sites.lengths) >= threshold)
            raster(sites.points[s].x, sites.points[s].y) = 1;
    return raster;
}

} // namespace pantin
