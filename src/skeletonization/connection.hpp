// Makes the raster of a Voronoi skeleton homotopic to its shape: one component, no cycle but around a hole.
#pragma once

#include "pantin/grid.hpp"

namespace pantin {

// Fills the 4-connected background regions of the raster that hold no background of the mask: neighbouring
// ridges that were drawn beside each other close such loops, and thinning would keep them.
Mask fill_spurious_cycles(const Mask& raster, const Mask& mask);

// Joins the raster's components by paths inside the (connected) mask, where it is thick rather than along its
// border, until one is left (ERRATA 3). An empty raster gets the deepest pixel of the mask.
Mask bridge_gaps(const Mask& raster, const Mask& mask);

} // namespace pantin
