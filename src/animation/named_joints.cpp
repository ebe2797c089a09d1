// SPDX-License-Identifier: MIT
#include "animation/named_joints.hpp"

#include <algorithm>
#include <initializer_list>

#include "animation/skeleton_shape.hpp"

namespace pantin {
namespace {

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
        // A "root" may stand on the ground: the legs say where the hips are.
        joints.hips = find(BodySide::none, {"hips", "hip", "pelvis", "hipcenter", "hipscenter", "spinebase"});
        if (const int tail = first_tail(); tail >= 0) {
            joints.tail = longest_way(motion_, tail, {});
            joints.tail.insert(joints.tail.begin(), tail);
        }
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

    const Motion& motion_;
    const std::vector<SimpleName>& names_;
    int root_;
};

} // namespace

MotionJoints joints_by_name(const Motion& motion, const std::vector<SimpleName>& names, int root) {
    return NameMatcher(motion, names, root).match();
}

} // namespace pantin
