// SPDX-License-Identifier: MIT
// Hand-made characters for the tests of rigging and animation.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "pantin/animation.hpp"
#include "pantin/rigging.hpp"

namespace pantin::tests {

inline void fill(LabelMap& labels, int x0, int y0, int x1, int y1, Label label) {
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) labels(x, y) = static_cast<std::uint8_t>(label);
}

inline SkeletonEdge straight_edge(const SkeletonGraph& graph, int u, int v) {
    SkeletonEdge edge{u, v, 0, {}};
    const SkeletonVertex &a = graph.vertices[u], &b = graph.vertices[v];
    const int n =
        std::max(1, static_cast<int>(std::rint(std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)))));
    for (int i = 0; i <= n; ++i)
        edge.pixels.push_back({static_cast<int>(std::rint(a.x + (b.x - a.x) * i / n)),
                               static_cast<int>(std::rint(a.y + (b.y - a.y) * i / n))});
    for (std::size_t i = 1; i < edge.pixels.size(); ++i)
        edge.length += distance(to_double(edge.pixels[i - 1]), to_double(edge.pixels[i]));
    return edge;
}

struct Character {
    LabelMap labels;
    SkeletonGraph graph;
    ReferenceSkeleton reference;
    Mapping mapping;
};

// A table: body 20…100 × 30…50, four legs of width 8 down to y = 90, a tail to the right, a head to the left.
// Vertices: 0 head, 1 tail, 2…5 feet, 6…9 junctions on the body's axis above the legs.
inline Character table() {
    Character c;
    c.labels = LabelMap(128, 100);
    fill(c.labels, 20, 30, 100, 50, Label::body);
    fill(c.labels, 4, 28, 20, 52, Label::head);
    fill(c.labels, 100, 36, 122, 44, Label::tail);
    const int legs[4] = {24, 44, 68, 88};
    for (int x : legs) fill(c.labels, x, 50, x + 8, 90, Label::limb);
    c.graph.width = 128, c.graph.height = 100;
    c.graph.vertices = {{9, 40, Label::head, true}, {118, 40, Label::tail, true}};
    for (int x : legs) c.graph.vertices.push_back({x + 4.0, 86, Label::limb, true});
    for (int x : legs) c.graph.vertices.push_back({x + 4.0, 40, Label::body, false});
    for (const auto& [u, v] :
         {std::pair{0, 6}, {6, 7}, {7, 8}, {8, 9}, {1, 9}, {2, 6}, {3, 7}, {4, 8}, {5, 9}})
        c.graph.edges.push_back(straight_edge(c.graph, u, v));
    c.reference = load_references()[1];
    const auto node = [&](const char* name) {
        for (std::size_t n = 0; n < c.reference.nodes.size(); ++n)
            if (c.reference.nodes[n].name == name) return static_cast<int>(n);
        return -1;
    };
    const char* names[6] = {"head",          "tail",          "leg_front_left", "leg_front_right",
                            "leg_hind_left", "leg_hind_right"};
    for (int end = 0; end < 6; ++end) c.mapping.pairs.push_back({end, node(names[end]), 0});
    return c;
}

inline Rig rig_of(const Character& c, const RigOptions& options = {}) {
    return rig_with_mapping(c.graph, c.labels, c.reference, false, c.mapping, options);
}

inline int bone_named(const Rig& rig, const std::string& name) {
    for (std::size_t b = 0; b < rig.bones.size(); ++b)
        if (rig.bones[b].name == name) return static_cast<int>(b);
    return -1;
}

} // namespace pantin::tests
