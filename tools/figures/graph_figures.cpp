// SPDX-License-Identifier: MIT
// The skeleton graph and the two heuristics that simplify it (thesis 4.4), with the preset "thesis".
#include <algorithm>

#include "figures/figures.hpp"
#include "figures/palette.hpp"
#include "figures/panel.hpp"

namespace pantin::figures {
namespace {

std::string counts(const SkeletonGraph& graph) {
    const auto ends = std::count_if(graph.vertices.begin(), graph.vertices.end(),
                                    [](const SkeletonVertex& v) { return v.end; });
    return std::to_string(graph.vertices.size()) + " vertices, " + std::to_string(ends) + " ends";
}

void draw_graph(Svg& svg, Rectangle place, const Skeletonization& s, const SkeletonGraph& graph,
                const std::string& caption) {
    Panel panel(svg, place, s.mask.width(), s.mask.height());
    panel.mask(s.mask, silhouette_colour);
    panel.graph(graph, stroked(paper, 2), 5);
    panel.caption(caption + ": " + counts(graph));
}

// A part of it, larger.
void draw_closeup(Svg& svg, Rectangle place, const Mask& mask, const SkeletonGraph& graph, Point2d centre) {
    constexpr double width = 36, height = 18; // pixels
    Panel panel(svg, place, {centre.x - width / 2, centre.y - height / 2, width, height});
    svg.begin_clip(panel.frame());
    panel.mask(mask, silhouette_colour);
    panel.graph(graph, stroked(paper, 3), 9);
    svg.end_clip();
    panel.border();
}

Figure h1_figure(Gallery& gallery) {
    const Run& run = gallery.run("dog.png", 0, "thesis");
    Sheet sheet(2, 1, 440, 290, 24);
    legend(sheet.svg(), {margin, 24}, part_entries(run.labels()));
    draw_graph(sheet.svg(), sheet[0], run.skeleton, run.skeleton.raw, "(a) skeleton");
    draw_graph(sheet.svg(), sheet[1], run.skeleton, run.skeleton.after_h1, "(b) after H1");
    return {"fig-4.11-heuristic-h1.svg",
            sheet.svg().document("The skeleton graph before and after heuristic H1")};
}

// The vertices that H2 merges first: the nearest two of one label.
Point2d nearest_pair(const SkeletonGraph& graph) {
    Point2d middle;
    double nearest = 1e9;
    for (const SkeletonVertex& u : graph.vertices)
        for (const SkeletonVertex& v : graph.vertices) {
            const double d = distance(Point2d{u.x, u.y}, Point2d{v.x, v.y});
            if (&u != &v && u.label == v.label && d < nearest)
                nearest = d, middle = 0.5 * (Point2d{u.x, u.y} + Point2d{v.x, v.y});
        }
    return middle;
}

Figure h2_figure(Gallery& gallery) {
    const Run& run = gallery.run("person.png", 0, "thesis");
    const SkeletonGraph* graphs[] = {&run.skeleton.raw, &run.skeleton.after_h1, &run.skeleton.graph};
    const char* captions[] = {"(a) skeleton", "(b) H1", "(c) H2"};
    const Point2d centre = nearest_pair(run.skeleton.after_h1);
    Sheet sheet(3, 1, 300, 420, 24);
    Svg svg(sheet.svg().width(), sheet.svg().height() + 178);
    legend(svg, {margin, 24}, part_entries(run.labels()));
    for (int i = 0; i < 3; ++i) {
        draw_graph(svg, sheet[i], run.skeleton, *graphs[i], captions[i]);
        draw_closeup(svg, {sheet[i].x, sheet.svg().height() + 4, 300, 150}, run.skeleton.mask, *graphs[i],
                     centre);
    }
    svg.text({svg.width() / 2, svg.height() - 6}, "the chest, larger: two vertices closer than ε become one");
    return {"fig-4.12-heuristic-h2.svg",
            svg.document("The skeleton graph, after heuristic H1, after heuristic H2")};
}

} // namespace

std::vector<Figure> graph_figures(Gallery& gallery) { return {h1_figure(gallery), h2_figure(gallery)}; }

} // namespace pantin::figures
