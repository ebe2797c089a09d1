// SPDX-License-Identifier: MIT
// Whether a drawing was photographed (thesis ch. 5 treats photographs apart and does not say how it knows
// them). A camera sees the light fall off over the paper; a scanner brings its own, and a drawing program has
// none.
#include <algorithm>
#include <cmath>
#include <vector>

#include "image/paper.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace {

constexpr double least_fall = 0.04;

float percentile(std::vector<float>& values, std::size_t percent) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(percent * (values.size() - 1) / 100);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

} // namespace

PaperLight paper_light(const RgbImage& page) {
    if (page.empty()) return {};
    const Paper paper = estimate_paper(is_light_on_dark(page) ? inverted(page) : page);
    std::vector<float> light;
    for (std::size_t i = 0; i < paper.bare.size(); ++i)
        if (paper.bare.data()[i]) light.push_back(brightness(paper.colours.data()[i]));
    if (light.empty()) return {};
    const float brightest = percentile(light, 95), darkest = percentile(light, 5);
    return {1 - static_cast<double>(darkest) / static_cast<double>(brightest),
            static_cast<double>(paper.grain)};
}

bool is_photograph(const RgbImage& page) { return paper_light(page).fall > least_fall; }

} // namespace pantin
