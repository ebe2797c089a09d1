// SPDX-License-Identifier: MIT
// Disjoint sets of 0 … n−1 (union–find with path halving). The smallest element of a set is its root, so that
// what is built on roots does not depend on the order of the unions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace pantin {

class DisjointSets {
public:
    explicit DisjointSets(std::size_t count = 0) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }
    // One more element, alone in its set; returns it.
    int add() {
        parent_.push_back(static_cast<int>(parent_.size()));
        return parent_.back();
    }
    int find(int i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    // Returns the root of the united set.
    int unite(int a, int b) {
        a = find(a), b = find(b);
        return parent_[std::max(a, b)] = std::min(a, b);
    }
    int size() const { return static_cast<int>(parent_.size()); }

private:
    std::vector<int> parent_;
};

} // namespace pantin
