// SPDX-License-Identifier: MIT
// A rigged solid to one picture of four views: front, side, top, three quarters.
#include "pipeline/model_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/math.hpp"
#include "pantin/animation.hpp"

namespace pantin {
namespace {

constexpr int panels = 4;
constexpr double margin = 0.04;                            // of the larger extent
constexpr double yaw = 35, pitch = 20;                     // degrees, of the last panel
constexpr double line_width = 0.005, joint_radius = 0.008; // of a panel
constexpr Rgb8 paper{255, 255, 255}, bone_colour{200, 30, 30}, joint_colour{30, 60, 200},
    root_colour{20, 140, 40};

using Turn = std::function<Vec3(Vec3)>;

// The model's frame to the camera's: x to the right, y up, z towards it.
std::vector<Turn> cameras() {
    const double cy = math::cos(yaw * math::pi / 180), sy = math::sin(yaw * math::pi / 180);
    const double cp = math::cos(pitch * math::pi / 180), sp = math::sin(pitch * math::pi / 180);
    return {[](Vec3 p) { return p; },
            [](Vec3 p) {
                return Vec3{-p.z, p.y, p.x};
            },
            [](Vec3 p) {
                return Vec3{p.x, -p.z, p.y};
            },
            [=](Vec3 p) {
                const Vec3 q{cy * p.x + sy * p.z, p.y, cy * p.z - sy * p.x};
                return Vec3{q.x, cp * q.y - sp * q.z, sp * q.y + cp * q.z};
            }};
}

// A square that holds all points.
View square_view(const std::vector<Vec3>& points) {
    Vec3 low = points.front(), high = low;
    for (const Vec3& p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), 0};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), 0};
    }
    const double side = (1 + 2 * margin) * std::max(high.x - low.x, high.y - low.y);
    return {0.5 * (low.x + high.x - side), 0.5 * (low.y + high.y - side), side, side};
}

void draw_disc(RgbImage& image, Point2d centre, double radius, Rgb8 colour) {
    const auto begin = [](double x) { return std::max(0, static_cast<int>(std::ceil(x))); };
    for (int y = begin(centre.y - radius); y <= std::min(centre.y + radius, image.height() - 1.0); ++y)
        for (int x = begin(centre.x - radius); x <= std::min(centre.x + radius, image.width() - 1.0); ++x)
            if (distance(Point2d{1.0 * x, 1.0 * y}, centre) <= radius) image(x, y) = colour;
}

void draw_skeleton(RgbImage& image, const Model& model, const ModelView& view, const View& window,
                   const Turn& turn) {
    const auto place = [&](const ModelSkeleton::Joint& joint) {
        const Point2d pixel = view.offset + view.scale * Point2d{joint.place.x, -joint.place.y};
        const Vec3 p =
            turn(to_world(pixel, view.width, view.height, view.scale * joint.place.z / view.height));
        return Point2d{(p.x - window.left) / window.width * image.width() - 0.5,
                       (1 - (p.y - window.bottom) / window.height) * image.height() - 0.5};
    };
    const auto& joints = model.skeleton().joints;
    for (const auto& joint : joints) {
        if (joint.parent < 0) continue;
        const Point2d a = place(joints[joint.parent]), b = place(joint);
        const int steps = 1 + static_cast<int>(2 * distance(a, b));
        for (int i = 0; i <= steps; ++i)
            draw_disc(image, a + static_cast<double>(i) / steps * (b - a), 0.5 * line_width * image.width(),
                      bone_colour);
    }
    for (const auto& joint : joints)
        draw_disc(image, place(joint), joint_radius * image.width(),
                  joint.parent < 0 ? root_colour : joint_colour);
}

} // namespace

RgbImage model_sheet(const Rig& rig, const RgbaImage& texture, const Model& model, const ModelView& view,
                     int size) {
    RgbImage sheet(panels * size, size, paper);
    const std::vector<Turn> turns = cameras();
    for (int panel = 0; panel < panels; ++panel) {
        std::vector<Vec3> vertices;
        for (std::size_t v = 0; v < rig.mesh.vertices.size(); ++v)
            vertices.push_back(
                turns[panel](to_world(rig.mesh.vertices[v], rig.width, rig.height, rig.depth[v])));
        const View window = square_view(vertices);
        RenderOptions options;
        options.size = size;
        options.background = {paper.r, paper.g, paper.b, 255};
        const RgbaImage frame = render_frame(rig, vertices, texture, window, options);
        RgbImage image(frame.width(), frame.height());
        std::transform(frame.begin(), frame.end(), image.begin(), [](Rgba8 p) {
            return Rgb8{p.r, p.g, p.b};
        });
        if (panel + 1 < panels) draw_skeleton(image, model, view, window, turns[panel]);
        for (int y = 0; y < image.height(); ++y)
            std::copy(image.row(y), image.row(y) + image.width(), sheet.row(y) + panel * size);
    }
    return sheet;
}

} // namespace pantin
