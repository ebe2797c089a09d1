// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>

#include "shapes.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

SkeletonGraph graph_of(const std::vector<std::string>& rows, Label label = Label::body) {
    const Mask mask = picture(rows);
    return extract_graph(mask, all_of(mask, label));
}

// Canonical form: sorted, simple, ends marked, chains of 8-neighbours from vertex to vertex.
void check_canonical(const SkeletonGraph& graph) {
    std::vector<int> degree(graph.vertices.size(), 0);
    std::set<std::pair<int, int>> seen;
    std::pair<int, int> before = {-1, -1};
    for (const SkeletonEdge& edge : graph.edges) {
        REQUIRE(edge.u < edge.v);
        REQUIRE(std::pair(edge.u, edge.v) > before);
        before = {edge.u, edge.v};
        ++degree[edge.u];
        ++degree[edge.v];
        const auto rounded = [&](int i) {
            const SkeletonVertex& v = graph.vertices[i];
            return Point2i{static_cast<int>(std::floor(v.x + 0.5)), static_cast<int>(std::floor(v.y + 0.5))};
        };
        REQUIRE(edge.pixels.front() == rounded(edge.u));
        REQUIRE(edge.pixels.back() == rounded(edge.v));
        double sum = 0;
        for (std::size_t i = 1; i < edge.pixels.size(); ++i) {
            const Point2i a = edge.pixels[i - 1], b = edge.pixels[i];
            REQUIRE(std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) == 1);
            sum += distance(to_double(a), to_double(b));
        }
        REQUIRE(edge.length == Approx(sum));
    }
    for (std::size_t i = 0; i < degree.size(); ++i) REQUIRE(graph.vertices[i].end == (degree[i] == 1));
}

SkeletonGraph tree(const std::vector<Label>& labels, const std::vector<std::pair<int, int>>& edges) {
    SkeletonGraph graph;
    graph.width = graph.height = 200;
    std::vector<int> degree(labels.size(), 0);
    for (const auto& [u, v] : edges) {
        graph.edges.push_back({u, v, 0, {}});
        ++degree[u];
        ++degree[v];
    }
    for (std::size_t i = 0; i < labels.size(); ++i)
        graph.vertices.push_back({20.0 * static_cast<double>(i), 10, labels[i], degree[i] == 1});
    return graph;
}

std::vector<Label> labels_of(const SkeletonGraph& graph) {
    std::vector<Label> labels;
    for (const SkeletonVertex& v : graph.vertices) labels.push_back(v.label);
    return labels;
}

constexpr Label H = Label::head, B = Label::body, L = Label::limb, T = Label::tail;

} // namespace

TEST_CASE("graph of a line: two ends and the chain between them") {
    const SkeletonGraph graph = graph_of({"#....", ".###.", "....#"});
    REQUIRE(graph.vertices.size() == 2);
    REQUIRE(graph.edges.size() == 1);
    CHECK(graph.vertices[0] == SkeletonVertex{0, 0, B, true});
    CHECK(graph.vertices[1] == SkeletonVertex{4, 2, B, true});
    CHECK(graph.edges[0].pixels == std::vector<Point2i>{{0, 0}, {1, 1}, {2, 1}, {3, 1}, {4, 2}});
    CHECK(graph.edges[0].length == Approx(2 + 2 * std::sqrt(2.0)));
}

TEST_CASE("graph of a cross: the adjacent pixels of a crossing are one junction") {
    const SkeletonGraph graph = graph_of({
        "...#...",
        "...#...",
        "...#...",
        "#######",
        "...#...",
        "...#...",
        "...#...",
    });
    REQUIRE(graph.vertices.size() == 5);
    CHECK(graph.vertices[0] == SkeletonVertex{3, 3, B, false});
    REQUIRE(graph.edges.size() == 4);
    for (const SkeletonEdge& edge : graph.edges) {
        CHECK(edge.u == 0);
        CHECK(edge.length == 3);
    }
    check_canonical(graph);
}

TEST_CASE("labels of vertices are those of the pixels below") {
    const Mask mask = picture({"#######"});
    LabelMap labels(7, 1, 0);
    for (int x = 0; x < 7; ++x) labels(x, 0) = x < 3 ? 1 : 4;
    CHECK(labels_of(extract_graph(mask, labels)) == std::vector<Label>{H, T});
}

TEST_CASE("graph of degenerate skeletons: nothing, a pixel, two pixels") {
    CHECK(graph_of({"...", "..."}).vertices.empty());
    const SkeletonGraph one = graph_of({"...", ".#."});
    REQUIRE(one.vertices.size() == 1);
    CHECK_FALSE(one.vertices[0].end);
    const SkeletonGraph two = graph_of({"#.", ".#"});
    CHECK(two.vertices.size() == 2);
    REQUIRE(two.edges.size() == 1);
    CHECK(two.edges[0].pixels.size() == 2);
}

TEST_CASE("a closed loop without junction becomes a triangle") {
    const SkeletonGraph graph = graph_of({
        "..####..",
        ".#....#.",
        "#......#",
        "#......#",
        ".#....#.",
        "..####..",
    });
    CHECK(graph.vertices.size() == 3);
    CHECK(graph.edges.size() == 3);
    CHECK(cycles(graph) == 1);
    check_canonical(graph);
    double length = 0;
    for (const SkeletonEdge& edge : graph.edges) length += edge.length;
    CHECK(length == Approx(8 + 8 * std::sqrt(2.0)));
}

TEST_CASE("lassos and parallel chains keep their cycle in a simple graph") {
    const SkeletonGraph lasso = graph_of({
        ".......###..",
        "......#...#.",
        "######.....#",
        "......#...#.",
        ".......###..",
    });
    CHECK(cycles(lasso) == 1);
    CHECK(graph_components(lasso) == 1);
    check_canonical(lasso);
    const SkeletonGraph eye = graph_of({
        ".....####.....",
        "....#....#....",
        "####......####",
        "....#....#....",
        ".....####.....",
    });
    CHECK(cycles(eye) == 1);
    CHECK(eye.vertices.size() == 5); // two ends, two junctions, the middle of the second way
    check_canonical(eye);
}

TEST_CASE("graphs of random skeletons are canonical and have their cycles and components") {
    Random random(21);
    int many = 0;
    for (int round = 0; round < 150; ++round) {
        const Mask mask = random_blob(random, random.integer(16, 60));
        const Mask skeleton = remove_redundant_pixels(zhang_suen(mask));
        const SkeletonGraph graph = extract_graph(skeleton, all_of(mask, L));
        check_canonical(graph);
        const CountedTopology expected = topology(skeleton);
        REQUIRE(graph_components(graph) == expected.components);
        REQUIRE(cycles(graph) <= expected.holes); // a hole of a few pixels may lie inside a junction
        many += cycles(graph) == expected.holes;
        const SkeletonGraph merged = apply_h2(apply_h1(graph), 5);
        check_canonical(merged);
        REQUIRE(graph_components(merged) == expected.components);
    }
    CHECK(many > 130);
}

TEST_CASE("H1 removes ends of head and body beside their like, again and again") {
    // body – body – limb, with a side branch of two body vertices: it goes in two rounds.
    const SkeletonGraph graph = tree({L, B, B, B, B, T}, {{0, 1}, {1, 2}, {1, 5}, {2, 3}, {3, 4}});
    CHECK(labels_of(apply_h1(graph)) == std::vector<Label>{L, B, T});
    // Limbs, tails and wings keep their ends; the only head stays, because its neighbour is body.
    const SkeletonGraph kept = tree({H, B, L, L, T, T}, {{0, 1}, {1, 2}, {1, 4}, {2, 3}, {4, 5}});
    CHECK(apply_h1(kept) == kept);
    // A figure of one part shrinks to one vertex, not to none.
    CHECK(labels_of(apply_h1(tree({H, H}, {{0, 1}}))) == std::vector<Label>{H});
    CHECK(apply_h1(tree({B, B, B, B}, {{0, 1}, {1, 2}, {2, 3}})).vertices.size() == 1);
}

TEST_CASE("H2 puts a vertex in the middle, or nearer to what has more edges or stands for more vertices") {
    SkeletonGraph graph = tree({B, B, B, L, L}, {{0, 1}, {1, 2}, {0, 3}, {0, 4}});
    graph.vertices[0].x = 10, graph.vertices[1].x = 12, graph.vertices[2].x = 17;
    graph.vertices[3].x = 100, graph.vertices[4].x = 140;
    const auto place = [&](MergeWeighting weighting) {
        const SkeletonGraph merged = apply_h2(graph, 8, weighting);
        REQUIRE(merged.vertices.size() == 3);
        check_canonical(merged);
        return merged.vertices[0].x;
    };
    CHECK(place(MergeWeighting::equal) == 14);            // 11, then half way to 17
    CHECK(place(MergeWeighting::edges) == Approx(12.35)); // 3 : 2 edges make 10.8, then 3 : 1
    CHECK(place(MergeWeighting::vertices) == Approx(13)); // the mean of 10, 12 and 17
    CHECK(apply_h2(graph, 8) == apply_h2(graph, 8, MergeWeighting::equal));
}

TEST_CASE("H2 merges the closest vertices of one type first, adjacent or not") {
    SkeletonGraph graph = tree({B, B, B, L, L}, {{0, 1}, {1, 2}, {0, 3}, {2, 4}});
    graph.vertices[0].x = 10, graph.vertices[1].x = 14, graph.vertices[2].x = 17;
    graph.vertices[3] = {100, 20, L, true};
    graph.vertices[4] = {102, 20, L, true};
    // 3–4 (distance 2), then 1–2 (3) to 15.5; 0 stays, 5.5 away. The two limbs close a cycle.
    const SkeletonGraph merged = apply_h2(graph, 5);
    REQUIRE(merged.vertices.size() == 3);
    CHECK(merged.vertices[0] == SkeletonVertex{10, 10, B, false});
    CHECK(merged.vertices[1] == SkeletonVertex{15.5, 10, B, false});
    CHECK(merged.vertices[2] == SkeletonVertex{101, 20, L, false});
    CHECK(cycles(merged) == 1);
    // Closer than ε, not at ε; and other types never.
    CHECK(apply_h2(graph, 2).vertices.size() == 5);
    graph.vertices[1].label = H;
    CHECK(apply_h2(graph, 4).vertices.size() == 4);
    check_canonical(merged);
}
