// SPDX-License-Identifier: MIT
// The Voronoi diagram of the border's pixels, one cell after the other (every other site cuts a half plane
// off), its residuals by walking along the borders (thesis 3.4, ERRATA 1), and the raster (thesis 4.4).
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "replay/stored.hpp"

namespace pantin::test::replay {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double short_edge = 1e-6; // four sites on one circle: whether such an edge exists is rounding

struct Site {
    Point2i pixel;
    std::vector<std::pair<int, double>> visits; // border, way along it
};
struct Borders {
    std::vector<Site> sites;     // in the order of the first visit
    std::vector<double> lengths; // all around
};

Borders walk(const Stored& s) {
    Borders result;
    Grid<int> index(s.width, s.height, -1);
    for (std::size_t b = 0; b < s.borders.size(); ++b) {
        const std::vector<Point2i>& points = s.borders[b];
        double way = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            int& site = index(points[i].x, points[i].y);
            if (site < 0)
                site = static_cast<int>(result.sites.size()), result.sites.push_back({points[i], {}});
            result.sites[site].visits.emplace_back(b, way);
            way += distance(to_double(points[i]), to_double(points[(i + 1) % points.size()]));
        }
        result.lengths.push_back(way);
    }
    return result;
}

// The shorter way along a border between two visits.
double way_between(const Borders& borders, std::pair<int, double> a, std::pair<int, double> b) {
    if (a.first != b.first) return infinity;
    const double forth = std::abs(a.second - b.second);
    return std::min(forth, borders.lengths[a.first] - forth);
}

double residual(const Borders& borders, int a, int b, bool arc) {
    double way = infinity;
    for (const auto& u : borders.sites[a].visits)
        for (const auto& v : borders.sites[b].visits) way = std::min(way, way_between(borders, u, v));
    const Point2d p = to_double(borders.sites[a].pixel), q = to_double(borders.sites[b].pixel);
    return arc ? way : way - distance(p, q);
}

// A corner of a cell, and the site behind the side that leads from it to the next one (−1: the frame).
struct Corner {
    Point2d at;
    int behind = -1;
};

void cut(std::vector<Corner>& cell, Point2d site, Point2d other, int index) {
    const Point2d middle = 0.5 * (site + other), normal = other - site;
    const auto beyond = [&](Point2d p) { return dot(p - middle, normal); }; // > 0: nearer to the other
    std::vector<Corner> left;
    for (std::size_t i = 0; i < cell.size(); ++i) {
        const Corner &a = cell[i], &b = cell[(i + 1) % cell.size()];
        const double fa = beyond(a.at), fb = beyond(b.at);
        if (fa <= 0) left.push_back(a);
        if (fa <= 0 && fb > 0) left.push_back({a.at + (fa / (fa - fb)) * (b.at - a.at), index});
        if (fa > 0 && fb <= 0) left.push_back({a.at + (fa / (fa - fb)) * (b.at - a.at), a.behind});
    }
    cell = std::move(left);
}

std::vector<Corner> cell_of(const Stored& s, const std::vector<Site>& sites, int index) {
    const Point2d site = to_double(sites[index].pixel);
    const double w = s.width + 10, h = s.height + 10;
    std::vector<Corner> cell = {{{-10, -10}, -1}, {{w, -10}, -1}, {{w, h}, -1}, {{-10, h}, -1}};
    std::vector<std::pair<double, int>> others;
    for (int i = 0; i < std::ssize(sites); ++i)
        if (i != index) others.emplace_back(distance(site, to_double(sites[i].pixel)), i);
    std::sort(others.begin(), others.end());
    for (const auto& [far, other] : others) {
        double reach = 0;
        for (const Corner& c : cell) reach = std::max(reach, distance(site, c.at));
        if (far > 2 * reach + 1) break; // what follows is too far away to cut
        cut(cell, site, to_double(sites[other].pixel), other);
    }
    return cell;
}

using Segment = std::pair<Point2d, Point2d>;
using Edges = std::map<std::pair<int, int>, Segment>;

Edges edges_of(const Stored& s, const std::vector<Site>& sites) {
    Edges edges;
    for (int i = 0; i < std::ssize(sites); ++i) {
        const std::vector<Corner> cell = cell_of(s, sites, i);
        for (std::size_t k = 0; k < cell.size(); ++k) {
            const Point2d a = cell[k].at, b = cell[(k + 1) % cell.size()].at;
            if (cell[k].behind > i && distance(a, b) > short_edge) edges[{i, cell[k].behind}] = {a, b};
        }
    }
    return edges;
}

std::optional<Point2i> pixel_in(const Mask& mask, Point2d p) {
    const int x = static_cast<int>(std::floor(p.x + 0.5)), y = static_cast<int>(std::floor(p.y + 0.5));
    if (mask.value_or(x, y, 0) == 0) return std::nullopt;
    return Point2i{x, y};
}

// 1: in a pixel of the mask; 0: in none; −1: rounding decides.
int inside(const Mask& mask, Point2d p) {
    int count = 0;
    for (const double dx : {-1e-7, 1e-7})
        for (const double dy : {-1e-7, 1e-7}) count += pixel_in(mask, {p.x + dx, p.y + dy}).has_value();
    return count == 4 ? 1 : count == 0 ? 0 : -1;
}

bool same_segment(const Segment& a, const Segment& b) {
    const auto near = [](Point2d p, Point2d q) { return distance(p, q) < 1e-6; };
    return (near(a.first, b.first) && near(a.second, b.second)) ||
           (near(a.first, b.second) && near(a.second, b.first));
}

struct StoredEdge {
    Segment ends;
    int a = 0, b = 0; // sites, a < b
    double residual = 0;
};
std::vector<StoredEdge> stored_edges(const Stored& s) {
    std::vector<StoredEdge> edges;
    for (const auto& e : s.voronoi_edges) {
        const int a = e["sites"][0], b = e["sites"][1];
        edges.push_back({{{e["from"][0], e["from"][1]}, {e["to"][0], e["to"][1]}},
                         std::min(a, b),
                         std::max(a, b),
                         e["residual"].is_null() ? infinity : e["residual"].get<double>()});
    }
    return edges;
}

// Every edge with both ends in the silhouette, and no other.
bool same_diagram(const Stored& s, const Borders& borders, const std::vector<StoredEdge>& stored) {
    Edges left = edges_of(s, borders.sites);
    for (const StoredEdge& e : stored) {
        const auto ours = left.find({e.a, e.b});
        if (ours == left.end()) {
            if (distance(e.ends.first, e.ends.second) > 2 * short_edge) return false;
            continue;
        }
        if (!same_segment(ours->second, e.ends)) return false;
        if (inside(s.silhouette, ours->second.first) == 0 || inside(s.silhouette, ours->second.second) == 0)
            return false;
        left.erase(ours);
    }
    return std::none_of(left.begin(), left.end(), [&](const auto& edge) {
        return inside(s.silhouette, edge.second.first) == 1 && inside(s.silhouette, edge.second.second) == 1;
    });
}

// The line from the upper end (of equals the left one): at every step along the longer axis the pixel nearest
// to it, of two equally near ones the farther along.
void draw_line(Mask& raster, const Mask& mask, Point2i a, Point2i b) {
    if (b.y < a.y || (b.y == a.y && b.x < a.x)) std::swap(a, b);
    const int dx = std::abs(b.x - a.x), dy = std::abs(b.y - a.y), steps = std::max(dx, dy);
    const int sx = b.x < a.x ? -1 : 1;
    for (int i = 0; i <= steps; ++i) {
        const auto along = [&](int d) { return steps == 0 ? 0 : (2 * i * d + steps) / (2 * steps); };
        const int x = a.x + sx * along(dx), y = a.y + along(dy);
        if (mask(x, y)) raster(x, y) = 1;
    }
}

// Edges over the threshold, and pixels that a border passes twice with a long way between.
Mask raster_of(const Stored& s, const Borders& borders, const std::vector<StoredEdge>& edges,
               double threshold) {
    Mask raster(s.width, s.height);
    for (const StoredEdge& e : edges) {
        const auto a = pixel_in(s.silhouette, e.ends.first), b = pixel_in(s.silhouette, e.ends.second);
        if (e.residual >= threshold && a && b) draw_line(raster, s.silhouette, *a, *b);
    }
    for (const Site& site : borders.sites) {
        double neck = infinity;
        for (std::size_t i = 0; i < site.visits.size(); ++i)
            for (std::size_t j = i + 1; j < site.visits.size(); ++j)
                neck = std::min(neck, way_between(borders, site.visits[i], site.visits[j]));
        if (site.visits.size() > 1 && neck >= threshold) raster(site.pixel.x, site.pixel.y) = 1;
    }
    return raster;
}

// Without the background regions that hold no background of the silhouette.
Mask pockets_filled(Mask raster, const Mask& silhouette) {
    const Regions gaps = regions_of(raster, false, false);
    std::vector<bool> real(gaps.area.size() + 1, false);
    for (int y = 0; y < raster.height(); ++y)
        for (int x = 0; x < raster.width(); ++x) {
            const bool rim = x == 0 || y == 0 || x == raster.width() - 1 || y == raster.height() - 1;
            if (rim || !silhouette(x, y)) real[gaps.id(x, y)] = true;
        }
    for (std::size_t i = 0; i < raster.size(); ++i)
        if (!real[gaps.id.data()[i]] && !raster.data()[i]) raster.data()[i] = 1;
    return raster;
}

bool one_with_holes(const Mask& raster, int holes) {
    return regions_of(raster, true, true).area.size() == 1 && holes_of(raster) == holes;
}

bool covers(const Mask& large, const Mask& small) {
    for (std::size_t i = 0; i < large.size(); ++i)
        if (small.data()[i] && !large.data()[i]) return false;
    return true;
}

} // namespace

void replay_voronoi(const Stored& s, Tally& tally) {
    const Borders borders = walk(s);
    const std::vector<StoredEdge> edges = stored_edges(s);
    const auto known = [&](const StoredEdge& e) { return e.a >= 0 && e.b < std::ssize(borders.sites); };
    if (!std::all_of(edges.begin(), edges.end(), known))
        return tally.add("Voronoi diagram", false, "unknown site");
    tally.add("Voronoi diagram", same_diagram(s, borders, edges));
    bool residuals = true;
    for (const StoredEdge& e : edges) {
        const double ours = residual(borders, e.a, e.b, s.thesis);
        residuals = residuals && (ours == e.residual || std::abs(ours - e.residual) < 1e-9);
    }
    tally.add("residuals", residuals);

    const int holes = holes_of(s.silhouette);
    const Mask drawn = raster_of(s, borders, edges, 30 * s.scale());
    const Mask filled = pockets_filled(drawn, s.silhouette);
    tally.add("raster: connected, a cycle around every hole",
              one_with_holes(pockets_filled(s.voronoi, s.silhouette), holes) &&
                  covers(s.silhouette, s.voronoi));
    tally.add("raster: has every edge over the threshold", covers(s.voronoi, drawn));
    // The thesis adds nothing where the drawn edges hang together; the default adds branches for parts.
    if (s.thesis && one_with_holes(filled, holes)) tally.add("raster: equal", drawn == s.voronoi);
}

} // namespace pantin::test::replay
