// SPDX-License-Identifier: MIT
// The mask that the user gives (--mask, or mask.png of an AnimatedDrawings folder).
#pragma once

#include <filesystem>
#include <string>

#include "pantin/image.hpp"

namespace pantin {

struct GivenMask {
    Mask mask;
    std::string remark; // what was wrong with the file and could be helped: one line; empty: nothing
};

// A grey PNG, turned clockwise by `rotate` degrees: the figure is where it is at least 128 (on black, where
// it is half transparent). One without such a pixel that is transparent in places is the figure where it is
// opaque; one whose largest value is 1 is the figure where it is 1, and one that is white all around a black
// figure is taken the other way round, each with a remark. Error(input) names the file. Own.
GivenMask load_given_mask(const std::filesystem::path& file, int rotate);

} // namespace pantin
