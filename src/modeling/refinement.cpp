// SPDX-License-Identifier: MIT
// Ma et al. 2021, section 3.3, on one sub-skeleton or on the connected skeleton of a model.
#include <algorithm>
#include <limits>
#include <numeric>

#include "geometry/extent.hpp"
#include "modeling/chains.hpp"
#include "pantin/modeling.hpp"

namespace pantin {
namespace {

struct Branch {
    std::vector<int> joints; // from an end or a junction to the next one
    double length = 0;
};

class Refiner {
public:
    Refiner(const JointTree& skeleton, const std::vector<RefinementOptions>& limits)
        : skeleton_(skeleton), limits_(limits), neighbours_(skeleton.joints.size()),
          gone_(skeleton.joints.size()), group_(skeleton.joints.size()) {
        std::iota(group_.begin(), group_.end(), 0);
        for (const auto& [a, b] : skeleton.bones) {
            neighbours_[a].push_back(b);
            neighbours_[b].push_back(a);
        }
        for (int j = 0; j < std::ssize(neighbours_); ++j) was_junction_.push_back(is_junction(j));
    }

    // All branches that end are judged at once, by the skeleton as it was, so a star of short ones
    // becomes its junction.
    void prune() {
        for (const Branch& branch : branches()) {
            const bool ends = is_end(branch.joints.front()) != is_end(branch.joints.back());
            const int end = is_end(branch.joints.front()) ? branch.joints.front() : branch.joints.back();
            if (!ends || branch.length >= limits_[skeleton_.joints[end].part].prune) continue;
            const int junction = is_end(branch.joints.front()) ? branch.joints.back() : branch.joints.front();
            for (const int j : branch.joints) gone_[j] = gone_[j] || j != junction;
        }
        for (int j = 0; j < std::ssize(neighbours_); ++j)
            std::erase_if(neighbours_[j], [&](int n) { return gone_[j] || gone_[n]; });
    }

    // Along each branch a junction nearer than the limit to the last one that stays becomes that one.
    // Junctions that pruning made inner joints count as well, and what lies between near ones goes even where
    // they stay: so that a larger limit of prune() never gives more joints.
    void merge_junctions() {
        for (const Branch& branch : branches()) {
            const std::vector<int>& joints = branch.joints;
            std::size_t last = joints.size(); // junction
            double way = 0;                   // from the one that stays to the last one, in limits
            for (std::size_t i = 0; i < joints.size(); ++i) {
                if (!was_junction_[joints[i]]) continue;
                double span = std::numeric_limits<double>::infinity();
                if (last < i)
                    span = in_limits(length_of(joints, last, i), joints[last], joints[i],
                                     &RefinementOptions::merge);
                if (span < 1)
                    for (std::size_t k = last + 1; k < i; ++k)
                        join(joints[k], is_end(joints[last]) ? joints[i] : joints[last]);
                way += span;
                if (way < 1 && !is_end(joints[last]) && !is_end(joints[i]))
                    join(joints[i], joints[last]);
                else
                    way = 0;
                last = i;
            }
        }
    }

    // Along each branch an inner joint nearer than the limit to the last one that stays becomes that one. The
    // way along the branch counts, so that a branch of many short bones is thinned and does not shrink to a
    // joint.
    void collapse() {
        for (const Branch& branch : branches()) {
            const std::vector<int>& joints = branch.joints;
            double way = 0; // from the joint that stays, in limits
            for (std::size_t i = 1; i < joints.size(); ++i) {
                const int a = joints[i - 1], b = joints[i];
                if (is_end(a) || is_end(b)) continue;
                if (root(a) != root(b))
                    way += in_limits(length_of(joints, i - 1, i), a, b, &RefinementOptions::collapse);
                if (way < 1)
                    join(a, b);
                else
                    way = 0;
            }
        }
    }

    JointTree result() {
        JointTree refined;
        std::vector<int> place(skeleton_.joints.size(), -1);
        for (int j = 0; j < std::ssize(place); ++j) {
            if (gone_[j]) continue;
            const int g = root(j);
            if (place[g] < 0) {
                place[g] = static_cast<int>(refined.joints.size());
                refined.joints.push_back(skeleton_.joints[j]);
            } else if (skeleton_.joints[j].radius > refined.joints[place[g]].radius) {
                refined.joints[place[g]] = skeleton_.joints[j];
            }
        }
        for (const auto& [a, b] : skeleton_.bones)
            if (!gone_[a] && !gone_[b] && root(a) != root(b))
                refined.bones.emplace_back(place[root(a)], place[root(b)]);
        return refined;
    }

private:
    bool is_end(int j) const { return neighbours_[j].size() == 1; }
    bool is_junction(int j) const { return neighbours_[j].size() > 2; }
    int root(int j) const {
        while (group_[j] != j) j = group_[j];
        return j;
    }
    double limit(int a, int b, double RefinementOptions::*operation) const {
        return std::max(limits_[skeleton_.joints[a].part].*operation,
                        limits_[skeleton_.joints[b].part].*operation);
    }
    double in_limits(double way, int a, int b, double RefinementOptions::*operation) const {
        const double least = limit(a, b, operation);
        return least > 0 ? way / least : std::numeric_limits<double>::infinity();
    }
    double length_of(const std::vector<int>& chain, std::size_t first, std::size_t last) const {
        double sum = 0;
        for (std::size_t i = first; i < last; ++i)
            sum += distance(skeleton_.joints[chain[i]].place, skeleton_.joints[chain[i + 1]].place);
        return sum;
    }
    void join(int a, int b) { group_[std::max(root(a), root(b))] = std::min(root(a), root(b)); }

    std::vector<Branch> branches() const {
        std::vector<Branch> found;
        for (std::vector<int>& chain : chains_of(neighbours_)) {
            const double length = length_of(chain, 0, chain.size() - 1);
            found.push_back({std::move(chain), length});
        }
        return found;
    }

    const JointTree& skeleton_;
    const std::vector<RefinementOptions>& limits_;
    std::vector<std::vector<int>> neighbours_;
    std::vector<char> gone_;
    std::vector<char> was_junction_; // before pruning
    std::vector<int> group_;         // union-find; the smallest joint of a group is its root
};

} // namespace

JointTree refine(const JointTree& tree, const std::vector<RefinementOptions>& limits) {
    Refiner refiner(tree, limits);
    refiner.prune();
    refiner.merge_junctions();
    refiner.collapse();
    return refiner.result();
}

SubSkeleton refine(const SubSkeleton& skeleton, const RefinementOptions& options) {
    const double diagonal = diagonal_of(skeleton.outline.corners);
    JointTree tree;
    for (const SubSkeleton::Joint& joint : skeleton.joints)
        tree.joints.push_back({{joint.place.x, joint.place.y, 0}, joint.radius, 0});
    tree.bones = skeleton.bones;
    const JointTree refined =
        refine(tree, {{options.prune * diagonal, options.merge * diagonal, options.collapse * diagonal}});
    SubSkeleton result;
    result.outline = skeleton.outline;
    for (const JointTree::Joint& joint : refined.joints)
        result.joints.push_back({{joint.place.x, joint.place.y}, joint.radius});
    result.bones = refined.bones;
    std::vector<std::vector<int>> neighbours(result.joints.size());
    for (const auto& [a, b] : result.bones) {
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
    }
    result.branches = chains_of(neighbours);
    return result;
}

} // namespace pantin
