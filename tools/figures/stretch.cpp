// SPDX-License-Identifier: MIT
// A rig and a clip in, the stretch of its edges out, as numbers and as a picture.
#include "figures/stretch.hpp"

#include <algorithm>

#include "figures/palette.hpp"
#include "figures/panel.hpp"
#include "rigging/mesh_topology.hpp"

namespace pantin::figures {
namespace {

constexpr double negligible = 0.01; // of the mean length at rest

// The edges that are long enough to be seen, and their lengths at rest in world units.
struct Edges {
    std::vector<std::pair<int, int>> ends;
    std::vector<double> lengths;
};

Edges edges_at_rest(const Rig& rig) {
    std::vector<Vec3> rest;
    for (std::size_t v = 0; v < rig.mesh.vertices.size(); ++v)
        rest.push_back(to_world(rig.mesh.vertices[v], rig.width, rig.height, rig.depth[v]));
    Edges all, kept;
    all.ends = edges_of(rig.mesh);
    double mean = 0;
    for (const auto& [u, v] : all.ends) {
        all.lengths.push_back(distance(rest[u], rest[v]));
        mean += all.lengths.back() / static_cast<double>(all.ends.size());
    }
    for (std::size_t i = 0; i < all.ends.size(); ++i)
        if (all.lengths[i] >= negligible * mean)
            kept.ends.push_back(all.ends[i]), kept.lengths.push_back(all.lengths[i]);
    return kept;
}

} // namespace

Stretch stretch_of(const Rig& rig, const BoneAnimation& animation) {
    const Edges edges = edges_at_rest(rig);
    Stretch stretch;
    for (const double time : animation.times) {
        const std::vector<Vec3> posed = skin(rig, animation, time);
        for (std::size_t i = 0; i < edges.ends.size(); ++i) {
            const auto& [u, v] = edges.ends[i];
            const double ratio = distance(posed[u], posed[v]) / edges.lengths[i];
            if (ratio > stretch.largest) stretch = {ratio, time};
        }
    }
    return stretch;
}

void draw_stretched(Svg& svg, Rectangle place, const Rig& rig, const BoneAnimation& animation, double time,
                    double limit) {
    const std::vector<Vec3> posed = skin(rig, animation, time);
    const View view = view_of(rig, {animation});
    Panel panel(svg, place, {view.left, -view.bottom - view.height, view.width, view.height});
    Mesh mesh{{}, rig.mesh.faces};
    for (const Vec3& p : posed) mesh.vertices.push_back({p.x, -p.y});
    panel.mesh(mesh, outlined({228, 231, 236}, {150, 154, 162}, 0.35));
    const Edges edges = edges_at_rest(rig);
    std::vector<std::pair<Point2d, Point2d>> long_ones;
    for (std::size_t i = 0; i < edges.ends.size(); ++i) {
        const auto& [u, v] = edges.ends[i];
        if (distance(posed[u], posed[v]) > limit * edges.lengths[i])
            long_ones.push_back({mesh.vertices[u], mesh.vertices[v]});
    }
    panel.segments(long_ones, stroked(accent, 1.4));
}

} // namespace pantin::figures
