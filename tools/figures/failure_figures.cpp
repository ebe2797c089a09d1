// SPDX-License-Identifier: MIT
// What goes wrong in the thesis's own results, provoked by drawings of ours, both presets beside each other:
// the fish of 6.1 (Fig. 6.7) and the mapping of symmetric figures (6.3, Fig. 6.10). Fig. 6.8, a stick figure,
// goes right in the thesis. What the lines and captions say of a run is read from it.
#include <array>

#include "figures/figures.hpp"
#include "figures/mapping_picture.hpp"
#include "figures/palette.hpp"
#include "figures/preset_rows.hpp"

namespace pantin::figures {
namespace {

Figure fish_figure(Gallery& gallery) {
    const RgbImage picture = doodled("other:fish", 43);
    Sheet sheet(4, 2, preset_column, preset_row - 60, preset_header);
    std::string here;
    for (int i = 0; i < 2; ++i) {
        const Run run = gallery.whole_run(picture, presets[i]);
        draw_preset_row(sheet, i, run);
        here += (i ? "; " : "") + of_preset(i, run.identification.reference) + ", side fin → " +
                partners_of(run, Label::limb) + ", tail fin → " + partners_of(run, Label::tail);
    }
    head_lines(sheet.svg(),
               "no reference is a fish, so it gets quadruped motion: lower fins → legs, back fin → tail.",
               here);
    return {"fig-6.7-fish.svg",
            sheet.svg().document("A fish that moves like a quadruped, with both presets")};
}

Figure stick_figure(Gallery& gallery) {
    const RgbImage picture = doodled("humanoid:stick person", 2);
    Sheet sheet(4, 2, preset_column, preset_row, preset_header);
    std::string here;
    for (int i = 0; i < 2; ++i) {
        const Run run = gallery.whole_run(picture, presets[i]);
        draw_preset_row(sheet, i, run);
        here += (i ? "; " : "") + of_preset(i, run.identification.reference) + ", limbs → " +
                partners_of(run, Label::limb);
    }
    head_lines(sheet.svg(),
               "no failure: a stick figure is identified as a humanoid, and its ends are mapped rightly.",
               here + " (from top to bottom)");
    return {"fig-6.8-stick-figure.svg", sheet.svg().document("A stick figure, with both presets")};
}

// The names of the reference's ends beside the ends of the drawing that they move.
void draw_named(Svg& svg, Rectangle place, const Run& run) {
    constexpr double room = 74; // for names on both sides
    const pantin::Figure character = character_figure(run);
    const Mask shape = shape_of(character);
    place.x += room, place.width -= 2 * room;
    Panel panel(svg, place, shape.width(), shape.height());
    panel.mask(shape, {228, 231, 236});
    panel.graph(character.graph, stroked(muted, 1.4), 4);
    for (const EndPair& pair : run.rig.mapping.pairs) {
        const SkeletonVertex& v = character.graph.vertices[pair.end];
        const Point2d p = panel.at(v.x, v.y);
        const bool right = v.x > shape.width() / 2.0;
        svg.text({p.x + (right ? 9 : -9), p.y + 4}, spoken(run.reference->nodes[pair.reference_end].name),
                 {.size = 12, .anchor = right ? Anchor::start : Anchor::end, .fill = fourth, .bold = true});
    }
}

Figure symmetry_figure(Gallery& gallery) {
    struct Example {
        const char* letter;
        std::uint64_t seed;
    };
    constexpr std::array<Example, 2> examples = {{{"(a)", 5}, {"(b)", 16}}};
    Sheet sheet(4, 2, preset_column, preset_row + 10, preset_header);
    Svg& svg = sheet.svg();
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 2; ++i) {
            const Run run = gallery.whole_run(doodled("humanoid:teddy", examples[k].seed), presets[i]);
            const Rectangle lines = sheet.place(2 * i, k), names = sheet.place(2 * i + 1, k);
            draw_mapping(svg, lines, run, 4);
            caption(svg, lines, std::string(examples[k].letter) + " " + of_preset(i, "ends mapped"));
            draw_named(svg, names, run);
            caption(svg, names, "which end moves which");
        }
    head_lines(svg,
               "the mapping is not robust against symmetry: ends are assigned wrongly (a), those of a panda "
               "rightly (b).",
               "two toy bears; names are those of the reference's ends, beside the ends of the drawing that "
               "they move.");
    return {"fig-6.10-symmetry.svg",
            svg.document("End-effectors of two symmetric figures and their partners, with both presets")};
}

} // namespace

std::vector<Figure> failure_figures(Gallery& gallery) {
    return {fish_figure(gallery), stick_figure(gallery), symmetry_figure(gallery)};
}

} // namespace pantin::figures
