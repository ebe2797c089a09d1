// SPDX-License-Identifier: MIT
// The reference skeletons and the distance to them (thesis 4.5).
#include <algorithm>

#include "figures/figures.hpp"
#include "figures/mapping_picture.hpp"
#include "figures/palette.hpp"
#include "figures/panel.hpp"

namespace pantin::figures {
namespace {

constexpr const char* names[] = {"humanoid", "quadruped", "flying"};

void draw_reference_panel(Sheet& sheet, int index, const ReferenceSkeleton& reference,
                          const std::string& caption) {
    const pantin::Figure figure = draw_reference(reference, false);
    const Mask shape = shape_of(figure);
    Panel panel(sheet.svg(), sheet[index], shape.width(), shape.height());
    panel.mask(shape, {228, 231, 236});
    panel.graph(figure.graph, stroked(ink, 2), 6);
    panel.border();
    panel.caption(caption);
}

void draw_skeleton(Sheet& sheet, int index, const Run& run, const std::string& caption) {
    Panel panel(sheet.svg(), sheet[index], run.labels().width(), run.labels().height());
    panel.mask(run.skeleton.mask, {228, 231, 236});
    panel.graph(run.skeleton.graph, stroked(ink, 2), 5);
    panel.caption(caption);
}

Figure references_figure(Gallery& gallery) {
    const Run& run = gallery.run("dog.png");
    Sheet sheet(4, 2, 220, 220, 24);
    std::vector<std::pair<std::string, Rgb8>> parts;
    for (int label = 1; label < label_count; ++label)
        parts.emplace_back(label_names[label], part_colours[label]);
    legend(sheet.svg(), {margin, 24}, parts);
    for (int i = 0; i < 3; ++i)
        draw_reference_panel(sheet, i, gallery.reference(names[i]),
                             std::string("(") + "abc"[i] + ") " + names[i]);
    draw_skeleton(sheet, 3, run, "(d) a drawing's skeleton");
    draw_reference_panel(sheet, 4, gallery.reference("bird"), "(e) bird (ours)");
    draw_reference_panel(sheet, 5, gallery.reference("insect"), "(f) insect (ours)");
    draw_skeleton(sheet, 6, gallery.run("humanoid.png"), "(g) a person's skeleton");
    draw_skeleton(sheet, 7, gallery.run("flying.png"), "(h) a bird's skeleton");
    return {"fig-4.13-references.svg",
            sheet.svg().document("Reference skeletons with their shapes, and a drawing's skeleton")};
}

// --- the distance's terms
// --------------------------------------------------------------------------------------------

// Both graphs normalised, matched vertices joined.
void draw_match(Svg& svg, Rectangle place, const Run& run, const ReferenceSkeleton& reference,
                const Candidate& candidate) {
    const LabelledGraph a = normalised(to_labelled_graph(run.skeleton.graph));
    LabelledGraph b = normalised(to_labelled_graph(reference));
    if (candidate.mirrored) b = mirrored(b);
    Panel panel(svg, place, {-0.12, -0.12, 1.24, 1.24});
    const auto edges = [&](const LabelledGraph& g, const Style& style) {
        std::vector<std::pair<Point2d, Point2d>> lines;
        for (const auto& [u, v] : g.edges) lines.push_back({g.positions[u], g.positions[v]});
        panel.segments(lines, style);
    };
    edges(b, {.stroke = css(faint), .width = 3});
    edges(a, stroked(ink, 1.4));
    for (const auto& [u, v] : candidate.pairs)
        svg.line(panel.at(a.positions[u]), panel.at(b.positions[v]),
                 {.stroke = css(highlight), .width = 1.6, .dash = "3 2"});
    const auto vertices = [&](const LabelledGraph& g, bool end) {
        for (std::size_t i = 0; i < g.positions.size(); ++i)
            panel.vertex({g.positions[i].x, g.positions[i].y, g.labels[i], end}, 4);
    };
    vertices(b, false);
    vertices(a, true);
    panel.border();
}

struct Term {
    const char* name;
    double GgdTerms::*value;
    Rgb8 colour;
};
constexpr Term terms[] = {{"places (K_v)", &GgdTerms::places, highlight},
                          {"labels (K_l)", &GgdTerms::labels, accent},
                          {"lengths of matched edges (K_e)", &GgdTerms::lengths, {0, 170, 180}},
                          {"edges of the drawing without a partner (K_e)", &GgdTerms::edges_a, ink},
                          {"edges of the reference without a partner (K_e)", &GgdTerms::edges_b, faint}};

Figure distance_figure(Gallery& gallery) {
    const Run& run = gallery.run("dog.png", 0, "thesis");
    constexpr double side = 250, bar_width = 250;
    Svg svg(3 * (side + 24) + 12, 2 * margin + side + 170);
    double most = 0;
    for (const Candidate& c : run.identification.candidates) most = std::max(most, c.distance);
    for (int i = 0; i < 3; ++i) {
        const ReferenceSkeleton& reference = gallery.reference(names[i]);
        const auto candidate =
            std::find_if(run.identification.candidates.begin(), run.identification.candidates.end(),
                         [&](const Candidate& c) { return c.reference == reference.name; });
        const double left = margin + i * (side + 24);
        draw_match(svg, {left, margin, side, side}, run, reference, *candidate);
        svg.text({left + side / 2, margin + side + 20}, std::string("(") + "abc"[i] + ") to " + names[i] +
                                                            ": ggd = " + shown(candidate->distance, 2, true));
        double x = left;
        for (const Term& term : terms) {
            const double length = bar_width * candidate->terms.*term.value / most;
            svg.rectangle({x, margin + side + 34, length, 22}, filled(term.colour));
            x += length;
        }
    }
    double y = margin + side + 84;
    for (const Term& term : terms) {
        legend(svg, {margin, y}, {{term.name, term.colour}});
        y += 18;
    }
    const double right = margin + 372;
    svg.text({right, margin + side + 84},
             "Black, squares: the drawing's skeleton; grey, circles: the reference;",
             {.size = 12, .anchor = Anchor::start, .fill = muted});
    svg.text({right, margin + side + 102},
             "both in [0, 1]. Dashed: matched vertices. Bars: the terms of the sum.",
             {.size = 12, .anchor = Anchor::start, .fill = muted});
    svg.text({right, margin + side + 120}, "Preset thesis: K_v = 1 (quadruped 0.38), K_e = 1, K_l = 5.",
             {.size = 12, .anchor = Anchor::start, .fill = muted});
    return {"eq-4.7-graph-distance.svg",
            svg.document("The terms of the labelled graph distance to each reference")};
}

} // namespace

std::vector<Figure> identification_figures(Gallery& gallery) {
    return {references_figure(gallery), distance_figure(gallery)};
}

} // namespace pantin::figures
