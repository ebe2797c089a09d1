// SPDX-License-Identifier: MIT
// The distance transform of a shape and its mean, by which Eq. 4.8 of the thesis divides (ERRATA 14): in come
// the skeleton graph and the mask of one figure.
#include "rigging/figure.hpp"

#include <cmath>
#include <utility>

#include "pantin/image.hpp"

namespace pantin {

Figure make_figure(SkeletonGraph graph, const Mask& shape) {
    Figure figure{std::move(graph), squared_distance_transform(shape), 0};
    double sum = 0;
    long count = 0;
    for (const int squared : figure.squared_distance) {
        if (squared <= 0) continue;
        sum += std::sqrt(static_cast<double>(squared));
        ++count;
    }
    figure.mean_distance = count > 0 ? sum / static_cast<double>(count) : 1;
    return figure;
}

} // namespace pantin
