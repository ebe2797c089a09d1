// SPDX-License-Identifier: MIT
// When the frames of a film begin.
#pragma once

#include <cmath>
#include <cstddef>

namespace pantin {

// From the start of the film, so that rounding does not add up.
inline int milliseconds(std::size_t frame, double fps) {
    return static_cast<int>(std::rint(1000.0 * static_cast<double>(frame) / fps));
}

} // namespace pantin
