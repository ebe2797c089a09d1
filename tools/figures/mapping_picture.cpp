// SPDX-License-Identifier: MIT
// A run in, the picture of its end-effector mapping out (thesis, Fig. 4.16).
#include "figures/mapping_picture.hpp"

#include <algorithm>

#include "figures/palette.hpp"
#include "pantin/image.hpp"

namespace pantin::figures {
namespace {

// Vertices joined by straight lines: the bones of the thesis, simplified.
std::vector<std::pair<Point2d, Point2d>> bones_of(const SkeletonGraph& graph) {
    std::vector<std::pair<Point2d, Point2d>> bones;
    for (const SkeletonEdge& edge : graph.edges) {
        const SkeletonVertex &u = graph.vertices[edge.u], &v = graph.vertices[edge.v];
        bones.push_back({{u.x, u.y}, {v.x, v.y}});
    }
    return bones;
}

void draw_figure(Panel& panel, const Mask& shape, const SkeletonGraph& graph, double radius) {
    panel.mask(shape, {228, 231, 236});
    std::vector<std::vector<Point2d>> lines;
    for (const SkeletonEdge& edge : graph.edges) lines.push_back(panel.at(edge.pixels));
    panel.svg().lines(lines, stroked({90, 160, 240}, 2.6));
    panel.segments(bones_of(graph), stroked(ink, 1.2));
    for (const SkeletonVertex& v : graph.vertices) panel.vertex(v, radius);
}

} // namespace

Mask shape_of(const pantin::Figure& figure) {
    Mask mask(figure.squared_distance.width(), figure.squared_distance.height());
    std::transform(figure.squared_distance.begin(), figure.squared_distance.end(), mask.begin(),
                   [](int d) { return d > 0; });
    return mask;
}

pantin::Figure reference_figure(const Run& run) {
    return draw_reference(*run.reference, run.candidate().mirrored);
}
pantin::Figure character_figure(const Run& run) {
    return make_figure(run.skeleton.graph, foreground(run.labels()));
}

void draw_mapping(Svg& svg, Rectangle place, const Run& run, double radius) {
    const pantin::Figure reference = reference_figure(run), character = character_figure(run);
    const Mask model = shape_of(reference), shape = shape_of(character);
    const double left_width = 0.4 * place.width;
    Panel left(svg, {place.x, place.y, left_width, place.height}, model.width(), model.height());
    Panel right(svg, {place.x + left_width, place.y, place.width - left_width, place.height}, shape.width(),
                shape.height());
    draw_figure(left, model, reference.graph, radius);
    draw_figure(right, shape, character.graph, radius);
    for (const EndPair& pair : run.rig.mapping.pairs) {
        const SkeletonVertex &a = reference.graph.vertices[pair.reference_end],
                             &b = character.graph.vertices[pair.end];
        svg.line(left.at(a.x, a.y), right.at(b.x, b.y), stroked(highlight, 1.4));
    }
    for (const EndPair& pair : run.rig.mapping.pairs) { // above the lines
        left.vertex(reference.graph.vertices[pair.reference_end], radius);
        right.vertex(character.graph.vertices[pair.end], radius);
    }
}

} // namespace pantin::figures
