// SPDX-License-Identifier: MIT
#include "animation/skeleton_shape.hpp"

#include <algorithm>
#include <cmath>

#include "animation/body_axes.hpp"

namespace pantin {
namespace {

constexpr int ring = 6;               // so many alike at one joint are no limbs
constexpr double alike = 0.08;        // by which the lengths of left and right may differ
constexpr double least_limb = 0.35;   // of the longest limb's length
constexpr double least_tail = 0.15;   // of a leg's length
constexpr double clearly = 1.1;       // longer: else the inner one of two places along a limb counts
constexpr double most_unlike = 1.8;   // upper against lower part of a limb
constexpr double stiff = 0.996;       // cosine: a joint that never bends more is a twist
constexpr std::size_t looked_at = 30; // frames

std::size_t at(int joint) { return static_cast<std::size_t>(joint); }

// Two children of a joint that mirror each other.
struct Pair {
    int joint = -1, depth = 0; // where they begin; below how many joints
    int a = -1, b = -1;
    double length = 0;
};

class Skeleton {
public:
    explicit Skeleton(const Motion& motion)
        : motion_(motion), children_(motion.joints.size()), reach_(motion.joints.size()),
          size_(motion.joints.size(), 1), depth_(motion.joints.size()) {
        const std::size_t step = std::max<std::size_t>(1, motion.frames() / looked_at);
        for (std::size_t i = 0; i < motion.frames(); i += step) poses_.push_back(joint_positions(motion, i));
        for (std::size_t j = motion.joints.size(); j-- > 0;) {
            const int parent = motion.joints[j].parent;
            if (parent < 0) continue;
            children_[at(parent)].insert(children_[at(parent)].begin(), static_cast<int>(j));
            reach_[at(parent)] = std::max(reach_[at(parent)], extent(static_cast<int>(j)));
            size_[at(parent)] += size_[j];
        }
        for (std::size_t j = 0; j < motion.joints.size(); ++j)
            if (const int parent = motion.joints[j].parent; parent >= 0) depth_[j] = depth_[at(parent)] + 1;
    }

    // From the joint's parent to the farthest end behind it.
    double extent(int joint) const {
        return distance(poses_[0][at(joint)], poses_[0][at(motion_.joints[at(joint)].parent)]) +
               reach_[at(joint)];
    }

    std::vector<int> longest_way(int joint, const std::vector<int>& without) const {
        std::vector<int> way;
        while (true) {
            int next = -1;
            for (const int child : children_[at(joint)]) {
                if (std::find(without.begin(), without.end(), child) != without.end()) continue;
                if (next < 0 || extent(child) > extent(next)) next = child;
            }
            if (next < 0) return way;
            way.push_back(joint = next);
        }
    }

    // The pairs of limbs below a root, none inside another, the longest first.
    std::vector<Pair> limb_pairs(int root) const {
        std::vector<Pair> all;
        for (std::size_t j = at(root); j < at(root) + static_cast<std::size_t>(size_[at(root)]); ++j)
            for (std::size_t x = 0; x < children_[j].size(); ++x)
                for (std::size_t y = x + 1; y < children_[j].size(); ++y)
                    if (const int a = children_[j][x], b = children_[j][y];
                        are_alike(a, b) && !is_one_of_many(a) && limb(a) && limb(b))
                        all.push_back({static_cast<int>(j), depth_[j], a, b, extent(a)});
        std::stable_sort(all.begin(), all.end(),
                         [](const Pair& p, const Pair& q) { return p.length > q.length; });
        std::vector<Pair> chosen;
        for (const Pair& pair : all) {
            const bool taken = std::any_of(chosen.begin(), chosen.end(), [&](const Pair& c) {
                return is_below(pair.joint, c.a) || is_below(pair.joint, c.b) || is_below(c.joint, pair.a) ||
                       is_below(c.joint, pair.b) || pair.a == c.a || pair.a == c.b || pair.b == c.a ||
                       pair.b == c.b;
            });
            if (taken || (!chosen.empty() && pair.length < least_limb * chosen[0].length)) continue;
            chosen.push_back(pair);
        }
        return chosen;
    }

    // Strips of a skirt hang in a ring.
    bool is_one_of_many(int joint) const {
        const int parent = motion_.joints[at(joint)].parent;
        const std::vector<int>& all = children_[at(parent)];
        const auto like = std::count_if(all.begin(), all.end(), [&](int other) {
            return std::abs(extent(other) - extent(joint)) < 0.35 * extent(joint);
        });
        return like >= ring;
    }

    // The joints where a limb begins, bends and ends.
    std::optional<std::array<int, 3>> limb(int first) const {
        std::vector<int> way = {first};
        for (const int joint : longest_way(first, {})) way.push_back(joint);
        // Without twists, and with all joints: an elbow that is straight throughout is no twist.
        std::optional<std::array<int, 3>> best;
        double longest = 0;
        for (const std::vector<int>& joints : {without_twists(way), way})
            for (std::size_t i = 0; i + 2 < joints.size(); ++i) {
                const double upper = between(joints[i], joints[i + 1]),
                             lower = between(joints[i + 1], joints[i + 2]);
                if (upper > most_unlike * lower || lower > most_unlike * upper ||
                    upper + lower <= clearly * longest)
                    continue;
                longest = upper + lower;
                best = {joints[i], joints[i + 1], joints[i + 2]};
            }
        // A hand that never bends is one all the same; its end site is none.
        if (best && is_end_site((*best)[2]) && motion_.joints[at((*best)[2])].parent != (*best)[1])
            (*best)[2] = motion_.joints[at((*best)[2])].parent;
        return best;
    }
    // The same of a limb with joints called wings: these.
    std::optional<std::array<int, 3>> wing(int first, const std::vector<SimpleName>& names) const {
        std::vector<int> way = longest_way(first, {});
        way.insert(way.begin(), first);
        for (std::size_t i = 0; i + 2 < way.size(); ++i)
            if (names[at(way[i])].word.find("wing") != std::string::npos)
                return std::array<int, 3>{way[i], way[i + 1], way[i + 2]};
        return std::nullopt;
    }

    bool is_below(int joint, int top) const {
        while (joint >= 0 && joint != top) joint = motion_.joints[at(joint)].parent;
        return joint == top;
    }

private:
    bool is_end_site(int joint) const { return motion_.joints[at(joint)].name.empty(); }
    double between(int a, int b) const { return distance(poses_[0][at(a)], poses_[0][at(b)]); }

    bool are_alike(int a, int b) const {
        const double p = extent(a), q = extent(b);
        if (!(std::max(p, q) > 1e-9) || std::abs(p - q) > alike * std::max(p, q)) return false;
        if (2 * std::min(size_[at(a)], size_[at(b)]) < std::max(size_[at(a)], size_[at(b)])) return false;
        return longest_way(a, {}).size() == longest_way(b, {}).size();
    }

    std::vector<int> without_twists(const std::vector<int>& way) const {
        std::vector<int> bending = {way.front()};
        for (std::size_t i = 1; i < way.size(); ++i) {
            const bool last = i + 1 == way.size();
            if (last || bends(bending.back(), way[i], way[i + 1])) bending.push_back(way[i]);
        }
        return bending;
    }
    bool bends(int before, int joint, int after) const {
        return std::any_of(poses_.begin(), poses_.end(), [&](const std::vector<Vec3>& pose) {
            const Vec3 in = pose[at(joint)] - pose[at(before)], out = pose[at(after)] - pose[at(joint)];
            return dot(in, out) < stiff * length(in) * length(out);
        });
    }

    const Motion& motion_;
    std::vector<std::vector<int>> children_;
    std::vector<double> reach_; // to the farthest end below
    std::vector<int> size_, depth_;
    std::vector<std::vector<Vec3>> poses_;
};

// Where a standing figure of this skeleton looks to: toes point forwards, four legs walk towards the head.
Vec3 forwards_of(const Motion& motion, const Skeleton& skeleton, const MotionJoints& joints,
                 const BodyAxes& axes, const std::vector<Vec3>& pose) {
    Vec3 forwards;
    if (axes.on_four_legs) {
        forwards = limb_directions(pose, joints).trunk;
    } else {
        for (const int foot : {joints.left.foot, joints.right.foot})
            for (const int toe : skeleton.longest_way(foot, {}))
                forwards = forwards + pose[at(toe)] - pose[at(motion.joints[at(toe)].parent)];
    }
    forwards = forwards - dot(forwards, axes.up) * axes.up;
    const double size = length(limb_directions(pose, joints).legs);
    if (length(forwards) > 0.02 * size) return forwards;
    return axes.up.y != 0 ? Vec3{0, 0, 1} : Vec3{0, -1, 0}; // what most programs write
}

BodySide side_of(const Motion& motion, const std::vector<SimpleName>& names, int joint) {
    for (; joint >= 0; joint = motion.joints[at(joint)].parent)
        if (names[at(joint)].side != BodySide::none) return names[at(joint)].side;
    return BodySide::none;
}

// Left and right change places where names or shape say so.
void settle_sides(const Motion& motion, const Skeleton& skeleton, const std::vector<SimpleName>& names,
                  MotionJoints& joints) {
    const BodyAxes axes = body_axes(motion, joints);
    const std::vector<Vec3> pose = axes.stands_at_rest ? rest_positions(motion) : joint_positions(motion, 0);
    const Vec3 left = cross(axes.up, forwards_of(motion, skeleton, joints, axes, pose));
    const auto wrong = [&](int l, int r) {
        const BodySide a = side_of(motion, names, l), b = side_of(motion, names, r);
        if (a != b) return a == BodySide::right || b == BodySide::left;
        return dot(pose[at(l)] - pose[at(r)], left) < 0;
    };
    const bool swap_arms = wrong(joints.left.hand, joints.right.hand),
               swap_legs = wrong(joints.left.foot, joints.right.foot);
    MotionJoints::Side &l = joints.left, &r = joints.right;
    if (swap_arms)
        std::swap(l.upper_arm, r.upper_arm), std::swap(l.forearm, r.forearm), std::swap(l.hand, r.hand);
    if (swap_legs) std::swap(l.thigh, r.thigh), std::swap(l.shin, r.shin), std::swap(l.foot, r.foot);
}

} // namespace

std::vector<int> longest_way(const Motion& motion, int joint, const std::vector<int>& without) {
    return Skeleton(motion).longest_way(joint, without);
}

std::vector<int> ancestors(const Motion& motion, int joint) {
    std::vector<int> all;
    for (; joint >= 0; joint = motion.joints[at(joint)].parent) all.push_back(joint);
    return all;
}

int outermost_child(const Motion& motion, int joint) {
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

int head_of(const Motion& motion, const std::vector<int>& way) {
    int head = -1;
    for (std::size_t i = 1; i < way.size(); ++i) {
        if (motion.joints[at(way[i])].name.empty()) break; // its end site
        head = way[i];
        const auto children = std::count_if(motion.joints.begin(), motion.joints.end(),
                                            [&](const MotionJoint& j) { return j.parent == head; });
        if (children > 1) break; // eyes, ears, a jaw
    }
    return head;
}

int common_ancestor(const Motion& motion, int a, int b) {
    const std::vector<int> above = ancestors(motion, a);
    for (; b >= 0; b = motion.joints[at(b)].parent)
        if (std::find(above.begin(), above.end(), b) != above.end()) return b;
    return -1;
}

std::optional<MotionJoints> joints_by_shape(const Motion& motion, const std::vector<SimpleName>& names,
                                            int root) {
    const Skeleton skeleton(motion);
    std::vector<Pair> pairs = skeleton.limb_pairs(root);
    if (pairs.size() < 2) return std::nullopt;
    // Legs begin nearest to the root, arms nearest to them: hair hangs from the head. At one joint, legs are
    // the longer ones, which come first.
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Pair& p, const Pair& q) { return p.depth < q.depth; });
    const auto& [legs, arms] = std::pair(pairs[0], pairs[1]);
    MotionJoints joints;
    const auto put = [&](int first, int& begin, int& bend, int& end) {
        auto limb = skeleton.wing(first, names);
        if (!limb) limb = skeleton.limb(first);
        if (limb) begin = (*limb)[0], bend = (*limb)[1], end = (*limb)[2];
        return limb.has_value();
    };
    MotionJoints::Side &l = joints.left, &r = joints.right;
    if (!put(legs.a, l.thigh, l.shin, l.foot) || !put(legs.b, r.thigh, r.shin, r.foot) ||
        !put(arms.a, l.upper_arm, l.forearm, l.hand) || !put(arms.b, r.upper_arm, r.forearm, r.hand))
        return std::nullopt;
    joints.hips = legs.joint;
    std::vector<int> limbs = {arms.a, arms.b, legs.a, legs.b};
    const std::vector<int> way = skeleton.longest_way(arms.joint, limbs);
    if (!way.empty()) joints.neck = way.front();
    joints.head = head_of(motion, way);
    for (const int joint : ancestors(motion, arms.joint)) limbs.push_back(joint);
    if (legs.joint != arms.joint) {
        joints.tail = skeleton.longest_way(legs.joint, limbs);
        const double leg = legs.length;
        if (joints.tail.empty() || skeleton.extent(joints.tail.front()) < least_tail * leg)
            joints.tail.clear();
        if (!joints.tail.empty() && skeleton.is_one_of_many(joints.tail.front())) joints.tail.clear();
    }
    settle_sides(motion, skeleton, names, joints);
    return joints;
}

} // namespace pantin
