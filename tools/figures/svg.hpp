// SPDX-License-Identifier: MIT
// A small SVG writer: shapes in the figure's own units (CSS pixels, y down), on a white background so that a
// figure reads the same in dark mode. Numbers have two decimals at most.
#pragma once

#include <string>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/point.hpp"

namespace pantin::figures {

struct Rectangle {
    double x = 0, y = 0, width = 0, height = 0;
};

struct Style {
    std::string fill = "none", stroke = "none";
    double width = 1;      // of the stroke
    std::string dash = ""; // "4 3"
    std::string cap = "";  // "round"
};
Style filled(Rgb8 fill);
Style stroked(Rgb8 stroke, double width = 1);
Style outlined(Rgb8 fill, Rgb8 stroke, double width = 1);

// A number for readers: with a minus sign, and without zeros at the end unless `padded`.
std::string shown(double value, int decimals = 2, bool padded = false);

enum class Anchor { start, middle, end };
struct TextStyle {
    double size = 13;
    Anchor anchor = Anchor::middle;
    Rgb8 fill{32, 32, 36};
    bool bold = false;
};

class Svg {
public:
    Svg(double width, double height) : width_(width), height_(height) {}
    double width() const { return width_; }
    double height() const { return height_; }

    void rectangle(Rectangle r, const Style& style);
    void circle(Point2d centre, double radius, const Style& style);
    void line(Point2d from, Point2d to, const Style& style);
    // With an arrow head at `to`.
    void arrow(Point2d from, Point2d to, const Style& style);
    void polyline(const std::vector<Point2d>& points, const Style& style, bool closed = false);
    // Many lines, or many closed polygons (even-odd), as one element.
    void lines(const std::vector<std::vector<Point2d>>& lines, const Style& style);
    void polygons(const std::vector<std::vector<Point2d>>& polygons, const Style& style);
    void text(Point2d at, const std::string& text, const TextStyle& style = {});
    // PNG inside; `sharp`: pixels stay squares when they grow.
    void image(Rectangle r, const std::vector<unsigned char>& png, bool sharp = false);
    // What follows, up to end_clip, is cut to the rectangle.
    void begin_clip(Rectangle r);
    void end_clip();

    void append(const Svg& other) { body_ += other.body_; } // in its coordinates; clips of both must not mix

    // The document. `title` is what a screen reader says.
    std::string document(const std::string& title) const;

private:
    void shape(const std::string& element, const Style& style);

    double width_, height_;
    int clips_ = 0;
    std::string body_;
};

} // namespace pantin::figures
