// SPDX-License-Identifier: MIT
// The step (thesis 4.3): a crop and its detected silhouette to part labels and the direction of the
// character: the crop through the network, the final silhouette, the labels inside it.
#include <algorithm>

#include "pantin/error.hpp"
#include "pantin/image.hpp"
#include "pantin/segmentation.hpp"
#include "segmentation/final_silhouette.hpp"
#include "segmentation/letterbox.hpp"
#include "segmentation/part_labels.hpp"
#include "segmentation/segmenter_model.hpp"
#include "segmentation/views.hpp"

namespace pantin {

namespace {

long border_length(const Mask& region) {
    long count = 0;
    for (int y = 0; y < region.height(); ++y)
        for (int x = 0; x < region.width(); ++x) count += on_border(region, x, y);
    return count;
}

// Half of the ink's border is its strokes' length.
double stroke_ratio(const Grid<float>& ink, const Mask& silhouette) {
    Mask strokes(ink.width(), ink.height());
    std::transform(ink.begin(), ink.end(), strokes.begin(),
                   [](float darkness) { return darkness >= 1.0f / 3; });
    const long outline = border_length(silhouette);
    return outline == 0 ? 0
                        : 0.5 * static_cast<double>(border_length(strokes)) / static_cast<double>(outline);
}

} // namespace

Segmenter::Segmenter(std::span<const unsigned char> weights, const std::string& source)
    : model_(std::make_unique<Model>(
          Model{segmentation::load_segmentation_network(network::WeightFile(weights, source))})) {}
Segmenter::~Segmenter() = default;
Segmenter::Segmenter(Segmenter&&) noexcept = default;

Segmentation Segmenter::segment(const GreyImage& drawn, const Mask& mask, const SegmentationOptions& options,
                                bool exact_mask) const {
    if (drawn.empty() || mask.empty()) throw Error(ErrorKind::internal, "segmentation: the crop is empty");
    const segmentation::SegmentationNetwork& net = *model_->network;
    const network::Runtime runtime(options.threads);

    // 1. The network sees how dark the ink is, in its own square.
    const Grid<float> ink = darkness_of(drawn);
    const segmentation::NetworkResult seen = segmentation::segment_views(
        net, segmentation::to_input(ink, net.input, options.grey_erosion == GreyErosion::always),
        {options.mirror, options.tilt, options.inverse_temperature, options.sufficient_confidence}, runtime);

    Segmentation result;
    result.confidence = seen.confidence;
    result.expert = net.expert_names[static_cast<std::size_t>(seen.expert)];
    for (std::size_t e = 0; e < net.expert_names.size(); ++e)
        result.router.emplace_back(net.expert_names[e], seen.router(0, static_cast<int>(e), 0, 0));
    for (std::size_t p = 0; p < result.pose.size(); ++p)
        result.pose[p] = seen.pose(0, static_cast<int>(p), 0, 0);
    if (seen.type.size() > 0) {
        auto& type = result.type.emplace();
        std::copy(seen.type.begin(), seen.type.end(), type.begin());
    }
    result.probabilities =
        segmentation::from_output(seen.parts, segmentation::letterbox(ink.width(), ink.height(), net.input));

    // 2. At working size: silhouette, then a part for each of its pixels.
    std::vector<Grid<float>> probabilities;
    for (const Grid<float>& plane : result.probabilities)
        probabilities.push_back(resize(plane, mask.width(), mask.height()));
    Grid<float> foreground = probabilities[0];
    for (float& p : foreground) p = 1 - p;
    const Grid<float> working_ink = resize(ink, mask.width(), mask.height());
    const Mask silhouette =
        exact_mask || !options.refine_silhouette
            ? mask
            : segmentation::decide_silhouette(mask, foreground, working_ink, options.silhouette);
    result.stroke_ratio = stroke_ratio(working_ink, silhouette);
    result.labels = segmentation::label_parts(silhouette, probabilities, options.silhouette);
    return result;
}

} // namespace pantin
