// SPDX-License-Identifier: MIT
// Products of the steps in, SVG shapes out, in coordinates of the working size.
#include "figures/panel.hpp"

#include <algorithm>

#include "figures/palette.hpp"
#include "pantin/image.hpp"

namespace pantin::figures {

Panel::Panel(Svg& svg, Rectangle place, Rectangle content) : svg_(svg), place_(place), content_(content) {
    scale_ = std::min(place.width / content.width, place.height / content.height);
    left_ = place.x + (place.width - scale_ * content.width) / 2;
    top_ = place.y + (place.height - scale_ * content.height) / 2;
}

std::vector<Point2d> Panel::at(const std::vector<Point2d>& points) const {
    std::vector<Point2d> result;
    for (const Point2d p : points) result.push_back(at(p));
    return result;
}
std::vector<Point2d> Panel::at(const std::vector<Point2i>& points) const {
    std::vector<Point2d> result;
    for (const Point2i p : points) result.push_back(at(to_double(p)));
    return result;
}

void Panel::picture(const RgbImage& image, int width, int height, bool sharp) {
    constexpr double detail = 1.6; // pixels of the file to one of the figure, at most
    const Point2d corner = at(-0.5, -0.5);
    const int shown_width = static_cast<int>(detail * scale_ * width),
              shown_height = static_cast<int>(detail * scale_ * height);
    const bool shrinks = !sharp && image.width() > shown_width;
    svg_.image({corner.x, corner.y, scale_ * width, scale_ * height},
               encode_png(shrinks ? resize(image, shown_width, shown_height) : image), sharp);
}

void Panel::mask(const Mask& mask, Rgb8 colour) {
    RgbaImage image(mask.width(), mask.height());
    std::transform(mask.begin(), mask.end(), image.begin(), [colour](std::uint8_t v) {
        return v ? Rgba8{colour.r, colour.g, colour.b, 255} : Rgba8{};
    });
    const Point2d corner = at(-0.5, -0.5);
    svg_.image({corner.x, corner.y, scale_ * mask.width(), scale_ * mask.height()}, encode_png(image), true);
}

void Panel::parts(const LabelMap& labels, bool light) {
    RgbImage image(labels.width(), labels.height());
    std::transform(labels.begin(), labels.end(), image.begin(), [light](std::uint8_t v) {
        const Rgb8 colour = part_colours[v];
        return light ? pale(colour) : colour;
    });
    picture(image, labels.width(), labels.height(), true);
}

void Panel::border(Rgb8 colour) { svg_.rectangle(frame(), stroked(colour)); }

void Panel::pixels(const std::vector<Point2i>& pixels, Rgb8 colour) {
    std::vector<std::vector<Point2d>> squares;
    for (const Point2i p : pixels)
        squares.push_back(at(std::vector<Point2d>{
            {p.x - 0.5, p.y - 0.5}, {p.x + 0.5, p.y - 0.5}, {p.x + 0.5, p.y + 0.5}, {p.x - 0.5, p.y + 0.5}}));
    if (!squares.empty()) svg_.polygons(squares, filled(colour));
}

void Panel::segments(const std::vector<std::pair<Point2d, Point2d>>& segments, const Style& style) {
    std::vector<std::vector<Point2d>> lines;
    for (const auto& [a, b] : segments) lines.push_back({at(a), at(b)});
    if (!lines.empty()) svg_.lines(lines, style);
}

void Panel::vertex(const SkeletonVertex& vertex, double radius) {
    const Point2d p = at(vertex.x, vertex.y);
    const Style style = outlined(part_colour(vertex.label), paper, 1.3);
    if (vertex.end)
        svg_.rectangle({p.x - radius, p.y - radius, 2 * radius, 2 * radius}, style);
    else
        svg_.circle(p, radius, style);
}

void Panel::graph(const SkeletonGraph& graph, const Style& edges, double radius) {
    std::vector<std::vector<Point2d>> lines;
    const auto place = [&](int v) { return at(graph.vertices[v].x, graph.vertices[v].y); };
    for (const SkeletonEdge& edge : graph.edges) { // vertices that H2 merged lie beside the pixels
        std::vector<Point2d>& line = lines.emplace_back(at(edge.pixels));
        line.insert(line.begin(), place(edge.u));
        line.push_back(place(edge.v));
    }
    if (!lines.empty()) svg_.lines(lines, edges);
    for (const SkeletonVertex& v : graph.vertices) vertex(v, radius);
}

void Panel::mesh(const Mesh& mesh, const Style& style) {
    std::vector<std::vector<Point2d>> polygons;
    for (const std::vector<int>& face : mesh.faces) {
        polygons.emplace_back();
        for (const int v : face) polygons.back().push_back(at(mesh.vertices[v]));
    }
    svg_.polygons(polygons, style);
}

void caption(Svg& svg, Rectangle place, const std::string& text) {
    svg.text({place.x + place.width / 2, place.y + place.height + 18}, text);
}

Sheet::Sheet(int columns, int rows, double width, double height, double header)
    : columns_(columns), width_(width), height_(height), header_(header),
      svg_(margin + columns * (width + margin), margin + header + rows * (height + caption_height + 6)) {}

Rectangle Sheet::place(int column, int row) const {
    return {margin + column * (width_ + margin), margin + header_ + row * (height_ + caption_height + 6),
            width_, height_};
}

void legend(Svg& svg, Point2d at, const std::vector<std::pair<std::string, Rgb8>>& entries) {
    for (const auto& [name, colour] : entries) {
        svg.rectangle({at.x, at.y - 10, 12, 12}, outlined(colour, muted, 0.5));
        svg.text({at.x + 17, at.y}, name, {.size = 12, .anchor = Anchor::start});
        at.x += 34 + 6.6 * static_cast<double>(name.size());
    }
}

std::vector<std::pair<std::string, Rgb8>> part_entries(const LabelMap& labels) {
    std::vector<std::pair<std::string, Rgb8>> entries;
    for (int label = 1; label < label_count; ++label)
        if (std::count(labels.begin(), labels.end(), label) > 0)
            entries.emplace_back(label_names[label], part_colours[label]);
    return entries;
}

} // namespace pantin::figures
