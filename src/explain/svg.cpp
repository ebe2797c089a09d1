// SPDX-License-Identifier: MIT
// Shapes in pixels of the working size in, one SVG element out (own).
#include "explain/svg.hpp"

#include "explain/markup.hpp"
#include "explain/palette.hpp"

namespace pantin {

namespace {

std::string place(Point2d p) { return decimal(p.x) + " " + decimal(p.y); }

} // namespace

std::string path_text(const std::vector<Point2d>& points, bool closed) {
    std::string text;
    for (std::size_t i = 0; i < points.size(); ++i) text += (i == 0 ? "M" : "L") + place(points[i]);
    return text + (closed ? "Z" : "");
}

Svg::Svg(double width, double height, std::string title, double margin)
    : width_(width), height_(height), margin_(margin), title_(std::move(title)) {}

Svg& Svg::raw(std::string_view element) {
    body_ += element;
    return *this;
}

Svg& Svg::underlay(const std::string& id, double opacity) {
    return raw("<use href=\"#" + id + "\" opacity=\"" + decimal(opacity, 2) + "\"/>");
}

Svg& Svg::image(const std::string& uri, double width, double height, double opacity) {
    return raw("<image href=\"" + uri + "\" x=\"-0.5\" y=\"-0.5\" width=\"" + decimal(width) +
               "\" height=\"" + decimal(height) + "\" preserveAspectRatio=\"none\" opacity=\"" +
               decimal(opacity, 2) + "\"/>");
}

Svg& Svg::line(Point2d a, Point2d b, const std::string& colour, double width) {
    return polyline({a, b}, colour, width);
}

Svg& Svg::polyline(const std::vector<Point2d>& points, const std::string& colour, double width, bool closed) {
    return raw("<path d=\"" + path_text(points, closed) + "\" fill=\"none\" stroke=\"" + colour +
               "\" stroke-width=\"" + decimal(width, 2) +
               "\" stroke-linejoin=\"round\" stroke-linecap=\"round\"/>");
}

Svg& Svg::polygon(const std::vector<Point2d>& points, const std::string& fill, const std::string& stroke,
                  double width) {
    return raw("<path d=\"" + path_text(points, true) + "\" fill=\"" + fill + "\" stroke=\"" + stroke +
               "\" stroke-width=\"" + decimal(width, 2) + "\"/>");
}

Svg& Svg::disc(Point2d c, double radius, const std::string& fill) {
    return raw("<circle cx=\"" + decimal(c.x) + "\" cy=\"" + decimal(c.y) + "\" r=\"" + decimal(radius) +
               "\" fill=\"" + fill + "\" stroke=\"#fff\" stroke-width=\"" + decimal(radius / 4, 2) + "\"/>");
}

Svg& Svg::square(Point2d c, double radius, const std::string& fill) {
    return raw("<rect x=\"" + decimal(c.x - radius) + "\" y=\"" + decimal(c.y - radius) + "\" width=\"" +
               decimal(2 * radius) + "\" height=\"" + decimal(2 * radius) + "\" fill=\"" + fill +
               "\" stroke=\"#fff\" stroke-width=\"" + decimal(radius / 4, 2) + "\"/>");
}

Svg& Svg::text(Point2d at, std::string_view text, double size, const std::string& colour) {
    return raw("<text x=\"" + decimal(at.x) + "\" y=\"" + decimal(at.y) + "\" font-size=\"" + decimal(size) +
               "\" fill=\"" + colour + "\" paint-order=\"stroke\" stroke=\"#fff\" stroke-width=\"" +
               decimal(size / 5, 2) + "\">" + escaped(text) + "</text>");
}

Svg& Svg::graph(const SkeletonGraph& graph, double scale) {
    for (const SkeletonEdge& edge : graph.edges) {
        std::vector<Point2d> points = {{graph.vertices[edge.u].x, graph.vertices[edge.u].y}};
        for (const Point2i p : edge.pixels) points.push_back(to_double(p));
        points.push_back({graph.vertices[edge.v].x, graph.vertices[edge.v].y});
        polyline(points, "#111", 1.2 * scale);
    }
    for (const SkeletonVertex& v : graph.vertices) {
        if (v.end)
            square({v.x, v.y}, 3.4 * scale, css(v.label));
        else
            disc({v.x, v.y}, 3.8 * scale, css(v.label));
    }
    return *this;
}

std::string Svg::str(const std::string& classes) const {
    const std::string title = escaped(title_);
    const double left = -0.5 - margin_, w = width_ + 2 * margin_, h = height_ + 2 * margin_;
    return "<svg class=\"picture " + classes + "\" role=\"img\" aria-label=\"" + title + "\" viewBox=\"" +
           decimal(left) + " " + decimal(left) + " " + decimal(w) + " " + decimal(h) +
           "\" style=\"--ratio:" + decimal(w / h, 3) + "\"><title>" + title + "</title>" + body_ + "</svg>";
}

} // namespace pantin
