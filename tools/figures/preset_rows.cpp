// SPDX-License-Identifier: MIT
// Runs of both presets in, panels and words out.
#include "figures/preset_rows.hpp"

#include <algorithm>

#include "doodle/doodle.hpp"
#include "figures/mapping_picture.hpp"
#include "figures/palette.hpp"
#include "figures/rendering.hpp"
#include "pantin/geometry.hpp"

namespace pantin::figures {
namespace {

void draw_silhouette(Svg& svg, Rectangle place, const Run& run) {
    const Mask shape = foreground(run.labels());
    Panel panel(svg, place, shape.width(), shape.height());
    panel.picture(run.detected.drawing, shape.width(), shape.height());
    for (const Border& border : follow_borders(shape))
        svg.polyline(panel.at(border.points), stroked(second, 1.2), true);
}

} // namespace

RgbImage doodled(const std::string& what, std::uint64_t seed) {
    doodle::DoodleOptions options;
    options.width = options.height = 480;
    options.photo = options.paper = options.colour = options.gaps = options.tilt = 0;
    options.fill = 0.8;
    options.pen = 4;
    return doodle::draw_character(what, seed, options).picture;
}

void head_lines(Svg& svg, const std::string& thesis, const std::string& here) {
    const TextStyle style{.size = 12.5, .anchor = Anchor::start};
    svg.text({margin, 20}, "The text: " + thesis, style);
    svg.text({margin, 40}, "Here: " + here, style);
}

std::string of_preset(int index, const std::string& text) {
    return "preset " + std::string(presets[index]) + ": " + text;
}

std::string spoken(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

std::string partners_of(const Run& run, Label label) {
    const std::vector<SkeletonVertex>& vertices = run.skeleton.graph.vertices;
    std::vector<EndPair> pairs = run.rig.mapping.pairs;
    std::stable_sort(pairs.begin(), pairs.end(), [&](const EndPair& a, const EndPair& b) {
        return vertices[a.end].y < vertices[b.end].y;
    });
    std::string names;
    for (const EndPair& pair : pairs)
        if (vertices[pair.end].label == label)
            names += (names.empty() ? "" : ", ") + spoken(run.reference->nodes[pair.reference_end].name);
    return names.empty() ? "none" : names;
}

void draw_labelled(Svg& svg, Rectangle place, const Run& run) {
    Panel panel(svg, place, run.labels().width(), run.labels().height());
    panel.parts(run.labels(), true);
    panel.graph(run.skeleton.graph, stroked(ink, 1.6), 4);
}

void draw_preset_row(Sheet& sheet, int index, const Run& run, double share) {
    Svg& svg = sheet.svg();
    const std::string clip = run.reference->clips.front().name;
    draw_silhouette(svg, sheet.place(0, index), run);
    caption(svg, sheet.place(0, index), of_preset(index, "silhouette"));
    draw_labelled(svg, sheet.place(1, index), run);
    caption(svg, sheet.place(1, index), "parts and skeleton");
    draw_mapping(svg, sheet.place(2, index), run, 4);
    caption(svg, sheet.place(2, index), "identified: " + run.identification.reference);
    draw_film(svg, sheet.place(3, index), run, clip, 1, share);
    caption(svg, sheet.place(3, index), "in the clip “" + clip + "”");
}

} // namespace pantin::figures
