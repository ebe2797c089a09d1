// SPDX-License-Identifier: MIT
// Trees of joints in, the same with roots and parents out (docs/errata.md, 27).
#include "modeling/rooted.hpp"

#include <algorithm>
#include <numeric>

namespace pantin {

ModelSkeleton rooted(const JointTree& tree) {
    std::vector<std::vector<int>> neighbours(tree.joints.size());
    for (const auto& [a, b] : tree.bones) {
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
    }
    std::vector<int> order(tree.joints.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        const JointTree::Joint &p = tree.joints[a], &q = tree.joints[b];
        return p.part != q.part ? p.part < q.part : p.radius > q.radius;
    });
    ModelSkeleton skeleton;
    std::vector<char> known(tree.joints.size());
    for (const int root : order) {
        if (known[root]) continue;
        std::vector<std::pair<int, int>> open = {{root, -1}}; // joint, its parent in the result
        known[root] = 1;
        for (std::size_t i = 0; i < open.size(); ++i) {
            const auto [joint, parent] = open[i];
            const JointTree::Joint& j = tree.joints[joint];
            const int number = static_cast<int>(skeleton.joints.size());
            skeleton.joints.push_back({j.place, j.radius, j.part, parent});
            for (const int next : neighbours[joint])
                if (!known[next]) known[next] = 1, open.emplace_back(next, number);
        }
    }
    return skeleton;
}

} // namespace pantin
