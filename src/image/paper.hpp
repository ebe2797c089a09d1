// SPDX-License-Identifier: MIT
// Internal: the colour of the bare paper at every place of a page.
#pragma once

#include <array>
#include <vector>

#include "pantin/grid.hpp"

namespace pantin {

using Colour = std::array<float, 3>; // red, green, blue: 0 … 255

// Of square blocks, bilinear between their centres.
struct Paper {
    int block = 0;        // pixels a side
    Grid<Colour> colours; // per block, at least 1 each
    Mask bare;            // per block: its own colour is the paper's (else it is a filled area, or none)
    float grain = 0;      // median over the bare blocks of the mean difference of horizontal neighbours
    bool even = false;    // as a drawing program leaves it: no light, no grain
};

// The ground is the region of evenly changing colour that covers most of the page and of its border. Where
// its colours continue step by step (shadows fall off smoothly) a block is bare; a filled area begins with an
// edge. There the paper continues as it is at the nearest bare block.
Paper estimate_paper(const RgbImage& page);

// Of a block's colour, 0 … 255.
float brightness(const Colour& colour);

// Whether the page is light on dark: what is drawn is lighter than the ground around it more than it is
// darker, and the ground is no white paper.
bool is_light_on_dark(const RgbImage& page);

// The paper's colour along one row of pixels.
std::vector<Colour> paper_row(const Paper& paper, int y, int width);

} // namespace pantin
