// SPDX-License-Identifier: MIT
// An element with its paint in, outlines of parts and painted areas out (SVG 2, chapters 9, 10 and 13).
#include "modeling/pugixml/svg_shapes.hpp"

#include <algorithm>
#include <cmath>

#include "core/plural.hpp"
#include "geometry/extent.hpp"
#include "modeling/pugixml/svg_text.hpp"
#include "modeling/svg_outlines.hpp"
#include "modeling/thick_line.hpp"
#include "pantin/error.hpp"

namespace pantin::svg {
namespace {

constexpr double same_place = 1e-9; // share of the diagonal: a path that ends so near its beginning is closed
constexpr std::size_t most_shown = 40; // characters of a value in a message
// An open line is an outline with a gap when the gap is at most this share of the line, and it encloses
// this many times the line's own area.
constexpr double gap_share = 0.3, enclosed_areas = 2;

[[noreturn]] void fail(const std::string& where, const std::string& fact) {
    throw Error(ErrorKind::input, where + ": " + fact);
}

std::string hex_of(Rgb8 colour) {
    std::string text = "#";
    for (const int byte : {colour.r, colour.g, colour.b}) {
        text += "0123456789abcdef"[byte / 16];
        text += "0123456789abcdef"[byte % 16];
    }
    return text;
}

double way_length(const std::vector<Point2d>& way) {
    double sum = 0;
    for (std::size_t i = 1; i < way.size(); ++i) sum += distance(way[i - 1], way[i]);
    return sum;
}

// Movements of the pen alone go; so does a last point that is the first one again.
void tidy(std::vector<Subpath>& subpaths) {
    const auto is_dot = [](const Subpath& s) {
        return std::all_of(s.points.begin(), s.points.end(), [&](Point2d p) { return p == s.points[0]; });
    };
    std::erase_if(subpaths, is_dot);
    for (Subpath& s : subpaths) {
        if (distance(s.points.front(), s.points.back()) > same_place * diagonal_of(s.points)) continue;
        s.points.pop_back();
        s.closed = true;
    }
}

void colour(GatheredShape& shape, const Paint& fill, const Paint& stroke) {
    for (const Paint& paint : {fill, stroke}) {
        if (!paint.seen() || !paint.given) continue;
        if (paint.colour) {
            shape.colour = hex_of(*paint.colour);
            return;
        }
        shape.notes.push_back("'" + paint.odd.substr(0, most_shown) + "' is no plain colour, left out");
    }
}

PaintedShape painted(const Paint& paint) {
    PaintedShape shape;
    shape.colour = paint.colour.value_or(Rgb8{128, 128, 128});
    shape.opacity = paint.opacity;
    return shape;
}

// Each outline that has something filled inside and nothing outside is a part.
void add_filled(GatheredShape& shape, const std::vector<Subpath>& subpaths, const Paint& fill,
                FillRule rule) {
    const FilledOutlines found = filled_outlines(subpaths, rule);
    if (found.parts.empty()) return;
    shape.filled = true;
    for (const std::size_t i : found.parts) shape.outlines.push_back(subpaths[i].points);
    shape.holes.resize(shape.outlines.size());
    for (const auto& [hole, part] : found.holes) shape.holes[part].push_back(subpaths[hole].points);
    const auto note = [&](std::size_t count, const char* what, const char* why) {
        if (count > 0) shape.notes.push_back(count_of(static_cast<long>(count), what) + " " + why);
    };
    note(found.specks, "outline", "left out, too small beside the others");
    if (std::any_of(found.parts.begin(), found.parts.end(),
                    [&](std::size_t i) { return !subpaths[i].closed; }))
        shape.notes.emplace_back("the open path was closed");
    PaintedShape& area = shape.painting.emplace_back(painted(fill));
    area.even_odd = rule == FillRule::even_odd;
    for (const Subpath& subpath : subpaths) area.outlines.push_back(subpath.points);
}

bool encloses(const std::vector<Point2d>& way, double width) {
    const double length = way_length(way);
    return distance(way.front(), way.back()) <= gap_share * length &&
           std::abs(area_of(way)) >= enclosed_areas * length * width;
}

// The outline as it is painted, and where nothing is filled also the parts that it makes: what it encloses,
// or the thick line itself. A line without a width of its own is a mark, and as such `thin`.
void add_line(GatheredShape& shape, pugi::xml_node node, const std::vector<Subpath>& seen, const Setting& own,
              std::vector<std::vector<Point2d>>& thin) {
    const LineStyle style = own.look.line(own.viewport, own.where);
    if (style.width == 0) return;
    // A stroke is as wide as its own units say, and is moved then.
    const bool scaled = own.look.scales_lines();
    std::vector<Subpath> subpaths = scaled ? subpaths_of(node, {}, own.viewport, own.where) : seen;
    if (scaled) tidy(subpaths);
    const auto moved = [&](std::vector<Point2d> points) {
        if (scaled)
            for (Point2d& p : points) p = own.transform * p;
        return points;
    };
    PaintedShape& line = shape.painting.emplace_back(painted(own.stroke));
    line.line = true;
    for (const Subpath& s : subpaths)
        for (std::vector<Point2d>& piece : line_pieces(s.points, s.closed, style))
            line.outlines.push_back(moved(std::move(piece)));
    // Pieces have one orientation, which a mirror turns round for all of them.
    if (shape.filled) return;
    const bool wide = own.look.width_given();
    for (const Subpath& s : subpaths) {
        const bool area = has_area(s.points);
        if (area && (s.closed || encloses(s.points, style.width))) {
            shape.outlines.push_back(moved(s.points));
            if (!s.closed && shape.notes.empty()) shape.notes.emplace_back("the open path was closed");
            continue;
        }
        const std::vector<Point2d> outline = moved(thick_line(s.points, style));
        if (has_area(outline)) (wide ? shape.outlines : thin).push_back(outline);
    }
}

} // namespace

ShapeOutlines add_outlines(GatheredShape& shape, pugi::xml_node node, const Setting& setting) {
    ShapeOutlines result;
    std::vector<Subpath> subpaths = subpaths_of(node, setting.transform, setting.viewport, setting.where);
    tidy(subpaths);
    result.empty = subpaths.empty();
    if (result.empty) return result;
    colour(shape, setting.fill, setting.stroke);
    if (setting.fill.seen()) add_filled(shape, subpaths, setting.fill, setting.look.fill_rule());
    if (setting.stroke.seen()) add_line(shape, node, subpaths, setting, result.thin);
    return result;
}

void add_attributes(pugi::xml_node node, const std::string& where, Json& part) {
    const auto number = [&](const char* name, const char* key) {
        if (!node.attribute(name)) return;
        const std::vector<double> numbers = svg_numbers(node.attribute(name).value(), where + ": " + name);
        if (numbers.size() != 1) fail(where, std::string(name) + " must be a number");
        part[key] = numbers[0];
    };
    const auto text = [&](const char* name, const char* key) {
        if (node.attribute(name)) part[key] = attribute(node, name);
    };
    number("data-depth", "depth");
    text("data-view", "view");
    text("data-symmetric", "symmetric");
    if (part.contains("symmetric") && part["symmetric"] == "true") part["symmetric"] = true;
    if (part.contains("symmetric") && part["symmetric"] == "false") part["symmetric"] = false;
    text("data-parent", "parent");
    number("data-height", "height");
    text("data-label", "label");
    number("data-layer", "layer");
    if (part.contains("layer") && part["layer"] == std::floor(part["layer"].get<double>()))
        part["layer"] = static_cast<long>(part["layer"].get<double>());
    text("data-bones", "bones");
    if (part.contains("bones") && (part["bones"] == "true" || part["bones"] == "false"))
        part["bones"] = part["bones"] == "true";
}

} // namespace pantin::svg
