// SPDX-License-Identifier: MIT
// Which of many boxes meet a box: a binary tree of boxes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace pantin {

struct GridBox {
    std::array<std::int64_t, 3> low{INT64_MAX, INT64_MAX, INT64_MAX}, high{INT64_MIN, INT64_MIN, INT64_MIN};
    void include(const std::array<std::int64_t, 3>& p) {
        for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    }
    void include(const GridBox& box) { include(box.low), include(box.high); }
    bool meets(const GridBox& other) const {
        for (int k = 0; k < 3; ++k)
            if (low[k] > other.high[k] || other.low[k] > high[k]) return false;
        return true;
    }
};

class BoxTree {
public:
    explicit BoxTree(std::vector<GridBox> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
        std::iota(order_.begin(), order_.end(), 0);
        if (!boxes_.empty()) build(0, static_cast<int>(boxes_.size()));
    }
    // visit(i) for every box i that meets the given one, borders included.
    template <class Visit> void each(const GridBox& box, const Visit& visit) const {
        if (!nodes_.empty()) each(0, box, visit);
    }

private:
    static constexpr int leaf_size = 6;
    struct Node {
        GridBox box;
        int first, last, right; // the left child comes next; right < 0: a leaf
    };
    int build(int first, int last) {
        const int at = static_cast<int>(nodes_.size());
        GridBox box;
        for (int i = first; i < last; ++i) box.include(boxes_[order_[i]]);
        nodes_.push_back({box, first, last, -1});
        if (last - first <= leaf_size) return at;
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (box.high[k] - box.low[k] > box.high[axis] - box.low[axis]) axis = k;
        const int middle = (first + last) / 2;
        const auto place = [&](int i) { return boxes_[i].low[axis] + boxes_[i].high[axis]; };
        std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                         [&](int i, int k) { return place(i) != place(k) ? place(i) < place(k) : i < k; });
        build(first, middle);
        const int right = build(middle, last);
        nodes_[at].right = right;
        return at;
    }
    template <class Visit> void each(int at, const GridBox& box, const Visit& visit) const {
        const Node& node = nodes_[at];
        if (!node.box.meets(box)) return;
        if (node.right < 0) {
            for (int i = node.first; i < node.last; ++i)
                if (boxes_[order_[i]].meets(box)) visit(order_[i]);
            return;
        }
        each(at + 1, box, visit);
        each(node.right, box, visit);
    }

    std::vector<GridBox> boxes_;
    std::vector<int> order_;
    std::vector<Node> nodes_;
};

} // namespace pantin
