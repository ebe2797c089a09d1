// SPDX-License-Identifier: MIT
// Measures of an evaluation.
#include <algorithm>
#include <limits>
#include <set>

#include "pantin/evaluation.hpp"

namespace pantin {

double CharacterResult::mean_overlap() const {
    double sum = 0;
    int parts = 0;
    for (std::size_t part = 1; part < part_overlap.size(); ++part)
        if (part_overlap[part] >= 0) sum += part_overlap[part], ++parts;
    return parts == 0 ? -1 : sum / parts;
}

double average_precision(const Evaluation& evaluation, double least_overlap, bool by_mask) {
    const auto all = std::count_if(evaluation.characters.begin(), evaluation.characters.end(),
                                   [](const CharacterResult& c) { return c.labelled; });
    if (all == 0) return std::numeric_limits<double>::quiet_NaN();
    std::vector<const FoundCharacter*> ranked;
    for (const FoundCharacter& found : evaluation.found) ranked.push_back(&found);
    std::stable_sort(ranked.begin(), ranked.end(), [](auto a, auto b) { return a->score > b->score; });

    std::set<std::pair<std::string, int>> taken;
    std::vector<double> precisions; // at each hit
    int seen = 0;
    for (const FoundCharacter* found : ranked) {
        ++seen;
        const double overlap = by_mask ? found->mask_overlap : found->silhouette_overlap;
        const int character = by_mask ? found->true_by_mask : found->true_by_silhouette;
        if (overlap >= least_overlap && taken.emplace(found->page, character).second)
            precisions.push_back(static_cast<double>(precisions.size() + 1) / seen);
    }
    double best = 0, area = 0;
    for (std::size_t i = precisions.size(); i-- > 0;) {
        best = std::max(best, precisions[i]);
        area += best;
    }
    return area / static_cast<double>(all);
}

} // namespace pantin
