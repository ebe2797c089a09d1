// SPDX-License-Identifier: MIT
// How a drawing was meant to be held. Own: the thesis takes pages as they come.
//
// The segmentation network sees the drawing in all four turns. Each time its head of turns says how many more
// bring it upright; the mean of these answers, brought back to the drawing, decides together with the
// confidence of the parts, which is larger when the drawing stands as those of the training did. One look is
// enough for a drawing that the head takes for upright.
#include <algorithm>

#include "core/math.hpp"
#include "pantin/error.hpp"
#include "pantin/image.hpp"
#include "segmentation/letterbox.hpp"
#include "segmentation/segmenter_model.hpp"
#include "segmentation/views.hpp"

namespace pantin {
namespace {

using Scores = TurnProbabilities::value_type;
constexpr std::size_t turns = std::tuple_size_v<Scores>;

// Fitted by logistic regression on the drawings of fold 0, five folds (weights/README.md).
constexpr double head_weight = 1.1, confidence_weight = 15;
constexpr double surely_upright = 0.9; // by the head alone

// Probabilities of scores, exp of each over the sum of all.
Scores softmax(const Scores& scores) {
    const double largest = *std::max_element(scores.begin(), scores.end());
    Scores result;
    double sum = 0;
    for (std::size_t k = 0; k < turns; ++k) sum += result[k] = math::exp(scores[k] - largest);
    for (double& value : result) value /= sum;
    return result;
}

} // namespace

TurnProbabilities Segmenter::find_turn(const GreyImage& drawn, const SegmentationOptions& options) const {
    if (drawn.empty()) throw Error(ErrorKind::internal, "segmentation: the crop is empty");
    const segmentation::SegmentationNetwork& net = *model_->network;
    const network::Runtime runtime(options.threads);
    Scores sum{};
    for (std::size_t shown = 0; shown < turns; ++shown) {
        const auto encoded =
            net.encode(segmentation::to_input(darkness_of(turned(drawn, 90 * static_cast<int>(shown))),
                                              net.input, options.grey_erosion == GreyErosion::always),
                       runtime);
        if (encoded->turn.size() != turns) return std::nullopt;
        Scores said;
        std::copy(encoded->turn.begin(), encoded->turn.end(), said.begin());
        if (shown == 0 && said[0] >= surely_upright) return said;
        // Shown after `shown` turns, k − shown more bring it upright when k do.
        for (std::size_t k = 0; k < turns; ++k)
            sum[k] += head_weight / turns * math::log(std::max(said[(k + turns - shown) % turns], 1e-9));
        sum[shown] += confidence_weight *
                      segmentation::confidence_of(
                          encoded->decode(segmentation::most_probable(encoded->router), runtime).parts);
    }
    return softmax(sum);
}

} // namespace pantin
