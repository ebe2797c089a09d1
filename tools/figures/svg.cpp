// SPDX-License-Identifier: MIT
// Shapes in CSS pixels in, the text of an SVG out.
#include "figures/svg.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "explain/markup.hpp"
#include "explain/palette.hpp"

namespace pantin::figures {
namespace {

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + value + "\"";
}
std::string attribute(const char* name, double value) { return attribute(name, decimal(value, 2)); }

std::string fixed(double value, int decimals) {
    std::array<char, 64> text{};
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals);
    return {text.data(), end};
}

std::string pair(Point2d p) { return decimal(p.x, 2) + " " + decimal(p.y, 2); }

std::string path_of(const std::vector<std::vector<Point2d>>& lines, bool closed) {
    std::string d;
    for (const std::vector<Point2d>& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i)
            d += (i == 0 ? "M" : i == 1 ? "L" : " ") + pair(line[i]);
        if (closed) d += "Z";
    }
    return d;
}

} // namespace

Style filled(Rgb8 fill) { return {.fill = css(fill)}; }
Style stroked(Rgb8 stroke, double width) { return {.stroke = css(stroke), .width = width}; }
Style outlined(Rgb8 fill, Rgb8 stroke, double width) {
    return {.fill = css(fill), .stroke = css(stroke), .width = width};
}

std::string shown(double value, int decimals, bool padded) {
    std::string digits = padded ? fixed(value, decimals) : decimal(value, decimals);
    if (digits.front() == '-') digits.replace(0, 1, "−");
    return digits;
}

void Svg::shape(const std::string& element, const Style& style) {
    body_ += "<" + element + attribute("fill", style.fill);
    if (style.stroke != "none")
        body_ += attribute("stroke", style.stroke) + attribute("stroke-width", style.width);
    if (!style.dash.empty()) body_ += attribute("stroke-dasharray", style.dash);
    if (!style.cap.empty())
        body_ += attribute("stroke-linecap", style.cap) + attribute("stroke-linejoin", style.cap);
    body_ += "/>\n";
}

void Svg::rectangle(Rectangle r, const Style& style) {
    shape("rect" + attribute("x", r.x) + attribute("y", r.y) + attribute("width", r.width) +
              attribute("height", r.height),
          style);
}
void Svg::circle(Point2d centre, double radius, const Style& style) {
    shape("circle" + attribute("cx", centre.x) + attribute("cy", centre.y) + attribute("r", radius), style);
}
void Svg::line(Point2d from, Point2d to, const Style& style) { lines({{from, to}}, style); }
void Svg::arrow(Point2d from, Point2d to, const Style& style) {
    const double size = 4 + 2 * style.width, whole = std::max(1e-9, distance(from, to));
    const Point2d along = (1 / whole) * (to - from), across{-along.y, along.x}, neck = to - size * along;
    line(from, neck, style);
    polygons({{to, neck + 0.45 * size * across, neck - 0.45 * size * across}}, {.fill = style.stroke});
}
void Svg::polyline(const std::vector<Point2d>& points, const Style& style, bool closed) {
    shape("path" + attribute("d", path_of({points}, closed)), style);
}
void Svg::lines(const std::vector<std::vector<Point2d>>& lines, const Style& style) {
    shape("path" + attribute("d", path_of(lines, false)), style);
}
void Svg::polygons(const std::vector<std::vector<Point2d>>& polygons, const Style& style) {
    shape("path" + attribute("fill-rule", std::string("evenodd")) + attribute("d", path_of(polygons, true)),
          style);
}

void Svg::text(Point2d at, const std::string& text, const TextStyle& style) {
    constexpr const char* anchors[] = {"start", "middle", "end"};
    body_ += "<text" + attribute("x", at.x) + attribute("y", at.y) + attribute("font-size", style.size);
    if (style.anchor != Anchor::start)
        body_ += attribute("text-anchor", std::string(anchors[static_cast<int>(style.anchor)]));
    if (style.bold) body_ += attribute("font-weight", std::string("bold"));
    body_ += attribute("fill", css(style.fill)) + ">" + escaped(text) + "</text>\n";
}

void Svg::image(Rectangle r, const std::vector<unsigned char>& png, bool sharp) {
    body_ += "<image" + attribute("x", r.x) + attribute("y", r.y) + attribute("width", r.width) +
             attribute("height", r.height) + attribute("preserveAspectRatio", std::string("none"));
    if (sharp) body_ += attribute("style", std::string("image-rendering:pixelated"));
    body_ += " xlink:href=\"" + data_uri("image/png", png) + "\"/>\n";
}

void Svg::begin_clip(Rectangle r) {
    const std::string id = "clip" + std::to_string(++clips_);
    body_ += "<clipPath id=\"" + id + "\">";
    rectangle(r, {});
    body_ += "</clipPath><g clip-path=\"url(#" + id + ")\">\n";
}
void Svg::end_clip() { body_ += "</g>\n"; }

std::string Svg::document(const std::string& title) const {
    const std::string w = decimal(width_, 2), h = decimal(height_, 2);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"" +
           w + "\" height=\"" + h + "\" viewBox=\"0 0 " + w + " " + h +
           "\" role=\"img\" font-family=\"Helvetica, Arial, sans-serif\">\n<title>" + escaped(title) +
           "</title>\n<rect width=\"" + w + "\" height=\"" + h + "\" fill=\"#ffffff\"/>\n" + body_ +
           "</svg>\n";
}

} // namespace pantin::figures
