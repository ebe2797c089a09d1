// SPDX-License-Identifier: MIT
#include "pipeline/upright.hpp"

#include <algorithm>
#include <array>

#include "core/math.hpp"

namespace pantin {
namespace {

constexpr std::size_t asked = 8; // characters of a page, the largest ones
constexpr double floor = 0.001;  // no character says more against a turn

std::vector<const DetectedCharacter*> largest_of(const std::vector<DetectedCharacter>& characters) {
    std::vector<const DetectedCharacter*> result;
    for (const DetectedCharacter& character : characters) result.push_back(&character);
    std::stable_sort(result.begin(), result.end(),
                     [](const auto* a, const auto* b) { return a->box.area() > b->box.area(); });
    if (result.size() > asked) result.resize(asked);
    return result;
}

} // namespace

int find_page_turn(const std::vector<DetectedCharacter>& characters, Context& context) {
    const double wanted = context.options().detection.turn_probability;
    if (wanted > 1) return 0;
    std::array<double, 4> sum{};
    for (const DetectedCharacter* character : largest_of(characters)) {
        const TurnProbabilities turns =
            context.segmenter().find_turn(character->ink, context.options().segmentation);
        if (!turns) return 0;
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += math::log(std::max((*turns)[k], floor));
    }
    const auto best = std::max_element(sum.begin(), sum.end());
    double total = 0; // relative to the best
    for (const double value : sum) total += math::exp(value - *best);
    return 1 / total >= wanted ? 90 * static_cast<int>(best - sum.begin()) : 0;
}

} // namespace pantin
