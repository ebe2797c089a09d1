// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace pantin {

// From 0 at t ≤ 0 to 1 at t ≥ 1, flat at both ends.
inline double smoothstep(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

} // namespace pantin
