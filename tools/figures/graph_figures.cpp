// The skeleton graph and the two heuristics that simplify it (thesis 4.4), with the preset "thesis".
#include <algorithm>

#include "figures/figures.hpp"
#include "figures/palette.hpp"
#include "figures/panel.hpp"

namespace pantin::figures {
namespace {

std::string counts(const SkeletonGraph& graph) {
    const auto ends = std::count_if(graph.vertices.begin(), graph.vertices.end(), [](const SkeletonVertex& v) { return v.end; });
    return std::to_string(graph.vertices.size()) + " vertices, " + std::to_string(ends) + " ends";
}

void draw_graph(Sheet& sheet, int index, const Skeletonization& s, const SkeletonGraph& graph, const std::string& caption) {
    Panel panel(sheet.svg(), sheet[index], s.mask.width(), s.mask.height());
    panel.mask(s.mask, silhouette_colour);
    panel.graph(graph, stroked(paper, 2), 5);
    panel.caption(caption + ": " + counts(graph));
}

Figure h1_figure(Gallery& gallery) {
    const Run& run = gallery.run("quadruped.png", 0, "thesis");
    Sheet sheet(2, 1, 440, 290, 24);
    legend(sheet.svg(), {margin, 24}, part_entries(run.labels()));
    draw_graph(sheet, 0, run.skeleton, run.skeleton.raw, "(a) skeleton");
    draw_graph(sheet, 1, run.skeleton, run.skeleton.after_h1, "(b) after H1");
    return {"fig-4.11-heuristic-h1.svg", sheet.svg().document("The skeleton graph before and after heuristic H1")};
}

Figure h2_figure(Gallery& gallery) {
    const Run& run = gallery.run("humanoid.png", 0, "thesis");
    Sheet sheet(3, 1, 300, 370, 24);
    legend(sheet.svg(), {margin, 24}, part_entries(run.labels()));
    draw_graph(sheet, 0, run.skeleton, run.skeleton.raw, "(a) skeleton");
    draw_graph(sheet, 1, run.skeleton, run.skeleton.after_h1, "(b) H1");
    draw_graph(sheet, 2, run.skeleton, run.skeleton.graph, "(c) H2");
    return {"fig-4.12-heuristic-h2.svg", sheet.svg().document("The skeleton graph, after heuristic H1, after heuristic H2")};
}

} // namespace

std::vector<Figure> graph_figures(Gallery& gallery) { return {h1_figure(gallery), h2_figure(gallery)}; }

} // namespace pantin::figures
