// SPDX-License-Identifier: MIT
// How far clips stretch and crush the mesh, and how far feet slide: for each character folder and clip, over
// all key poses, the largest stretch of an edge (length / length at rest), the 99th percentile of the edges'
// largest stretches, and the smallest area of a triangle over its area at rest, all in 3D (a limb that turns
// towards the viewer is not crushed). Edges and triangles smaller than a hundredth of the mean are left out:
// their ratios mean nothing to the eye. A foot is the lowest vertex of the outer half of a leg's last bone,
// where the clip says that it steps or is planted; it is on the ground while it is less than a hundredth of
// the character's height above its place at rest. Its slide is the largest way over the ground within one
// such time, as a share of the character's height.
//
// usage: motion_quality PRESET CHARACTER_DIR... > table.tsv   (the preset that made the folders: default or
// thesis)
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "animation/footing.hpp"
#include "animation/vector.hpp"
#include "pipeline/character.hpp"
#include "reference/tracks.hpp"

using namespace pantin;

namespace {

constexpr double negligible = 0.01; // of the mean length or area at rest

double norm(Vec3 v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }
double area(Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 u = b - a, v = c - a;
    return 0.5 * norm({u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x});
}

struct Triangle {
    int a, b, c;
};

struct Shape {
    std::vector<std::pair<int, int>> edges;
    std::vector<Triangle> triangles;
    std::vector<double> lengths, areas; // at rest
};

Shape shape_of(const Rig& rig, const std::vector<Vec3>& rest) {
    Shape shape;
    std::map<std::pair<int, int>, bool> seen;
    for (const std::vector<int>& face : rig.mesh.faces)
        for (std::size_t i = 0; i < face.size(); ++i) {
            const auto edge = std::minmax(face[i], face[(i + 1) % face.size()]);
            if (!std::exchange(seen[{edge.first, edge.second}], true))
                shape.edges.emplace_back(edge.first, edge.second);
            if (i > 0 && i + 1 < face.size()) shape.triangles.push_back({face[0], face[i], face[i + 1]});
        }
    double edge_sum = 0, area_sum = 0;
    for (const auto& [a, b] : shape.edges) edge_sum += norm(rest[a] - rest[b]);
    for (const auto& [a, b, c] : shape.triangles) area_sum += area(rest[a], rest[b], rest[c]);
    const double least_edge = negligible * edge_sum / static_cast<double>(shape.edges.size());
    const double least_area = negligible * area_sum / static_cast<double>(shape.triangles.size());
    std::erase_if(shape.edges, [&](auto& e) { return norm(rest[e.first] - rest[e.second]) < least_edge; });
    std::erase_if(shape.triangles,
                  [&](auto& t) { return area(rest[t.a], rest[t.b], rest[t.c]) < least_area; });
    for (const auto& [a, b] : shape.edges) shape.lengths.push_back(norm(rest[a] - rest[b]));
    for (const auto& [a, b, c] : shape.triangles) shape.areas.push_back(area(rest[a], rest[b], rest[c]));
    return shape;
}

constexpr double touching = 0.01; // of the character's height

std::vector<int> feet_of(const Rig& rig, const ReferenceClip& clip) {
    std::vector<int> feet;
    for (std::size_t b = 1; b < rig.bones.size(); ++b) {
        const bool last = b + 1 == rig.bones.size() || rig.bones[b + 1].segment == 0;
        const bool steps = std::any_of(clip.tracks.begin(), clip.tracks.end(), [&](const ReferenceTrack& t) {
            return on_ground(t.kind) && t.joint == rig.bones[b].reference_joint;
        });
        const int foot = last && steps ? foot_vertex(rig, static_cast<int>(b)) : -1;
        if (foot >= 0) feet.push_back(foot);
    }
    return feet;
}

double height_of(const std::vector<Vec3>& points) {
    double low = points.front().y, high = low;
    for (const Vec3& p : points) low = std::min(low, p.y), high = std::max(high, p.y);
    return high - low;
}

double slide_of(const Rig& rig, const BoneAnimation& animation, const std::vector<int>& feet,
                const std::vector<Vec3>& rest) {
    const double height = height_of(rest);
    double slide = 0;
    std::vector<double> least(feet.size()), most(feet.size());
    std::vector<char> down(feet.size());
    for (const double time : animation.times) {
        const std::vector<Vec3> p = skin(rig, animation, time);
        for (std::size_t f = 0; f < feet.size(); ++f) {
            const Vec3 place = p[feet[f]];
            const double way = place.x - animation.ground_speed * time;
            const bool was_down = std::exchange(down[f], place.y - rest[feet[f]].y < touching * height);
            least[f] = was_down ? std::min(least[f], way) : way;
            most[f] = was_down ? std::max(most[f], way) : way;
            if (down[f]) slide = std::max(slide, (most[f] - least[f]) / height);
        }
    }
    return slide;
}

void measure(const std::string& folder, const ReferenceSkeleton& reference, const Rig& rig,
             const BoneAnimation& animation) {
    std::vector<Vec3> rest;
    for (std::size_t v = 0; v < rig.mesh.vertices.size(); ++v)
        rest.push_back(to_world(rig.mesh.vertices[v], rig.width, rig.height, rig.depth[v]));
    const auto clip = std::find_if(reference.clips.begin(), reference.clips.end(),
                                   [&](const ReferenceClip& c) { return c.name == animation.name; });
    const double slide =
        clip == reference.clips.end() ? 0 : slide_of(rig, animation, feet_of(rig, *clip), rest);
    const Shape shape = shape_of(rig, rest);
    std::vector<double> stretch(shape.edges.size());
    double crushed = 1;
    for (const double time : animation.times) {
        const std::vector<Vec3> p = skin(rig, animation, time);
        for (std::size_t i = 0; i < shape.edges.size(); ++i) {
            const auto& [a, b] = shape.edges[i];
            stretch[i] = std::max(stretch[i], norm(p[a] - p[b]) / shape.lengths[i]);
        }
        for (std::size_t i = 0; i < shape.triangles.size(); ++i) {
            const auto& [a, b, c] = shape.triangles[i];
            crushed = std::min(crushed, area(p[a], p[b], p[c]) / shape.areas[i]);
        }
    }
    std::sort(stretch.begin(), stretch.end());
    std::printf("%s\t%s\t%s\t%.3f\t%.3f\t%.3f\t%.4f\n", folder.c_str(), reference.name.c_str(),
                animation.name.c_str(), stretch.back(), stretch[stretch.size() * 99 / 100], crushed, slide);
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fprintf(stderr, "usage: motion_quality PRESET CHARACTER_DIR...\n");
        return 2;
    }
    std::printf("character\treference\tclip\tlargest_stretch\tstretch_99\tsmallest_area\tslide\n");
    try {
        Settings settings;
        settings.options = make_preset(argv[1]);
        for (int i = 2; i < argc; ++i) {
            Context context(settings);
            const Character character = load_character(argv[i], Step::render, context);
            for (const BoneAnimation& animation : character.animations)
                measure(argv[i], character.reference, character.rig, animation);
        }
    } catch (const Error& error) {
        std::fprintf(stderr, "motion_quality: %s\n", error.what());
        return 1;
    }
    return 0;
}
