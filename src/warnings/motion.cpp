// SPDX-License-Identifier: MIT
// Rig, part labels and a posed clip to what is wrong with the motion: a head that hangs, limbs that stay, a
// figure that is small in its frame (docs/warnings.md). Own.
#include <algorithm>
#include <cmath>

#include "pantin/image.hpp"
#include "pantin/warnings.hpp"

namespace pantin {

namespace {

constexpr double least_piece = 0.01; // of the silhouette's area
constexpr double hardly = 0.05;      // of the piece's diagonal: no movement that one sees

using Vertices = std::vector<int>;
using Pose = std::vector<Vec3>;

// The pixel that a vertex lies on, in the map.
template <class T> T value_at(const Grid<T>& map, Point2d vertex) {
    const int x = static_cast<int>(std::rint(vertex.x)), y = static_cast<int>(std::rint(vertex.y));
    return map.value_or(x, y, T{});
}

Vertices vertices_of(const Rig& rig, const LabelMap& labels, Label label) {
    Vertices found;
    for (std::size_t v = 0; v < rig.mesh.vertices.size(); ++v)
        if (value_at(labels, rig.mesh.vertices[v]) == static_cast<std::uint8_t>(label))
            found.push_back(static_cast<int>(v));
    return found;
}

Pose at_rest(const Rig& rig) {
    Pose pose(rig.mesh.vertices.size());
    for (std::size_t v = 0; v < pose.size(); ++v)
        pose[v] = to_world(rig.mesh.vertices[v], rig.width, rig.height, rig.depth[v]);
    return pose;
}

Vec3 centre_of(const Pose& pose, const Vertices& vertices) {
    Vec3 sum;
    for (const int v : vertices) sum = sum + pose[v];
    return 1.0 / static_cast<double>(vertices.size()) * sum;
}

// The stiff motion in the plane that takes some vertices at rest nearest to where they are in a pose (least
// squares).
struct StiffMotion {
    Vec3 from, to;
    double cosine = 1, sine = 0;
    Vec3 operator()(Vec3 p) const {
        const Vec3 d = p - from;
        return {to.x + cosine * d.x - sine * d.y, to.y + sine * d.x + cosine * d.y, to.z + d.z};
    }
};

StiffMotion stiff_motion(const Pose& rest, const Pose& pose, const Vertices& vertices) {
    StiffMotion motion{centre_of(rest, vertices), centre_of(pose, vertices)};
    double dots = 0, crosses = 0;
    for (const int v : vertices) {
        const Vec3 a = rest[v] - motion.from, b = pose[v] - motion.to;
        dots += a.x * b.x + a.y * b.y;
        crosses += a.x * b.y - a.y * b.x;
    }
    const double length = std::sqrt(dots * dots + crosses * crosses);
    if (length > 0) motion.cosine = dots / length, motion.sine = crosses / length;
    return motion;
}

double diagonal_of(const Pose& pose, const Vertices& vertices) {
    Vec3 low = pose[vertices.front()], high = low;
    for (const int v : vertices) {
        low.x = std::min(low.x, pose[v].x), high.x = std::max(high.x, pose[v].x);
        low.y = std::min(low.y, pose[v].y), high.y = std::max(high.y, pose[v].y);
    }
    return distance(Vec3{low.x, low.y, 0}, Vec3{high.x, high.y, 0});
}

// Pieces of the label that are large enough to be looked at.
std::vector<Vertices> pieces_of(const Rig& rig, const LabelMap& labels, Label label) {
    Mask mask(labels.width(), labels.height());
    std::transform(labels.begin(), labels.end(), mask.begin(),
                   [&](std::uint8_t l) -> std::uint8_t { return l == static_cast<std::uint8_t>(label); });
    const Components components = connected_components(mask);
    const double least =
        least_piece * static_cast<double>(labels.size() - std::count(labels.begin(), labels.end(), 0));
    std::vector<Vertices> pieces(components.list.size());
    for (std::size_t v = 0; v < rig.mesh.vertices.size(); ++v)
        if (const int id = value_at(components.ids, rig.mesh.vertices[v]); id > 0)
            pieces[id - 1].push_back(static_cast<int>(v));
    for (const Component& c : components.list)
        if (c.area < least) pieces[c.id - 1].clear();
    std::erase_if(pieces, [](const Vertices& piece) { return piece.empty(); });
    return pieces;
}

// How far a vertex of the piece gets from where the body alone would take it.
double reach_of(const Pose& rest, const std::vector<Pose>& poses, const std::vector<StiffMotion>& body,
                const Vertices& piece) {
    double reach = 0;
    for (std::size_t i = 0; i < poses.size(); ++i)
        for (const int v : piece) reach = std::max(reach, distance(poses[i][v], body[i](rest[v])));
    return reach;
}

} // namespace

PosedClip posed(const Rig& rig, const BoneAnimation& animation, int samples) {
    PosedClip clip{animation.name, {}};
    for (int i = 0; i < samples; ++i)
        clip.poses.push_back(skin(rig, animation, animation.duration * i / samples));
    return clip;
}

double hanging_head(const Rig& rig, const LabelMap& labels, const PosedClip& clip) {
    const Vertices head = vertices_of(rig, labels, Label::head), body = vertices_of(rig, labels, Label::body);
    if (head.empty() || body.empty()) return 0;
    const Pose rest = at_rest(rig);
    if (centre_of(rest, head).y <= centre_of(rest, body).y) return 0;
    int hanging = 0;
    // As the body sees it: one that lies, or stands on its hands, has its head where it belongs.
    for (const Pose& pose : clip.poses) {
        const StiffMotion b = stiff_motion(rest, pose, body), h = stiff_motion(rest, pose, head);
        const Vec3 d = centre_of(pose, head) - centre_of(pose, body);
        hanging += b.cosine * d.y - b.sine * d.x < 0 || h.cosine * b.cosine + h.sine * b.sine < 0;
    }
    return static_cast<double>(hanging) / static_cast<double>(clip.poses.size());
}

double still_limbs(const Rig& rig, const LabelMap& labels, const PosedClip& clip) {
    const Vertices body = vertices_of(rig, labels, Label::body);
    if (body.empty()) return 0;
    const Pose rest = at_rest(rig);
    std::vector<StiffMotion> motions;
    for (const Pose& pose : clip.poses) motions.push_back(stiff_motion(rest, pose, body));
    const std::vector<Vertices> pieces = pieces_of(rig, labels, Label::limb);
    const auto still = std::count_if(pieces.begin(), pieces.end(), [&](const Vertices& piece) {
        return reach_of(rest, clip.poses, motions, piece) < hardly * diagonal_of(rest, piece);
    });
    return pieces.empty() ? 0 : static_cast<double>(still) / static_cast<double>(pieces.size());
}

double figure_size(const PosedClip& clip, const View& view) {
    double sum = 0;
    for (const Pose& pose : clip.poses) {
        if (pose.empty()) return 1;
        double left = pose[0].x, right = left, bottom = pose[0].y, top = bottom;
        for (const Vec3& p : pose) {
            left = std::min(left, p.x), right = std::max(right, p.x);
            bottom = std::min(bottom, p.y), top = std::max(top, p.y);
        }
        sum += std::max(right - left, top - bottom) / std::max(view.width, view.height);
    }
    return sum / static_cast<double>(clip.poses.size());
}

} // namespace pantin
