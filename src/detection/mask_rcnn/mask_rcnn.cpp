// SPDX-License-Identifier: MIT
// The whole network: page to detections.
#include <algorithm>
#include <cmath>

#include "detection/mask_rcnn/mask_rcnn.hpp"
#include "pantin/error.hpp"

namespace pantin::mask_rcnn {

Transformed transform(const Tensor& image, const TransformOptions& options, const Runtime& runtime) {
    if (image.channels() != static_cast<int>(options.mean.size()))
        throw Error(ErrorKind::weights, "mask-rcnn: the image has another number of channels than the mean");
    Tensor normalised = image;
    for (int c = 0; c < image.channels(); ++c) {
        const auto i = static_cast<std::size_t>(c);
        for (std::size_t k = 0; k < image.plane_size(); ++k)
            normalised.plane(0, c)[k] = (image.plane(0, c)[k] - options.mean[i]) / options.deviation[i];
    }
    const int shorter = std::min(image.height(), image.width()),
              longer = std::max(image.height(), image.width());
    // By the reciprocal in fp32 and then rounded down, as torchvision does it: 640×480 becomes 1066×800, but
    // 500×333 becomes 1201×799.
    const auto ratio = [](int target, int size) {
        return 1.0f / static_cast<float>(size) * static_cast<float>(target);
    };
    const double scale = std::min(ratio(options.shorter, shorter), ratio(options.longer, longer));
    const auto scaled = [&](int size) { return std::max(1, static_cast<int>(size * scale)); };
    const auto padded = [&](int size) {
        return (size + options.divisor - 1) / options.divisor * options.divisor;
    };
    Transformed result;
    result.size.clip_width = scaled(image.width());
    result.size.clip_height = scaled(image.height());
    result.size.width = padded(result.size.clip_width);
    result.size.height = padded(result.size.clip_height);
    const Tensor resized =
        network::resize_bilinear(normalised, result.size.clip_height, result.size.clip_width, runtime);
    result.image = Tensor(1, image.channels(), result.size.height, result.size.width);
    for (int c = 0; c < image.channels(); ++c)
        for (int y = 0; y < resized.height(); ++y)
            std::copy_n(resized.plane(0, c) + static_cast<std::size_t>(y) * resized.width(), resized.width(),
                        result.image.plane(0, c) + static_cast<std::size_t>(y) * result.image.width());
    return result;
}

namespace {

// So many regions are pooled at a time: all at once would take more memory than the network's weights.
constexpr std::size_t portion = 64;

template <class Use> void in_portions(const std::vector<Region>& regions, Use use) {
    for (std::size_t first = 0; first < regions.size(); first += portion) {
        const auto begin = regions.begin() + static_cast<std::ptrdiff_t>(first);
        use(std::vector<Region>(
            begin, begin + static_cast<std::ptrdiff_t>(std::min(portion, regions.size() - first))));
    }
}

// The tensors one after the other along the batch.
Tensor stacked(const std::vector<Tensor>& parts) {
    if (parts.empty()) return {};
    int batch = 0;
    for (const Tensor& part : parts) batch += part.batch();
    const Tensor& first = parts.front();
    Tensor all = Tensor::uninitialised(batch, first.channels(), first.height(), first.width());
    float* out = all.begin();
    for (const Tensor& part : parts) out = std::copy(part.begin(), part.end(), out);
    return all;
}

// The regions of the levels, as the head that begins with `first` reads them.
template <class Layer>
Tensor pooled(const std::vector<Tensor>& levels, const std::vector<Region>& regions, int size, const Layer&,
              const InputSize& image, const DetectionOptions& options, const Runtime& runtime) {
    return pool_regions(levels, regions, size, image, options, runtime);
}
template <class Layer>
network::integer::ByteTensor
pooled(const std::vector<network::integer::ByteTensor>& levels, const std::vector<Region>& regions, int size,
       const Layer& first, const InputSize& image, const DetectionOptions& options, const Runtime& runtime) {
    return pool_regions(levels, regions, size, first.zero(), image, options, runtime);
}

} // namespace

template <class A>
std::vector<Detection> BasicNetwork<A>::forward(const Tensor& image, const Runtime& runtime) const {
    const Transformed input = transform(image, options.transform, runtime);
    const std::vector<typename A::Map> levels =
        pyramid.forward(backbone.forward(A::input(input.image), runtime), runtime); // [256, /4] … [256, /64]

    std::vector<Objectness> seen;
    for (const typename A::Map& level : levels) seen.push_back(proposal_head.forward(level, runtime));
    const std::vector<Region> regions = propose(seen, input.size, options.proposals);

    const DetectionOptions& heads = options.detection;
    std::vector<Tensor> scores, displacements;
    in_portions(regions, [&](const std::vector<Region>& some) {
        BoxScores result = box_head.forward(
            pooled(levels, some, heads.box_pool, box_head.fc6, input.size, heads, runtime), runtime);
        scores.push_back(std::move(result.scores));
        displacements.push_back(std::move(result.displacements));
    });
    const std::vector<Found> found =
        find_boxes({stacked(scores), stacked(displacements)}, regions, input.size, heads, runtime);

    std::vector<Region> boxes;
    for (const Found& f : found) boxes.push_back(f.box);
    std::vector<Tensor> seen_masks;
    in_portions(boxes, [&](const std::vector<Region>& some) {
        seen_masks.push_back(network::sigmoid(mask_head.forward(
            pooled(levels, some, heads.mask_pool, mask_head.convs[0], input.size, heads, runtime), runtime)));
    });
    const Tensor masks = stacked(seen_masks);

    const float x = static_cast<float>(image.width()) / static_cast<float>(input.size.clip_width);
    const float y = static_cast<float>(image.height()) / static_cast<float>(input.size.clip_height);
    std::vector<Detection> detections;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Region& box = found[i].box;
        Detection detection{{box.left * x, box.top * y, box.right * x, box.bottom * y},
                            found[i].score,
                            found[i].label,
                            Tensor(1, 1, masks.height(), masks.width())};
        std::copy_n(masks.plane(static_cast<int>(i), found[i].label), masks.plane_size(),
                    detection.mask.plane(0, 0));
        detections.push_back(std::move(detection));
    }
    return detections;
}
template struct BasicNetwork<network::RealArithmetic>;
template struct BasicNetwork<network::IntegerArithmetic>;

Grid<float> paste_mask(const Detection& detection, int page_width, int page_height) {
    const Tensor& mask = detection.mask;
    Tensor bordered(1, 1, mask.height() + 2, mask.width() + 2);
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) bordered(0, 0, y + 1, x + 1) = mask(0, 0, y, x);

    const Region& box = detection.box;
    const float grow_x = static_cast<float>(bordered.width()) / static_cast<float>(mask.width());
    const float grow_y = static_cast<float>(bordered.height()) / static_cast<float>(mask.height());
    const float half_width = (box.right - box.left) * 0.5f * grow_x,
                half_height = (box.bottom - box.top) * 0.5f * grow_y;
    const float centre_x = (box.right + box.left) * 0.5f, centre_y = (box.bottom + box.top) * 0.5f;
    const int left = static_cast<int>(centre_x - half_width), right = static_cast<int>(centre_x + half_width);
    const int top = static_cast<int>(centre_y - half_height),
              bottom = static_cast<int>(centre_y + half_height);
    const Tensor resized = network::resize_bilinear(bordered, std::max(1, bottom - top + 1),
                                                    std::max(1, right - left + 1), Runtime(1));
    Grid<float> page(page_width, page_height, 0.0f);
    for (int y = std::max(0, top); y <= std::min(bottom, page_height - 1); ++y)
        for (int x = std::max(0, left); x <= std::min(right, page_width - 1); ++x)
            page(x, y) = resized(0, 0, y - top, x - left);
    return page;
}

} // namespace pantin::mask_rcnn
