// SPDX-License-Identifier: MIT
// Ma et al. 2021, section 3.2: sub-skeletons become one skeleton, or several when parts do not meet.
#include <algorithm>
#include <limits>
#include <tuple>

#include "pantin/modeling.hpp"

namespace pantin {
namespace {

struct Foot {
    double distance = 0;
    double share = 0;    // of the way along the bone
    bool inside = false; // the bone's influence region holds the point
};

// Eq. (1): the distance from p to the bone a–b.
Foot foot_of(Vec3 p, Vec3 a, Vec3 b) {
    const Vec3 along = b - a;
    const double square = dot(along, along);
    const double t = square > 0 ? dot(p - a, along) / square : 0;
    const bool inside = square > 0 && t > 0 && t < 1;
    const double share = inside ? t : t <= 0 ? 0 : 1;
    return {distance(p, a + share * along), share, inside};
}

// Balls and cylinders leave the corners of a part free, and parts may meet there alone: balls that are nearer
// than this share of the part's widest one meet, too.
constexpr double corner_reach = 0.25;

struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    double gap = std::numeric_limits<double>::infinity(); // to the surface of the balls and cylinders;
                                                          // negative: inside
    int joint = -1;                                       // of the child
    int bone = -1;         // of the parent; −1: its joint `parent_joint` alone
    int parent_joint = -1; // the end of the bone when the foot is not inside
    double share = 0;
    bool split = false;
};

class Connector {
public:
    Connector(const std::vector<JointTree>& parts, const std::vector<ParentWish>& wishes,
              const std::vector<std::vector<JointTree::Joint>>& balls)
        : parts_(parts), wishes_(wishes), balls_(balls) {
        balls_.resize(parts.size());
    }

    Connection run() {
        for (int part = 0; part < std::ssize(parts_); ++part) {
            const int first = static_cast<int>(connected_.tree.joints.size());
            Attachment attachment;
            Nearest nearest;
            attachment.parent = choose_parent(part);
            if (attachment.parent >= 0) nearest = nearest_to(part, attachment.parent, true);
            if (nearest.joint >= 0 && nearest.gap > 0)
                nearest = nearest_to(part, attachment.parent, true, true);
            add(part, first);
            if (nearest.joint >= 0) attach(attachment, nearest, first);
            connected_.attachments.push_back(attachment);
        }
        return std::move(connected_);
    }

private:
    // Ends and junctions may be connected (Definitions 3 and 5), all joints where none of them lies in the
    // parent (`all`); a part of one joint has that one.
    std::vector<int> candidates(int part, bool all) const {
        std::vector<int> degree(parts_[part].joints.size());
        for (const auto& [a, b] : parts_[part].bones) ++degree[a], ++degree[b];
        std::vector<int> found;
        for (int j = 0; j < std::ssize(degree); ++j)
            if (all || degree[j] != 2) found.push_back(j);
        return found;
    }

    // Of the child's candidates and the parent's bones, as they are now (`divided`) or as they were drawn,
    // the nearest pair.
    Nearest nearest_to(int child, int parent, bool divided, bool all = false) const {
        const JointTree& tree = divided ? connected_.tree : parts_[parent];
        Nearest best;
        const auto offer = [&](int joint, const Foot& foot, double radius, int bone, int end) {
            best.gap = std::min(best.gap, foot.distance - radius);
            if (foot.distance < best.distance)
                best = {foot.distance, best.gap, joint, bone, end, foot.share, foot.inside};
        };
        for (const int joint : candidates(child, all)) {
            const Vec3 p = parts_[child].joints[joint].place;
            for (int j = 0; j < std::ssize(tree.joints); ++j)
                if (!divided || tree.joints[j].part == parent)
                    offer(joint, {distance(p, tree.joints[j].place), 0, false}, tree.joints[j].radius, -1, j);
            for (int b = 0; b < std::ssize(tree.bones); ++b) {
                const auto [from, to] = tree.bones[b];
                const JointTree::Joint &a = tree.joints[from], &c = tree.joints[to];
                if (divided && (a.part != parent || c.part != parent)) continue;
                const Foot foot = foot_of(p, a.place, c.place);
                if (foot.inside) offer(joint, foot, a.radius + foot.share * (c.radius - a.radius), b, -1);
            }
            for (const JointTree::Joint& ball : balls_[parent])
                best.gap = std::min(best.gap, distance(p, ball.place) - ball.radius);
        }
        return best;
    }

    // Whether the balls and cylinders of two parts meet: those of one against the balls of the other.
    double clearance(int child, int parent) const {
        double least = std::numeric_limits<double>::infinity();
        const auto against = [&](const JointTree& balls, const JointTree& cylinders) {
            for (const JointTree::Joint& ball : balls.joints) {
                for (const JointTree::Joint& other : cylinders.joints)
                    least = std::min(least, distance(ball.place, other.place) - ball.radius - other.radius);
                for (const auto& [from, to] : cylinders.bones) {
                    const JointTree::Joint &a = cylinders.joints[from], &c = cylinders.joints[to];
                    const Foot foot = foot_of(ball.place, a.place, c.place);
                    if (foot.inside)
                        least = std::min(least, foot.distance - ball.radius -
                                                    (a.radius + foot.share * (c.radius - a.radius)));
                }
            }
        };
        against(parts_[child], parts_[parent]);
        against(parts_[parent], parts_[child]);
        for (const JointTree::Joint& ball : balls_[child])
            for (const JointTree::Joint& other : balls_[parent])
                least = std::min(least, distance(ball.place, other.place) - ball.radius - other.radius);
        return least;
    }

    // The part or its copy, which comes right after it.
    int nearer_copy(int part, int parent) const {
        const int copy = parent + 1;
        if (parent < 0 || copy >= part || wishes_[copy].like != parent) return parent;
        return nearest_to(part, copy, false).distance < nearest_to(part, parent, false).distance ? copy
                                                                                                 : parent;
    }

    int choose_parent(int part) const {
        const auto [wanted, like] = wishes_[part];
        if (wanted >= 0) return nearer_copy(part, wanted);
        if (like >= 0) {
            const int parent = connected_.attachments[like].parent;
            const bool is_copy = parent > 0 && wishes_[parent].like >= 0;
            return nearer_copy(part, is_copy ? wishes_[parent].like : parent);
        }
        int best = -1;
        double nearest = std::numeric_limits<double>::infinity();
        for (int other = 0; other < part; ++other) {
            const Nearest found = nearest_to(part, other, false);
            if (found.gap <= 0 && found.distance < nearest)
                std::tie(best, nearest) = std::tuple(other, found.distance);
        }
        if (best >= 0) return best;
        nearest = corner_reach * widest_ball(part);
        for (int other = 0; other < part; ++other)
            if (const double gap = clearance(part, other); gap < nearest)
                std::tie(best, nearest) = std::tuple(other, gap);
        return best;
    }

    double widest_ball(int part) const {
        double widest = 0;
        for (const JointTree::Joint& joint : parts_[part].joints) widest = std::max(widest, joint.radius);
        return widest;
    }

    void add(int part, int first) {
        for (JointTree::Joint joint : parts_[part].joints) {
            joint.part = part;
            connected_.tree.joints.push_back(joint);
        }
        for (const auto& [a, b] : parts_[part].bones)
            connected_.tree.bones.emplace_back(first + a, first + b);
    }

    void attach(Attachment& attachment, const Nearest& nearest, int first) {
        JointTree& tree = connected_.tree;
        attachment.joint = first + nearest.joint;
        attachment.split = nearest.split;
        attachment.parent_joint = nearest.parent_joint;
        if (nearest.split) {
            const auto [a, b] = tree.bones[nearest.bone];
            const JointTree::Joint from = tree.joints[a], to = tree.joints[b];
            attachment.parent_joint = static_cast<int>(tree.joints.size());
            tree.joints.push_back({from.place + nearest.share * (to.place - from.place),
                                   from.radius + nearest.share * (to.radius - from.radius),
                                   attachment.parent});
            tree.bones[nearest.bone].second = attachment.parent_joint;
            tree.bones.emplace_back(attachment.parent_joint, b);
        }
        tree.bones.emplace_back(attachment.parent_joint, attachment.joint);
    }

    const std::vector<JointTree>& parts_;
    const std::vector<ParentWish>& wishes_;
    std::vector<std::vector<JointTree::Joint>> balls_;
    Connection connected_;
};

} // namespace

Connection connect(const std::vector<JointTree>& parts, const std::vector<ParentWish>& wishes,
                   const std::vector<std::vector<JointTree::Joint>>& balls) {
    return Connector(parts, wishes, balls).run();
}

} // namespace pantin
