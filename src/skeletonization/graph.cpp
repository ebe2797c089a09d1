// SPDX-License-Identifier: MIT
// The graph of a one-pixel-wide skeleton (thesis 4.4): a vertex at every end and wherever lines meet, an edge
// for every chain of pixels between two vertices. In come the skeleton and its labels, out goes the graph in
// the form of graph_edit.hpp.
#include "pantin/skeletonization.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "skeletonization/graph_edit.hpp"
#include "skeletonization/neighbourhood.hpp"

namespace pantin {
namespace {

using Chain = std::vector<Point2i>;

// The graph so far. The pixels of all vertices bear the vertex's index in `vertex_at`, others −1.
struct GraphInProgress {
    std::vector<Point2i> pixels; // of the skeleton, in raster order
    SkeletonGraph graph;
    std::vector<Point2i> places; // of the vertices
    Grid<int> vertex_at;
    Mask walked; // pixels of chains that are edges already

    int& at(Point2i p) { return vertex_at(p.x, p.y); }
};

std::vector<Point2i> neighbours(const Mask& skeleton, Point2i p) {
    std::vector<Point2i> result;
    for (const Point2i d : neighbour_offsets)
        if (skeleton.value_or(p.x + d.x, p.y + d.y, 0)) result.push_back({p.x + d.x, p.y + d.y});
    return result;
}

int degree(const Mask& skeleton, Point2i p) { return neighbour_count(neighbourhood(skeleton, p.x, p.y)); }

int add_vertex(GraphInProgress& g, Point2i p, const LabelMap& labels) {
    const auto label = static_cast<Label>(labels(p.x, p.y));
    g.graph.vertices.push_back({static_cast<double>(p.x), static_cast<double>(p.y), label, false});
    g.places.push_back(p);
    return static_cast<int>(g.places.size()) - 1;
}

// --- vertices ----------------------------------------------------------------------------------------------

// The pixel nearest to the centroid of the cluster (ties: the first in raster order):
// n·|p − centroid|² compared in integers.
Point2i central_pixel(std::vector<Point2i> cluster) {
    std::sort(cluster.begin(), cluster.end(),
              [](Point2i a, Point2i b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
    const auto n = static_cast<long long>(cluster.size());
    long long sum_x = 0, sum_y = 0;
    for (const Point2i p : cluster) {
        sum_x += p.x;
        sum_y += p.y;
    }
    const auto off = [&](Point2i p) {
        const long long dx = n * p.x - sum_x, dy = n * p.y - sum_y;
        return dx * dx + dy * dy;
    };
    return *std::min_element(cluster.begin(), cluster.end(),
                             [&](Point2i a, Point2i b) { return off(a) < off(b); });
}

// Adjacent pixels with three or more neighbours are one junction, at the one nearest to their centroid.
void find_junctions(GraphInProgress& g, const Mask& skeleton, const LabelMap& labels) {
    for (const Point2i start : g.pixels) {
        if (degree(skeleton, start) < 3 || g.at(start) >= 0) continue;
        const int id = static_cast<int>(g.places.size());
        std::vector<Point2i> cluster = {start};
        g.at(start) = id;
        for (std::size_t i = 0; i < cluster.size(); ++i)
            for (const Point2i q : neighbours(skeleton, cluster[i]))
                if (degree(skeleton, q) >= 3 && g.at(q) < 0) {
                    g.at(q) = id;
                    cluster.push_back(q);
                }
        add_vertex(g, central_pixel(cluster), labels);
    }
}

// A pixel without any neighbour counts as an end, too.
void find_ends(GraphInProgress& g, const Mask& skeleton, const LabelMap& labels) {
    for (const Point2i p : g.pixels)
        if (degree(skeleton, p) <= 1) g.at(p) = add_vertex(g, p, labels);
}

// --- edges -------------------------------------------------------------------------------------------------

// The way from a pixel of a junction to the junction's place, through its pixels (breadth first).
Chain way_to_place(GraphInProgress& g, const Mask& skeleton, Point2i from) {
    const int id = g.at(from);
    std::vector<std::pair<Point2i, int>> reached = {{from, -1}}; // pixel, index of the one before
    for (std::size_t i = 0; i < reached.size(); ++i) {
        if (reached[i].first == g.places[id]) {
            Chain way;
            for (int j = static_cast<int>(i); j >= 0; j = reached[j].second) way.push_back(reached[j].first);
            std::reverse(way.begin(), way.end());
            return way;
        }
        for (const Point2i q : neighbours(skeleton, reached[i].first)) {
            const auto known = [&](const auto& r) { return r.first == q; };
            if (g.at(q) == id && std::none_of(reached.begin(), reached.end(), known))
                reached.push_back({q, static_cast<int>(i)});
        }
    }
    return {from};
}

// Adds the edge along first → … → last, where both are pixels of vertices and the rest is not.
void add_chain(GraphInProgress& g, const Mask& skeleton, const Chain& chain) {
    const int u = g.at(chain.front()), v = g.at(chain.back());
    Chain pixels = way_to_place(g, skeleton, chain.front());
    std::reverse(pixels.begin(), pixels.end());
    pixels.insert(pixels.end(), chain.begin() + 1, chain.end());
    const Chain tail = way_to_place(g, skeleton, chain.back());
    pixels.insert(pixels.end(), tail.begin() + 1, tail.end());
    g.graph.edges.push_back(make_edge(u, v, std::move(pixels)));
}

// Follows pixels with two neighbours until a vertex (or, on a loop without one, the start) is reached.
void extend(GraphInProgress& g, const Mask& skeleton, Chain& chain) {
    while (g.at(chain.back()) < 0 && !g.walked(chain.back().x, chain.back().y)) {
        g.walked(chain.back().x, chain.back().y) = 1;
        const std::vector<Point2i> around = neighbours(skeleton, chain.back());
        chain.push_back(around[0] == chain[chain.size() - 2] ? around[1] : around[0]);
    }
}

void walk_chains(GraphInProgress& g, const Mask& skeleton) {
    for (const Point2i start : g.pixels) {
        const int id = g.at(start);
        if (id < 0) continue;
        for (const Point2i first : neighbours(skeleton, start)) {
            if (g.at(first) > id) add_chain(g, skeleton, {start, first});
            if (g.at(first) >= 0 || g.walked(first.x, first.y)) continue;
            Chain chain = {start, first};
            extend(g, skeleton, chain);
            add_chain(g, skeleton, chain);
        }
    }
}

// A closed loop without end or junction gets three vertices: its first pixel in raster order and the thirds.
void walk_loops(GraphInProgress& g, const Mask& skeleton, const LabelMap& labels) {
    for (const Point2i start : g.pixels) {
        if (g.at(start) >= 0 || g.walked(start.x, start.y)) continue;
        Chain loop = {start, neighbours(skeleton, start)[0]};
        g.walked(start.x, start.y) = 1;
        extend(g, skeleton, loop);
        const int third = static_cast<int>(loop.size() - 1) / 3;
        const int a = add_vertex(g, loop[0], labels), b = add_vertex(g, loop[third], labels),
                  c = add_vertex(g, loop[2 * third], labels);
        std::vector<SkeletonEdge>& edges = g.graph.edges;
        edges.push_back(make_edge(a, b, Chain(loop.begin(), loop.begin() + third + 1)));
        edges.push_back(make_edge(b, c, Chain(loop.begin() + third, loop.begin() + 2 * third + 1)));
        edges.push_back(make_edge(c, a, Chain(loop.begin() + 2 * third, loop.end())));
    }
}

// --- a simple graph ----------------------------------------------------------------------------------------

// Splits an edge at pixels[at], which becomes a vertex.
void split(GraphInProgress& g, std::size_t edge, int at, const LabelMap& labels) {
    const SkeletonEdge whole = g.graph.edges[edge];
    const int middle = add_vertex(g, whole.pixels[at], labels);
    g.graph.edges[edge] =
        make_edge(whole.u, middle, Chain(whole.pixels.begin(), whole.pixels.begin() + at + 1));
    g.graph.edges.push_back(make_edge(middle, whole.v, Chain(whole.pixels.begin() + at, whole.pixels.end())));
}

// Around a hole two edges may join the same vertices, or one its vertex with itself. The graph stays simple
// and keeps its cycles: the longer parallel edges get a vertex in the middle, a loop gets two at its thirds.
// A loop too short for that is dropped.
void make_simple(GraphInProgress& g, const LabelMap& labels) {
    std::vector<SkeletonEdge>& edges = g.graph.edges;
    std::map<std::pair<int, int>, std::size_t> shortest;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto [found, fresh] = shortest.insert({{edges[e].u, edges[e].v}, e});
        if (!fresh && edges[e].length < edges[found->second].length) found->second = e;
    }
    const std::size_t count = edges.size();
    for (std::size_t e = 0; e < count; ++e) {
        const SkeletonEdge& edge = edges[e];
        const int last = static_cast<int>(edge.pixels.size()) - 1;
        if (edge.u == edge.v && last >= 3) {
            split(g, e, last / 3, labels);
            const std::size_t rest = edges.size() - 1;
            // The rest runs from the new vertex, which is the larger index, so its pixels are reversed.
            split(g, rest, static_cast<int>(edges[rest].pixels.size()) / 2, labels);
        } else if (edge.u != edge.v && shortest.at({edge.u, edge.v}) != e && last >= 2)
            split(g, e, last / 2, labels);
    }
    std::erase_if(edges, [](const SkeletonEdge& e) { return e.u == e.v; });
}

} // namespace

SkeletonGraph extract_graph(const Mask& skeleton, const LabelMap& labels) {
    const int width = skeleton.width(), height = skeleton.height();
    GraphInProgress g{foreground_pixels(skeleton),
                      {width, height, {}, {}},
                      {},
                      Grid<int>(width, height, -1),
                      Mask(width, height)};
    // Vertices: where lines meet, and where they end.
    find_junctions(g, skeleton, labels);
    find_ends(g, skeleton, labels);
    // Edges: the chains between them, and closed loops without any.
    walk_chains(g, skeleton);
    walk_loops(g, skeleton, labels);
    // The canonical form.
    make_simple(g, labels);
    sort_edges(g.graph);
    mark_ends(g.graph);
    return std::move(g.graph);
}

} // namespace pantin
