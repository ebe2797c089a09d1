// SPDX-License-Identifier: MIT
// The page with a numbered box around each character: which number is whom (--only).
#pragma once

#include "pantin/page.hpp"

namespace pantin {

// Longer side at most 1024 pixels. `picture`: of the page's size.
RgbImage draw_overview(const RgbImage& picture, const Page& page);

} // namespace pantin
