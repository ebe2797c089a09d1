// SPDX-License-Identifier: MIT
// How a drawing was meant to be held, by the segmentation network's head for it. Own: the thesis takes pages
// as they come.
#include <algorithm>

#include "core/math.hpp"
#include "pantin/error.hpp"
#include "pantin/image.hpp"
#include "segmentation/letterbox.hpp"
#include "segmentation/segmenter_model.hpp"

namespace pantin {
namespace {

constexpr int turns = 4;

using Scores = std::array<double, turns>;

Scores log_softmax(const network::Tensor& scores) {
    const double largest = *std::max_element(scores.begin(), scores.end());
    double sum = 0;
    for (const float score : scores) sum += math::exp(score - largest);
    Scores result;
    std::transform(scores.begin(), scores.end(), result.begin(),
                   [&](float score) { return score - largest - math::log(sum); });
    return result;
}

// [1, 1, side, side] turned clockwise by a quarter.
network::Tensor quarter_turned(const network::Tensor& ink) {
    const int side = ink.width();
    network::Tensor result = network::Tensor::uninitialised(1, 1, side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) result(0, 0, x, side - 1 - y) = ink(0, 0, y, x);
    return result;
}

} // namespace

// The input is shown in all four turns: what the head says of each is brought back to the first, and the mean
// of the logarithms counts, so that a turned drawing gets the answer of the upright one, turned.
TurnProbabilities Segmenter::find_turn(const GreyImage& drawn, const SegmentationOptions& options) const {
    if (drawn.empty()) throw Error(ErrorKind::internal, "segmentation: the crop is empty");
    const segmentation::SegmentationNetwork& net = *model_->network;
    const network::Runtime runtime(options.threads);
    network::Tensor ink =
        segmentation::to_input(darkness_of(drawn), net.input, options.grey_erosion == GreyErosion::always);
    Scores sum{};
    for (int shown = 0; shown < turns; ++shown) {
        const network::Tensor scores = net.turn_scores(ink, runtime);
        if (scores.size() == 0) return std::nullopt;
        const Scores logs = log_softmax(scores);
        // Shown after `shown` quarter turns, `k − shown` more bring it upright when `k` do.
        for (int k = 0; k < turns; ++k)
            sum[static_cast<std::size_t>(k)] +=
                logs[static_cast<std::size_t>((k - shown + turns) % turns)] / turns;
        if (shown + 1 < turns) ink = quarter_turned(ink);
    }
    const double largest = *std::max_element(sum.begin(), sum.end());
    double total = 0;
    for (double& value : sum) total += value = math::exp(value - largest);
    for (double& value : sum) value /= total;
    return sum;
}

} // namespace pantin
