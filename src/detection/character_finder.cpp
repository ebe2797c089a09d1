// SPDX-License-Identifier: MIT
// The page through Mask R-CNN, and what it says of the page's pixels.
#include <algorithm>
#include <cmath>

#include "detection/mask_rcnn/model.hpp"
#include "pantin/detection.hpp"
#include "pantin/error.hpp"
#include "pantin/image.hpp"

namespace pantin {

struct CharacterFinder::Model {
    mask_rcnn::Network network;
};

CharacterFinder::CharacterFinder(std::span<const unsigned char> weights, const std::string& source)
    : model_(std::make_unique<Model>(Model{mask_rcnn::load_network(network::WeightFile(weights, source))})) {
    const std::size_t channels = model_->network.options.transform.mean.size();
    if (channels != 1 && channels != 3)
        throw Error(ErrorKind::weights, source + ": the network sees neither ink darkness nor three colours");
}
CharacterFinder::~CharacterFinder() = default;
CharacterFinder::CharacterFinder(CharacterFinder&&) noexcept = default;

namespace {

// What the network sees: ink darkness, or red, green and blue in [0, 1]. Large pages are averaged down first;
// the network's own resizing would skip thin lines.
network::Tensor input_of(const RgbImage& page, const mask_rcnn::TransformOptions& options) {
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
        const Grid<float> ink = reduced(ink_darkness(page));
        std::copy(ink.begin(), ink.end(), input.begin());
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

} // namespace

std::vector<CharacterFinder::Found> CharacterFinder::find(const RgbImage& page, int threads) const {
    const network::Tensor image = input_of(page, model_->network.options.transform);
    const double x = static_cast<double>(page.width()) / image.width(),
                 y = static_cast<double>(page.height()) / image.height();
    std::vector<Found> found;
    for (const mask_rcnn::Detection& d : model_->network.forward(image, network::Runtime(threads))) {
        Grid<float> mask(d.mask.width(), d.mask.height());
        std::copy(d.mask.begin(), d.mask.end(), mask.begin());
        found.push_back({d.score, d.box.left * x, d.box.top * y, d.box.right * x, d.box.bottom * y, mask});
    }
    return found;
}

// Bilinear between the centres of the mask's pixels.
double CharacterFinder::Found::probability(double x, double y) const {
    if (x < left || x > right || y < top || y > bottom) return 0;
    const auto place = [](double at, double from, double to, int extent) {
        return std::clamp((at - from) / (to - from) * extent - 0.5, 0.0, extent - 1.0);
    };
    const double u = place(x, left, right, mask.width()), v = place(y, top, bottom, mask.height());
    const int x0 = static_cast<int>(u), y0 = static_cast<int>(v);
    const int x1 = std::min(x0 + 1, mask.width() - 1), y1 = std::min(y0 + 1, mask.height() - 1);
    const double fx = u - x0, fy = v - y0;
    return (1 - fy) * ((1 - fx) * mask(x0, y0) + fx * mask(x1, y0)) +
           fy * ((1 - fx) * mask(x0, y1) + fx * mask(x1, y1));
}

Grid<int> CharacterFinder::claims(const std::vector<Found>& found, int width, int height, int factor) {
    Grid<int> owner(width, height, 0);
    Grid<float> strongest(width, height, 0.0f);
    for (std::size_t k = 0; k < found.size(); ++k) {
        const Found& f = found[k];
        const auto cell = [&](double pixel) { return static_cast<int>(std::floor(pixel / factor)); };
        const int right = std::min(width - 1, cell(f.right)), bottom = std::min(height - 1, cell(f.bottom));
        for (int row = std::max(0, cell(f.top)); row <= bottom; ++row)
            for (int column = std::max(0, cell(f.left)); column <= right; ++column) {
                const double p = f.probability((column + 0.5) * factor, (row + 0.5) * factor);
                const auto claim = static_cast<float>(p * f.score);
                if (p < 0.5 || claim <= strongest(column, row)) continue;
                strongest(column, row) = claim;
                owner(column, row) = static_cast<int>(k) + 1;
            }
    }
    return owner;
}

} // namespace pantin
