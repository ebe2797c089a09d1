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

// 3D: right-handed, y up, the drawing in the plane z = 0, origin at the bottom centre of the crop, one unit =
// its height.
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
};
// Samples `samples` + 1 key poses of a reference's clip on the rig's bones.
BoneAnimation retarget(const Rig& rig, const ReferenceSkeleton& reference, const ReferenceClip& clip,
                       int samples = 24);

// World positions of all mesh vertices at `time`.
std::vector<Vec3> skin(const Rig& rig, const BoneAnimation& animation, double time);
// Unit normals of a posed mesh's vertices, pointing outward: means of their faces', weighted by area.
std::vector<Vec3> vertex_normals(const Mesh& mesh, const std::vector<Vec3>& vertices);

struct RenderOptions {
    int size = 512; // longer side of the frame
    bool perspective = false;
    int supersampling = 3; // per axis, for antialiased edges
    Rgba8 background{0, 0, 0, 0};
};
// Rectangle of the world that holds every frame of the animation, with a margin.
struct View {
    double left = 0, bottom = 0, width = 1, height = 1;
};
View view_of(const Rig& rig, const std::vector<BoneAnimation>& animations);
// Texture: the drawing; `alpha` cuts it to the silhouette at the drawing's resolution. Outside it colours go
// on as they are at the border.
RgbaImage make_texture(const RgbImage& drawing, const LabelMap& labels);
// The same without the cut, for solids, whose surface alone says where they end.
RgbaImage make_solid_texture(const RgbImage& drawing, const LabelMap& labels);
// Draws frames of one character, all from the same view. Keeps a reference to `rig`; may be used by several
// threads at once.
class FrameRenderer {
public:
    FrameRenderer(const Rig& rig, const RgbaImage& texture, const View& view,
                  const RenderOptions& options = {});
    ~FrameRenderer();
    FrameRenderer(FrameRenderer&&) noexcept;
    RgbaImage operator()(const std::vector<Vec3>& vertices) const;

private:
    struct Parts;
    std::unique_ptr<const Parts> parts_;
};
RgbaImage render_frame(const Rig& rig, const std::vector<Vec3>& vertices, const RgbaImage& texture,
                       const View& view, const RenderOptions& options = {});
std::vector<RgbaImage> render(const Rig& rig, const BoneAnimation& animation, const RgbaImage& texture,
                              const View& view, double fps, const RenderOptions& options = {});

} // namespace pantin
