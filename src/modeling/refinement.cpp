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

using Threshold = double RefinementOptions::*;

class Refiner {
public:
    Refiner(const JointTree& skeleton, const std::vector<RefinementOptions>& limits,
            const StaysInside& inside)
        : skeleton_(skeleton), limits_(limits), inside_(inside), joints_(skeleton.joints),
          neighbours_(skeleton.joints.size()), gone_(skeleton.joints.size()), group_(skeleton.joints.size()) {
        std::iota(group_.begin(), group_.end(), 0);
        for (const auto& [a, b] : skeleton.bones) {
            neighbours_[a].push_back(b);
            neighbours_[b].push_back(a);
        }
    }

    // The two nearest junctions, one pair after the other, with what lies between them. The distance counts
    // from where a cluster came to lie, so that a row of many does not become one.
    void merge_junctions() {
        for (;;) {
            std::vector<Branch> all = branches();
            std::erase_if(all, [&](const Branch& branch) {
                const int a = branch.joints.front(), b = branch.joints.back();
                return !is_junction(a) || !is_junction(b) ||
                       branch.length >= limit(a, b, &RefinementOptions::merge);
            });
            std::stable_sort(all.begin(), all.end(),
                             [](const Branch& p, const Branch& q) { return p.length < q.length; });
            const auto merged = [&](const Branch& branch) { return merge(branch.joints); };
            if (std::none_of(all.begin(), all.end(), merged)) return;
        }
    }

    // The shortest branch that ends, one after the other.
    void prune() {
        for (;;) {
            const std::vector<Branch> all = branches();
            const Branch* shortest = nullptr;
            for (const Branch& branch : all) {
                const int front = branch.joints.front(), back = branch.joints.back();
                if (!(is_end(front) && is_junction(back)) && !(is_end(back) && is_junction(front))) continue;
                if (branch.length >= limits_[joints_[is_end(front) ? front : back].part].prune) continue;
                if (!shortest || branch.length < shortest->length) shortest = &branch;
            }
            if (!shortest) return;
            for (const int j : shortest->joints)
                if (!is_junction(j)) gone_[j] = 1;
            for (auto& neighbours : neighbours_) std::erase_if(neighbours, [&](int n) { return gone_[n]; });
            for (const int j : shortest->joints)
                if (gone_[j]) neighbours_[j].clear();
        }
    }

    // Bones between two inner joints, the shortest first.
    void collapse() {
        contract_short_bones(&RefinementOptions::collapse,
                             [&](int a, int b) { return !is_end(a) && !is_end(b); });
    }
    void collapse_rest() {
        contract_short_bones(&RefinementOptions::least_bone, [](int, int) { return true; });
    }

    JointTree result() {
        JointTree refined;
        std::vector<int> place(joints_.size(), -1);
        for (int j = 0; j < std::ssize(place); ++j)
            if (!gone_[j] && root(j) == j) {
                place[j] = static_cast<int>(refined.joints.size());
                refined.joints.push_back(joints_[j]);
            }
        for (const auto& [a, b] : skeleton_.bones)
            if (!gone_[root(a)] && !gone_[root(b)] && root(a) != root(b))
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
    double limit(int a, int b, Threshold threshold) const {
        return std::max(limits_[joints_[a].part].*threshold, limits_[joints_[b].part].*threshold);
    }
    double span(int a, int b) const { return distance(joints_[a].place, joints_[b].place); }

    // The ends of a chain become one, at the place of the wider. False where bones would leave their part.
    bool merge(const std::vector<int>& chain) {
        const int a = chain.front(), b = chain.back();
        const bool first = joints_[a].radius >= joints_[b].radius;
        if (!takes_over(first ? a : b, first ? b : a, chain)) return false;
        const JointTree::Joint widest = joints_[first ? a : b];
        int all = a;
        for (std::size_t i = 1; i < chain.size(); ++i) all = contract(all, chain[i]);
        joints_[all] = widest;
        return true;
    }

    // Whether a joint can have another one's neighbours, those in `chain` apart.
    bool takes_over(int kept, int other, const std::vector<int>& chain) const {
        if (!inside_) return true;
        const JointTree::Joint& joint = joints_[kept];
        return std::none_of(neighbours_[other].begin(), neighbours_[other].end(), [&](int n) {
            const bool between = std::find(chain.begin(), chain.end(), n) != chain.end();
            return !between && n != kept && joints_[n].part == joint.part &&
                   !inside_(joint.part, joint.place, joints_[n].place);
        });
    }

    // Two neighbours become one, at the place of the wider; returns it.
    int contract(int a, int b) {
        const int kept = std::min(a, b), other = std::max(a, b);
        const bool first =
            joints_[a].radius > joints_[b].radius || (joints_[a].radius == joints_[b].radius && a < b);
        const JointTree::Joint wider = joints_[first ? a : b];
        std::erase(neighbours_[kept], other);
        for (const int n : neighbours_[other])
            if (n != kept) {
                std::replace(neighbours_[n].begin(), neighbours_[n].end(), other, kept);
                neighbours_[kept].push_back(n);
            }
        neighbours_[other].clear();
        group_[other] = kept;
        joints_[kept] = wider;
        return kept;
    }

    struct Bone {
        double length;
        int kept, other;
    };
    // Which of two joints stays: the wider one, but an end rather than a joint between two bones, which it is
    // the tip of, and a junction rather than an end; the other one where the bones would leave the part.
    bool choose(int a, int b, Bone& bone) const {
        bool first =
            joints_[a].radius > joints_[b].radius || (joints_[a].radius == joints_[b].radius && a < b);
        if (is_end(a) != is_end(b)) {
            const bool at_junction = is_junction(a) || is_junction(b);
            first = is_end(a) != at_junction;
        }
        for (const bool turn : {first, !first}) {
            bone = {span(a, b), turn ? a : b, turn ? b : a};
            if (takes_over(bone.kept, bone.other, {})) return true;
        }
        return false;
    }

    template <class Condition> void contract_short_bones(Threshold threshold, Condition&& condition) {
        for (;;) {
            Bone shortest{std::numeric_limits<double>::infinity(), -1, -1};
            for (int a = 0; a < std::ssize(joints_); ++a)
                for (const int b : neighbours_[a]) {
                    if (b < a || !condition(a, b)) continue;
                    const double length = span(a, b);
                    if (length >= limit(a, b, threshold) || length >= shortest.length) continue;
                    if (Bone bone{}; choose(a, b, bone)) shortest = bone;
                }
            if (shortest.kept < 0) return;
            const JointTree::Joint place = joints_[shortest.kept];
            joints_[contract(shortest.kept, shortest.other)] = place;
        }
    }

    std::vector<Branch> branches() const {
        std::vector<Branch> found;
        for (std::vector<int>& chain : chains_of(neighbours_)) {
            double length = 0;
            for (std::size_t i = 1; i < chain.size(); ++i) length += span(chain[i - 1], chain[i]);
            found.push_back({std::move(chain), length});
        }
        return found;
    }

    const JointTree& skeleton_;
    const std::vector<RefinementOptions>& limits_;
    const StaysInside& inside_;
    std::vector<JointTree::Joint> joints_; // of a group, at its root
    std::vector<std::vector<int>> neighbours_;
    std::vector<char> gone_;
    std::vector<int> group_; // union-find; the smallest joint of a group is its root
};

void widen(ThresholdRange& range, double length) {
    range.least = range.most > 0 ? std::min(range.least, length) : length;
    range.most = std::max(range.most, length);
}

} // namespace

JointTree refine(const JointTree& tree, const std::vector<RefinementOptions>& limits,
                 const StaysInside& inside) {
    Refiner refiner(tree, limits, inside);
    refiner.merge_junctions();
    refiner.prune();
    refiner.collapse();
    refiner.collapse_rest();
    return refiner.result();
}

RefinementOptions times(const RefinementOptions& shares, double length) {
    return {shares.merge * length, shares.prune * length, shares.collapse * length,
            shares.least_bone * length};
}

ThresholdRanges threshold_ranges(const JointTree& tree) {
    std::vector<std::vector<int>> neighbours(tree.joints.size());
    for (const auto& [a, b] : tree.bones) {
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
    }
    const auto degree = [&](int j) { return neighbours[j].size(); };
    ThresholdRanges ranges;
    for (const auto& [a, b] : tree.bones)
        if (degree(a) > 1 && degree(b) > 1)
            widen(ranges.collapse, distance(tree.joints[a].place, tree.joints[b].place));
    for (const std::vector<int>& chain : chains_of(neighbours)) {
        double length = 0;
        for (std::size_t i = 1; i < chain.size(); ++i)
            length += distance(tree.joints[chain[i - 1]].place, tree.joints[chain[i]].place);
        const std::size_t fewer = std::min(degree(chain.front()), degree(chain.back()));
        const std::size_t more = std::max(degree(chain.front()), degree(chain.back()));
        if (fewer > 2) widen(ranges.merge, length);
        if (fewer == 1 && more > 2) widen(ranges.prune, length);
    }
    return ranges;
}

SubSkeleton refine(const SubSkeleton& skeleton, const RefinementOptions& options) {
    const double diagonal = diagonal_of(skeleton.outline.corners);
    JointTree tree;
    for (const SubSkeleton::Joint& joint : skeleton.joints)
        tree.joints.push_back({{joint.place.x, joint.place.y, 0}, joint.radius, 0});
    tree.bones = skeleton.bones;
    const JointTree refined = refine(tree, {times(options, diagonal)});
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
