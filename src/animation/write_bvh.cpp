// SPDX-License-Identifier: MIT
// A character's animation as a Biovision hierarchy file.
#include <algorithm>
#include <cmath>

#include "animation/vector.hpp"
#include "core/decimal.hpp"
#include "core/math.hpp"
#include "pantin/motion.hpp"

namespace pantin {
namespace {

constexpr double written_height = 100; // of the character in a file

double degrees(double radians) { return radians * (180 / math::pi); }

// Angles of R = Rz · Rx · Ry.
Vec3 zxy_angles(const Matrix3& m) {
    const double sine = std::clamp(m.rows[2].y, -1.0, 1.0),
                 cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
    const double x = math::atan2(sine, cosine);
    if (cosine < 1e-9) return {degrees(x), 0, degrees(math::atan2(m.rows[1].x, m.rows[0].x))};
    return {degrees(x), degrees(math::atan2(-m.rows[2].x, m.rows[2].z)),
            degrees(math::atan2(-m.rows[0].y, m.rows[1].y))};
}

class Writer {
public:
    Writer(const Rig& rig, const BoneAnimation& animation)
        : rig_(rig), animation_(animation), children_(rig.bones.size()) {
        for (std::size_t b = 1; b < rig.bones.size(); ++b)
            children_[static_cast<std::size_t>(rig.bones[b].parent)].push_back(static_cast<int>(b));
    }
    std::string write() {
        text_ = "HIERARCHY\n";
        bone(0, 0);
        const std::size_t frames =
            std::max<std::size_t>(1, animation_.times.size() - 1); // the last pose is the first
        const double time = animation_.duration / static_cast<double>(frames);
        text_ += "MOTION\nFrames: " + std::to_string(frames) + "\nFrame Time: " + to_decimal(time) + "\n";
        for (std::size_t i = 0; i < frames; ++i) frame(i);
        return std::move(text_);
    }

private:
    Vec3 place(Point2d p) const { return written_height * to_world(p, rig_.width, rig_.height); }
    std::string triple(Vec3 v) const {
        return to_decimal(v.x) + " " + to_decimal(v.y) + " " + to_decimal(v.z);
    }

    void bone(int index, int depth) {
        const Bone& b = rig_.bones[static_cast<std::size_t>(index)];
        const std::string tabs(static_cast<std::size_t>(depth), '\t');
        const Vec3 head = place(b.head),
                   from = b.parent < 0 ? Vec3{} : place(rig_.bones[static_cast<std::size_t>(b.parent)].head);
        text_ += tabs + (depth == 0 ? "ROOT " : "JOINT ") + b.name + "\n" + tabs + "{\n";
        text_ += tabs + "\tOFFSET " + triple(head - from) + "\n" + tabs + "\tCHANNELS ";
        text_ += depth == 0 ? "6 Xposition Yposition Zposition " : "3 ";
        text_ += "Zrotation Xrotation Yrotation\n";
        order_.push_back(index);
        const auto& children = children_[static_cast<std::size_t>(index)];
        for (const int child : children) bone(child, depth + 1);
        if (children.empty())
            text_ += tabs + "\tEnd Site\n" + tabs + "\t{\n" + tabs + "\t\tOFFSET " +
                     triple(place(b.tail) - head) + "\n" + tabs + "\t}\n";
        text_ += tabs + "}\n";
    }
    void frame(std::size_t i) {
        text_ += triple(place(rig_.bones[0].head) + written_height * animation_.root_translation[i]);
        for (const int b : order_) {
            const Vec3 angles = zxy_angles(matrix_of(animation_.rotations[static_cast<std::size_t>(b)][i]));
            text_ += " " + triple({angles.z, angles.x, angles.y});
        }
        text_ += "\n";
    }

    const Rig& rig_;
    const BoneAnimation& animation_;
    std::vector<std::vector<int>> children_;
    std::vector<int> order_; // of the joints in the file
    std::string text_;
};

} // namespace

std::string to_bvh(const Rig& rig, const BoneAnimation& animation) { return Writer(rig, animation).write(); }

} // namespace pantin
