// SPDX-License-Identifier: MIT
// A rig and a clip in, the mesh between its limbs out, as numbers and as a picture.
#include "figures/joined_limbs.hpp"

#include <algorithm>
#include <map>

#include "figures/palette.hpp"
#include "figures/panel.hpp"
#include "rigging/mesh_topology.hpp"

namespace pantin::figures {
namespace {

constexpr double least_weight = 0.25;

// "leg_front_left.1" is a bone of "leg_front_left".
std::string limb_name(const Bone& bone) { return bone.name.substr(0, bone.name.find('.')); }

// By vertex; "" of what is of no limb.
std::vector<std::string> limbs_of(const Rig& rig) {
    std::vector<std::string> limbs;
    for (const VertexWeights& w : rig.weights) {
        std::map<std::string, double> sums;
        for (std::size_t k = 0; k < w.bones.size(); ++k)
            if (const Bone& bone = rig.bones[w.bones[k]]; bone.label == Label::limb)
                sums[limb_name(bone)] += w.weights[k];
        const auto most = std::max_element(sums.begin(), sums.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        limbs.push_back(most != sums.end() && most->second >= least_weight ? most->first : "");
    }
    return limbs;
}

std::vector<Vec3> at_rest(const Rig& rig) {
    std::vector<Vec3> rest;
    for (std::size_t v = 0; v < rig.mesh.vertices.size(); ++v)
        rest.push_back(to_world(rig.mesh.vertices[v], rig.width, rig.height, rig.depth[v]));
    return rest;
}

// About the vertices of the two limbs, and a little more.
Rectangle about(const std::vector<Point2d>& vertices, const std::vector<std::string>& limbs,
                const JoinedLimbs& joined) {
    Point2d low{1e9, 1e9}, high{-1e9, -1e9};
    for (std::size_t v = 0; v < vertices.size(); ++v)
        if (!limbs[v].empty() && (limbs[v] == joined.first || limbs[v] == joined.second))
            low = {std::min(low.x, vertices[v].x), std::min(low.y, vertices[v].y)},
            high = {std::max(high.x, vertices[v].x), std::max(high.y, vertices[v].y)};
    const double more = 0.06 * std::max(high.x - low.x, high.y - low.y);
    return {low.x - more, low.y - more, high.x - low.x + 2 * more, high.y - low.y + 2 * more};
}

} // namespace

JoinedLimbs joined_limbs_of(const Rig& rig, const BoneAnimation& animation) {
    const std::vector<std::string> limbs = limbs_of(rig);
    const std::vector<Vec3> rest = at_rest(rig);
    JoinedLimbs joined;
    for (const auto& [u, v] : edges_of(rig.mesh))
        if (!limbs[u].empty() && !limbs[v].empty() && limbs[u] != limbs[v]) joined.edges.emplace_back(u, v);
    for (const double time : animation.times) {
        const std::vector<Vec3> posed = skin(rig, animation, time);
        for (const auto& [u, v] : joined.edges)
            if (const double stretch = distance(posed[u], posed[v]) / distance(rest[u], rest[v]);
                stretch > joined.largest)
                joined.largest = stretch, joined.time = time, joined.first = limbs[u],
                joined.second = limbs[v];
    }
    return joined;
}

void draw_joined(Svg& svg, Rectangle place, const Rig& rig, const BoneAnimation& animation,
                 const JoinedLimbs& joined) {
    const std::vector<std::string> limbs = limbs_of(rig);
    std::vector<Point2d> vertices;
    for (const Vec3& p : skin(rig, animation, joined.time)) vertices.push_back({p.x, -p.y});
    Panel panel(svg, place, about(vertices, limbs, joined));
    Mesh others{vertices, {}}, first = others, second = others;
    for (const std::vector<int>& face : rig.mesh.faces) {
        const auto has = [&](const std::string& limb) {
            return std::all_of(face.begin(), face.end(), [&](int v) { return limbs[v] == limb; });
        };
        (has(joined.first) ? first : has(joined.second) ? second : others).faces.push_back(face);
    }
    std::vector<std::pair<Point2d, Point2d>> between;
    for (const auto& [u, v] : joined.edges) between.push_back({vertices[u], vertices[v]});
    svg.begin_clip(panel.frame());
    panel.mesh(others, outlined({238, 240, 244}, faint, 0.5));
    panel.mesh(first, outlined(pale(part_colour(Label::limb)), faint, 0.5));
    panel.mesh(second, outlined(mixed(part_colour(Label::limb), paper, 0.35), faint, 0.5));
    panel.segments(between, stroked(accent, 1.6));
    svg.end_clip();
    panel.border();
}

} // namespace pantin::figures
