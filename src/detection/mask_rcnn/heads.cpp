// SPDX-License-Identifier: MIT
// The heads on regions: what is in a box, where the box is exactly, and which of its pixels belong to it.
#include <algorithm>
#include <cmath>

#include "detection/mask_rcnn/mask_rcnn.hpp"

namespace pantin::mask_rcnn {
namespace {

constexpr float displacement_weights[4] = {10, 10, 5, 5};

// ⌊k₀ + log₂(√area / canonical) + 10⁻⁶⌋ (Lin et al. 2017, Eq. 1), cut to the levels that there are; by
// comparisons, so that no logarithm is rounded.
int level_of(const Region& box, int levels, int first_level, const DetectionOptions& options) {
    const double size = std::sqrt(static_cast<float>(area(box)));
    constexpr double just_below_one = 0.99999930685306; // 2^(−10⁻⁶)
    int level = 0;
    for (; level + 1 < levels; ++level) {
        const int next = first_level + level + 1 - options.canonical_level;
        if (size < options.canonical_size * std::ldexp(just_below_one, next)) break;
    }
    return level;
}

// log₂ of a level's stride, the nearest whole number.
template <class Map> int stride_exponent(const Map& level, const InputSize& image) {
    const double stride = static_cast<double>(image.clip_height) / level.height();
    int exponent = 0;
    while (stride / std::ldexp(1.0, exponent) > std::sqrt(2.0)) ++exponent;
    return exponent;
}

// Calls pool(level, boxes, their places among `regions`, the level's pixels per pixel) for each level that is
// read.
template <class Map, class Pool>
void pool_by_level(const std::vector<Map>& pyramid, const std::vector<Region>& regions,
                   const InputSize& image, const DetectionOptions& options, Pool pool) {
    const int levels = static_cast<int>(pyramid.size()) - 1; // the coarsest is for proposals alone
    std::vector<std::vector<int>> members(static_cast<std::size_t>(levels));
    const int first_level = stride_exponent(pyramid[0], image);
    for (std::size_t r = 0; r < regions.size(); ++r)
        members[static_cast<std::size_t>(level_of(regions[r], levels, first_level, options))].push_back(
            static_cast<int>(r));
    for (std::size_t level = 0; level < members.size(); ++level) {
        if (members[level].empty()) continue;
        std::vector<Region> boxes;
        for (const int r : members[level]) boxes.push_back(regions[static_cast<std::size_t>(r)]);
        pool(pyramid[level], boxes, members[level],
             std::ldexp(1.0f, -stride_exponent(pyramid[level], image)));
    }
}

} // namespace

Tensor pool_regions(const std::vector<Tensor>& pyramid, const std::vector<Region>& regions, int size,
                    const InputSize& image, const DetectionOptions& options, const Runtime& runtime) {
    Tensor pooled =
        Tensor::uninitialised(static_cast<int>(regions.size()), pyramid[0].channels(), size, size);
    pool_by_level(pyramid, regions, image, options,
                  [&](const Tensor& level, const std::vector<Region>& boxes, const std::vector<int>& places,
                      float scale) {
                      network::roi_align(level, boxes, places, scale, options.sampling, runtime, pooled);
                  });
    return pooled;
}

network::integer::ByteTensor pool_regions(const std::vector<network::integer::ByteTensor>& pyramid,
                                          const std::vector<Region>& regions, int size, std::uint8_t zero,
                                          const InputSize& image, const DetectionOptions& options,
                                          const Runtime& runtime) {
    using network::integer::ByteTensor;
    ByteTensor pooled =
        ByteTensor::uninitialised(static_cast<int>(regions.size()), pyramid[0].channels, size, size);
    pool_by_level(pyramid, regions, image, options,
                  [&](const ByteTensor& level, const std::vector<Region>& boxes,
                      const std::vector<int>& places, float scale) {
                      network::roi_align(level, boxes, places, scale, options.sampling, zero, runtime,
                                         pooled);
                  });
    return pooled;
}

template <class A>
BoxScores BoxHead<A>::forward(const typename A::Map& pooled, const Runtime& runtime) const {
    const typename A::Map x = network::relu(fc7, network::relu(fc6, pooled, runtime), runtime);
    return {network::real(scores, x, runtime), network::real(displacements, x, runtime)};
}
template struct BoxHead<network::RealArithmetic>;
template struct BoxHead<network::IntegerArithmetic>;

std::vector<Found> find_boxes(const BoxScores& seen, const std::vector<Region>& proposals,
                              const InputSize& image, const DetectionOptions& options,
                              const Runtime& runtime) {
    const Tensor probabilities = network::softmax(seen.scores, runtime);
    std::vector<Region> boxes;
    std::vector<float> scores;
    std::vector<int> labels;
    for (int r = 0; r < probabilities.batch(); ++r)
        for (int label = 1; label < probabilities.channels(); ++label) {
            const float score = probabilities(r, label, 0, 0);
            if (!(score > options.score)) continue;
            const Region box =
                clipped(displaced(proposals[static_cast<std::size_t>(r)],
                                  seen.displacements.plane(r, 4 * label), displacement_weights),
                        image.clip_width, image.clip_height);
            if (box.right - box.left < options.least_side || box.bottom - box.top < options.least_side)
                continue;
            boxes.push_back(box);
            scores.push_back(score);
            labels.push_back(label);
        }
    std::vector<Found> found;
    for (const int i : network::non_maximum_suppression(boxes, scores, labels, options.overlap)) {
        if (static_cast<int>(found.size()) == options.most) break;
        found.push_back({boxes[i], scores[i], labels[i]});
    }
    return found;
}

template <class A> Tensor MaskHead<A>::forward(const typename A::Map& pooled, const Runtime& runtime) const {
    typename A::Map x = convs[0].forward(pooled, runtime);
    for (std::size_t i = 1; i < convs.size(); ++i) x = convs[i].forward(x, runtime);
    return network::real(logits, up.forward(x, runtime), runtime);
}
template struct MaskHead<network::RealArithmetic>;
template struct MaskHead<network::IntegerArithmetic>;

} // namespace pantin::mask_rcnn
