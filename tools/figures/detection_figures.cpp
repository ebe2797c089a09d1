// SPDX-License-Identifier: MIT
// From the page to the parts of its characters (thesis 4.2, 4.3), and their borders (4.4).
#include <algorithm>
#include <cmath>

#include "doodle/doodle.hpp"
#include "figures/figures.hpp"
#include "figures/palette.hpp"
#include "figures/panel.hpp"
#include "pantin/image.hpp"

namespace pantin::figures {
namespace {

constexpr Rgb8 found_colours[] = {second, accent, third, fourth, highlight, {0, 150, 160}};

// Each pixel where some character's claim is largest, in that character's colour.
RgbImage claimed(const RgbImage& page, const Grid<int>& claims) {
    RgbImage image = page;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (const int id = claims(x, y); id > 0)
                image(x, y) = mixed(image(x, y), found_colours[(id - 1) % 6], 0.4);
    return image;
}

Figure mask_rcnn_figure(Gallery& gallery) {
    const RgbImage& page = gallery.page("demo.png");
    auto found = gallery.networks().finder().find(page, ink_darkness(page));
    const double least = DetectionOptions{}.network_score;
    std::erase_if(found, [least](const CharacterFinder::Found& f) { return f.score < least; });
    constexpr double width = 560;
    const double scale = width / page.width(), height = scale * page.height();
    Svg svg(width + 2 * margin, height + margin + caption_height + 6);
    Panel panel(svg, {margin, margin, width, height}, page.width(), page.height());
    const RgbImage picture = claimed(page, CharacterFinder::claims(found, page.width(), page.height(), 1));
    panel.picture(resize(picture, 700, 700 * page.height() / page.width()), page.width(), page.height());
    for (std::size_t i = 0; i < found.size(); ++i) {
        const CharacterFinder::Found& f = found[i];
        const Rgb8 colour = found_colours[i % 6];
        const Point2d corner = panel.at(f.left, f.top), other = panel.at(f.right, f.bottom);
        svg.rectangle({corner.x, corner.y, other.x - corner.x, other.y - corner.y}, stroked(colour, 2));
        svg.rectangle({corner.x - 1, corner.y, 104, 19}, filled(colour));
        svg.text({corner.x + 51, corner.y + 14}, "character " + shown(f.score, 2, true),
                 {.size = 12, .fill = paper, .bold = true});
    }
    panel.caption("box, class, score and mask of what scores at least " + shown(least));
    return {"fig-4.3-mask-rcnn.svg",
            svg.document("Output of the detection network: boxes, scores and masks")};
}

Figure composed_figure() {
    doodle::DoodleOptions options;
    options.width = 600;
    options.height = 480;
    options.photo = options.paper = options.colour = 0;
    options.tilt = 2;
    options.fill = 0.9;
    const doodle::Page page = doodle::draw_page(
        {"humanoid", "quadruped", "flying", "quadruped:giraffe", "humanoid", "flying"}, 46, options);
    Sheet sheet(3, 1, 300, 240);
    Panel drawing(sheet.svg(), sheet[0], options.width, options.height);
    drawing.picture(page.picture, options.width, options.height);
    drawing.border();
    drawing.caption("(a) page, placed and turned at random");
    Panel instances(sheet.svg(), sheet[1], options.width, options.height);
    RgbImage ids(options.width, options.height, paper);
    for (std::size_t i = 0; i < ids.size(); ++i)
        if (const int id = page.instances.data()[i]; id > 0) ids.data()[i] = found_colours[(id - 1) % 6];
    instances.picture(ids, options.width, options.height, true);
    for (const doodle::Character& c : page.characters) {
        const Point2d corner = instances.at(c.box.x - 0.5, c.box.y - 0.5);
        sheet.svg().rectangle(
            {corner.x, corner.y, instances.scale() * c.box.width, instances.scale() * c.box.height},
            stroked(muted));
    }
    instances.border();
    instances.caption("(b) truth for detection: box and mask");
    Panel parts(sheet.svg(), sheet[2], options.width, options.height);
    parts.parts(page.labels);
    parts.border();
    parts.caption("(c) truth for segmentation: parts");
    return {"fig-4.6-composed-page.svg", sheet.svg().document("A composed page of drawings with its truth")};
}

Figure segmentation_figure(Gallery& gallery) {
    const RgbImage& page = gallery.page("dog.png");
    const Run& run = gallery.run("dog.png");
    const Box box = run.detected.box;
    Sheet sheet(2, 2, 400, 300, 24);
    legend(sheet.svg(), {margin, 24}, part_entries(run.labels()));
    Panel input(sheet.svg(), sheet[0], page.width(), page.height());
    input.picture(page, page.width(), page.height());
    input.border();
    input.caption("(a) input");
    Panel boxed(sheet.svg(), sheet[1], page.width(), page.height());
    boxed.picture(page, page.width(), page.height());
    boxed.border();
    const Point2d corner = boxed.at(box.x - 0.5, box.y - 0.5);
    sheet.svg().rectangle({corner.x, corner.y, boxed.scale() * box.width, boxed.scale() * box.height},
                          stroked(accent, 2));
    boxed.caption("(b) box of the detected character, score " + shown(run.detected.score, 2, true));
    Panel mask(sheet.svg(), sheet[2], run.labels().width(), run.labels().height());
    mask.mask(run.detected.mask, silhouette_colour);
    mask.border();
    mask.caption("(c) its mask");
    Panel parts(sheet.svg(), sheet[3], run.labels().width(), run.labels().height());
    parts.parts(run.labels());
    parts.border();
    parts.caption("(d) its parts");
    return {"fig-4.7-detection-segmentation.svg", sheet.svg().document("A character's box, mask and parts")};
}

// --- borders
// -----------------------------------------------------------------------------------------------------

// A ring with an island in its hole.
Mask nested_mask() {
    Mask ring(120, 120);
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 120; ++x) {
            const int d = (x - 60) * (x - 60) + (y - 60) * (y - 60);
            ring(x, y) = (d < 52 * 52 && d > 30 * 30) || d < 14 * 14;
        }
    return ring;
}

void draw_borders(Panel& panel, const std::vector<Border>& borders, double width) {
    for (const Border& border : borders)
        panel.svg().polyline(panel.at(border.points),
                             stroked(border.outer ? Rgb8{0, 170, 60} : fourth, width), true);
}

Figure contour_figure(Gallery& gallery) {
    const Skeletonization& s = gallery.run("person.png").skeleton;
    Sheet sheet(3, 1, 300, 340);
    Panel mask(sheet.svg(), sheet[0], s.mask.width(), s.mask.height());
    mask.mask(s.mask, silhouette_colour);
    mask.border();
    mask.caption("(a) silhouette: black 1, white 0");
    Panel contour(sheet.svg(), sheet[1], s.mask.width(), s.mask.height());
    contour.mask(s.mask, silhouette_colour);
    draw_borders(contour, s.contour, 2);
    contour.border();
    contour.caption("(b) its border, " + std::to_string(s.contour.front().points.size()) + " pixels");
    const Mask ring = nested_mask();
    Panel nested(sheet.svg(), sheet[2], ring.width(), ring.height());
    nested.mask(ring, silhouette_colour);
    const std::vector<Border> borders = follow_borders(ring);
    draw_borders(nested, borders, 3);
    for (std::size_t b = 0; b < borders.size(); ++b) {
        const Point2d top = nested.at(60, borders[b].points.front().y);
        const std::string parent = borders[b].parent < 0 ? "the frame" : std::to_string(borders[b].parent);
        sheet.svg().text({top.x, top.y + 22}, std::to_string(b) + ", in " + parent,
                         {.size = 12, .fill = borders[b].outer ? paper : ink});
    }
    nested.border();
    nested.caption("(c) nested: outer borders green, of holes orange");
    return {"fig-4.9-contour.svg", sheet.svg().document("A silhouette and its borders")};
}

} // namespace

std::vector<Figure> detection_figures(Gallery& gallery) {
    return {mask_rcnn_figure(gallery), composed_figure(), segmentation_figure(gallery),
            contour_figure(gallery)};
}

} // namespace pantin::figures
