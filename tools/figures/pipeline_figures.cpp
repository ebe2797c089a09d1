// SPDX-License-Identifier: MIT
// The whole way at a glance, and what goes in (thesis 4.1).
#include <algorithm>
#include <cmath>

#include "figures/figures.hpp"
#include "figures/mapping_picture.hpp"
#include "figures/palette.hpp"
#include "figures/panel.hpp"
#include "figures/rendering.hpp"
#include "pantin/image.hpp"

namespace pantin::figures {
namespace {

Figure page_figure(Gallery& gallery) {
    const RgbImage& page = gallery.page("demo.png");
    constexpr double width = 560;
    const double height = width * page.height() / page.width();
    Svg svg(width + 2 * margin, height + 2 * margin);
    Panel panel(svg, {margin, margin, width, height}, page.width(), page.height());
    panel.picture(resize(page, 700, 700 * page.height() / page.width()), page.width(), page.height());
    panel.border();
    return {"fig-4.2-page.svg", svg.document("A page with several characters")};
}

Figure overview_figure(Gallery& gallery) {
    const RgbImage& page = gallery.page("dog.png");
    const Run& run = gallery.run("dog.png");
    const int width = run.labels().width(), height = run.labels().height();
    Sheet sheet(3, 2, 330, 220);
    Svg& svg = sheet.svg();
    Panel input(svg, sheet[0], page.width(), page.height());
    input.picture(page, page.width(), page.height());
    input.border();
    input.caption("(a) drawing");
    Panel detected(svg, sheet[1], width, height);
    detected.mask(run.detected.mask, silhouette_colour);
    detected.caption("(b) detected: its silhouette");
    Panel parts(svg, sheet[2], width, height);
    parts.parts(run.labels());
    parts.caption("(c) segmented: its parts");
    Panel skeleton(svg, sheet[3], width, height);
    skeleton.parts(run.labels(), true);
    skeleton.graph(run.skeleton.graph, stroked(ink, 2));
    skeleton.caption("(d) skeletonized");
    draw_mapping(svg, sheet[4], run, 4);
    caption(svg, sheet[4], "(e) identified: " + run.identification.reference + ", ends mapped");
    draw_film(svg, sheet[5], run, run.reference->clips.front().name, 1, 0.25);
    caption(svg, sheet[5], "(f) mesh, rigged and animated");
    return {"fig-4.1-pipeline.svg", svg.document("One drawing through all steps of the pipeline")};
}

} // namespace

std::vector<Figure> pipeline_figures(Gallery& gallery) {
    return {overview_figure(gallery), page_figure(gallery)};
}

} // namespace pantin::figures
