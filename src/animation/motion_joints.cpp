// SPDX-License-Identifier: MIT
// Which joint of a recorded motion plays which part of a body: by hand, by its name, by the skeleton's shape.
#include <algorithm>
#include <iterator>

#include "animation/body_axes.hpp"
#include "animation/joint_names.hpp"
#include "animation/named_joints.hpp"
#include "animation/skeleton_shape.hpp"
#include "core/suggestion.hpp"
#include "pantin/error.hpp"
#include "pantin/motion.hpp"

namespace pantin {
namespace {

std::size_t at(int joint) { return static_cast<std::size_t>(joint); }

// The parts of a body, in the order of the table that people read.
struct Part {
    const char* name;
    int* (*of)(MotionJoints&);
    bool required;
    int above; // the part that it hangs from, −1: any
};
constexpr Part body_parts[] = {
    {"hips", [](MotionJoints& j) { return &j.hips; }, false, -1},
    {"neck", [](MotionJoints& j) { return &j.neck; }, false, -1},
    {"head", [](MotionJoints& j) { return &j.head; }, false, -1},
    {"left upper arm", [](MotionJoints& j) { return &j.left.upper_arm; }, true, -1},
    {"left forearm", [](MotionJoints& j) { return &j.left.forearm; }, true, 3},
    {"left hand", [](MotionJoints& j) { return &j.left.hand; }, true, 4},
    {"left thigh", [](MotionJoints& j) { return &j.left.thigh; }, true, 0},
    {"left shin", [](MotionJoints& j) { return &j.left.shin; }, true, 6},
    {"left foot", [](MotionJoints& j) { return &j.left.foot; }, true, 7},
    {"right upper arm", [](MotionJoints& j) { return &j.right.upper_arm; }, true, -1},
    {"right forearm", [](MotionJoints& j) { return &j.right.forearm; }, true, 9},
    {"right hand", [](MotionJoints& j) { return &j.right.hand; }, true, 10},
    {"right thigh", [](MotionJoints& j) { return &j.right.thigh; }, true, 0},
    {"right shin", [](MotionJoints& j) { return &j.right.shin; }, true, 12},
    {"right foot", [](MotionJoints& j) { return &j.right.foot; }, true, 13},
};

std::vector<SimpleName> names_of(const Motion& motion) {
    std::vector<std::string> names;
    for (const MotionJoint& joint : motion.joints) names.push_back(joint.name);
    return simplified(names);
}

// The first part that does not hang from the one that it should; none: the limbs hang together. Hips that
// carry no legs count only where a map names them: complete() finds others.
const Part* loose_part(const Motion& motion, MotionJoints joints, bool hips_named = false) {
    for (const Part& part : body_parts) {
        const int joint = *part.of(joints), from = part.above < 0 ? -1 : *body_parts[part.above].of(joints);
        if (joint < 0 || from < 0 || (part.above == 0 && !hips_named)) continue;
        if (from == joint || common_ancestor(motion, from, joint) != from) return &part;
    }
    return nullptr;
}

// Every part of the limbs is there, and forearms hang from upper arms.
bool is_complete(const Motion& motion, MotionJoints joints) {
    for (const Part& part : body_parts)
        if (part.required && *part.of(joints) < 0) return false;
    return !loose_part(motion, joints);
}

// The way from the neck, or from the chest, that no limb takes ends in the head.
void find_head(const Motion& motion, int chest, MotionJoints& joints) {
    std::vector<int> limbs;
    for (const int limb :
         {joints.left.upper_arm, joints.right.upper_arm, joints.left.thigh, joints.right.thigh})
        for (const int joint : ancestors(motion, limb))
            if (joint != chest) limbs.push_back(joint);
    std::vector<int> way;
    if (joints.neck >= 0)
        way = longest_way(motion, joints.neck, limbs), way.insert(way.begin(), joints.neck);
    else
        way = longest_way(motion, chest, limbs);
    if (way.empty()) return;
    joints.neck = way.front();
    joints.head = head_of(motion, way);
}

// What the limbs tell of the rest.
void complete(const Motion& motion, const std::vector<SimpleName>& names, MotionJoints& joints) {
    const int hips = common_ancestor(motion, joints.left.thigh, joints.right.thigh),
              chest = common_ancestor(motion, joints.left.upper_arm, joints.right.upper_arm);
    if (joints.hips < 0 || common_ancestor(motion, joints.hips, hips) != joints.hips) joints.hips = hips;
    if (joints.head < 0 && chest >= 0) find_head(motion, chest, joints);
    if (joints.head >= 0) joints.head_end = outermost_child(motion, joints.head);
    const auto is_wing = [&](int joint) { return names[at(joint)].word.find("wing") != std::string::npos; };
    const MotionJoints::Side& l = joints.left;
    if (is_wing(l.upper_arm) || is_wing(l.forearm) || is_wing(l.hand))
        joints.plan = BodyPlan::bird;
    else if (body_axes(motion, joints).on_four_legs)
        joints.plan = BodyPlan::quadruped;
}

std::string list_of_names(const Motion& motion) {
    std::string names;
    for (const MotionJoint& joint : motion.joints)
        if (!joint.name.empty() && names.size() < 300) names += (names.empty() ? "" : ", ") + joint.name;
    return names;
}

// --- by hand -----------------------------------------------------------------------------------------------

void apply(const JointMap& by_hand, const Motion& motion, MotionJoints& joints) {
    for (const auto& [part, joint_name] : by_hand) {
        const std::string& name = joint_name; // for the lambda: clang 14 captures no structured binding
        const auto joint = std::find_if(motion.joints.begin(), motion.joints.end(),
                                        [&](const MotionJoint& j) { return j.name == name; });
        for (const Part& p : body_parts)
            if (p.name == part) *p.of(joints) = static_cast<int>(joint - motion.joints.begin());
    }
    for (MotionJoints::Side* s : {&joints.left, &joints.right}) {
        if (s->hand < 0 && s->forearm >= 0) s->hand = outermost_child(motion, s->forearm);
        if (s->foot < 0 && s->shin >= 0) s->foot = outermost_child(motion, s->shin);
    }
}

bool names_hips(const JointMap& by_hand) {
    return std::any_of(by_hand.begin(), by_hand.end(),
                       [](const auto& entry) { return entry.first == "hips"; });
}

void apply_plan(const JointMap& by_hand, MotionJoints& joints) {
    for (const auto& [part, name] : by_hand)
        for (std::size_t k = 0; part == "body" && k < body_plan_names.size(); ++k)
            if (body_plan_names[k] == name) joints.plan = static_cast<BodyPlan>(k);
}

// Every joint of the map is there.
void check(const JointMap& by_hand, const Motion& motion, const std::string& file) {
    std::vector<std::string> names;
    for (const MotionJoint& joint : motion.joints)
        if (!joint.name.empty()) names.push_back(joint.name);
    for (const auto& [part, name] : by_hand)
        if (part != "body" && std::find(names.begin(), names.end(), name) == names.end())
            throw Error(ErrorKind::input, file + ": has no joint '" + name + "', which is to play the " +
                                              part + did_you_mean(name, names));
}

[[noreturn]] void refuse(const Motion& motion, MotionJoints joints, const Part& loose,
                         const std::string& file) {
    const auto place = [&](const Part& part) {
        const std::string& own = motion.joints[at(*part.of(joints))].name;
        return std::string(part.name) + ", " + (own.empty() ? "an end site" : "'" + own + "'");
    };
    throw Error(ErrorKind::input, file + ": the " + place(loose) + ", does not hang from the " +
                                      place(body_parts[loose.above]));
}

[[noreturn]] void refuse(const Motion& motion, MotionJoints joints, const JointMap& by_hand,
                         const std::string& file) {
    std::string missing;
    for (const Part& part : body_parts)
        if (missing.empty() && part.required && *part.of(joints) < 0) missing = part.name;
    if (missing.empty() || !by_hand.empty())
        if (const Part* loose = loose_part(motion, joints, names_hips(by_hand)))
            refuse(motion, joints, *loose, file);
    throw Error(ErrorKind::input, file + ": no joint plays the " +
                                      (missing.empty() ? "left upper arm" : missing) + " (" +
                                      list_of_names(motion) + "); --motion-map names the joints by hand");
}

// Bones without any length show no motion.
void require_lengths(const Motion& motion, const MotionJoints& joints, const std::string& file) {
    const std::vector<Vec3> pose = joint_positions(motion, 0);
    const LimbDirections d = limb_directions(pose, joints);
    if (length(d.legs) + length(d.arms) + length(d.trunk) <= 0)
        throw Error(ErrorKind::input, file + ": the bones have no length");
}

} // namespace

MotionJoints match_joints(const Motion& motion, const std::string& file, const JointMap& by_hand) {
    check(by_hand, motion, file);
    const std::vector<SimpleName> names = names_of(motion);
    std::optional<MotionJoints> incomplete;
    for (std::size_t j = 0; j < motion.joints.size(); ++j) {
        if (motion.joints[j].parent >= 0) continue;
        const int root = static_cast<int>(j);
        MotionJoints found = joints_by_name(motion, names, root);
        apply(by_hand, motion, found);
        if (!incomplete) incomplete = found;
        if (!is_complete(motion, found)) {
            const std::optional<MotionJoints> shaped = joints_by_shape(motion, names, root);
            if (!shaped) continue;
            found = *shaped;
            apply(by_hand, motion, found);
            if (!is_complete(motion, found)) {
                incomplete = found;
                continue;
            }
        }
        if (const Part* loose = loose_part(motion, found, names_hips(by_hand)))
            refuse(motion, found, *loose, file);
        require_lengths(motion, found, file);
        complete(motion, names, found);
        apply_plan(by_hand, found);
        return found;
    }
    refuse(motion, *incomplete, by_hand, file);
}

JointMap match_table(const Motion& motion, const MotionJoints& joints) {
    JointMap table;
    if (joints.plan != BodyPlan::humanoid)
        table.emplace_back("body", std::string(body_plan_names[static_cast<std::size_t>(joints.plan)]));
    const auto add = [&](const std::string& part, int joint) {
        if (joint < 0) return;
        const MotionJoint& j = motion.joints[at(joint)];
        const std::string end = j.parent >= 0 ? motion.joints[at(j.parent)].name + " (its end)" : "";
        table.emplace_back(part, j.name.empty() ? end : j.name);
    };
    MotionJoints all = joints;
    for (const Part& part : body_parts) add(part.name, *part.of(all));
    if (!joints.tail.empty()) add("tail", joints.tail.front());
    return table;
}

std::vector<std::string> motion_parts() {
    std::vector<std::string> names = {"body"};
    for (const Part& part : body_parts) names.emplace_back(part.name);
    return names;
}

} // namespace pantin
