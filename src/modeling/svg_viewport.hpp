// SPDX-License-Identifier: MIT
// Viewports: what a viewBox and preserveAspectRatio make of the units inside (SVG 2, chapter 8).
#pragma once

#include <optional>
#include <string>

#include "modeling/svg_path.hpp"

namespace pantin {

struct ViewBox {
    double x = 0, y = 0, width = 0, height = 0;
};
// "x y width height"; nothing when it is empty, or has no extent. Error(input) as svg_numbers().
std::optional<ViewBox> svg_view_box(const std::string& text, const std::string& where);
// From the units of the box to those around a viewport of that place and size. `aspect` as
// preserveAspectRatio; what is no value of it is the default, xMidYMid meet. No error. SVG 2, 8.2.
Affine svg_viewport(const ViewBox& box, const ViewBox& viewport, const std::string& aspect);

} // namespace pantin
