// SPDX-License-Identifier: MIT
// A dog whose proportions are chosen, not left to a seed: some failures of the thesis need legs or a tail of
// a certain kind (Fig. 6.9, table 6.1).
#pragma once

#include "pantin/grid.hpp"

namespace pantin::figures {

// Lengths in units of which the dog is about 400 long; angles in radians, y down, 0 forward.
struct DogShape {
    double trunk, girth;          // half axes of the trunk
    double neck;                  // height of the head above the trunk, relative to the usual one
    double pairs;                 // from the middle to each pair of legs
    double hips, feet;            // distance of two legs of a pair, above and below
    double leg, leg_radius;       // length
    double tail, tail_radius;     // length
    double tail_angle, tail_bend; // of its first half, and of its second half against that
};

struct DrawnDog {
    RgbImage picture;
    LabelMap labels; // the truth, of the picture's size
};

// Facing left, as the quadruped reference does, on a page of width × height pixels, with one even line.
DrawnDog draw_dog(const DogShape& shape, int width, int height);

} // namespace pantin::figures
