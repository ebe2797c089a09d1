// SPDX-License-Identifier: MIT
// Several looks at one drawing: as it is, tilted to both sides, mirrored. Each answer is brought back to the
// drawing; the surer ones count more.
#pragma once

#include "segmentation/model.hpp"

namespace pantin::segmentation {

// Which looks, and how much surer ones count: from SegmentationOptions of those names.
struct Looks {
    bool mirror = false;
    double tilt = 0; // degrees; 0: none
    double sharpness = 0;
    double sure_enough = 2; // a first look this sure is the only one
};

// The network's input from a drawing that is turned about its ink and scaled so that it fills the square
// again. Pixel p of the drawing (centres on whole numbers) lies at scale · R(angle) · p + shift of the view.
struct Tilt {
    double cosine = 1, sine = 0; // times scale
    double shift_x = 0, shift_y = 0;
};
// By `degrees`, counter-clockwise on y-down pixels when negative. Without ink: the identity.
Tilt tilt_of(const Tensor& ink, double degrees);
// Bilinear, 0 outside: [1, 1, side, side].
Tensor tilted(const Tensor& ink, const Tilt& tilt);
// Each channel brought back to the drawing, bilinear; outside of the view channel 0 is 1, the others 0.
Tensor straightened(const Tensor& parts, const Tilt& tilt);

// Router, pose and parts are means over the looks, weighted by exp(sharpness · sureness), where sureness is
// the mean of the most probable part over the foreground; the result's is the surest look's. The drawing
// itself is seen first. The expert is the one of the mean router.
NetworkResult look(const Network& net, const Tensor& ink, const Looks& looks, const Runtime& runtime);

} // namespace pantin::segmentation
