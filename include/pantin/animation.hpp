// SPDX-License-Identifier: MIT
// Step 6 (thesis 4.6, 6.1): clips retargeted to the character's bones, linear blend skinning, software
// rasteriser.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/point.hpp"
#include "pantin/rigging.hpp"

namespace pantin {

struct Quaternion {
    double x = 0, y = 0, z = 0, w = 1;
};

// World units: right-handed, y up, the drawing in the plane z = 0, origin at the bottom centre of the crop,
// one unit = its height. `width`, `height`: of the working crop, pixels; `depth`: world units. No error. Own.
Vec3 to_world(Point2d working_pixel, int width, int height, double depth = 0);

// A clip on the character's own bones, sampled at fixed times.
struct BoneAnimation {
    std::string name;
    double duration = 0; // seconds; the pose at `duration` equals the pose at 0
    std::vector<double> times;
    std::vector<std::vector<Quaternion>> rotations; // [bone][time], local, rest = identity
    std::vector<Vec3> root_translation;             // [time]
    // The character stays in its place and the ground passes below it: world units a second, negative to the
    // left; 0: none.
    double ground_speed = 0;
    // [bone][time], or empty: how far what the bone carries is moved towards the viewer, which decides what
    // is drawn before what; world units, not added up from the root.
    std::vector<std::vector<double>> depths;
    std::vector<double> camera; // [time], or empty: world x that films go along with
};
// The animation as a camera sees it that goes along with `camera`. No error. Own.
BoneAnimation as_filmed(BoneAnimation animation);
// Samples `samples` + 1 key poses of a reference's clip on the rig's bones, evenly over its duration. The
// clip is one of that reference; samples ≥ 1. No error. Thesis 3.3 (Fig. 3.12) and 6.1.
BoneAnimation retarget(const Rig& rig, const ReferenceSkeleton& reference, const ReferenceClip& clip,
                       int samples = 24);

// World positions of all mesh vertices at `time`, seconds; beyond the duration the clip repeats. No error.
// Thesis 3.3 (Fig. 3.8): linear blend skinning.
std::vector<Vec3> skin(const Rig& rig, const BoneAnimation& animation, double time);
// Unit normals of a posed mesh's vertices, one a vertex, pointing outward: means of their faces', weighted by
// area. No error. Own.
std::vector<Vec3> vertex_normals(const Mesh& mesh, const std::vector<Vec3>& vertices);

struct RenderOptions {
    int size = 512; // longer side of the frame
    bool perspective = false;
    int supersampling = 4; // samples of a pixel per axis, for antialiased edges; 1 to 5
    Rgba8 background{0, 0, 0, 0};
};
// Rectangle of the world that holds every frame of the animation, with a margin.
struct View {
    double left = 0, bottom = 0, width = 1, height = 1;
};
// The view of the pose at rest and all key poses, world units. No error. Own.
View view_of(const Rig& rig, const std::vector<BoneAnimation>& animations);
// Texture of the drawing's size: the drawing, its alpha cut to the silhouette (where the labels, of working
// size, are not 0). Outside it colours go on as they are at the border. ink: of the drawing, its size;
// strokes that the silhouette's border runs along belong to it whole, paper beside them does not. Empty: the
// silhouette is exact. No error. Own.
RgbaImage make_texture(const RgbImage& drawing, const GreyImage& ink, const LabelMap& labels);
// The same without the cut, for solids, whose surface alone says where they end. No error. Own.
RgbaImage make_solid_texture(const RgbImage& drawing, const LabelMap& labels);
// Draws frames of one character, all from the same view, with a depth buffer. Refers to `rig`, which must
// outlive it; may be used by several threads at once. No error. Own; thesis ch. 5 shows the result in
// Blender.
class FrameRenderer {
public:
    FrameRenderer(const Rig& rig, const RgbaImage& texture, const View& view,
                  const RenderOptions& options = {});
    ~FrameRenderer();
    FrameRenderer(FrameRenderer&&) noexcept;
    // One frame, longer side `options.size` pixels. `vertices`: world positions, one a vertex of the rig's
    // mesh, as from skin(). The bits do not depend on `threads`. No error.
    RgbaImage operator()(const std::vector<Vec3>& vertices, int threads = 1) const;

private:
    struct Parts;
    std::unique_ptr<const Parts> parts_;
};
// One frame, as FrameRenderer. No error. Own.
RgbaImage render_frame(const Rig& rig, const std::vector<Vec3>& vertices, const RgbaImage& texture,
                       const View& view, const RenderOptions& options = {});
// The clip as a loop of frames at about `fps` frames a second: a whole number of them fills it. No error.
// Own.
std::vector<RgbaImage> render(const Rig& rig, const BoneAnimation& animation, const RgbaImage& texture,
                              const View& view, double fps, const RenderOptions& options = {});

} // namespace pantin
