// SPDX-License-Identifier: MIT
// A model from three sides with its skeleton, and once more at an angle without it, as one picture.
#pragma once

#include "pantin/animation.hpp"
#include "pantin/model_view.hpp"

namespace pantin {

// Front, side, top, three quarters; `size` pixels each way a panel, on white. `rig`: model_rig()'s.
RgbImage model_sheet(const Rig& rig, const RgbaImage& texture, const Model& model, const ModelView& view,
                     int size = 400);

} // namespace pantin
