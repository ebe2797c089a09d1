// SPDX-License-Identifier: MIT
// Before step 1: a sheet of paper on a photograph of a desk, seen from any side, to the sheet alone.
#pragma once

#include <array>
#include <optional>

#include "pantin/grid.hpp"
#include "pantin/point.hpp"

namespace pantin {

// Corners of a sheet in picture pixels: of its top left corner as it lies in the picture, then clockwise.
using SheetCorners = std::array<Point2d, 4>;

// A bright quadrilateral that covers at least a quarter of the picture, with darker or more colourful
// surroundings on at least three sides; none when the picture is the sheet, or shows no whole one. No error.
// Own.
std::optional<SheetCorners> find_sheet(const RgbImage& picture);

// The sheet as if seen from straight above, its sides level, at about the picture's resolution. The ratio of
// its sides follows from its perspective (Zhang & He 2007, section 4). No error.
RgbImage flattened(const RgbImage& picture, const SheetCorners& corners);

} // namespace pantin
