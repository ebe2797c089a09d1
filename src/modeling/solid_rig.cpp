// SPDX-License-Identifier: MIT
// Rigs in space (include/pantin/model_view.hpp).
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

#include "pantin/model_view.hpp"

namespace pantin {
namespace {

struct OnSkeleton {
    Vec3 place;
    double radius = 0;
};

// The point of the model's skeleton that is seen nearest to a pixel.
OnSkeleton seen_at(const ModelSkeleton& skeleton, const ModelView& view, Point2d pixel) {
    OnSkeleton best;
    double nearest = std::numeric_limits<double>::infinity();
    for (const ModelSkeleton::Joint& joint : skeleton.joints) {
        const ModelSkeleton::Joint& parent = joint.parent >= 0 ? skeleton.joints[joint.parent] : joint;
        const Point2d a = project(view, parent.place), v = project(view, joint.place) - a;
        const double square = dot(v, v);
        const double t = square > 0 ? std::clamp(dot(pixel - a, v) / square, 0.0, 1.0) : 0;
        const double d = distance(pixel, a + t * v);
        if (d >= nearest) continue;
        nearest = d;
        best = {parent.place + t * (joint.place - parent.place),
                parent.radius + t * (joint.radius - parent.radius)};
    }
    return best;
}

// Working pixels and depth of the rig's world (animation.hpp), seen straight from the front.
struct Straight {
    const ModelView& view;
    Point2d pixel(Vec3 p) const { return view.offset + view.scale * Point2d{p.x, -p.y}; }
    double depth(Vec3 p) const { return view.scale * p.z / view.height; }
};

// Mesh, texture coordinates and weights of a rig whose bones are there. A vertex at which parts meet becomes
// one of each part, so that colours and shading end there. Colours: per triangle.
void add_surface(Rig& rig, const SolidMesh& mesh, const ModelView& view,
                 const std::vector<BoneSegment>& segments, const std::vector<Rgb8>& colours) {
    using Corner = std::pair<int, int>; // vertex, part
    const auto part_at = [&](std::size_t t) {
        return mesh.triangle_parts.empty() ? 0 : mesh.triangle_parts[t];
    };
    std::vector<Corner> corners;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const int v : mesh.triangles[t]) corners.emplace_back(v, part_at(t));
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());

    const Straight straight{view};
    const std::vector<VertexWeights> weights = bone_heat(mesh, segments);
    rig.width = view.width;
    rig.height = view.height;
    rig.solid = true;
    rig.mesh = {};
    rig.texture.clear(), rig.depth.clear(), rig.weights.clear();
    for (const auto& [vertex, part] : corners) {
        const Vec3& v = mesh.vertices[vertex];
        rig.mesh.vertices.push_back(straight.pixel(v));
        rig.depth.push_back(straight.depth(v));
        const Point2d seen = project(view, v);
        rig.texture.push_back({std::clamp((seen.x + 0.5) / view.width, 0.0, 1.0),
                               std::clamp((seen.y + 0.5) / view.height, 0.0, 1.0)});
        rig.weights.push_back(weights[vertex]);
    }
    rig.colours.resize(colours.empty() ? 0 : corners.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        std::array<int, 3> face{};
        for (int k = 0; k < 3; ++k) {
            const auto at =
                std::lower_bound(corners.begin(), corners.end(), Corner{mesh.triangles[t][k], part_at(t)});
            face[k] = static_cast<int>(at - corners.begin());
            if (!colours.empty()) rig.colours[face[k]] = colours[t];
        }
        rig.mesh.faces.push_back({face[0], face[2], face[1]});
    }
}

void place(Bone& bone, Vec3 head, Vec3 tail, const ModelView& view) {
    const Straight straight{view};
    bone.head = straight.pixel(head), bone.tail = straight.pixel(tail);
    bone.head_depth = straight.depth(head), bone.tail_depth = straight.depth(tail);
}

} // namespace

std::vector<Rgb8> part_colours(const Model& model, const SolidMesh& mesh) {
    std::vector<Rgb8> colours;
    for (const int part : mesh.triangle_parts) colours.push_back(colour_of(model.parts()[part]));
    return colours;
}

Rig model_rig(const Model& model, const SolidMesh& mesh, const ModelView& view,
              const std::vector<Rgb8>& colours) {
    const ModelSkeleton& skeleton = model.skeleton();
    Rig rig;
    std::vector<BoneSegment> segments;
    std::map<std::string, int> used;
    std::vector<int> bone_of(skeleton.joints.size());
    for (std::size_t j = 0; j < skeleton.joints.size(); ++j) {
        const ModelSkeleton::Joint& joint = skeleton.joints[j];
        const ModelPart& part = model.parts()[joint.part];
        const bool root = joint.parent < 0;
        if (root && j > 0) { // a tree of its own hangs on the first one's root
            bone_of[j] = 0;
            continue;
        }
        const ModelSkeleton::Joint& parent = root ? joint : skeleton.joints[joint.parent];
        Bone bone;
        bone.name = root ? "hips" : part.name();
        if (const int number = used[bone.name]++; number > 0) bone.name += "." + std::to_string(number);
        bone.label = label_of(part);
        bone.parent = root ? -1 : bone_of[joint.parent];
        place(bone, parent.place, joint.place, view);
        bone_of[j] = static_cast<int>(rig.bones.size());
        rig.bones.push_back(bone);
        segments.push_back({parent.place, joint.place, 0.5 * (parent.radius + joint.radius)});
    }
    add_surface(rig, mesh, view, segments, colours);
    return rig;
}

Rig lifted(const Rig& flat, const Model& model, const SolidMesh& mesh, const ModelView& view,
           const std::vector<Rgb8>& colours) {
    Rig rig = flat;
    std::vector<BoneSegment> segments;
    for (Bone& bone : rig.bones) {
        const OnSkeleton head = seen_at(model.skeleton(), view, bone.head),
                         tail = seen_at(model.skeleton(), view, bone.tail);
        place(bone, head.place, tail.place, view);
        segments.push_back({head.place, tail.place, 0.5 * (head.radius + tail.radius)});
    }
    add_surface(rig, mesh, view, segments, colours);
    return rig;
}

} // namespace pantin
