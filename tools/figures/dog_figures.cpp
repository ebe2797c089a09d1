// SPDX-License-Identifier: MIT
// Two failures of the thesis that come with certain legs and tails, both presets beside each other: limbs
// that the mesh joins (6.3, Fig. 6.9) and the dog of table 6.1 (6.2).
#include <algorithm>

#include "figures/drawn_dog.hpp"
#include "figures/figures.hpp"
#include "figures/joined_limbs.hpp"
#include "figures/mapping_picture.hpp"
#include "figures/preset_rows.hpp"
#include "figures/rendering.hpp"

namespace pantin::figures {
namespace {

// Two legs of a pair stand close above and apart below.
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
    Sheet sheet(5, 2, preset_column, preset_row, preset_header);
    std::string here;
    for (int i = 0; i < 2; ++i) {
        const Run run = gallery.whole_run(picture, presets[i]);
        const BoneAnimation clip = clip_of(run, run.reference->clips.front().name);
        const JoinedLimbs joined = joined_limbs_of(run.rig, clip);
        draw_preset_row(sheet, i, run, joined.time / clip.duration);
        draw_joined(sheet.svg(), sheet.place(4, i), run.rig, clip, joined);
        caption(sheet.svg(), sheet.place(4, i), "mesh of two legs; red: between legs");
        here += (i ? "; " : "") + of_preset(i, std::to_string(joined.edges.size())) +
                " edges between legs, stretched to " + shown(joined.largest, 1) + " times their length";
    }
    head_lines(
        sheet.svg(),
        "all four limbs are found and mapped, but the mesh follows the drawing: it connects two limbs and "
        "stretches between them.",
        here);
    return {"fig-6.9-joined-limbs.svg", sheet.svg().document("Legs that the mesh joins, with both presets")};
}

// A tail that hangs about where the humanoid reference has a hand.
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

// "humanoid 5.69, quadruped 5.82": the two candidates of the least distances or scores, the identified one
// first.
std::string best_two(const Identification& identification) {
    const auto text = [](const Candidate& c) { return c.reference + " " + shown(c.score, 2, true); };
    return text(identification.candidates[0]) + ", " + text(identification.candidates[1]);
}

Figure dog_figure(Gallery& gallery) {
    const LabelMap right = draw_dog(hanging_tail, 320, 267).labels;
    LabelMap wrong = right;
    std::replace(wrong.begin(), wrong.end(), static_cast<std::uint8_t>(Label::tail),
                 static_cast<std::uint8_t>(Label::limb));
    Sheet sheet(4, 2, preset_column, preset_row - 20, preset_header);
    Svg& svg = sheet.svg();
    for (int i = 0; i < 2; ++i)
        for (int k = 0; k < 2; ++k) {
            const Run run = gallery.with_labels({}, k ? right : wrong, presets[i]);
            const Rectangle parts = sheet.place(2 * k, i), mapping = sheet.place(2 * k + 1, i);
            draw_labelled(svg, parts, run);
            caption(svg, parts, of_preset(i, k ? "the tail corrected" : "the tail as a limb"));
            draw_mapping(svg, mapping, run, 4);
            caption(svg, mapping, best_two(run.identification));
        }
    head_lines(
        svg,
        "a dog whose tail is labelled as a limb is identified as a humanoid; manually corrected it is a "
        "quadruped.",
        "the parts are given by hand. Below each mapping the two best references, with what decides (the "
        "least): distances, or scores of default.");
    return {"table-6.1-dog.svg",
            svg.document("A dog with its tail labelled as a limb, and corrected, with both presets")};
}

} // namespace

std::vector<Figure> dog_figures(Gallery& gallery) {
    return {joined_limbs_figure(gallery), dog_figure(gallery)};
}

} // namespace pantin::figures
