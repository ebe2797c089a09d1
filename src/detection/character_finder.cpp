// SPDX-License-Identifier: MIT
// The page through a detection network (thesis 4.2: Mask R-CNN), and what it says of the page's pixels.
#include <algorithm>
#include <cmath>

#include "detection/detection_network.hpp"

namespace pantin {

struct CharacterFinder::Model {
    std::unique_ptr<detection::DetectionNetwork> network;
};

CharacterFinder::CharacterFinder(std::span<const unsigned char> weights, const std::string& source)
    : model_(std::make_unique<Model>(
          Model{detection::load_detection_network(network::WeightFile(weights, source))})) {}
CharacterFinder::~CharacterFinder() = default;
CharacterFinder::CharacterFinder(CharacterFinder&&) noexcept = default;

std::vector<CharacterFinder::Found> CharacterFinder::find(const RgbImage& page, const Grid<float>& ink,
                                                          int threads) const {
    return model_->network->find(page, ink, network::Runtime(threads));
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
