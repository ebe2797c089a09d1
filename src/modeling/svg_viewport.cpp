// SPDX-License-Identifier: MIT
// viewBox and preserveAspectRatio in, a transform out (SVG 2, 8.2: the equivalent transform of a viewport).
#include "modeling/svg_viewport.hpp"

#include <algorithm>

#include "pantin/error.hpp"

namespace pantin {
namespace {

// The alignment along an axis ("xMin", "xMid", "xMax") as a share of the space that is left over.
double share_of(const std::string& aspect, const std::string& axis) {
    if (aspect.find(axis + "Min") != std::string::npos) return 0;
    if (aspect.find(axis + "Max") != std::string::npos) return 1;
    return 0.5;
}

} // namespace

std::optional<ViewBox> svg_view_box(const std::string& text, const std::string& where) {
    const std::vector<double> v = svg_numbers(text, where + ": viewBox");
    if (v.empty()) return {};
    if (v.size() != 4) throw Error(ErrorKind::input, where + ": viewBox must be four numbers");
    if (!(v[2] > 0) || !(v[3] > 0)) return {};
    return ViewBox{v[0], v[1], v[2], v[3]};
}

Affine svg_viewport(const ViewBox& box, const ViewBox& viewport, const std::string& aspect) {
    double sx = viewport.width / box.width, sy = viewport.height / box.height;
    double x = viewport.x, y = viewport.y;
    if (aspect.find("none") == std::string::npos) {
        const bool slice = aspect.find("slice") != std::string::npos;
        sx = sy = slice ? std::max(sx, sy) : std::min(sx, sy);
        x += share_of(aspect, "x") * (viewport.width - box.width * sx);
        y += share_of(aspect, "Y") * (viewport.height - box.height * sy);
    }
    return {sx, 0, 0, sy, x - box.x * sx, y - box.y * sy};
}

} // namespace pantin
