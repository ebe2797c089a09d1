// SPDX-License-Identifier: MIT
// Several views of one drawing (test-time augmentation): as it is, tilted to both sides, mirrored. Each
// answer is brought back to the drawing; those of more confident views count more.
#pragma once

#include "segmentation/segmentation_network.hpp"

namespace pantin::segmentation {

// Which views, and how much confident ones count: SegmentationOptions of those names.
struct ViewOptions {
    bool mirror = false;
    double tilt = 0; // degrees; 0: none
    double inverse_temperature = 0;
    double sufficient_confidence = 2; // of the first view: it stays the only one
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

// Mean probability of the most probable part over the foreground; 0 without one.
double confidence_of(const Tensor& parts);

// Router, type, pose and parts are means over the views, weighted by a softmax of inverse_temperature ·
// confidence; the result's confidence is the largest of the views. The drawing itself is seen first. The
// expert is the one of the mean router.
NetworkResult segment_views(const SegmentationNetwork& net, const Tensor& ink, const ViewOptions& options,
                            const Runtime& runtime);

} // namespace pantin::segmentation
