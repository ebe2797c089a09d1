// SPDX-License-Identifier: MIT
// Where the canvas of a part lies in the model (strokes.hpp).
#pragma once

#include "pantin/model.hpp"

namespace pantin {

Frame frame_of(Viewpoint view, Point2d origin, double depth);
// Scaled and turned about the centre, then moved.
Frame moved(const Frame& frame, Vec3 centre, const MovePart& move);
Frame mirrored(const Frame& frame, Symmetry symmetry);
Point2d middle_of(const std::vector<Point2d>& points); // of the bounding box

} // namespace pantin
