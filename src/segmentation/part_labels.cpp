// SPDX-License-Identifier: MIT
// The final silhouette and the probabilities of the parts to a label for each of its pixels: the most
// probable part, the nearest trusted label where there is none, specks given away. Ours; SketchParse takes
// the most probable class of each pixel.
#include <algorithm>

#include "pantin/image.hpp"
#include "segmentation/part_labels.hpp"

namespace pantin::segmentation {
namespace {

int most_probable_part(const std::vector<Grid<float>>& probabilities, int x, int y) {
    int best = 1;
    for (int label = 2; label < label_count; ++label)
        if (probabilities[static_cast<std::size_t>(label)](x, y) >
            probabilities[static_cast<std::size_t>(best)](x, y))
            best = label;
    return best;
}

// Gives every pixel of the silhouette that is not `trusted` the label of the nearest one that is.
void spread(LabelMap& labels, const Mask& silhouette, const Mask& trusted) {
    const Grid<int> nearest = nearest_seed(trusted);
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (silhouette.data()[i] && !trusted.data()[i] && nearest.data()[i] >= 0)
            labels.data()[i] = labels.data()[nearest.data()[i]];
}

// Trusts no piece of a label that is smaller than `least`; the largest pieces of all are kept.
void remove_specks(LabelMap& labels, const Mask& silhouette, double least) {
    std::vector<Components> pieces; // per part
    int largest = 0;
    for (int label = 1; label < label_count; ++label) {
        Mask part(labels.width(), labels.height());
        for (std::size_t i = 0; i < labels.size(); ++i) part.data()[i] = labels.data()[i] == label;
        pieces.push_back(connected_components(part));
        for (const Component& piece : pieces.back().list) largest = std::max(largest, piece.area);
    }
    Mask trusted(labels.width(), labels.height());
    for (const Components& part : pieces)
        for (std::size_t i = 0; i < labels.size(); ++i) {
            const int id = part.ids.data()[i];
            if (id == 0) continue;
            const int area = part.list[static_cast<std::size_t>(id) - 1].area;
            trusted.data()[i] = area >= least || area == largest;
        }
    spread(labels, silhouette, trusted);
}

} // namespace

LabelMap label_parts(const Mask& silhouette, const std::vector<Grid<float>>& probabilities,
                     const SilhouetteOptions& options) {
    LabelMap labels(silhouette.width(), silhouette.height());
    Mask trusted(silhouette.width(), silhouette.height());
    long area = 0;
    for (int y = 0; y < silhouette.height(); ++y)
        for (int x = 0; x < silhouette.width(); ++x) {
            if (!silhouette(x, y)) continue;
            ++area;
            labels(x, y) = static_cast<std::uint8_t>(most_probable_part(probabilities, x, y));
            trusted(x, y) = 1 - probabilities[0](x, y) >= options.part_probability;
        }
    spread(labels, silhouette, trusted);
    remove_specks(labels, silhouette, options.speck_share * static_cast<double>(area));
    return labels;
}

} // namespace pantin::segmentation
