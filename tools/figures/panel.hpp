// SPDX-License-Identifier: MIT
// A part of a figure that shows something in coordinates of its own, mostly working pixels.
#pragma once

#include <string>
#include <vector>

#include "figures/svg.hpp"
#include "pantin/rigging.hpp"
#include "pantin/skeletonization.hpp"

namespace pantin::figures {

inline constexpr double caption_height = 26, margin = 12; // of a figure

// Below a place in a figure: "(a) the mask".
void caption(Svg& svg, Rectangle place, const std::string& text);

class Panel {
public:
    // `content` is scaled to fit the middle of `place`.
    Panel(Svg& svg, Rectangle place, Rectangle content);
    // Content: pixels 0 … width − 1, each a unit square about its centre.
    Panel(Svg& svg, Rectangle place, int width, int height)
        : Panel(svg, place, {-0.5, -0.5, width + 0.0, height + 0.0}) {}

    Svg& svg() { return svg_; }
    double scale() const { return scale_; }
    Point2d at(Point2d p) const {
        return {left_ + scale_ * (p.x - content_.x), top_ + scale_ * (p.y - content_.y)};
    }
    Point2d at(double x, double y) const { return at(Point2d{x, y}); }
    std::vector<Point2d> at(const std::vector<Point2d>& points) const;
    std::vector<Point2d> at(const std::vector<Point2i>& points) const;
    Rectangle frame() const { return {left_, top_, scale_ * content_.width, scale_ * content_.height}; }

    // Pictures that cover pixels 0 … width − 1 of the content, whatever their own size.
    void picture(const RgbImage& image, int width, int height, bool sharp = false);
    void mask(const Mask& mask, Rgb8 colour);
    void parts(const LabelMap& labels, bool light = false); // each in its colour
    void border(Rgb8 colour = {196, 200, 208});             // about the content

    // One filled square each.
    void pixels(const std::vector<Point2i>& pixels, Rgb8 colour);
    void segments(const std::vector<std::pair<Point2d, Point2d>>& segments, const Style& style);
    // Edges along their pixels, then vertices in the colours of their parts: ends square, junctions round.
    void graph(const SkeletonGraph& graph, const Style& edges, double radius = 4.5);
    void vertex(const SkeletonVertex& vertex, double radius = 4.5);
    void mesh(const Mesh& mesh, const Style& style);

    void caption(const std::string& text) { figures::caption(svg_, place_, text); }

private:
    Svg& svg_;
    Rectangle place_, content_;
    double scale_ = 1, left_ = 0, top_ = 0;
};

// Rows of panels of one size with captions.
class Sheet {
public:
    Sheet(int columns, int rows, double width, double height, double header = 0);
    Svg& svg() { return svg_; }
    Rectangle place(int column, int row = 0) const;
    // Of panel number `index`, row by row.
    Rectangle operator[](int index) const { return place(index % columns_, index / columns_); }

private:
    int columns_;
    double width_, height_, header_;
    Svg svg_;
};

// Boxes with the names of the parts that occur, in one row from `at` to the right.
void legend(Svg& svg, Point2d at, const std::vector<std::pair<std::string, Rgb8>>& entries);
std::vector<std::pair<std::string, Rgb8>> part_entries(const LabelMap& labels);

} // namespace pantin::figures
