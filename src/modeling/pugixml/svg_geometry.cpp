// SPDX-License-Identifier: MIT
// An element in, its subpaths out: each basic shape as the path that SVG takes for it (SVG 2, chapter 10).
#include "modeling/pugixml/svg_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "core/decimal.hpp"
#include "modeling/pugixml/svg_text.hpp"
#include "pantin/error.hpp"

namespace pantin::svg {
namespace {

[[noreturn]] void fail(const std::string& where, const std::string& fact) {
    throw Error(ErrorKind::input, where + ": " + fact);
}

class PathText {
public:
    std::string text;
    PathText& add(const char* command, std::initializer_list<double> numbers) {
        text += command;
        for (const double x : numbers) text += " " + to_decimal(x);
        return *this;
    }
};

// Section 10.2: from the end of the upper left corner clockwise.
std::string path_of_rect(pugi::xml_node node, const Viewport& port, const std::string& where) {
    const double x = length_of(node, "x", port.width, where), y = length_of(node, "y", port.height, where);
    const double width = extent_of(node, "width", port.width, where);
    const double height = extent_of(node, "height", port.height, where);
    double rx = extent_of(node, "rx", port.width, where, -1);
    double ry = extent_of(node, "ry", port.height, where, -1);
    if (width == 0 || height == 0) return {};
    if (rx < 0) rx = std::max(ry, 0.0); // of two radii one may be left out
    if (ry < 0) ry = rx;
    rx = std::min(rx, width / 2);
    ry = std::min(ry, height / 2);
    PathText path;
    const double right = x + width, bottom = y + height;
    if (rx == 0 || ry == 0)
        return path.add("M", {x, y}).add("H", {right}).add("V", {bottom}).add("H", {x}).add("Z", {}).text;
    path.add("M", {x + rx, y}).add("H", {right - rx}).add("A", {rx, ry, 0, 0, 1, right, y + ry});
    path.add("V", {bottom - ry}).add("A", {rx, ry, 0, 0, 1, right - rx, bottom});
    path.add("H", {x + rx}).add("A", {rx, ry, 0, 0, 1, x, bottom - ry});
    return path.add("V", {y + ry}).add("A", {rx, ry, 0, 0, 1, x + rx, y}).add("Z", {}).text;
}

// Section 10.3: four quarters, from the right end clockwise.
std::string path_of_ellipse(pugi::xml_node node, const Viewport& port, const std::string& where) {
    const bool circle = kind_of(node) == "circle";
    const double x = length_of(node, "cx", port.width, where), y = length_of(node, "cy", port.height, where);
    double rx =
        circle ? extent_of(node, "r", port.diagonal(), where) : extent_of(node, "rx", port.width, where, -1);
    double ry = circle ? rx : extent_of(node, "ry", port.height, where, -1);
    if (rx < 0) rx = std::max(ry, 0.0);
    if (ry < 0) ry = rx;
    if (rx == 0 || ry == 0) return {};
    PathText path;
    path.add("M", {x + rx, y}).add("A", {rx, ry, 0, 0, 1, x, y + ry}).add("A", {rx, ry, 0, 0, 1, x - rx, y});
    return path.add("A", {rx, ry, 0, 0, 1, x, y - ry})
        .add("A", {rx, ry, 0, 0, 1, x + rx, y})
        .add("Z", {})
        .text;
}

std::vector<Subpath> subpaths_of_points(pugi::xml_node node, const Affine& transform,
                                        const std::string& where) {
    const std::vector<double> numbers = svg_numbers(node.attribute("points").value(), where + ": points");
    if (numbers.size() % 2) fail(where, "points: the last one has no y");
    if (numbers.empty()) return {};
    Subpath subpath{{}, kind_of(node) == "polygon"};
    for (std::size_t i = 0; i < numbers.size(); i += 2)
        subpath.points.push_back(transform * Point2d{numbers[i], numbers[i + 1]});
    return {subpath};
}

std::vector<Subpath> subpaths_of_line(pugi::xml_node node, const Affine& transform, const Viewport& port,
                                      const std::string& where) {
    const Point2d from = {length_of(node, "x1", port.width, where),
                          length_of(node, "y1", port.height, where)};
    const Point2d to = {length_of(node, "x2", port.width, where), length_of(node, "y2", port.height, where)};
    return {{{transform * from, transform * to}, false}};
}

} // namespace

double Viewport::diagonal() const { return std::sqrt((width * width + height * height) / 2); }

double length_of(pugi::xml_node node, const char* name, double whole, const std::string& where,
                 double missing) {
    const std::string text = attribute(node, name);
    if (text.empty() || text == "auto") return missing;
    return svg_length(text, where + ": " + name, whole);
}

double extent_of(pugi::xml_node node, const char* name, double whole, const std::string& where,
                 double missing) {
    const double x = length_of(node, name, whole, where, missing);
    if (x < 0 && x != missing) fail(where, std::string(name) + " must not be negative");
    return x;
}

std::vector<Subpath> subpaths_of(pugi::xml_node node, const Affine& transform, const Viewport& viewport,
                                 const std::string& where) {
    const std::string_view kind = kind_of(node);
    if (kind == "path") return svg_path(node.attribute("d").value(), transform, where + ": d");
    if (kind == "polygon" || kind == "polyline") return subpaths_of_points(node, transform, where);
    if (kind == "line") return subpaths_of_line(node, transform, viewport, where);
    return svg_path(kind == "rect" ? path_of_rect(node, viewport, where)
                                   : path_of_ellipse(node, viewport, where),
                    transform, where);
}

} // namespace pantin::svg
