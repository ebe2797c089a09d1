// SPDX-License-Identifier: MIT
// The region proposal network (Ren et al. 2015): where there may be something.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "detection/mask_rcnn/mask_rcnn.hpp"

namespace pantin::mask_rcnn {
namespace {

constexpr float displacement_weights[4] = {1, 1, 1, 1};

// Positions of the `count` largest values, by descending value; equal values by position.
std::vector<int> largest(const std::vector<float>& values, int count) {
    std::vector<int> order(values.size());
    std::iota(order.begin(), order.end(), 0);
    const auto end = order.begin() + std::min<std::ptrdiff_t>(count, std::ssize(order));
    std::partial_sort(order.begin(), end, order.end(), [&](int a, int b) {
        return values[a] > values[b] || (values[a] == values[b] && a < b);
    });
    order.erase(end, order.end());
    return order;
}

struct Candidates {
    std::vector<Region> boxes;
    std::vector<float> logits;
    std::vector<int> levels;
};

void add_level(Candidates& candidates, const Objectness& seen, int level, const InputSize& size,
               const ProposalOptions& options) {
    const int anchors = seen.logits.channels(), grid_width = seen.logits.width(),
              grid_height = seen.logits.height();
    std::vector<float> logits; // in the order of the anchors: y, x, anchor
    for (int y = 0; y < grid_height; ++y)
        for (int x = 0; x < grid_width; ++x)
            for (int a = 0; a < anchors; ++a) logits.push_back(seen.logits(0, a, y, x));
    const std::vector<Region> boxes =
        make_anchors(options.sizes[static_cast<std::size_t>(level)], options.ratios, grid_width, grid_height,
                     size.width / grid_width, size.height / grid_height);
    for (const int i : largest(logits, options.per_level)) {
        const int a = i % anchors, x = i / anchors % grid_width, y = i / anchors / grid_width;
        float displacement[4];
        for (int k = 0; k < 4; ++k) displacement[k] = seen.displacements(0, 4 * a + k, y, x);
        const Region box = clipped(displaced(boxes[i], displacement, displacement_weights), size.clip_width,
                                   size.clip_height);
        if (box.right - box.left < options.least_side || box.bottom - box.top < options.least_side) continue;
        candidates.boxes.push_back(box);
        candidates.logits.push_back(logits[i]);
        candidates.levels.push_back(level);
    }
}

} // namespace

std::vector<Region> make_anchors(float size, const std::vector<float>& ratios, int grid_width,
                                 int grid_height, int stride_x, int stride_y) {
    std::vector<Region> cell;
    for (const float ratio : ratios) {
        const float root = std::sqrt(ratio);
        // Rounded to whole pixels, halves to even.
        const float x = std::rint(1 / root * size / 2), y = std::rint(root * size / 2);
        cell.push_back({-x, -y, x, y});
    }
    std::vector<Region> anchors;
    for (int row = 0; row < grid_height; ++row)
        for (int column = 0; column < grid_width; ++column)
            for (const Region& c : cell) {
                const auto x = static_cast<float>(column * stride_x), y = static_cast<float>(row * stride_y);
                anchors.push_back({x + c.left, y + c.top, x + c.right, y + c.bottom});
            }
    return anchors;
}

template <class A>
Objectness ProposalHead<A>::forward(const typename A::Map& features, const Runtime& runtime) const {
    const typename A::Map x = conv.forward(features, runtime);
    return {network::real(logits, x, runtime), network::real(displacements, x, runtime)};
}
template struct ProposalHead<network::RealArithmetic>;
template struct ProposalHead<network::IntegerArithmetic>;

std::vector<Region> propose(const std::vector<Objectness>& levels, const InputSize& size,
                            const ProposalOptions& options) {
    Candidates candidates;
    for (std::size_t level = 0; level < levels.size(); ++level)
        add_level(candidates, levels[level], static_cast<int>(level), size, options);
    // The logits order the boxes as their sigmoids would, without the ties that rounding makes.
    const std::vector<int> kept = network::non_maximum_suppression(candidates.boxes, candidates.logits,
                                                                   candidates.levels, options.overlap);
    std::vector<Region> proposals;
    for (const int i : kept) {
        if (static_cast<int>(proposals.size()) == options.total) break;
        proposals.push_back(candidates.boxes[i]);
    }
    return proposals;
}

} // namespace pantin::mask_rcnn
