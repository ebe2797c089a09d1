// SPDX-License-Identifier: MIT
// A humanoid rig in, a character folder out (Smith et al. 2023, AnimatedDrawings).
#include "formats/animated_drawings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "core/file.hpp"
#include "formats/figure_joints.hpp"
#include "formats/file_names.hpp"
#include "pantin/image.hpp"
#include "pantin/motion.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

using Joints = std::map<std::string, Point2d>;

Point2d between(Point2d a, Point2d b, double share) { return a + share * (b - a); }

// Joints of the limb that a reference's joint drives: where it begins, its bend, its tip.
std::optional<std::array<Point2d, 3>> limb_of(const Rig& rig, const ReferenceSkeleton& reference,
                                              const std::string& group, bool picture_left) {
    std::vector<const Bone*> chain;
    for (const Bone& bone : rig.bones) {
        if (bone.reference_joint < 0) continue;
        const std::string& name = reference.joints[bone.reference_joint].name;
        if (name.starts_with(group) && shown_left(bone, name) == picture_left &&
            bone.segment == static_cast<int>(chain.size()))
            chain.push_back(&bone);
    }
    if (chain.empty()) return std::nullopt;
    const Point2d first = chain.front()->head, last = chain.back()->tail;
    return std::array<Point2d, 3>{first, chain.size() > 1 ? chain[1]->head : between(first, last, 0.5), last};
}

std::optional<Joints> joints_of(const Rig& rig, const ReferenceSkeleton& reference) {
    Joints joints;
    for (const bool picture_left : {true, false}) {
        const auto arm = limb_of(rig, reference, "arm", picture_left),
                   leg = limb_of(rig, reference, "leg", picture_left);
        if (!arm || !leg) return std::nullopt;
        const std::string side = picture_left ? "right_" : "left_"; // the figure faces the viewer
        joints[side + "shoulder"] = (*arm)[0], joints[side + "elbow"] = (*arm)[1],
                      joints[side + "hand"] = (*arm)[2];
        joints[side + "hip"] = (*leg)[0], joints[side + "knee"] = (*leg)[1],
                      joints[side + "foot"] = (*leg)[2];
    }
    joints["torso"] = between(joints["left_shoulder"], joints["right_shoulder"], 0.5);
    joints["hip"] = joints["root"] = between(joints["left_hip"], joints["right_hip"], 0.5);
    joints["neck"] = between(joints["hip"], joints["torso"], 1.4);
    for (const Bone& bone : rig.bones)
        if (bone.label == Label::head) joints["neck"] = bone.tail;
    return joints;
}

std::string config_text(const Joints& joints, int width, int height) {
    std::string text = "height: " + std::to_string(height) + "\nskeleton:\n";
    for (const auto& [name, parent] : animated_drawings_joints) {
        const Point2d p = joints.at(name);
        const auto pixel = [](double v, int size) {
            return std::to_string(std::clamp(static_cast<int>(std::floor(v + 0.5)), 0, size - 1));
        };
        text += "- loc:\n  - " + pixel(p.x, width) + "\n  - " + pixel(p.y, height) + "\n  name: " + name +
                "\n  parent: " + (parent ? parent : "null") + "\n";
    }
    return text + "width: " + std::to_string(width) + "\n";
}

} // namespace

bool is_animated_drawings_folder(const fs::path& folder) {
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored)) return false;
    return fs::exists(joints_file(folder), ignored) || fs::exists(folder / file_names::texture, ignored);
}

bool write_animated_drawings(const fs::path& folder, const Rig& rig, const ReferenceSkeleton& reference,
                             const RgbaImage& texture) {
    if (!is_humanoid(reference)) return false;
    std::optional<Joints> joints = joints_of(rig, reference);
    if (!joints) return false;
    const double scale = static_cast<double>(texture.width()) / rig.width;
    for (auto& [name, place] : *joints)
        place = {scale * (place.x + 0.5) - 0.5, scale * (place.y + 0.5) - 0.5};
    GreyImage mask(texture.width(), texture.height());
    std::transform(texture.begin(), texture.end(), mask.begin(),
                   [](const Rgba8& p) { return static_cast<std::uint8_t>(p.a >= 128 ? 255 : 0); });
    create_folder(folder);
    save_png(folder / file_names::texture, texture);
    save_png(folder / file_names::mask, mask);
    write_file(folder / file_names::animated_drawings_config,
               config_text(*joints, texture.width(), texture.height()));
    return true;
}

} // namespace pantin
