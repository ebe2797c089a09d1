// SPDX-License-Identifier: MIT
// The graph of the skeleton's pixels (thesis 4.4), by taking junctions and ends out and flooding what is
// left, and the heuristics H1 and H2 (ERRATA 7).
#include <algorithm>
#include <cmath>
#include <set>

#include "pantin/label.hpp"
#include "replay/stored.hpp"

namespace pantin::test::replay {
namespace {

using Place = std::tuple<double, double, std::string>; // x, y, label
using Link = std::tuple<int, int, int>;                // vertices u ≤ v, pixels from place to place

Mask pixels_with(const Mask& skeleton, int low, int high) { // neighbours
    Mask result(skeleton.width(), skeleton.height());
    for (int y = 0; y < skeleton.height(); ++y)
        for (int x = 0; x < skeleton.width(); ++x) {
            int count = -1;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) count += skeleton.value_or(x + dx, y + dy, 0) != 0;
            result(x, y) = skeleton(x, y) && count >= low && count <= high;
        }
    return result;
}

std::vector<std::vector<Point2i>> pixels_by_region(const Regions& regions) {
    std::vector<std::vector<Point2i>> pixels(regions.area.size());
    for (int y = 0; y < regions.id.height(); ++y)
        for (int x = 0; x < regions.id.width(); ++x)
            if (const int id = regions.id(x, y)) pixels[id - 1].push_back({x, y});
    return pixels;
}

// The pixel nearest to the centroid; the first of equals.
Point2i central(const std::vector<Point2i>& pixels) {
    long x = 0, y = 0;
    const long n = std::ssize(pixels);
    for (const Point2i p : pixels) x += p.x, y += p.y;
    const auto off = [&](Point2i p) { return (n * p.x - x) * (n * p.x - x) + (n * p.y - y) * (n * p.y - y); };
    Point2i best = pixels[0];
    for (const Point2i p : pixels)
        if (off(p) < off(best)) best = p;
    return best;
}

bool touch(Point2i a, Point2i b) {
    return !(a == b) && std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) == 1;
}

struct Junction {
    Point2i place;
    std::vector<Point2i> pixels;
};

// Steps from the pixel to the junction's place, through its pixels.
int steps_to_place(const Junction& junction, Point2i from) {
    std::vector<Point2i> reached = {from};
    std::vector<int> steps = {0};
    for (std::size_t i = 0; i < reached.size(); ++i) {
        if (reached[i] == junction.place) return steps[i];
        for (const Point2i p : junction.pixels)
            if (touch(p, reached[i]) && std::find(reached.begin(), reached.end(), p) == reached.end())
                reached.push_back(p), steps.push_back(steps[i] + 1);
    }
    return 0;
}

struct Multigraph {
    std::vector<Junction> vertices; // junctions and ends
    std::multiset<Link> links;
    int rings = 0; // without any vertex
};

Link link_of(int u, int v, int pixels) { return {std::min(u, v), std::max(u, v), pixels}; }

// Pairs (vertex, steps from its place) that the pixel touches.
std::vector<std::pair<int, int>> touched(const Multigraph& graph, Point2i p) {
    std::vector<std::pair<int, int>> result;
    for (int v = 0; v < std::ssize(graph.vertices); ++v)
        for (const Point2i q : graph.vertices[v].pixels)
            if (touch(p, q)) result.emplace_back(v, steps_to_place(graph.vertices[v], q));
    return result;
}

Multigraph read_skeleton(const Mask& skeleton) {
    Multigraph graph;
    const Regions crossings = regions_of(pixels_with(skeleton, 3, 8), true, true);
    for (const auto& pixels : pixels_by_region(crossings))
        graph.vertices.push_back({central(pixels), pixels});
    const Mask ends = pixels_with(skeleton, 0, 1);
    for (int y = 0; y < ends.height(); ++y)
        for (int x = 0; x < ends.width(); ++x)
            if (ends(x, y)) graph.vertices.push_back({{x, y}, {{x, y}}});
    for (const auto& chain : pixels_by_region(regions_of(pixels_with(skeleton, 2, 2), true, true))) {
        std::vector<std::pair<int, int>> sides;
        for (const Point2i p : chain)
            for (const auto& side : touched(graph, p)) sides.push_back(side);
        if (sides.size() == 2)
            graph.links.insert(
                link_of(sides[0].first, sides[1].first,
                        static_cast<int>(std::ssize(chain)) + 2 + sides[0].second + sides[1].second));
        else
            ++graph.rings;
    }
    for (int v = 0; v < std::ssize(graph.vertices); ++v) // without a pixel between
        for (const Point2i p : graph.vertices[v].pixels)
            for (const auto& [u, steps] : touched(graph, p))
                if (u < v)
                    graph.links.insert(link_of(u, v, 2 + steps + steps_to_place(graph.vertices[v], p)));
    // A loop so short that nothing could be put on it is dropped.
    for (auto link = graph.links.begin(); link != graph.links.end();)
        link = std::get<0>(*link) == std::get<1>(*link) && std::get<2>(*link) < 4 ? graph.links.erase(link)
                                                                                  : std::next(link);
    return graph;
}

// The stored graph without the vertices that keep it simple (of two edges, in the middle of a chain).
std::multiset<Link> contracted(const Graph& stored, const std::vector<int>& names) {
    std::vector<Link> links;
    for (const Edge& e : stored.edges) links.push_back({e.u, e.v, static_cast<int>(e.pixels.size())});
    for (int v = 0; v < std::ssize(stored.vertices); ++v) {
        if (names[v] >= 0) continue;
        std::vector<Link> kept;
        std::vector<int> far;
        int pixels = -1; // the vertex's pixel counts once
        for (const auto& [a, b, n] : links) {
            if (a != v && b != v) {
                kept.push_back({a, b, n});
                continue;
            }
            far.push_back(a == v ? b : a);
            pixels += n;
        }
        if (far.size() != 2) return {};
        kept.push_back({far[0], far[1], pixels});
        links = kept;
    }
    std::multiset<Link> result;
    for (const auto& [a, b, n] : links) result.insert(link_of(names[a], names[b], n));
    return result;
}

std::string label_of(const Stored& s, Point2i p) {
    return std::string(label_names[static_cast<std::size_t>(nearest_label(s.labels, p.x, p.y))]);
}

bool same_raw_graph(const Stored& s, const Multigraph& ours) {
    std::vector<int> names(s.raw.vertices.size(), -1);
    std::size_t found = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Vertex& v = s.raw.vertices[i];
        const Point2i place{static_cast<int>(v.x), static_cast<int>(v.y)};
        if (v.label != label_of(s, place) || !s.skeleton(place.x, place.y)) return false;
        for (int k = 0; k < std::ssize(ours.vertices); ++k)
            if (ours.vertices[k].place == place) names[i] = k, ++found;
    }
    return found == ours.vertices.size() && contracted(s.raw, names) == ours.links;
}

// --- heuristics
// ------------------------------------------------------------------------------------------------

struct Plain {
    std::vector<Vertex> vertices;
    std::set<std::pair<int, int>> edges; // u < v
};

Plain plain(const Graph& graph) {
    Plain result{graph.vertices, {}};
    for (const Edge& e : graph.edges) result.edges.insert({e.u, e.v});
    return result;
}

// The vertices and edges, whatever their order.
std::pair<std::multiset<Place>, std::multiset<std::pair<Place, Place>>> content(const Plain& graph) {
    const auto place = [&](int v) {
        const Vertex& at = graph.vertices[v];
        return Place{std::round(at.x * 1e6), std::round(at.y * 1e6), at.label};
    };
    std::multiset<Place> vertices;
    std::multiset<std::pair<Place, Place>> edges;
    for (int v = 0; v < std::ssize(graph.vertices); ++v) vertices.insert(place(v));
    for (const auto& [u, v] : graph.edges) edges.insert(std::minmax(place(u), place(v)));
    return {vertices, edges};
}

void remove_vertex(Plain& graph, int gone) {
    graph.vertices.erase(graph.vertices.begin() + gone);
    std::set<std::pair<int, int>> edges;
    for (const auto& [u, v] : graph.edges)
        if (u != gone && v != gone) edges.insert({u - (u > gone), v - (v > gone)});
    graph.edges = edges;
}

// Ends in head or body whose neighbour has the same label go, all at once, again and again; of two that have
// only each other the first stays.
Plain h1(Plain graph) {
    for (;;) {
        std::set<int> gone;
        for (int v = 0; v < std::ssize(graph.vertices); ++v) {
            int degree = 0, other = -1;
            for (const auto& [a, b] : graph.edges)
                if (a == v || b == v) ++degree, other = a == v ? b : a;
            if (degree != 1 || graph.vertices[v].label != graph.vertices[other].label) continue;
            if (graph.vertices[v].label != "head" && graph.vertices[v].label != "body") continue;
            int other_degree = 0;
            for (const auto& [a, b] : graph.edges) other_degree += a == other || b == other;
            if (other_degree > 1 || v > other) gone.insert(v);
        }
        if (gone.empty()) return graph;
        for (auto v = gone.rbegin(); v != gone.rend(); ++v) remove_vertex(graph, *v);
    }
}

// The closest two of one label below the distance become one in the middle, again and again.
Plain h2(Plain graph, double limit) {
    for (;;) {
        int first = -1, second = -1;
        double best = limit * limit;
        for (int i = 0; i < std::ssize(graph.vertices); ++i)
            for (int j = i + 1; j < std::ssize(graph.vertices); ++j) {
                const Vertex &a = graph.vertices[i], &b = graph.vertices[j];
                const double d = (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
                if (a.label == b.label && d < best) best = d, first = i, second = j;
            }
        if (first < 0) return graph;
        graph.vertices[first].x = (graph.vertices[first].x + graph.vertices[second].x) / 2;
        graph.vertices[first].y = (graph.vertices[first].y + graph.vertices[second].y) / 2;
        std::set<std::pair<int, int>> edges;
        for (auto [u, v] : graph.edges) {
            if (u == second) u = first;
            if (v == second) v = first;
            if (u != v) edges.insert(std::minmax(u, v));
        }
        graph.edges = edges;
        remove_vertex(graph, second);
    }
}

} // namespace

void replay_graph(const Stored& s, Tally& tally) {
    const Multigraph ours = read_skeleton(s.skeleton);
    if (ours.rings == 0) tally.add("graph of the skeleton", same_raw_graph(s, ours));
    tally.add("H1", content(h1(plain(s.raw))) == content(plain(s.after_h1)));
    tally.add("H2", content(h2(plain(s.after_h1), 5 * s.scale())) == content(plain(s.graph)));
}

} // namespace pantin::test::replay
