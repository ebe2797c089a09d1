// SPDX-License-Identifier: MIT
// Joints of a char_cfg.yaml in, part labels of its mask out; a humanoid rig in, such a folder out (Smith et
// al. 2023, AnimatedDrawings).
#include "formats/animated_drawings.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "core/file.hpp"
#include "core/json_reader.hpp"
#include "core/yaml.hpp"
#include "formats/file_names.hpp"
#include "pantin/image.hpp"
#include "pantin/motion.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

using Joints = std::map<std::string, Point2d>;

struct Segment {
    Label label;
    Point2d from, to;
};

double distance_to(const Segment& s, Point2d p) {
    const Point2d d = s.to - s.from;
    const double n = d.x * d.x + d.y * d.y;
    const double t = n > 0 ? std::clamp(((p.x - s.from.x) * d.x + (p.y - s.from.y) * d.y) / n, 0.0, 1.0) : 0;
    return distance(p, s.from + t * d);
}

Point2d between(Point2d a, Point2d b, double share) { return a + share * (b - a); }

// The trunk comes first: where a limb is no nearer, a pixel belongs to it.
std::vector<Segment> segments_of(const Joints& j) {
    const auto at = [&](const std::string& name) { return j.at(name); };
    std::vector<Segment> all = {{Label::body, at("torso"), at("hip")},
                                {Label::body, at("left_shoulder"), at("right_shoulder")},
                                {Label::body, at("left_hip"), at("right_hip")}};
    for (const std::string side : {"left_", "right_"}) {
        all.push_back({Label::body, at(side + "shoulder"), at(side + "hip")});
        // Where trunk and limb meet, the first fifth of the limb is the trunk's.
        all.push_back(
            {Label::limb, between(at(side + "shoulder"), at(side + "elbow"), 0.2), at(side + "elbow")});
        all.push_back({Label::limb, at(side + "elbow"), at(side + "hand")});
        all.push_back({Label::limb, between(at(side + "hip"), at(side + "knee"), 0.2), at(side + "knee")});
        all.push_back({Label::limb, at(side + "knee"), at(side + "foot")});
    }
    all.push_back(
        {Label::head, between(at("torso"), at("neck"), 0.6), between(at("torso"), at("neck"), 1.6)});
    return all;
}

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

// The number that the text of a scalar is: 12, 012, +3.5, 1e3.
std::optional<double> number_of(const std::string& text) {
    const char *begin = text.data() + (text.starts_with('+') ? 1 : 0), *end = text.data() + text.size();
    double number = 0;
    const auto [last, error] = std::from_chars(begin, end, number);
    return error == std::errc() && last == end ? std::optional(number) : std::nullopt;
}

Joints parse_joints(const std::string& text, const std::string& file, int width, int height) {
    const Json config = parse_yaml(text, file);
    const JsonReader reader(config, file);
    if (!reader.has("skeleton") || !config["skeleton"].is_array()) reader.fail("has no list \"skeleton\"");
    Joints joints;
    for (const JsonReader& joint : reader.at("skeleton").elements()) {
        const std::string name = joint.at("name").text();
        const auto fail = [&](const std::string& fact) { reader.fail("joint '" + name + "' " + fact); };
        if (!joint.has("loc") || joint.at("loc").value().size() != 2) fail("has no place of two numbers");
        const auto place = joint.at("loc").elements();
        const auto coordinate = [&](std::size_t k) {
            const std::optional<double> number = number_of(place[k].text());
            if (!number) fail("has no place of two numbers");
            return *number;
        };
        const Point2d p{coordinate(0), coordinate(1)};
        // A joint may lie a little outside of the picture.
        if (!(std::abs(p.x) <= 2.0 * width && std::abs(p.y) <= 2.0 * height))
            fail("lies far outside of texture.png");
        joints[name] = p;
    }
    for (const auto& joint : animated_drawings_joints)
        if (!joints.contains(joint.name)) reader.fail("misses the joint '" + std::string(joint.name) + "'");
    return joints;
}

} // namespace

bool is_animated_drawings_folder(const fs::path& folder) {
    std::error_code ignored;
    return fs::is_directory(folder, ignored) &&
           fs::exists(folder / file_names::animated_drawings_config, ignored);
}

std::map<std::string, Point2d> read_joints(const fs::path& folder, int width, int height) {
    const std::string file = (folder / file_names::animated_drawings_config).string();
    return parse_joints(read_text(folder / file_names::animated_drawings_config, std::size_t{1} << 20), file,
                        width, height);
}

LabelMap labels_from_joints(const Mask& mask, const std::map<std::string, Point2d>& joints) {
    const std::vector<Segment> segments = segments_of(joints);
    LabelMap labels(mask.width(), mask.height());
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) {
            if (!mask(x, y)) continue;
            double nearest = std::numeric_limits<double>::infinity();
            for (const Segment& segment : segments) {
                const double d = distance_to(segment, to_double({x, y}));
                if (d >= nearest) continue;
                nearest = d;
                labels(x, y) = static_cast<std::uint8_t>(segment.label);
            }
        }
    return labels;
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
