// SPDX-License-Identifier: MIT
// Surfaces without the shortest edges, which unions leave where edges nearly meet.
#pragma once

#include "modeling/solid_union.hpp"

namespace pantin {

// Makes one point of the ends of every edge that is shorter, the shortest first, unless the surface would
// touch itself there or a triangle would turn over (Hoppe et al. 1993). Closed before and after, of the same
// genus.
void collapse_short_edges(GridSurface& surface, double shorter);

} // namespace pantin
