// SPDX-License-Identifier: MIT
// The thesis's mapping of end-effectors (4.6, Algorithms 4.2 and 4.3, Eq. 4.8 to 4.14): every path by trying
// all, the bijection by a plain table, the assignment by trying all.
#include <algorithm>
#include <cmath>
#include <functional>

#include "pantin/reference.hpp"
#include "replay/stored.hpp"

namespace pantin::test::replay {
namespace {

struct Shape {
    std::vector<Point2d> places;
    std::vector<Edge> edges;
    Grid<double> depth;
    double mean_depth = 1;
    std::vector<int> ends; // clockwise
};

void finish(Shape& shape, const Mask& mask) {
    shape.depth = depths_of(mask);
    double sum = 0, count = 0;
    for (const double d : shape.depth) sum += d, count += d > 0;
    shape.mean_depth = sum / count;
    Point2d centre;
    for (int v = 0; v < std::ssize(shape.places); ++v) {
        int degree = 0;
        for (const Edge& e : shape.edges) degree += e.u == v || e.v == v;
        if (degree != 1) continue;
        shape.ends.push_back(v);
        centre = centre + shape.places[v];
    }
    centre = (1.0 / static_cast<double>(std::max<std::size_t>(1, shape.ends.size()))) * centre;
    const auto key = [&](int v) {
        const Point2d d = shape.places[v] - centre;
        return std::tuple(std::atan2(d.y, d.x), length(d), v);
    };
    std::sort(shape.ends.begin(), shape.ends.end(), [&](int u, int v) { return key(u) < key(v); });
}

Shape drawn(const Stored& s) {
    Shape shape;
    for (const Vertex& v : s.graph.vertices) shape.places.push_back({v.x, v.y});
    shape.edges = s.graph.edges;
    Mask mask(s.width, s.height);
    for (std::size_t i = 0; i < mask.size(); ++i) mask.data()[i] = s.labels.data()[i] != 0;
    finish(shape, mask);
    return shape;
}

double round_up(double x) { return std::floor(x + 0.5); }

// 321 pixels with a margin of 40: along every edge a disc at each half pixel, its radius between those of the
// two nodes.
Shape modelled(const ReferenceSkeleton& reference) {
    Shape shape;
    Mask mask(321, 321);
    std::vector<Point2d> exact;
    for (const ReferenceNode& n : reference.nodes) {
        exact.push_back({40 + 240 * n.x, 40 + 240 * n.y});
        shape.places.push_back({round_up(exact.back().x), round_up(exact.back().y)});
    }
    for (const auto& [u, v] : reference.edges) {
        const Point2d way = exact[v] - exact[u];
        const double r = 240 * reference.nodes[u].r, q = 240 * reference.nodes[v].r;
        const int discs = std::max(1, static_cast<int>(std::ceil(2 * length(way))));
        for (int k = 0; k <= discs; ++k) {
            const double t = static_cast<double>(k) / discs, radius = r + t * (q - r);
            const Point2d c = exact[u] + t * way;
            for (int y = 0; y < 321; ++y)
                for (int x = 0; std::abs(y - c.y) <= radius && x < 321; ++x)
                    if ((x - c.x) * (x - c.x) + (y - c.y) * (y - c.y) <= radius * radius) mask(x, y) = 1;
        }
        Edge edge{u, v, 0, {}};
        const int steps =
            std::max(1, static_cast<int>(std::ceil(std::max(std::abs(way.x), std::abs(way.y)))));
        for (int k = 0; k <= steps; ++k) {
            const Point2d p = exact[u] + (static_cast<double>(k) / steps) * way;
            edge.pixels.push_back({static_cast<int>(round_up(p.x)), static_cast<int>(round_up(p.y))});
            if (k > 0) edge.length += distance(to_double(edge.pixels[k - 1]), to_double(edge.pixels[k]));
        }
        shape.edges.push_back(edge);
    }
    finish(shape, mask);
    return shape;
}

// The edges of the shortest way without a vertex twice; of all of them where a cycle has two sides of one
// length, which the thesis leaves open (ERRATA 15).
std::vector<std::vector<int>> shortest_ways(const Shape& shape, int from, int to) {
    constexpr double equal = 1e-9;
    std::vector<std::vector<int>> best;
    std::vector<int> way;
    std::vector<bool> seen(shape.places.size(), false);
    double shortest = 1e300;
    const std::function<void(int, double)> go = [&](int at, double length) {
        if (length > shortest + equal) return;
        if (at == to) {
            if (length < shortest - equal) best.clear();
            shortest = std::min(shortest, length);
            best.push_back(way);
            return;
        }
        seen[at] = true;
        for (int e = 0; e < std::ssize(shape.edges); ++e) {
            const Edge& edge = shape.edges[e];
            if (edge.u != at && edge.v != at) continue;
            const int next = edge.u == at ? edge.v : edge.u;
            if (seen[next]) continue;
            way.push_back(e);
            go(next, length + edge.length);
            way.pop_back();
        }
        seen[at] = false;
    };
    go(from, 0);
    return best;
}

std::vector<Point2d> places_along(const Shape& shape, const std::vector<int>& way, int from, int to) {
    std::vector<Point2d> places = {shape.places[from]};
    for (int at = from; const int e : way) {
        std::vector<Point2i> pixels = shape.edges[e].pixels;
        if (shape.edges[e].v == at) std::reverse(pixels.begin(), pixels.end());
        for (const Point2i p : pixels) places.push_back(to_double(p));
        at = shape.edges[e].u == at ? shape.edges[e].v : shape.edges[e].u;
    }
    places.push_back(shape.places[to]);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

struct Samples {
    std::vector<double> radii; // 50, over the mean (Eq. 4.8, ERRATA 14)
    double length = 0;         // pixels
};

Samples sample(const Shape& shape, const std::vector<Point2d>& places) {
    Samples samples;
    for (std::size_t k = 1; k < places.size(); ++k) samples.length += distance(places[k - 1], places[k]);
    for (int i = 0; i < 50; ++i) {
        if (places.empty()) {
            samples.radii.push_back(0);
            continue;
        }
        double left = samples.length * i / 49;
        std::size_t k = 0;
        while (k + 2 < places.size() && left > distance(places[k], places[k + 1]))
            left -= distance(places[k], places[k + 1]), ++k;
        const double step = distance(places[k], places[k + 1]);
        const Point2d p = places[k] + std::min(1.0, left / step) * (places[k + 1] - places[k]);
        const int x = std::clamp(static_cast<int>(round_up(p.x)), 0, shape.depth.width() - 1),
                  y = std::clamp(static_cast<int>(round_up(p.y)), 0, shape.depth.height() - 1);
        samples.radii.push_back(shape.depth(x, y) / shape.mean_depth);
    }
    return samples;
}

double part(double a, double b) { return a + b > 0 ? (a - b) * (a - b) / (a + b) : 0; }

double path_distance_of(const Samples& a, const Samples& b) { // Eq. 4.9
    double sum = 0.1 * part(a.length, b.length);
    for (std::size_t i = 0; i < a.radii.size(); ++i) sum += part(a.radii[i], b.radii[i]);
    return sum;
}

// Rows and columns from (i, j) on: the cheapest of skipping a row (κ, Eq. 4.13), skipping a column, matching.
double bijection(const std::vector<std::vector<double>>& costs) {
    const std::size_t n = costs.size(), m = n == 0 ? 0 : costs[0].size();
    if (m == 0) return 0;
    double mean = 0, variance = 0;
    for (const auto& row : costs) mean += *std::min_element(row.begin(), row.end()) / static_cast<double>(n);
    for (const auto& row : costs)
        variance += std::pow(*std::min_element(row.begin(), row.end()) - mean, 2) / static_cast<double>(n);
    const double kappa = mean + std::sqrt(variance);
    std::vector<std::vector<double>> best(n + 1, std::vector<double>(m + 1, 0));
    for (std::size_t i = n; i-- > 0;) {
        best[i][m] = best[i + 1][m] + kappa;
        for (std::size_t j = m; j-- > 0;)
            best[i][j] = std::min({best[i + 1][j] + kappa, best[i][j + 1], best[i + 1][j + 1] + costs[i][j]});
    }
    return best[0][0];
}

using Paths = std::vector<Samples>; // from one end to the others, clockwise

// Of end number i; one for each choice among equally long ways.
std::vector<Paths> paths_from(const Shape& shape, std::size_t i) {
    const std::size_t n = shape.ends.size();
    std::vector<Paths> choices = {{}};
    for (std::size_t k = 1; k < n; ++k) {
        const int from = shape.ends[i], to = shape.ends[(i + k) % n];
        std::vector<Samples> alternatives;
        for (const std::vector<int>& way : shortest_ways(shape, from, to))
            alternatives.push_back(sample(shape, places_along(shape, way, from, to)));
        if (alternatives.empty()) alternatives.push_back(sample(shape, {})); // no way
        std::vector<Paths> longer;
        for (const Paths& choice : choices)
            for (const Samples& alternative : alternatives) {
                longer.push_back(choice);
                longer.back().push_back(alternative);
            }
        choices = std::move(longer);
    }
    return choices;
}

std::vector<std::vector<Paths>> all_paths(const Shape& shape) {
    std::vector<std::vector<Paths>> paths;
    for (std::size_t i = 0; i < shape.ends.size(); ++i) paths.push_back(paths_from(shape, i));
    return paths;
}

// Whether some choice of the ways costs that.
bool is_cost(double cost, const std::vector<Paths>& a, const std::vector<Paths>& b) {
    for (const Paths& from : a)
        for (const Paths& to : b) {
            std::vector<std::vector<double>> distances;
            for (const Samples& p : from) {
                std::vector<double>& row = distances.emplace_back();
                for (const Samples& q : to) row.push_back(path_distance_of(p, q));
            }
            if (std::abs(bijection(distances) - cost) < 1e-6) return true;
        }
    return false;
}

// The least sum of costs where the shorter side is assigned completely.
double cheapest_assignment(const std::vector<std::vector<double>>& costs) {
    const std::size_t n = costs.size(), m = costs[0].size();
    std::vector<std::vector<double>> rows(std::min(n, m), std::vector<double>(std::max(n, m)));
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < m; ++j) (n <= m ? rows[i][j] : rows[j][i]) = costs[i][j];
    double best = 1e300;
    std::vector<bool> used(rows[0].size(), false);
    const std::function<void(std::size_t, double)> go = [&](std::size_t i, double sum) {
        if (sum >= best) return;
        if (i == rows.size()) {
            best = sum;
            return;
        }
        for (std::size_t j = 0; j < used.size(); ++j) {
            if (used[j]) continue;
            used[j] = true;
            go(i + 1, sum + rows[i][j]);
            used[j] = false;
        }
    };
    go(0, 0);
    return best;
}

} // namespace

void replay_mapping(const Stored& s, Tally& tally) {
    if (!s.thesis || !s.rigged) return; // the default's costs are of its own (ERRATA 19)
    const auto references = load_references();
    const auto reference = std::find_if(references.begin(), references.end(), [&](const auto& r) {
        return r.name == s.identification["reference"];
    });
    const Shape a = drawn(s), b = modelled(*reference);
    const auto paths_a = all_paths(a), paths_b = all_paths(b);
    const auto stored = s.mapping["costs"].get<std::vector<std::vector<double>>>();
    bool costs = stored.size() == a.ends.size();
    for (std::size_t i = 0; costs && i < a.ends.size(); ++i)
        for (std::size_t j = 0; j < b.ends.size(); ++j)
            costs = costs && is_cost(stored[i].at(j), paths_a[i], paths_b[j]);
    tally.add("mapping: costs", costs);
    if (stored.empty() || stored[0].empty()) return;
    double sum = 0;
    bool entries = s.mapping["pairs"].size() == std::min(a.ends.size(), b.ends.size());
    for (const auto& pair : s.mapping["pairs"]) {
        const auto i = std::find(a.ends.begin(), a.ends.end(), pair["end"].get<int>()) - a.ends.begin();
        const auto j =
            std::find(b.ends.begin(), b.ends.end(), pair["reference_end"].get<int>()) - b.ends.begin();
        entries = entries && i < std::ssize(a.ends) && j < std::ssize(b.ends) && stored[i][j] == pair["cost"];
        sum += pair["cost"].get<double>();
    }
    tally.add("mapping: pairs are entries of the costs", entries);
    tally.add("mapping: cheapest assignment", std::abs(sum - cheapest_assignment(stored)) < 1e-9);
}

} // namespace pantin::test::replay
