// SPDX-License-Identifier: MIT
#include "pipeline/figure_test.hpp"

namespace pantin {

FigureTest make_figure_test(Context& context) {
    const DetectionOptions& options = context.options().detection;
    if (options.figure_score <= 0 && options.figure_other > 1) return {};
    return [&context, &options](const DetectedCharacter& character) {
        SegmentationOptions one_view = context.options().segmentation;
        one_view.sufficient_confidence = 0;
        const Segmentation seen = context.segmenter().segment(character.ink, character.mask, one_view);
        return !seen.type || probability_of(*seen.type, "other") < options.figure_other;
    };
}

} // namespace pantin
