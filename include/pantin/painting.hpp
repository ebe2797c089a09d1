// SPDX-License-Identifier: MIT
// What a vector drawing shows: filled areas, from back to front, on the canvas of the strokes (strokes.hpp).
#pragma once

#include <vector>

#include "pantin/grid.hpp"
#include "pantin/point.hpp"

namespace pantin {

struct PaintedShape {
    std::vector<std::vector<Point2d>> outlines; // canvas units; each closed on its own
    bool even_odd = false;                      // fill rule; else nonzero
    Rgb8 colour;
    double opacity = 1; // 0 … 1
    bool line = false;  // the stroke along an outline, not a fill
    bool operator==(const PaintedShape&) const = default;
};
using Painting = std::vector<PaintedShape>;

// Where a canvas point is seen in a picture, pixel centres at integer coordinates: offset + scale · point.
struct CanvasView {
    double scale = 1; // pixels per canvas unit, > 0
    Point2d offset;   // pixels
    Point2d pixel(Point2d p) const { return offset + scale * p; }
};

// The shapes over a transparent ground; a pixel is covered as far as four lines through it are. Straight
// alpha. width, height: pixels, ≥ 1. No error. Porter & Duff 1984 (over).
RgbaImage paint(const Painting& painting, const CanvasView& view, int width, int height);

} // namespace pantin
