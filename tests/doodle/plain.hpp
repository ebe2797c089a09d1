// SPDX-License-Identifier: MIT
// Drawings as plain as they come, for tests of the truth.
#pragma once

#include "doodle/doodle.hpp"

namespace pantin::doodle {

// Square, a pen on white, not coloured.
inline DoodleOptions plain(int size) {
    DoodleOptions options;
    options.width = options.height = size;
    options.photo = options.paper = options.colour = 0.0;
    return options;
}

} // namespace pantin::doodle
