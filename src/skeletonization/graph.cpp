// SPDX-License-Identifier: MIT
// The graph of a one-pixel-wide skeleton (thesis 4.4): a vertex at every end and wherever lines meet, an edge
// for every chain of pixels between two vertices.
#include "pantin/skeletonization.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

#include "skeletonization/graph_edit.hpp"
#include "skeletonization/neighbourhood.hpp"

namespace pantin {
namespace {

using Chain = std::vector<Point2i>;

// Adjacent pixels with three or more neighbours are one junction; its place is that of the pixel nearest to
// their centroid (ties: the first in raster order). The pixels of all vertices bear the vertex's index in
// `vertex_at`.
class GraphBuilder {
public:
    GraphBuilder(const Mask& skeleton, const LabelMap& labels)
        : skeleton_(skeleton), labels_(labels), pixels_(foreground_pixels(skeleton)),
          vertex_at_(skeleton.width(), skeleton.height(), -1), walked_(skeleton.width(), skeleton.height()) {
        graph_.width = skeleton.width();
        graph_.height = skeleton.height();
    }

    SkeletonGraph build() {
        find_junctions();
        find_ends();
        walk_chains();
        walk_loops();
        make_simple();
        sort_edges(graph_);
        mark_ends(graph_);
        return std::move(graph_);
    }

private:
    std::vector<Point2i> neighbours(Point2i p) const {
        std::vector<Point2i> result;
        for (const Point2i d : neighbour_offsets)
            if (skeleton_.value_or(p.x + d.x, p.y + d.y, 0)) result.push_back({p.x + d.x, p.y + d.y});
        return result;
    }
    int degree(Point2i p) const { return neighbour_count(neighbourhood(skeleton_, p.x, p.y)); }
    int& vertex_at(Point2i p) { return vertex_at_(p.x, p.y); }

    int add_vertex(Point2i p) {
        const auto label = static_cast<Label>(labels_(p.x, p.y));
        graph_.vertices.push_back({static_cast<double>(p.x), static_cast<double>(p.y), label, false});
        places_.push_back(p);
        return static_cast<int>(places_.size()) - 1;
    }

    void find_junctions() {
        for (const Point2i start : pixels_) {
            if (degree(start) < 3 || vertex_at(start) >= 0) continue;
            const int id = static_cast<int>(places_.size());
            std::vector<Point2i> cluster = {start};
            vertex_at(start) = id;
            for (std::size_t i = 0; i < cluster.size(); ++i)
                for (const Point2i q : neighbours(cluster[i]))
                    if (degree(q) >= 3 && vertex_at(q) < 0) {
                        vertex_at(q) = id;
                        cluster.push_back(q);
                    }
            add_vertex(central_pixel(cluster));
        }
    }

    // n·|p − centroid|² compared in integers.
    static Point2i central_pixel(std::vector<Point2i> cluster) {
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

    // A pixel without any neighbour counts as an end, too.
    void find_ends() {
        for (const Point2i p : pixels_) {
            if (degree(p) <= 1) vertex_at(p) = add_vertex(p);
        }
    }

    // The way from a pixel of a junction to the junction's place, through its pixels (breadth first).
    Chain way_to_place(Point2i from) {
        const int id = vertex_at(from);
        std::vector<std::pair<Point2i, int>> reached = {{from, -1}}; // pixel, index of the one before
        for (std::size_t i = 0; i < reached.size(); ++i) {
            if (reached[i].first == places_[id]) {
                Chain way;
                for (int j = static_cast<int>(i); j >= 0; j = reached[j].second)
                    way.push_back(reached[j].first);
                std::reverse(way.begin(), way.end());
                return way;
            }
            for (const Point2i q : neighbours(reached[i].first)) {
                const auto known = [&](const auto& r) { return r.first == q; };
                if (vertex_at(q) == id && std::none_of(reached.begin(), reached.end(), known))
                    reached.push_back({q, static_cast<int>(i)});
            }
        }
        return {from};
    }

    // Adds the edge along first → … → last, where both are pixels of vertices and the rest is not.
    void add_chain(const Chain& chain) {
        const int u = vertex_at(chain.front()), v = vertex_at(chain.back());
        Chain pixels = way_to_place(chain.front());
        std::reverse(pixels.begin(), pixels.end());
        pixels.insert(pixels.end(), chain.begin() + 1, chain.end());
        const Chain tail = way_to_place(chain.back());
        pixels.insert(pixels.end(), tail.begin() + 1, tail.end());
        graph_.edges.push_back(make_edge(u, v, std::move(pixels)));
    }

    void walk_chains() {
        for (const Point2i start : pixels_) {
            const int id = vertex_at(start);
            if (id < 0) continue;
            for (const Point2i first : neighbours(start)) {
                if (vertex_at(first) > id) add_chain({start, first});
                if (vertex_at(first) >= 0 || walked_(first.x, first.y)) continue;
                Chain chain = {start, first};
                extend(chain);
                add_chain(chain);
            }
        }
    }

    // Follows pixels with two neighbours until a vertex (or, on a loop without one, the start) is reached.
    void extend(Chain& chain) {
        while (vertex_at(chain.back()) < 0 && !walked_(chain.back().x, chain.back().y)) {
            walked_(chain.back().x, chain.back().y) = 1;
            const std::vector<Point2i> around = neighbours(chain.back());
            chain.push_back(around[0] == chain[chain.size() - 2] ? around[1] : around[0]);
        }
    }

    // A closed loop without end or junction gets three vertices: its first pixel in raster order and the
    // thirds.
    void walk_loops() {
        for (const Point2i start : pixels_) {
            if (vertex_at(start) >= 0 || walked_(start.x, start.y)) continue;
            Chain loop = {start, neighbours(start)[0]};
            walked_(start.x, start.y) = 1;
            extend(loop);
            const int third = static_cast<int>(loop.size() - 1) / 3;
            const int a = add_vertex(loop[0]), b = add_vertex(loop[third]), c = add_vertex(loop[2 * third]);
            graph_.edges.push_back(make_edge(a, b, Chain(loop.begin(), loop.begin() + third + 1)));
            graph_.edges.push_back(
                make_edge(b, c, Chain(loop.begin() + third, loop.begin() + 2 * third + 1)));
            graph_.edges.push_back(make_edge(c, a, Chain(loop.begin() + 2 * third, loop.end())));
        }
    }

    // Splits an edge at pixels[at], which becomes a vertex.
    void split(std::size_t edge, int at) {
        const SkeletonEdge whole = graph_.edges[edge];
        const int middle = add_vertex(whole.pixels[at]);
        graph_.edges[edge] =
            make_edge(whole.u, middle, Chain(whole.pixels.begin(), whole.pixels.begin() + at + 1));
        graph_.edges.push_back(
            make_edge(middle, whole.v, Chain(whole.pixels.begin() + at, whole.pixels.end())));
    }

    // Around a hole two edges may join the same vertices, or one its vertex with itself. The graph stays
    // simple and keeps its cycles: the longer parallel edges get a vertex in the middle, a loop gets two at
    // its thirds. A loop too short for that is dropped.
    void make_simple() {
        std::map<std::pair<int, int>, std::size_t> shortest;
        for (std::size_t e = 0; e < graph_.edges.size(); ++e) {
            const auto [found, fresh] = shortest.insert({{graph_.edges[e].u, graph_.edges[e].v}, e});
            if (!fresh && graph_.edges[e].length < graph_.edges[found->second].length) found->second = e;
        }
        const std::size_t count = graph_.edges.size();
        for (std::size_t e = 0; e < count; ++e) {
            const SkeletonEdge& edge = graph_.edges[e];
            const int last = static_cast<int>(edge.pixels.size()) - 1;
            if (edge.u == edge.v && last >= 3) {
                split(e, last / 3);
                const std::size_t rest = graph_.edges.size() - 1;
                // The rest runs from the new vertex, which is the larger index, so its pixels are reversed.
                split(rest, static_cast<int>(graph_.edges[rest].pixels.size()) / 2);
            } else if (edge.u != edge.v && shortest.at({edge.u, edge.v}) != e && last >= 2)
                split(e, last / 2);
        }
        std::erase_if(graph_.edges, [](const SkeletonEdge& e) { return e.u == e.v; });
    }

    const Mask& skeleton_;
    const LabelMap& labels_;
    const std::vector<Point2i> pixels_; // of the skeleton, in raster order
    SkeletonGraph graph_;
    std::vector<Point2i> places_; // of the vertices
    Grid<int> vertex_at_;
    Mask walked_;
};

} // namespace

SkeletonEdge make_edge(int u, int v, std::vector<Point2i> pixels) {
    if (u > v) {
        std::swap(u, v);
        std::reverse(pixels.begin(), pixels.end());
    }
    SkeletonEdge edge{u, v, 0, std::move(pixels)};
    long straight = 0, diagonal = 0;
    for (std::size_t i = 1; i < edge.pixels.size(); ++i) {
        const int steps = std::abs(edge.pixels[i].x - edge.pixels[i - 1].x) +
                          std::abs(edge.pixels[i].y - edge.pixels[i - 1].y);
        straight += steps == 1;
        diagonal += steps == 2;
    }
    edge.length = static_cast<double>(straight) + static_cast<double>(diagonal) * std::sqrt(2.0);
    return edge;
}

void sort_edges(SkeletonGraph& graph) {
    std::stable_sort(
        graph.edges.begin(), graph.edges.end(),
        [](const SkeletonEdge& a, const SkeletonEdge& b) { return a.u != b.u ? a.u < b.u : a.v < b.v; });
}

std::vector<int> vertex_degrees(const SkeletonGraph& graph) {
    std::vector<int> degree(graph.vertices.size(), 0);
    for (const SkeletonEdge& edge : graph.edges) {
        ++degree[edge.u];
        ++degree[edge.v];
    }
    return degree;
}

void mark_ends(SkeletonGraph& graph) {
    const std::vector<int> degree = vertex_degrees(graph);
    for (std::size_t i = 0; i < degree.size(); ++i) graph.vertices[i].end = degree[i] == 1;
}

SkeletonGraph extract_graph(const Mask& skeleton, const LabelMap& labels) {
    return GraphBuilder(skeleton, labels).build();
}

} // namespace pantin
