// Internal: which background belongs to a shape whose outline has gaps.
#pragma once

#include "pantin/grid.hpp"

namespace pantin {

struct RoomOptions {
    double mouth_ratio = 1.35; // inradius of a room over the half-width of its widest mouth, at least
    double max_mouth = 0.09;   // half-width of a mouth over the diagonal of the ink's box, at most
    double corridor = 1.4;     // a corridor leads on while it is no wider than this times its narrowest place
};

// The background that the ink encloses, wholly or but for narrow mouths. 1 = interior, ink itself is 0.
Mask find_rooms(const Mask& ink, const RoomOptions& options = {});

} // namespace pantin
