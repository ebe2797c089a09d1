// SPDX-License-Identifier: MIT
// How many pieces and holes a mask has, and how the raster of a skeleton gets those of its shape: one
// component, and one cycle around every hole.
#pragma once

#include "pantin/grid.hpp"

namespace pantin {

struct Topology {
    int pieces = 0, holes = 0; // 8-connected, 4-connected
    bool operator==(const Topology&) const = default;
};
// By the numbers of outer borders and of borders of holes (Suzuki & Abe 1985).
Topology topology_of(const Mask& mask);

// Fills the 4-connected background regions of the raster that hold no background of the mask: neighbouring
// ridges that were drawn beside each other close such loops, and thinning would keep them.
Mask fill_spurious_cycles(const Mask& raster, const Mask& mask);

// The raster, led on along the middle of the (connected) mask where parts of it are not joined or a hole is
// not surrounded, and with its spurious cycles filled or, without `fill_pockets`, as they are (ERRATA 3). An
// empty raster gets the deepest pixel of the mask.
Mask restore_topology(const Mask& raster, const Mask& mask, bool fill_pockets = true);

} // namespace pantin
