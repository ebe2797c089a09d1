// SPDX-License-Identifier: MIT
// Ink of a crop to the network's square and the planes of the square back to the crop; grey erosion is thesis
// ch. 5, the placing ours.
#include "segmentation/letterbox.hpp"

#include <algorithm>

#include "pantin/image.hpp"

namespace pantin::segmentation {
namespace {

// Largest value of the 3×3 neighbourhood: grey erosion, in terms of ink.
Grid<float> thicken(const Grid<float>& ink) {
    Grid<float> out(ink.width(), ink.height());
    for (int y = 0; y < ink.height(); ++y)
        for (int x = 0; x < ink.width(); ++x) {
            float darkest = 0;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    darkest = std::max(darkest, ink.value_or(x + dx, y + dy, 0.0f));
            out(x, y) = darkest;
        }
    return out;
}

} // namespace

Box letterbox(int width, int height, int side) {
    const int longer = std::max(width, height);
    // round(extent · side / longer) in integers, half up
    const auto scaled = [&](int extent) {
        return std::max(1, static_cast<int>((2L * extent * side + longer) / (2L * longer)));
    };
    const int w = scaled(width), h = scaled(height);
    return {(side - w) / 2, (side - h) / 2, w, h};
}

network::Tensor to_input(const Grid<float>& ink, int side, bool grey_erosion) {
    network::Tensor input(1, 1, side, side);
    const Box box = letterbox(ink.width(), ink.height(), side);
    Grid<float> scaled = resize(ink, box.width, box.height);
    if (grey_erosion) scaled = thicken(scaled);
    for (int y = 0; y < box.height; ++y)
        for (int x = 0; x < box.width; ++x) input(0, 0, box.y + y, box.x + x) = scaled(x, y);
    return input;
}

std::vector<Grid<float>> from_output(const network::Tensor& output, Box box) {
    std::vector<Grid<float>> planes;
    for (int c = 0; c < output.channels(); ++c) {
        Grid<float> plane(box.width, box.height);
        for (int y = 0; y < box.height; ++y)
            for (int x = 0; x < box.width; ++x) plane(x, y) = output(0, c, box.y + y, box.x + x);
        planes.push_back(std::move(plane));
    }
    return planes;
}

} // namespace pantin::segmentation
