// SPDX-License-Identifier: MIT
// Vector pictures over a drawing, in pixels of its working size.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pantin/point.hpp"
#include "pantin/skeletonization.hpp"

namespace pantin {

class Svg {
public:
    // The picture holds pixels 0 … width−1, 0 … height−1 whole, with `margin` of white paper around. `title`
    // is what it shows, for those who do not see it.
    Svg(double width, double height, std::string title, double margin = 0);

    Svg& raw(std::string_view element);
    Svg& underlay(const std::string& id,
                  double opacity = 1); // an element of the page, as the drawing `drawing-1`
    Svg& image(const std::string& uri, double width, double height,
               double opacity = 1); // over pixels 0 … width−1, …
    Svg& line(Point2d a, Point2d b, const std::string& colour, double width);
    Svg& polyline(const std::vector<Point2d>& points, const std::string& colour, double width,
                  bool closed = false);
    Svg& polygon(const std::vector<Point2d>& points, const std::string& fill, const std::string& stroke,
                 double width);
    Svg& disc(Point2d centre, double radius, const std::string& fill);
    Svg& square(Point2d centre, double radius, const std::string& fill);
    Svg& text(Point2d at, std::string_view text, double size, const std::string& colour = "#111");
    Svg& graph(const SkeletonGraph& graph,
               double scale); // ends as squares, junctions as discs, in the colours of their parts
    // `classes`: of the element.
    std::string str(const std::string& classes = "") const;

private:
    double width_, height_, margin_;
    std::string title_, body_;
};

// "M1 2L3 4", one decimal.
std::string path_text(const std::vector<Point2d>& points, bool closed);

} // namespace pantin
