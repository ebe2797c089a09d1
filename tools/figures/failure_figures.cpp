// SPDX-License-Identifier: MIT
// What goes wrong in the thesis's own results (thesis 6.1 to 6.3: Fig. 6.7, 6.9, 6.10, the dog of table 6.1),
// provoked by drawings of ours, `thesis` beside `default`; and the stick figure of Fig. 6.8, which goes right
// there. What captions say of a run is read from it.
#include <algorithm>

#include "doodle/doodle.hpp"
#include "figures/drawn_dog.hpp"
#include "figures/figures.hpp"
#include "figures/mapping_picture.hpp"
#include "figures/palette.hpp"
#include "figures/panel.hpp"
#include "figures/rendering.hpp"
#include "figures/stretch.hpp"
#include "pantin/geometry.hpp"

namespace pantin::figures {
namespace {

constexpr const char* presets[] = {"thesis", "default"};
constexpr double column = 236, row = 190, header = 46;

// One even pen on white, upright, so that what goes wrong is not the paper's fault.
RgbImage doodled(const std::string& what, std::uint64_t seed) {
    doodle::DoodleOptions options;
    options.width = options.height = 480;
    options.photo = options.paper = options.colour = options.gaps = options.tilt = 0;
    options.fill = 0.8;
    options.pen = 4;
    return doodle::draw_character(what, seed, options).picture;
}

// Above the panels: what the thesis says, and what is seen here.
void head_lines(Svg& svg, const std::string& thesis, const std::string& here) {
    const TextStyle style{.size = 12.5, .anchor = Anchor::start};
    svg.text({margin, 20}, "Thesis: " + thesis, style);
    svg.text({margin, 40}, "Here: " + here, style);
}

void draw_silhouette(Svg& svg, Rectangle place, const Run& run) {
    const Mask shape = foreground(run.labels());
    Panel panel(svg, place, shape.width(), shape.height());
    panel.picture(run.detected.drawing, shape.width(), shape.height());
    for (const Border& border : follow_borders(shape))
        svg.polyline(panel.at(border.points), stroked(second, 1.2), true);
}

void draw_parts(Svg& svg, Rectangle place, const Run& run) {
    Panel panel(svg, place, run.labels().width(), run.labels().height());
    panel.parts(run.labels(), true);
    panel.graph(run.skeleton.graph, stroked(ink, 1.6), 4);
}

// "leg_front_left" for readers.
std::string spoken(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

// The reference's ends that the drawing's ends of the label were mapped to, from top to bottom: "hand left,
// hand right".
std::string partners_of(const Run& run, Label label) {
    std::vector<EndPair> pairs = run.rig.mapping.pairs;
    const auto& vertices = run.skeleton.graph.vertices;
    std::stable_sort(pairs.begin(), pairs.end(), [&](const EndPair& a, const EndPair& b) {
        return vertices[a.end].y < vertices[b.end].y;
    });
    std::string names;
    for (const EndPair& pair : pairs)
        if (vertices[pair.end].label == label)
            names += (names.empty() ? "" : ", ") + spoken(run.reference->nodes[pair.reference_end].name);
    return names.empty() ? "nothing" : names;
}

// Silhouette, parts, mapping and the pose at a share of the clip, of one preset in a row of the sheet.
void draw_row(Sheet& sheet, int index, const Run& run, double share = 0.25) {
    Svg& svg = sheet.svg();
    draw_silhouette(svg, sheet.place(0, index), run);
    caption(svg, sheet.place(0, index), std::string("`") + presets[index] + "`: silhouette");
    draw_parts(svg, sheet.place(1, index), run);
    caption(svg, sheet.place(1, index), "parts and skeleton");
    draw_mapping(svg, sheet.place(2, index), run, 4);
    caption(svg, sheet.place(2, index), "ends of the " + run.identification.reference);
    draw_film(svg, sheet.place(3, index), run, run.reference->clips.front().name, 1, share);
    caption(svg, sheet.place(3, index), "clip “" + run.reference->clips.front().name + "”");
}

Figure fish_figure(Gallery& gallery) {
    const RgbImage picture = doodled("other:fish", 43);
    Sheet sheet(4, 2, column, row - 50, header);
    std::string fins;
    for (int i = 0; i < 2; ++i) {
        const Run run = gallery.whole_run(picture, presets[i]);
        draw_row(sheet, i, run);
        fins += std::string(i ? "; `" : "`") + presets[i] + "`: " + run.identification.reference +
                ", fin to " + partners_of(run, Label::limb) + ", tail to " + partners_of(run, Label::tail);
    }
    head_lines(
        sheet.svg(),
        "no reference is a fish, so it moves like a quadruped: lower fins are legs, the back fin the tail.",
        fins);
    return {"fig-6.7-fish.svg",
            sheet.svg().document("A fish that moves like a quadruped, with both presets")};
}

Figure stick_figure(Gallery& gallery) {
    const RgbImage picture = doodled("humanoid:stick person", 2);
    Sheet sheet(4, 2, column, row, header);
    std::string limbs;
    for (int i = 0; i < 2; ++i) {
        const Run run = gallery.whole_run(picture, presets[i]);
        draw_row(sheet, i, run);
        limbs += std::string(i ? "; `" : "`") + presets[i] + "`: " + run.identification.reference +
                 ", limbs from top to bottom " + partners_of(run, Label::limb);
    }
    head_lines(sheet.svg(),
               "a simple stick figure is identified as a humanoid and all its ends are mapped right.", limbs);
    return {"fig-6.8-stick-figure.svg", sheet.svg().document("A stick figure with both presets")};
}

// Legs that stand close above and apart below.
constexpr DogShape close_legs{.trunk = 126,
                              .girth = 47,
                              .neck = 0.86,
                              .pairs = 93,
                              .hips = 24,
                              .feet = 77,
                              .leg = 127,
                              .leg_radius = 15,
                              .tail = 81,
                              .tail_radius = 17,
                              .tail_angle = 2.84,
                              .tail_bend = 0};

Figure joined_limbs_figure(Gallery& gallery) {
    const RgbImage picture = draw_dog(close_legs, 480, 400).picture;
    Sheet sheet(5, 2, column, row, header);
    std::string here;
    for (int i = 0; i < 2; ++i) {
        const Run run = gallery.whole_run(picture, presets[i]);
        const BoneAnimation clip = clip_of(run, run.reference->clips.front().name);
        const Stretch stretch = stretch_of(run.rig, clip);
        draw_row(sheet, i, run, stretch.time / clip.duration);
        draw_stretched(sheet.svg(), sheet.place(4, i), run.rig, clip, stretch.time, 2);
        caption(sheet.svg(), sheet.place(4, i), "red: twice as long as at rest, or more");
        here += std::string(i ? "; `" : "`") + presets[i] + "`: limbs to " + partners_of(run, Label::limb) +
                ", largest stretch " + shown(stretch.largest, 1);
    }
    head_lines(sheet.svg(),
               "all four limbs are found and mapped, but the mesh joins the two of a pair and stretches "
               "between them.",
               here);
    return {"fig-6.9-joined-limbs.svg",
            sheet.svg().document(
                "Legs that the mesh joins, in the pose that stretches it most, with both presets")};
}

// The names of the reference's ends beside the ends of the drawing.
void draw_named(Svg& svg, Rectangle place, const Run& run) {
    const pantin::Figure character = character_figure(run);
    const Mask shape = shape_of(character);
    Panel panel(svg, place, {-90, -16, shape.width() + 180.0, shape.height() + 32.0});
    panel.mask(shape, {228, 231, 236});
    panel.graph(character.graph, stroked(muted, 1.4), 4);
    const double middle = shape.width() / 2.0;
    for (const EndPair& pair : run.rig.mapping.pairs) {
        const SkeletonVertex& v = character.graph.vertices[pair.end];
        const Point2d p = panel.at(v.x, v.y);
        const bool right = v.x > middle;
        svg.text({p.x + (right ? 9 : -9), p.y + 5}, spoken(run.reference->nodes[pair.reference_end].name),
                 {.size = 12.5, .anchor = right ? Anchor::start : Anchor::end, .fill = fourth, .bold = true});
    }
}

Figure symmetry_figure(Gallery& gallery) {
    const char* of[] = {"(a) ", "(b) "};
    const std::uint64_t seeds[] = {5, 29};
    Sheet sheet(4, 2, column, row + 20, header);
    Svg& svg = sheet.svg();
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 2; ++i) {
            const Run run = gallery.whole_run(doodled("humanoid:teddy", seeds[k]), presets[i]);
            draw_mapping(svg, sheet.place(2 * i, k), run, 4);
            caption(svg, sheet.place(2 * i, k), of[k] + std::string("`") + presets[i] + "`: ends mapped");
            draw_named(svg, sheet.place(2 * i + 1, k), run);
            caption(svg, sheet.place(2 * i + 1, k), "as what the drawing's ends move");
        }
    head_lines(svg,
               "paths of a symmetric figure are alike, so its ends are assigned wrongly (a), or rightly (b).",
               "two toy bears; the names are those of the reference's ends that move the drawing's.");
    return {"fig-6.10-symmetry.svg",
            svg.document("End-effectors of two symmetric figures and their partners, with both presets")};
}

// A tail that hangs about where a hand of the humanoid reference is.
constexpr DogShape hanging_tail{.trunk = 143,
                                .girth = 40,
                                .neck = 0.51,
                                .pairs = 99,
                                .hips = 28,
                                .feet = 66,
                                .leg = 114,
                                .leg_radius = 17,
                                .tail = 127,
                                .tail_radius = 17,
                                .tail_angle = 3.08,
                                .tail_bend = -0.59};

// "quadruped (quadruped 3.10, humanoid 3.34)": what was identified, and the distances or scores.
std::string verdict(const Run& run) {
    std::string text = run.identification.reference + " (";
    for (const char* name : {"quadruped", "humanoid"})
        for (const Candidate& c : run.identification.candidates)
            if (c.reference == name)
                text += (text.back() == '(' ? "" : ", ") + c.reference + " " + shown(c.score, 2, true);
    return text + ")";
}

Figure dog_figure(Gallery& gallery) {
    const LabelMap right = draw_dog(hanging_tail, 320, 270).labels;
    LabelMap wrong = right;
    std::replace(wrong.begin(), wrong.end(), static_cast<std::uint8_t>(Label::tail),
                 static_cast<std::uint8_t>(Label::limb));
    Sheet sheet(4, 2, column, row, header);
    Svg& svg = sheet.svg();
    for (int i = 0; i < 2; ++i)
        for (int k = 0; k < 2; ++k) {
            const Run run = gallery.with_labels({}, k ? right : wrong, presets[i]);
            draw_parts(svg, sheet.place(2 * k, i), run);
            caption(svg, sheet.place(2 * k, i), k ? "the tail corrected" : "the tail labelled as a limb");
            draw_mapping(svg, sheet.place(2 * k + 1, i), run, 4);
            caption(svg, sheet.place(2 * k + 1, i), std::string("`") + presets[i] + "`: " + verdict(run));
        }
    head_lines(svg,
               "a dog whose tail is labelled as a limb is taken for a humanoid; corrected by hand it is a "
               "quadruped.",
               "parts given by hand, since the network labels this tail rightly; in brackets what decides, "
               "the least counts.");
    return {"table-6.1-dog.svg",
            svg.document("A dog with its tail labelled as a limb, and corrected, with both presets")};
}

} // namespace

std::vector<Figure> failure_figures(Gallery& gallery) {
    return {fish_figure(gallery), stick_figure(gallery), joined_limbs_figure(gallery),
            symmetry_figure(gallery), dog_figure(gallery)};
}

} // namespace pantin::figures
