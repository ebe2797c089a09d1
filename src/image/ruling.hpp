// SPDX-License-Identifier: MIT
// Internal: printed lines of a page are paper.
#pragma once

#include "pantin/grid.hpp"

namespace pantin {

// Takes ruled lines and grids out of the distance from the paper (0 … 1), of any darkness: at least three
// evenly spaced straight lines, each over half of the page, at most 3.5° from upright or level. Where
// something drawn crosses a line it stays; inside of a filled area the line takes the area's value.
void remove_ruling(Grid<float>& distance);

} // namespace pantin
