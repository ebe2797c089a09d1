// SPDX-License-Identifier: MIT
// Step 2: what the network believes of every pixel, and what it became.
#include <algorithm>
#include <cmath>

#include "explain/chapters.hpp"
#include "explain/palette.hpp"
#include "explain/svg.hpp"

namespace pantin {

namespace {

// The colour of a part, as opaque as the part is probable: a script can read the probability back from alpha.
RgbaImage veil(const Grid<float>& probability, Rgb8 colour) {
    RgbaImage image(probability.width(), probability.height());
    std::transform(probability.begin(), probability.end(), image.begin(), [&](float p) {
        return Rgba8{
            colour.r, colour.g, colour.b,
            static_cast<std::uint8_t>(std::lrint(255 * std::clamp(static_cast<double>(p), 0.0, 1.0)))};
    });
    return image;
}

std::string maps(const ChapterInput& input, const Segmentation& segmentation) {
    std::string figures;
    for (std::size_t l = 0; l < segmentation.probabilities.size() && l < label_names.size(); ++l) {
        const std::string name(label_names[l]);
        Svg map(input.width(), input.height(), "Where the network sees " + name);
        map.underlay(input.drawing(), 0.35);
        map.image(picture_uri(veil(segmentation.probabilities[l], row_of(static_cast<Label>(l)).colour)),
                  input.width(), input.height(), 0.9);
        figures += "<figure data-label=\"" + name + "\">" + map.str("map") +
                   "<figcaption><span class=\"swatch part-" + name + "\"></span>" + name +
                   " <output></output></figcaption></figure>";
    }
    return figures;
}

std::string bar(const std::string& name, double share, bool chosen) {
    return "<tr" + std::string(chosen ? " class=\"chosen\"" : "") + "><th scope=\"row\">" + escaped(name) +
           "</th><td class=\"bar\"><span style=\"width:" + decimal(100 * share, 1) + "%\"></span></td><td>" +
           decimal(share, 3) + "</td></tr>";
}

std::string router(const Segmentation& segmentation) {
    std::string rows;
    for (const auto& [name, share] : segmentation.router)
        rows += bar(name, share, name == segmentation.expert);
    return rows;
}

std::string pose(const Segmentation& segmentation) {
    std::string rows;
    const auto best =
        std::max_element(segmentation.pose.begin(), segmentation.pose.end()) - segmentation.pose.begin();
    for (std::size_t i = 0; i < segmentation.pose.size(); ++i)
        rows += bar(pose_names[i], segmentation.pose[i], static_cast<std::ptrdiff_t>(i) == best);
    return rows;
}

std::string areas(const LabelMap& labels) {
    std::string rows;
    const double silhouette = static_cast<double>(
        labels.size() - static_cast<std::size_t>(std::count(labels.begin(), labels.end(), 0)));
    for (int l = 1; l < label_count; ++l) {
        const double area = static_cast<double>(std::count(labels.begin(), labels.end(), l));
        rows += bar(std::string(label_names[l]), silhouette > 0 ? area / silhouette : 0, area > 0);
    }
    return rows;
}

// A swatch and a name for each part.
std::string legend() {
    std::string text;
    for (const Label label : part_labels)
        text += " <span class=\"swatch part-" + std::string(name_of(label)) + "\"></span>" +
                std::string(name_of(label));
    return text;
}

// "1 head, 2 body, …": what to paint labels.png with.
std::string grey_values() {
    std::string text;
    for (const Label label : part_labels)
        text += std::to_string(static_cast<int>(label)) + " " + std::string(name_of(label)) + ", ";
    return text + "0 not the character";
}

Svg painted(const ChapterInput& input, const LabelMap& labels) {
    RgbaImage image(labels.width(), labels.height());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const Rgb8 c = row_of(static_cast<Label>(labels.data()[i])).colour;
        image.data()[i] = {c.r, c.g, c.b, static_cast<std::uint8_t>(labels.data()[i] ? 130 : 0)};
    }
    Svg picture(labels.width(), labels.height(),
                "The drawing with every pixel of the silhouette in the colour of its part");
    picture.underlay(input.drawing()).image(picture_uri(image), labels.width(), labels.height());
    return picture;
}

} // namespace

Values segment_chapter(const ChapterInput& input) {
    const LabelMap& labels = input.character.segmentation.labels;
    Values values = {{"picture", painted(input, labels).str()},
                     {"areas", areas(labels)},
                     {"legend", legend()},
                     {"parts", listed_parts()},
                     {"values", grey_values()}};
    const Segmentation& segmentation = input.character.segmentation;
    if (!segmentation.router.empty()) {
        values["network"] = filled(asset("chapters/segment-network.html"),
                                   {{"maps", maps(input, segmentation)},
                                    {"router", router(segmentation)},
                                    {"pose", pose(segmentation)},
                                    {"expert", escaped(segmentation.expert)},
                                    {"confidence", decimal(segmentation.confidence, 3)},
                                    {"strokes", decimal(segmentation.stroke_ratio, 2)}});
    } else {
        values["network"] = "<p>The part labels of this character were given, so no network was asked.</p>";
    }
    return values;
}

} // namespace pantin
