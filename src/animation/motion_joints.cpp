// SPDX-License-Identifier: MIT
// Which joint of a recorded motion plays which part of a body: by hand, by its name, by the skeleton's shape.
#include <algorithm>
#include <array>
#include <initializer_list>
#include <span>

#include "animation/body_axes.hpp"
#include "animation/joint_names.hpp"
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
};
constexpr Part body_parts[] = {
    {"hips", [](MotionJoints& j) { return &j.hips; }, true},
    {"neck", [](MotionJoints& j) { return &j.neck; }, false},
    {"head", [](MotionJoints& j) { return &j.head; }, false},
    {"left upper arm", [](MotionJoints& j) { return &j.left.upper_arm; }, true},
    {"left forearm", [](MotionJoints& j) { return &j.left.forearm; }, true},
    {"left hand", [](MotionJoints& j) { return &j.left.hand; }, true},
    {"left thigh", [](MotionJoints& j) { return &j.left.thigh; }, true},
    {"left shin", [](MotionJoints& j) { return &j.left.shin; }, true},
    {"left foot", [](MotionJoints& j) { return &j.left.foot; }, true},
    {"right upper arm", [](MotionJoints& j) { return &j.right.upper_arm; }, true},
    {"right forearm", [](MotionJoints& j) { return &j.right.forearm; }, true},
    {"right hand", [](MotionJoints& j) { return &j.right.hand; }, true},
    {"right thigh", [](MotionJoints& j) { return &j.right.thigh; }, true},
    {"right shin", [](MotionJoints& j) { return &j.right.shin; }, true},
    {"right foot", [](MotionJoints& j) { return &j.right.foot; }, true},
};

std::vector<SimpleName> names_of(const Motion& motion) {
    std::vector<std::string> names;
    for (const MotionJoint& joint : motion.joints) names.push_back(joint.name);
    return simplified(names);
}

// Joints of one tree of the hierarchy by their names; −1 where no name says it.
class NameMatcher {
public:
    NameMatcher(const Motion& motion, const std::vector<SimpleName>& names, int root)
        : motion_(motion), names_(names), root_(root) {}

    MotionJoints match() const {
        MotionJoints joints;
        joints.left = side(BodySide::left);
        joints.right = side(BodySide::right);
        joints.neck = find(BodySide::none, {"neck", "neckbase", "shouldercenter", "neckcenter"}, true);
        joints.head = find(BodySide::none, {"head", "headcenter"});
        joints.hips =
            find(BodySide::none, {"hips", "hip", "pelvis", "hipcenter", "hipscenter", "spinebase", "root"});
        if (joints.hips < 0) joints.hips = root_;
        if (const int tail = first_tail(); tail >= 0) {
            joints.tail = longest_way(motion_, tail, {});
            joints.tail.insert(joints.tail.begin(), tail);
        }
        const auto wings = std::count_if(names_.begin(), names_.end(), [](const SimpleName& n) {
            return n.word.find("wing") != std::string::npos;
        });
        if (wings >= 2) joints.plan = BodyPlan::bird;
        return joints;
    }

private:
    bool is_here(int joint) const { return ancestors(motion_, joint).back() == root_; }

    // The first joint with the earliest of the words; main joints before their helpers.
    int find(BodySide side, std::initializer_list<const char*> words, bool helpers = false) const {
        for (const bool helper : {false, true})
            for (const std::string word : words)
                for (std::size_t j = 0; j < names_.size(); ++j)
                    if (names_[j].side == side && names_[j].word == word && names_[j].helper == helper &&
                        (!helper || helpers) && is_here(static_cast<int>(j)))
                        return static_cast<int>(j);
        return -1;
    }
    // The one of those words that comes first on the way outwards from a joint.
    int find_below(int joint, BodySide side, std::initializer_list<const char*> words) const {
        if (joint < 0) return -1;
        int nearest = -1;
        std::size_t least = 0;
        for (const char* word : words) {
            const int found = find(side, {word});
            if (found < 0 || found == joint) continue;
            const std::vector<int> above = ancestors(motion_, found);
            const auto place = std::find(above.begin(), above.end(), joint);
            const auto steps = static_cast<std::size_t>(place - above.begin());
            if (place == above.end() || (nearest >= 0 && steps >= least)) continue;
            nearest = found, least = steps;
        }
        return nearest >= 0 ? nearest : outermost_child(motion_, joint);
    }
    int first_tail() const {
        for (std::size_t j = 0; j < names_.size(); ++j)
            if (names_[j].word.starts_with("tail") && is_here(static_cast<int>(j)))
                return static_cast<int>(j);
        return -1;
    }

    MotionJoints::Side side(BodySide which) const {
        // A skeleton with an "arm" calls its collar bone "shoulder"; one with an elbow joint, its upper arm.
        MotionJoints::Side s;
        s.upper_arm = find(which, {"uparm", "arm", "humerus", "shoulder"});
        s.forearm = find(which, {"lowarm", "elbow", "radius"});
        s.thigh = find(which, {"upleg", "thigh", "femur", "hip", "hips"});
        s.shin = find(which, {"lowleg", "shin", "calf", "knee", "tibia", "leg"});
        if (s.thigh < 0) s.thigh = find(which, {"leg"});
        s.hand = find_below(s.forearm, which, {"hand", "wrist"});
        s.foot = find_below(s.shin, which, {"foot", "ankle"});
        return s;
    }

public:
    static int outermost_child(const Motion& motion, int joint) {
        int child = -1;
        double longest = -1;
        for (std::size_t j = 0; j < motion.joints.size(); ++j) {
            const double size = length(motion.joints[j].offset);
            if (motion.joints[j].parent != joint || size <= longest) continue;
            longest = size;
            child = static_cast<int>(j);
        }
        return child;
    }

private:
    const Motion& motion_;
    const std::vector<SimpleName>& names_;
    int root_;
};

bool is_chain(const Motion& motion, int a, int b, int c) {
    if (a < 0 || b < 0 || c < 0 || a == b || b == c) return false;
    return common_ancestor(motion, a, b) == a && common_ancestor(motion, b, c) == b;
}

// Every required part is there, and forearms hang from upper arms.
bool is_complete(const Motion& motion, MotionJoints joints) {
    for (const Part& part : body_parts)
        if (part.required && *part.of(joints) < 0) return false;
    for (const MotionJoints::Side& s : {joints.left, joints.right})
        if (!is_chain(motion, s.upper_arm, s.forearm, s.hand) || !is_chain(motion, s.thigh, s.shin, s.foot))
            return false;
    return true;
}

// The way from the neck, or from the chest, that no limb takes ends in the head.
void find_head(const Motion& motion, int chest, MotionJoints& joints) {
    std::vector<int> limbs;
    for (const int limb :
         {joints.left.upper_arm, joints.right.upper_arm, joints.left.thigh, joints.right.thigh})
        for (const int joint : ancestors(motion, limb))
            if (joint != chest) limbs.push_back(joint);
    std::vector<int> way = longest_way(motion, joints.neck >= 0 ? joints.neck : chest, limbs);
    while (!way.empty() && motion.joints[at(way.back())].name.empty()) way.pop_back(); // its end site
    if (way.empty()) return;
    if (joints.neck < 0) joints.neck = way.front();
    if (way.back() != joints.neck) joints.head = way.back();
}

// What the limbs tell of the rest.
void complete(const Motion& motion, MotionJoints& joints) {
    const int hips = common_ancestor(motion, joints.left.thigh, joints.right.thigh),
              chest = common_ancestor(motion, joints.left.upper_arm, joints.right.upper_arm);
    // The hips carry the legs; a "root" on the ground above them does, too, and is not meant.
    if (joints.hips < 0 || common_ancestor(motion, joints.hips, joints.left.thigh) != joints.hips)
        joints.hips = hips;
    if (joints.head < 0 && chest >= 0) find_head(motion, chest, joints);
    if (joints.head >= 0) joints.head_end = NameMatcher::outermost_child(motion, joints.head);
    if (joints.plan != BodyPlan::bird)
        joints.plan = body_axes(motion, joints).on_four_legs ? BodyPlan::quadruped : BodyPlan::humanoid;
}

std::string list_of_names(const Motion& motion) {
    std::string names;
    for (const MotionJoint& joint : motion.joints)
        if (!joint.name.empty() && names.size() < 300) names += (names.empty() ? "" : ", ") + joint.name;
    return names;
}

void apply(const JointMap& by_hand, const Motion& motion, MotionJoints& joints) {
    for (const auto& [part, name] : by_hand) {
        const auto joint = std::find_if(motion.joints.begin(), motion.joints.end(),
                                        [&](const MotionJoint& j) { return j.name == name; });
        for (const Part& p : body_parts)
            if (p.name == part) *p.of(joints) = static_cast<int>(joint - motion.joints.begin());
    }
    for (MotionJoints::Side* s : {&joints.left, &joints.right}) {
        if (s->hand < 0 && s->forearm >= 0) s->hand = NameMatcher::outermost_child(motion, s->forearm);
        if (s->foot < 0 && s->shin >= 0) s->foot = NameMatcher::outermost_child(motion, s->shin);
    }
}

void check(const JointMap& by_hand, const Motion& motion, const std::string& file) {
    std::vector<std::string> names;
    for (const MotionJoint& joint : motion.joints)
        if (!joint.name.empty()) names.push_back(joint.name);
    for (const auto& [part, name] : by_hand)
        if (std::find(names.begin(), names.end(), name) == names.end())
            throw Error(ErrorKind::input, file + ": has no joint '" + name + "', which is to play the " +
                                              part + did_you_mean(name, names));
}

[[noreturn]] void refuse(const Motion& motion, MotionJoints joints, const std::string& file) {
    std::string missing = "left upper arm";
    for (const Part& part : body_parts)
        if (part.required && *part.of(joints) < 0) {
            missing = part.name;
            break;
        }
    throw Error(ErrorKind::input, file + ": no joint plays the " + missing + " (" + list_of_names(motion) +
                                      "); --motion-map names the joints by hand");
}

} // namespace

MotionJoints match_joints(const Motion& motion, const std::string& file, const JointMap& by_hand) {
    check(by_hand, motion, file);
    const std::vector<SimpleName> names = names_of(motion);
    std::optional<MotionJoints> incomplete;
    for (std::size_t j = 0; j < motion.joints.size(); ++j) {
        if (motion.joints[j].parent >= 0) continue;
        const int root = static_cast<int>(j);
        MotionJoints named = NameMatcher(motion, names, root).match();
        apply(by_hand, motion, named);
        if (!incomplete) incomplete = named;
        if (!is_complete(motion, named)) {
            std::optional<MotionJoints> shaped = joints_by_shape(motion, names, root);
            if (!shaped) continue;
            shaped->plan = named.plan;
            apply(by_hand, motion, *shaped);
            if (!is_complete(motion, *shaped)) continue;
            named = *shaped;
        }
        complete(motion, named);
        return named;
    }
    refuse(motion, *incomplete, file);
}

JointMap match_table(const Motion& motion, const MotionJoints& joints) {
    JointMap table;
    if (joints.plan != BodyPlan::humanoid)
        table.emplace_back("body", joints.plan == BodyPlan::quadruped ? "quadruped" : "bird");
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
    std::vector<std::string> names;
    for (const Part& part : body_parts) names.emplace_back(part.name);
    return names;
}

} // namespace pantin
