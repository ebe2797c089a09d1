// SPDX-License-Identifier: MIT
// What was seen of a drawing to whether it is a scribble. Own: thesis 4.3 takes every drawing for a
// character.
#include <algorithm>
#include <numeric>

#include "image/label_map.hpp"
#include "pantin/segmentation.hpp"

namespace pantin {
namespace {

// Share of the largest part in the figure; 0 where that is the head, which is no scribble.
double largest_part_share(const LabelMap& labels) {
    const auto areas = part_areas(labels);
    const auto largest = std::max_element(areas.begin() + 1, areas.end());
    if (largest - areas.begin() == static_cast<int>(Label::head)) return 0;
    const long figure = std::accumulate(areas.begin() + 1, areas.end(), 0L);
    return figure > 0 ? static_cast<double>(*largest) / static_cast<double>(figure) : 0;
}

} // namespace

bool is_scribble(const Segmentation& s, const SegmentationOptions& options) {
    if (s.router.empty() || s.stroke_ratio <= options.scribble_ratio) return false;
    const bool doubtful = s.confidence < options.least_confidence;
    if (!s.type) return doubtful;
    return probability_of(*s.type, "other") >= options.scribble_other &&
           (doubtful || largest_part_share(s.labels) >= options.scribble_part);
}

} // namespace pantin
