// SPDX-License-Identifier: MIT
// Shortest paths on skeleton graphs: lengths, ties, several starts.
#include <catch2/catch.hpp>

#include <cmath>

#include "rigging/shortest_paths.hpp"

using namespace pantin;

namespace {

// A square of four vertices with sides of 2, and one vertex apart.
SkeletonGraph square() {
    SkeletonGraph graph;
    graph.vertices.resize(5);
    graph.edges = {{0, 1, 2, {}}, {0, 3, 2, {}}, {1, 2, 2, {}}, {2, 3, 2, {}}};
    return graph;
}

} // namespace

TEST_CASE("of equally long paths the one through the lower vertex counts") {
    const ShortestPaths paths = shortest_paths(square(), 0);
    CHECK(paths.order == std::vector<int>{0, 1, 3, 2});
    CHECK(paths.edge == std::vector<int>{-1, 0, 2, 1, -1});
    CHECK(paths.length[2] == 4);
    CHECK(std::isinf(paths.length[4]));
}

TEST_CASE("a path comes from the start that is nearest, with what lies behind it") {
    const ShortestPaths paths = shortest_paths(square(), {1, 1, 1, 1}, {{0, 2.5}, {2, 1}});
    CHECK(paths.length == std::vector<double>{2.5, 2, 1, 2, INFINITY});
    CHECK(paths.edge == std::vector<int>{-1, 2, -1, 3, -1});
}
