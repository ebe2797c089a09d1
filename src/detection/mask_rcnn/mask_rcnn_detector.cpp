// SPDX-License-Identifier: MIT
// A page to the channels that the weights were trained on, through Mask R-CNN, and its boxes back to the
// page. The thesis (4.2) feeds colours; ink darkness is ours.
#include "detection/mask_rcnn/mask_rcnn_detector.hpp"

#include <algorithm>
#include <cmath>

#include "detection/mask_rcnn/mask_rcnn.hpp"
#include "pantin/image.hpp"

namespace pantin::mask_rcnn {
namespace {

// What the network sees: ink darkness, or red, green and blue in [0, 1]. Large pages are averaged down first;
// the network's own resizing would skip thin lines.
network::Tensor input_of(const RgbImage& page, const Grid<float>& ink, const TransformOptions& options) {
    const int longer = std::max(page.width(), page.height());
    const auto side = [&](int pixels) {
        const double share = std::min(1.0, static_cast<double>(options.longer) / longer);
        return std::max(1, static_cast<int>(std::floor(pixels * share + 0.5)));
    };
    const int width = side(page.width()), height = side(page.height());
    const auto reduced = [&](const Grid<float>& image) {
        return longer > options.longer ? resize(image, width, height) : image;
    };
    network::Tensor input(1, static_cast<int>(options.mean.size()), height, width);
    if (input.channels() == 1) {
        const Grid<float> darkness = reduced(ink);
        std::copy(darkness.begin(), darkness.end(), input.begin());
        return input;
    }
    constexpr std::uint8_t Rgb8::*colours[] = {&Rgb8::r, &Rgb8::g, &Rgb8::b};
    for (int c = 0; c < 3; ++c) {
        Grid<float> plane(page.width(), page.height());
        std::transform(page.begin(), page.end(), plane.begin(),
                       [&](const Rgb8& pixel) { return static_cast<float>(pixel.*colours[c]) / 255; });
        const Grid<float> small = reduced(plane);
        std::copy(small.begin(), small.end(), input.plane(0, c));
    }
    return input;
}

template <class A> class Detector : public detection::DetectionNetwork {
public:
    explicit Detector(BasicNetwork<A> network) : network_(std::move(network)) {}

    std::vector<CharacterFinder::Found> find(const RgbImage& page, const Grid<float>& ink,
                                             const Runtime& runtime) const override {
        const Tensor image = input_of(page, ink, network_.options.transform);
        const double x = static_cast<double>(page.width()) / image.width(),
                     y = static_cast<double>(page.height()) / image.height();
        std::vector<CharacterFinder::Found> found;
        for (const Detection& d : network_.forward(image, runtime)) {
            Grid<float> mask(d.mask.width(), d.mask.height());
            std::copy(d.mask.begin(), d.mask.end(), mask.begin());
            found.push_back(
                {d.score, d.box.left * x, d.box.top * y, d.box.right * x, d.box.bottom * y, mask});
        }
        return found;
    }

private:
    BasicNetwork<A> network_;
};

template <class A> std::unique_ptr<detection::DetectionNetwork> load(const WeightFile& file) {
    BasicNetwork<A> network = load_network<A>(file);
    const TransformOptions& input = network.options.transform;
    if (input.mean.size() != 1 && input.mean.size() != 3)
        file.fail("the network sees neither ink darkness nor three colours");
    if constexpr (std::is_same_v<A, network::IntegerArithmetic>)
        if (std::any_of(input.mean.begin(), input.mean.end(), [](float m) { return m != 0; }) ||
            std::any_of(input.deviation.begin(), input.deviation.end(), [](float d) { return d != 1; }))
            file.fail("a network of integers needs 'image_mean' 0 and 'image_std' 1");
    return std::make_unique<Detector<A>>(std::move(network));
}

} // namespace

std::unique_ptr<detection::DetectionNetwork> load_detection_network(const WeightFile& file) {
    return network::holds_integers(file) ? load<network::IntegerArithmetic>(file)
                                         : load<network::RealArithmetic>(file);
}

} // namespace pantin::mask_rcnn
