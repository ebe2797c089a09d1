// SPDX-License-Identifier: MIT
// Skeleton paths, the discs along them and what two paths differ by (thesis 4.6, Eq. 4.8 and 4.9).
#include <algorithm>
#include <cmath>

#include "figures/figures.hpp"
#include "figures/mapping_picture.hpp"
#include "figures/palette.hpp"
#include "figures/panel.hpp"
#include "pantin/image.hpp"

namespace pantin::figures {
namespace {

constexpr Rgb8 path_green{60, 200, 90}, path_orange{255, 150, 40}, turquoise{0, 170, 180};

// The end-effectors of one part from left to right.
std::vector<int> ends_of(const SkeletonGraph& graph, Label label) {
    std::vector<int> ends;
    for (int v = 0; v < static_cast<int>(graph.vertices.size()); ++v)
        if (graph.vertices[v].end && graph.vertices[v].label == label) ends.push_back(v);
    std::sort(ends.begin(), ends.end(),
              [&](int a, int b) { return graph.vertices[a].x < graph.vertices[b].x; });
    return ends;
}

Figure paths_figure(Gallery& gallery) {
    const Run& run = gallery.run("dog.png");
    const SkeletonGraph& graph = run.skeleton.graph;
    const Grid<float> depth = distance_transform(run.skeleton.mask);
    const std::vector<int> legs = ends_of(graph, Label::limb);
    const std::vector<Point2d> first = shortest_path(graph, ends_of(graph, Label::head).front(),
                                                     ends_of(graph, Label::tail).front()),
                               second_path = shortest_path(graph, legs.front(), legs.back());
    Svg svg(640 + 2 * margin, 340 + margin + caption_height + 8);
    Panel panel(svg, {margin, margin, 640, 340}, run.labels().width(), run.labels().height());
    panel.mask(run.skeleton.mask, silhouette_colour);
    std::vector<std::vector<Point2d>> lines;
    for (const SkeletonEdge& edge : graph.edges) lines.push_back(panel.at(edge.pixels));
    svg.lines(lines, stroked(paper, 2));
    svg.polyline(panel.at(first), stroked(path_orange, 3.4));
    svg.polyline(panel.at(second_path), {.stroke = css(path_green), .width = 3.4, .dash = "9 5"});
    for (const auto& [path, share] : {std::pair{&first, 0.5}, {&first, 0.12}, {&second_path, 0.09}}) {
        const Point2d p = resample(*path, 1001)[static_cast<std::size_t>(1000 * share)];
        const double radius = depth(static_cast<int>(p.x + 0.5), static_cast<int>(p.y + 0.5));
        svg.circle(panel.at(p), panel.scale() * radius, stroked(highlight, 1.8));
        svg.circle(panel.at(p), 4, filled(highlight));
    }
    panel.caption("two skeleton paths (orange, green); pink: sample points with their maximal discs");
    return {"fig-4.14-skeleton-paths.svg",
            svg.document("Two skeleton paths, sample points with their maximal discs")};
}

Figure distance_figure(Gallery& gallery) {
    const Run& run = gallery.run("dog.png");
    const Mask& mask = run.skeleton.mask;
    const SkeletonGraph& graph = run.skeleton.graph;
    const Grid<float> depth = distance_transform(mask);
    const float deepest = *std::max_element(depth.begin(), depth.end());
    GreyImage grey(mask.width(), mask.height(), 255);
    for (std::size_t i = 0; i < grey.size(); ++i)
        if (mask.data()[i])
            grey.data()[i] = static_cast<std::uint8_t>(std::rint(225 * (1 - depth.data()[i] / deepest)));
    Sheet sheet(2, 1, 450, 300);
    Panel left(sheet.svg(), sheet[0], mask.width(), mask.height());
    sheet.svg().image(left.frame(), encode_png(grey));
    left.border();
    left.caption("(a) distance to the outside: up to " + shown(deepest, 1) + " px (black)");
    Panel right(sheet.svg(), sheet[1], mask.width(), mask.height());
    right.mask(mask, {228, 231, 236});
    std::vector<std::vector<Point2d>> lines;
    for (const SkeletonEdge& edge : graph.edges) lines.push_back(right.at(edge.pixels));
    sheet.svg().lines(lines, stroked(turquoise, 2));
    const std::vector<Point2d> samples = resample(
        shortest_path(graph, ends_of(graph, Label::limb).back(), ends_of(graph, Label::tail).front()),
        MappingOptions{}.samples);
    for (const Point2d p : samples) sheet.svg().circle(right.at(p), 2.6, filled(ink));
    right.border();
    right.caption("(b) M = " + std::to_string(samples.size()) +
                  " samples on the path between two end-effectors");
    return {"fig-4.15-distance-transform.svg",
            sheet.svg().document("Distance transform of a shape, samples along a skeleton path")};
}

// --- path distance
// -----------------------------------------------------------------------------------------------

// Samples of the path between two end-effectors, of which the mapping keeps one row an end.
const PathSamples& path_between(const std::vector<int>& ends,
                                const std::vector<std::vector<PathSamples>>& paths, int from, int to) {
    const auto place = [&](int v) { return std::find(ends.begin(), ends.end(), v) - ends.begin(); };
    const auto n = std::ssize(ends);
    return paths[static_cast<std::size_t>(place(from))]
                [static_cast<std::size_t>((place(to) - place(from) + n - 1) % n)];
}

void draw_curve(Panel& panel, const std::vector<double>& values, Rgb8 colour) {
    std::vector<Point2d> points;
    for (std::size_t i = 0; i < values.size(); ++i) points.push_back({static_cast<double>(i), -values[i]});
    panel.svg().polyline(panel.at(points), stroked(colour, 2));
}

void draw_path(Svg& svg, Rectangle place, const pantin::Figure& figure, int from, int to, Rgb8 path_colour,
               const std::string& caption) {
    const Mask shape = shape_of(figure);
    Panel panel(svg, place, shape.width(), shape.height());
    panel.mask(shape, {228, 231, 236});
    panel.graph(figure.graph, stroked(muted, 1), 3.5);
    svg.polyline(panel.at(shortest_path(figure.graph, from, to)), stroked(path_colour, 3));
    panel.caption(caption);
}

Figure path_distance_figure(Gallery& gallery) {
    const Run& run = gallery.run("dog.png");
    const Mapping& mapping = run.rig.mapping;
    const EndPair &from = mapping.pairs.front(), &to = mapping.pairs.back(); // the head's and a hind leg's
    const PathSamples& ours = path_between(mapping.ends, mapping.paths, from.end, to.end);
    const PathSamples& theirs =
        path_between(mapping.reference_ends, mapping.reference_paths, from.reference_end, to.reference_end);

    Svg svg(900, 330);
    draw_path(svg, {margin, margin, 250, 130}, character_figure(run), from.end, to.end, second,
              "a path of the drawing, l = " + shown(ours.length, 1) + " mean radii");
    draw_path(svg, {margin, margin + 164, 250, 115}, reference_figure(run), from.reference_end,
              to.reference_end, fourth, "its counterpart, l′ = " + shown(theirs.length, 1));

    std::vector<double> differences;
    double radii = 0;
    for (std::size_t i = 0; i < ours.radii.size(); ++i) {
        const double r = ours.radii[i], q = theirs.radii[i];
        differences.push_back(r + q > 0 ? (r - q) * (r - q) / (r + q) : 0);
        radii += differences.back();
    }
    const double highest = std::max(*std::max_element(ours.radii.begin(), ours.radii.end()),
                                    *std::max_element(theirs.radii.begin(), theirs.radii.end()));
    const double count = static_cast<double>(ours.radii.size()),
                 stretch = 0.36 * count / highest; // plots are wider than high
    const auto stretched = [stretch](std::vector<double> values) {
        for (double& v : values) v *= stretch;
        return values;
    };
    Panel plot(svg, {300, 20, 580, 230}, {0, -0.37 * count, count - 1, 0.38 * count});
    std::vector<std::pair<Point2d, Point2d>> bars;
    for (std::size_t i = 0; i < differences.size(); ++i)
        bars.push_back({{static_cast<double>(i), 0}, {static_cast<double>(i), -stretch * differences[i]}});
    plot.segments(bars, stroked(pale(accent), 6));
    draw_curve(plot, stretched(ours.radii), second);
    draw_curve(plot, stretched(theirs.radii), fourth);
    const Rectangle f = plot.frame();
    svg.lines({{{f.x, f.y}, {f.x, plot.at(0, 0).y}, {f.x + f.width, plot.at(0, 0).y}}}, stroked(muted));
    svg.text({f.x + f.width / 2, plot.at(0, 0).y + 18}, "sample i = 0 … M − 1", {.size = 12, .fill = muted});
    legend(svg, {f.x + 8, plot.at(0, 0).y + 40},
           {{"r_i", second}, {"r′_i", fourth}, {"(r_i − r′_i)² / (r_i + r′_i)", pale(accent)}});
    const double alpha = MappingOptions{}.alpha, l = ours.length, m = theirs.length,
                 lengths = alpha * (l - m) * (l - m) / (l + m);
    svg.text({f.x + 8, plot.at(0, 0).y + 64},
             "pd = " + shown(radii, 2, true) + " (sum of the bars) + " + shown(lengths, 2, true) +
                 " (α (l − l′)² / (l + l′), α = " + shown(alpha) +
                 ") = " + shown(path_distance(ours, theirs, alpha), 2, true),
             {.anchor = Anchor::start});
    return {"eq-4.9-path-distance.svg",
            svg.document("Radii along two skeleton paths, and the distance of the two")};
}

} // namespace

std::vector<Figure> path_figures(Gallery& gallery) {
    return {paths_figure(gallery), distance_figure(gallery), path_distance_figure(gallery)};
}

} // namespace pantin::figures
