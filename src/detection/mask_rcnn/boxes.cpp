// SPDX-License-Identifier: MIT
// Boxes and their displacements.
#include <algorithm>

#include "core/math.hpp"
#include "detection/mask_rcnn/mask_rcnn.hpp"

namespace pantin::mask_rcnn {
namespace {

// Largest logarithm of an enlargement, log(1000 / 16): no box overflows.
constexpr float most_growth = 4.135166556742356f;

float exp_of(float x) { return static_cast<float>(math::exp(static_cast<double>(x))); }

} // namespace

Region displaced(const Region& box, const float displacement[4], const float weights[4]) {
    const float width = box.right - box.left, height = box.bottom - box.top;
    const float x = displacement[0] / weights[0] * width + (box.left + 0.5f * width);
    const float y = displacement[1] / weights[1] * height + (box.top + 0.5f * height);
    const float w = exp_of(std::min(displacement[2] / weights[2], most_growth)) * width;
    const float h = exp_of(std::min(displacement[3] / weights[3], most_growth)) * height;
    return {x - 0.5f * w, y - 0.5f * h, x + 0.5f * w, y + 0.5f * h};
}

Region clipped(const Region& box, int width, int height) {
    const auto w = static_cast<float>(width), h = static_cast<float>(height);
    return {std::clamp(box.left, 0.0f, w), std::clamp(box.top, 0.0f, h), std::clamp(box.right, 0.0f, w),
            std::clamp(box.bottom, 0.0f, h)};
}

} // namespace pantin::mask_rcnn
