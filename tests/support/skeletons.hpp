// SPDX-License-Identifier: MIT
// Skeletons made by the tests with the joints that motion programs write: spine, collar bones, toes, twists.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace pantin::test {

// Names of joints; '<' stands for the side. "" leaves a joint out.
struct SkeletonNames {
    std::string left, right, hips, spine, chest, neck, head, collar, upper_arm, forearm, hand, thigh, shin,
        foot, toe;
    std::string twist; // of the upper arm, beside the forearm
};

// What a hierarchy is made of; its children follow it.
struct SkeletonJoint {
    std::string name; // "": an end site
    double x = 0, y = 0, z = 0;
    std::vector<SkeletonJoint> children;
};

inline std::string hierarchy_of(const SkeletonJoint& joint, bool root = true) {
    std::string text = joint.name.empty() ? "End Site" : (root ? "ROOT " : "JOINT ") + joint.name;
    text += "\n{\nOFFSET " + std::to_string(joint.x) + " " + std::to_string(joint.y) + " " +
            std::to_string(joint.z) + "\n";
    if (!joint.name.empty())
        text += std::string("CHANNELS ") + (root ? "6 Xposition Yposition Zposition" : "3") +
                " Zrotation Xrotation Yrotation\n";
    for (const SkeletonJoint& child : joint.children) text += hierarchy_of(child, false);
    return text + "}\n";
}

inline int joints_of(const SkeletonJoint& joint) {
    int count = joint.name.empty() ? 0 : 1;
    for (const SkeletonJoint& child : joint.children) count += joints_of(child);
    return count;
}

// `frames` frames in which nothing turns, the root 90 units up.
inline std::string still_motion(const SkeletonJoint& root, int frames = 2) {
    std::string text = "HIERARCHY\n" + hierarchy_of(root) + "MOTION\nFrames: " + std::to_string(frames) +
                       "\nFrame Time: 0.0333333\n";
    for (int i = 0; i < frames; ++i) {
        text += "0 90 0";
        for (int j = 0; j < 3 * joints_of(root); ++j) text += " 0";
        text += "\n";
    }
    return text;
}

// A joint that is left out hands its children on, moved.
inline void put(std::vector<SkeletonJoint>& to, SkeletonJoint joint, const std::string& left_out = "") {
    if (joint.name != left_out) {
        to.push_back(std::move(joint));
        return;
    }
    for (SkeletonJoint child : joint.children) {
        child.x += joint.x, child.y += joint.y, child.z += joint.z;
        to.push_back(std::move(child));
    }
}

// A person of 170 units facing +z, y up, arms held out.
inline SkeletonJoint person(const SkeletonNames& n) {
    const auto side = [&](const std::string& name, bool left) {
        const std::size_t at = name.find('<');
        return at == std::string::npos ? name
                                       : name.substr(0, at) + (left ? n.left : n.right) + name.substr(at + 1);
    };
    const SkeletonJoint end_of_head{"", 0, 20, 0, {}};
    SkeletonJoint chest{n.chest, 0, 22, 0, {}}, hips{n.hips, 0, 0, 0, {}};
    for (const bool left : {true, false}) {
        const double s = left ? 1 : -1;
        SkeletonJoint hand{side(n.hand, left), 25 * s, 0, 0, {{"", 9 * s, 0, 0, {}}}};
        SkeletonJoint upper{side(n.upper_arm, left), 13 * s, 0, 0, {}};
        if (!n.twist.empty()) upper.children.push_back({side(n.twist, left), 14 * s, 0, 0, {}});
        upper.children.push_back({side(n.forearm, left), 28 * s, 0, 0, {hand}});
        put(chest.children, {side(n.collar, left), 4 * s, 18, 0, {upper}});
        SkeletonJoint foot{side(n.foot, left), 0, -41, 0, {}};
        put(foot.children, {side(n.toe, left), 0, -6, 13, {{"", 0, 0, 5, {}}}});
        hips.children.push_back(
            {side(n.thigh, left), 9 * s, -4, 0, {{side(n.shin, left), 0, -42, 0, {foot}}}});
    }
    put(chest.children, {n.neck, 0, 24, 0, {{n.head, 0, 10, 1, {end_of_head}}}});
    put(hips.children, {n.spine, 0, 12, 0, {chest}});
    return hips;
}

} // namespace pantin::test
