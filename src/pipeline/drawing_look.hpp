// SPDX-License-Identifier: MIT
// A painting as the part network sees it.
#pragma once

#include <string>

#include "pantin/image.hpp"
#include "pantin/model_view.hpp"
#include "pantin/painting.hpp"
#include "pantin/segmentation.hpp"
#include "pipeline/context.hpp"

namespace pantin {

// The picture with the labels that the network gives it, and where on the canvas it was taken.
struct DrawingLook {
    ModelPicture picture;
    CanvasView view; // of the labels' pixels
};
// The painting on a transparent ground, as `animate` takes a picture that was cut out; the inside of outlines
// is white. `name` stands in messages. Error(input) when there is nothing to be seen; errors of the networks.
// Own; labels: thesis 4.3.
DrawingLook look_at(const Painting& painting, const std::string& name, Context& context);

// The drawing, of the opaque picture's size, with labelled pixels that are not opaque in the colour of the
// nearest one that is: what is made thicker than it is drawn has no rim of paper. No error.
RgbImage without_paper(RgbImage drawing, const Mask& opaque, const LabelMap& labels);
// Pixels of the mask. No error.
long pixel_count(const Mask& mask);

} // namespace pantin
