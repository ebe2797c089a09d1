// SPDX-License-Identifier: MIT
// The chordal axis of a mask, as pixels.
#pragma once

#include "pantin/grid.hpp"

namespace pantin {

// The chordal axis of the (connected) mask without the branches whose chord residual is below
// `least_residual` pixels. It goes around every hole; without holes it is a tree, and empty for a shape about
// as long as wide.
Mask chordal_ridges(const Mask& mask, double least_residual);

} // namespace pantin
