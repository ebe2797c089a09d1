// SPDX-License-Identifier: MIT
// The reference and the character side by side with their end-effectors joined: Fig. 4.16, and a part of
// Fig. 4.1.
#pragma once

#include "figures/gallery.hpp"
#include "figures/panel.hpp"
#include "rigging/path_distance.hpp"
#include "rigging/reference_shape.hpp"

namespace pantin::figures {

// The shape of a drawn reference or of a character: where the distance to the outside is not 0.
Mask shape_of(const pantin::Figure& figure);
// Reference and character of the run as the mapping sees them.
pantin::Figure reference_figure(const Run& run);
pantin::Figure character_figure(const Run& run);

void draw_mapping(Svg& svg, Rectangle place, const Run& run, double radius);

} // namespace pantin::figures
