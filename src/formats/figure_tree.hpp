// SPDX-License-Identifier: MIT
// The joints of a figure as trees.
#pragma once

#include <algorithm>
#include <vector>

#include "formats/figure_joints.hpp"

namespace pantin {

// Indices are those of the joints, whose parents make no cycle.
class FigureTree {
public:
    explicit FigureTree(const std::vector<FigureJoint>& joints) : children_(joints.size()) {
        for (int j = 0; j < static_cast<int>(joints.size()); ++j)
            if (const int parent = joints[j].parent; parent < 0)
                order_.push_back(j);
            else
                children_[parent].push_back(j);
        for (std::size_t k = 0; k < order_.size(); ++k) {
            const std::vector<int>& next = children_[order_[k]];
            order_.insert(order_.end(), next.begin(), next.end());
        }
        length_.resize(joints.size(), 1);
        forks_.resize(joints.size(), 0);
        for (auto j = order_.rbegin(); j != order_.rend(); ++j)
            for (const int child : children_[*j]) {
                length_[*j] = std::max(length_[*j], length_[child] + 1);
                forks_[*j] = forks_[*j] || forks_[child] || children_[*j].size() > 1;
            }
    }

    const std::vector<int>& parents_first() const { return order_; }
    const std::vector<int>& children(int j) const { return children_[j]; }
    int length(int j) const { return length_[j]; } // joints of the longest way from it outwards
    bool forks(int j) const { return forks_[j] != 0; }

private:
    std::vector<std::vector<int>> children_;
    std::vector<int> order_, length_;
    std::vector<char> forks_;
};

} // namespace pantin
