// SPDX-License-Identifier: MIT
// Runs in, one SVG a character out, to judge each step by eye.
#include "figures/review.hpp"

#include <algorithm>

#include "core/file.hpp"
#include "figures/mapping_picture.hpp"
#include "figures/palette.hpp"
#include "figures/panel.hpp"
#include "figures/rendering.hpp"
#include "pantin/error.hpp"

namespace pantin::figures {
namespace {

namespace fs = std::filesystem;

constexpr double side = 210;
constexpr int frames = 5;

Rectangle column(int index) { return {margin + index * (side + margin), 26, side, side}; }

void draw_detected(Svg& svg, const DetectedCharacter& character) {
    Panel panel(svg, column(0), character.mask.width(), character.mask.height());
    panel.picture(character.drawing, character.mask.width(), character.mask.height());
    for (const Border& border : follow_borders(character.mask))
        svg.polyline(panel.at(border.points), stroked(second, 1), true);
}

void draw_steps(Svg& svg, const Run& run) {
    const LabelMap& labels = run.labels();
    Panel parts(svg, column(1), labels.width(), labels.height());
    parts.parts(labels);
    Panel skeleton(svg, column(2), labels.width(), labels.height());
    skeleton.parts(labels, true);
    skeleton.graph(run.skeleton.graph, stroked(ink, 1.6));
    draw_mapping(svg, column(3), run, 3);
    Rectangle film = column(4);
    film.width = frames * (side + margin);
    draw_film(svg, film, run, run.reference->clips.front().name, frames, 0.1);
}

std::string review_of(Gallery& gallery, const std::string& file, std::size_t index) {
    Svg svg(margin + (4 + frames) * (side + margin), side + 34);
    std::string title = file + "#" + std::to_string(index + 1);
    draw_detected(svg, gallery.detection(file).characters[index]);
    try {
        const Run& run = gallery.run(file, index);
        draw_steps(svg, run);
        title += ": " + run.identification.reference + ", type " + run.identification.type;
    } catch (const CharacterRejected& rejected) {
        title += ": rejected, " + rejected.step() + ": " + rejected.what();
    }
    svg.text({margin, 18}, title, {.size = 14, .anchor = Anchor::start});
    return svg.document(title);
}

} // namespace

void write_review(const std::string& pictures, const fs::path& out) {
    create_folder(out);
    std::vector<std::string> files;
    for (const auto& entry : fs::directory_iterator(pictures))
        if (entry.is_regular_file()) files.push_back(entry.path().filename().string());
    std::sort(files.begin(), files.end());
    for (const std::string& file : files) {
        const std::string extension = fs::path(file).extension().string();
        if ((extension != ".png" && extension != ".jpg") || file.rfind("labels", 0) == 0) continue;
        Gallery gallery(pictures);
        for (std::size_t i = 0; i < gallery.detection(file).characters.size(); ++i)
            write_file(out / (fs::path(file).stem().string() + "-" + std::to_string(i + 1) + ".svg"),
                       review_of(gallery, file, i));
    }
}

} // namespace pantin::figures
