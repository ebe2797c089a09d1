// SPDX-License-Identifier: MIT
// Step 3: border, Voronoi diagram, thinning, graph.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/json.hpp"
#include "explain/chapters.hpp"
#include "explain/palette.hpp"
#include "explain/svg.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace {

const Skeletonization& skeletonization(const ChapterInput& input) { return input.character.skeletonization; }
const SkeletonizationOptions& options_of(const ChapterInput& input) {
    return input.context.options().skeletonization;
}

std::vector<Point2d> to_points(const std::vector<Point2i>& pixels) {
    std::vector<Point2d> points;
    for (const Point2i p : pixels) points.push_back(to_double(p));
    return points;
}

std::string count_of(std::size_t n, const char* one, const char* many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
}

// --- Voronoi
// ------------------------------------------------------------------------------------------------

// The edges in eight groups of like residual, so that the picture needs no script.
constexpr int shades = 8;

double finite_residual(double residual, double most) {
    return std::isfinite(residual) ? std::min(residual, most) : most;
}

// What the picture's scale ends at: enough to tell residuals around the threshold apart.
double most_residual(const std::vector<double>& residuals, double threshold) {
    double most = 0;
    for (const double r : residuals)
        if (std::isfinite(r)) most = std::max(most, r);
    return std::max(1.0, std::min(most, 6 * threshold));
}

// The cells: every pixel of the silhouette in the colour of the border pixel that is nearest to it.
RgbaImage cells(const Skeletonization& s) {
    Mask border(s.mask.width(), s.mask.height());
    Grid<int> number(border.width(), border.height());
    int count = 0;
    for (const Border& b : s.contour)
        for (const Point2i p : b.points) {
            border(p.x, p.y) = 1;
            number(p.x, p.y) = count++;
        }
    const Grid<int> owner = nearest_seed(border);
    RgbaImage image(border.width(), border.height());
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (!s.mask.data()[i]) continue;
        // Neighbours along the border are five colours apart.
        const Rgb8 c = category(static_cast<std::size_t>(5 * number.data()[owner.data()[i]]));
        image.data()[i] = {c.r, c.g, c.b, static_cast<std::uint8_t>(border.data()[i] ? 255 : 120)};
    }
    return image;
}

std::string shaded_edges(const Skeletonization& s, double most, double width) {
    std::array<std::string, shades> paths;
    for (std::size_t i = 0; i < s.voronoi.size(); ++i) {
        const double share = std::sqrt(std::max(0.0, finite_residual(s.residuals[i], most)) / most);
        paths[std::min(shades - 1, static_cast<int>(share * shades))] +=
            path_text({s.voronoi[i].from, s.voronoi[i].to}, false);
    }
    std::string text;
    for (int k = 0; k < shades; ++k)
        text += "<path d=\"" + paths[k] + "\" fill=\"none\" stroke=\"" + css(heat((k + 0.5) / shades)) +
                "\" stroke-width=\"" + decimal(width, 2) + "\"/>";
    return "<g class=\"edges\">" + text + "</g>";
}

Json edge_data(const Skeletonization& s, double most) {
    Json numbers = Json::array(); // x1, y1, x2, y2 in tenths of a pixel, residual in tenths
    const auto tenth = [](double v) { return static_cast<long>(std::rint(10 * v)); };
    for (std::size_t i = 0; i < s.voronoi.size(); ++i) {
        const VoronoiEdge& e = s.voronoi[i];
        for (const double v : {e.from.x, e.from.y, e.to.x, e.to.y}) numbers.push_back(tenth(v));
        numbers.push_back(tenth(std::isfinite(s.residuals[i]) ? s.residuals[i] : 10 * most));
    }
    return numbers;
}

// --- thinning
// -----------------------------------------------------------------------------------------------

// What a script needs of a thinning, as a picture: red 1 where it began with a pixel; green and blue the
// sub-iteration that took it.
RgbImage thinning_data(const Mask& before, const Grid<std::uint16_t>& removed_in) {
    RgbImage image(before.width(), before.height());
    for (std::size_t i = 0; i < before.size(); ++i) {
        const unsigned step = removed_in.data()[i];
        image.data()[i] = {static_cast<std::uint8_t>(before.data()[i]), static_cast<std::uint8_t>(step >> 8),
                           static_cast<std::uint8_t>(step & 255)};
    }
    return image;
}

int last_step(const Grid<std::uint16_t>& removed_in) {
    return removed_in.empty() ? 0 : *std::max_element(removed_in.begin(), removed_in.end());
}

// Pixels that went, coloured by when; the ones that stayed in black.
RgbaImage thinning_picture(const Skeletonization& s) {
    RgbaImage image(s.mask.width(), s.mask.height());
    const double last = std::max(1, last_step(s.thinned_in));
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (!s.voronoi_raster.data()[i]) continue;
        const Rgb8 c = heat(s.thinned_in.data()[i] / last);
        image.data()[i] = s.thinned.data()[i] ? Rgba8{0, 0, 0, 255} : Rgba8{c.r, c.g, c.b, 200};
    }
    return image;
}

} // namespace

Values contour_chapter(const ChapterInput& input) {
    const Skeletonization& s = skeletonization(input);
    Svg picture(s.mask.width(), s.mask.height(), "The borders that were followed, each in its own colour");
    picture.underlay(input.drawing(), 0.4);
    std::string rows;
    for (std::size_t i = 0; i < s.contour.size(); ++i) {
        const Border& border = s.contour[i];
        picture.polyline(to_points(border.points), css(category(i)), 1.4 * input.line(), true);
        if (!border.points.empty())
            picture.disc(to_double(border.points.front()), 3 * input.line(), css(category(i)));
        rows += "<tr><td><span class=\"swatch\" style=\"background:" + css(category(i)) + "\"></span>" +
                std::to_string(i) + "</td><td>" + (border.outer ? "outer border" : "border of a hole") +
                "</td><td>" + (border.parent < 0 ? "the frame" : std::to_string(border.parent)) +
                "</td><td>" + std::to_string(border.points.size()) + "</td><td>" +
                decimal(closed_length(border.points)) + "</td></tr>";
    }
    return {{"picture", picture.str()},
            {"rows", rows},
            {"count", count_of(s.contour.size(), "border", "borders")}};
}

Values voronoi_chapter(const ChapterInput& input) {
    const Skeletonization& s = skeletonization(input);
    const SkeletonizationOptions& options = options_of(input);
    const double threshold = s.threshold;
    const double most = most_residual(s.residuals, threshold);
    Svg picture(s.mask.width(), s.mask.height(),
                "Edges of the Voronoi diagram inside the silhouette, coloured by their residual");
    picture.underlay(input.drawing(), 0.3).raw(shaded_edges(s, most, 0.9 * input.line()));
    Svg lands(s.mask.width(), s.mask.height(),
              "Cells of the Voronoi diagram inside the silhouette, each in the colour of its border pixel");
    lands.underlay(input.drawing(), 0.3).image(picture_uri(cells(s)), s.mask.width(), s.mask.height());
    const auto kept =
        std::count_if(s.residuals.begin(), s.residuals.end(), [&](double r) { return r >= threshold; });
    Json data;
    data["threshold"] = threshold;
    data["most"] = most;
    data["edges"] = edge_data(s, most);
    return {{"picture", picture.str("voronoi")},
            {"cells", lands.str("cells")},
            {"data", script_json(data)},
            {"count", std::to_string(s.voronoi.size())},
            {"kept", std::to_string(kept)},
            {"threshold", decimal(threshold)},
            {"most", decimal(most)},
            {"residual", options.residual == Residual::chord ? "chord" : "arc"},
            {"slider", decimal(std::min(threshold, most))}};
}

Values thinning_chapter(const ChapterInput& input) {
    const Skeletonization& s = skeletonization(input);
    const int width = s.mask.width(), height = s.mask.height();
    Svg picture(width, height,
                "What thinning began with, coloured by when a pixel went, and in black what stayed");
    picture.underlay(input.drawing(), 0.3).image(picture_uri(thinning_picture(s)), width, height);
    const Thinning whole = zhang_suen_steps(s.mask); // for comparison: what thinning alone makes of the shape
    Json data;
    data["width"] = width;
    data["height"] = height;
    data["ridges"] = {{"picture", picture_uri(thinning_data(s.voronoi_raster, s.thinned_in))},
                      {"last", last_step(s.thinned_in)}};
    data["silhouette"] = {{"picture", picture_uri(thinning_data(s.mask, whole.removed_in))},
                          {"last", last_step(whole.removed_in)}};
    const auto pixels = [](const Mask& mask) {
        return std::to_string(std::count(mask.begin(), mask.end(), 1));
    };
    return {{"picture", picture.str("still")},
            {"data", script_json(data)},
            {"before", pixels(s.voronoi_raster)},
            {"thinned", pixels(s.thinned)},
            {"after", pixels(s.skeleton)},
            {"steps", std::to_string(last_step(s.thinned_in))},
            {"whole_steps", std::to_string(last_step(whole.removed_in))}};
}

Values graph_chapter(const ChapterInput& input) {
    const Skeletonization& s = skeletonization(input);
    const auto shown = [&](const SkeletonGraph& graph, const char* title) {
        Svg picture(s.mask.width(), s.mask.height(), title);
        picture.underlay(input.drawing(), 0.3).graph(graph, input.line());
        const auto ends = std::count_if(graph.vertices.begin(), graph.vertices.end(),
                                        [](const SkeletonVertex& v) { return v.end; });
        return "<figure>" + picture.str() + "<figcaption>" + title + ": " +
               count_of(graph.vertices.size(), "vertex", "vertices") + " (" +
               count_of(static_cast<std::size_t>(ends), "end", "ends") + "), " +
               count_of(graph.edges.size(), "edge", "edges") + ".</figcaption></figure>";
    };
    std::string rows;
    for (std::size_t i = 0; i < s.graph.vertices.size(); ++i) {
        const SkeletonVertex& v = s.graph.vertices[i];
        rows += "<tr><td>" + std::to_string(i) + "</td><td>" + decimal(v.x) + ", " + decimal(v.y) +
                "</td><td><span class=\"swatch part-" + std::string(name_of(v.label)) + "\"></span>" +
                std::string(name_of(v.label)) + "</td><td>" + (v.end ? "end" : "junction") + "</td></tr>";
    }
    return {{"pictures", shown(s.raw, "Raw") + shown(s.after_h1, "After H1") + shown(s.graph, "After H2")},
            {"rows", rows},
            {"epsilon",
             decimal(options_of(input).merge_distance * reference_scale(s.mask.width(), s.mask.height()))}};
}

} // namespace pantin
