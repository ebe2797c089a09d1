// Zhang and Suen's thinning: the neighbourhood, its conditions, its sub-iterations (thesis 4.4, Algorithm 4.1).
#include <algorithm>
#include <array>
#include <functional>

#include "figures/figures.hpp"
#include "figures/palette.hpp"
#include "figures/panel.hpp"
#include "pantin/image.hpp"
#include "skeletonization/neighbourhood.hpp"

namespace pantin::figures {
namespace {

// What Algorithm 4.1 asks about a pixel in its first sub-iteration.
struct Conditions {
    int b = 0, a = 0, c = 0, d = 0; // B(P1), A(P1), the two products

    explicit Conditions(unsigned n) {
        const auto p = [n](int i) { return static_cast<int>(n >> (i - 2) & 1u); }; // P2 … P9
        b = neighbour_count(n);
        for (int i = 2; i <= 9; ++i) a += p(i) == 0 && p(i == 9 ? 2 : i + 1) == 1;
        c = p(2) * p(4) * p(6);
        d = p(4) * p(6) * p(8);
    }
    bool holds_a() const { return 2 <= b && b <= 6; }
    bool deletes() const { return holds_a() && a == 1 && c == 0 && d == 0; }
};

void draw_names(Svg& svg, Point2d at, double cell) {
    const auto box = [&](int column, int row, const std::string& name, const std::string& place, bool centre) {
        const Point2d p{at.x + cell * column, at.y + cell * row};
        svg.rectangle({p.x, p.y, cell, cell}, outlined(centre ? pale(second) : paper, muted));
        svg.text({p.x + cell / 2, p.y + cell / 2 - 2}, name, {.size = 16, .bold = true});
        svg.text({p.x + cell / 2, p.y + cell / 2 + 16}, place, {.size = 11, .fill = muted});
    };
    box(1, 1, "P1", "I(i, j)", true);
    const auto shift = [](const char* name, int d) { return std::string(name) + (d == 0 ? "" : d > 0 ? "+1" : "−1"); };
    for (std::size_t k = 0; k < neighbour_offsets.size(); ++k) {
        const Point2i d = neighbour_offsets[k];
        box(1 + d.x, 1 + d.y, "P" + std::to_string(k + 2), "I(" + shift("i", d.y) + ", " + shift("j", d.x) + ")", false);
    }
}

// The first pixel in raster order, not near the picture's edge, for which `wanted` holds.
Point2i find_pixel(const Mask& mask, const std::function<bool(const Conditions&)>& wanted) {
    for (const Point2i p : foreground_pixels(mask))
        if (wanted(Conditions(neighbourhood(mask, p.x, p.y)))) return p;
    return {};
}

void draw_example(Svg& svg, Point2d at, const Mask& mask, Point2i p, const std::string& verdict) {
    constexpr int reach = 3;
    constexpr double side = 182;
    Panel panel(svg, {at.x, at.y, side, side}, {p.x - reach - 0.5, p.y - reach - 0.5, 2 * reach + 1.0, 2 * reach + 1.0});
    std::vector<Point2i> pixels;
    for (int y = p.y - reach; y <= p.y + reach; ++y)
        for (int x = p.x - reach; x <= p.x + reach; ++x)
            if (mask.value_or(x, y, 0)) pixels.push_back({x, y});
    panel.pixels(pixels, silhouette_colour);
    for (int i = 0; i <= 2 * reach + 1; ++i) {
        const double c = i - reach - 0.5;
        panel.segments({{{p.x + c, p.y - reach - 0.5}, {p.x + c, p.y + reach + 0.5}}, {{p.x - reach - 0.5, p.y + c}, {p.x + reach + 0.5, p.y + c}}}, stroked(faint, 0.7));
    }
    const Point2d corner = panel.at(p.x - 1.5, p.y - 1.5), inner = panel.at(p.x - 0.5, p.y - 0.5);
    svg.rectangle({corner.x, corner.y, 3 * panel.scale(), 3 * panel.scale()}, stroked(second, 2));
    svg.rectangle({inner.x, inner.y, panel.scale(), panel.scale()}, outlined(accent, accent, 1));

    const Conditions conditions(neighbourhood(mask, p.x, p.y));
    const auto row = [&](int i, const std::string& text, bool holds) {
        svg.text({at.x, at.y + side + 24 + 20 * i}, (holds ? "✓ " : "✗ ") + text, {.size = 12.5, .anchor = Anchor::start, .fill = holds ? third : accent});
    };
    row(0, "Ca: 2 ≤ B(P1) ≤ 6, B = " + std::to_string(conditions.b), conditions.holds_a());
    row(1, "Cb: A(P1) = 1, A = " + std::to_string(conditions.a), conditions.a == 1);
    row(2, "Cc: P2·P4·P6 = " + std::to_string(conditions.c), conditions.c == 0);
    row(3, "Cd: P4·P6·P8 = " + std::to_string(conditions.d), conditions.d == 0);
    svg.text({at.x + side / 2, at.y + side + 112}, verdict);
}

Figure neighbourhood_figure(Gallery& gallery) {
    const Mask& mask = gallery.run("humanoid.png").skeleton.mask;
    Svg svg(836, 344);
    draw_names(svg, {margin, margin}, 61);
    svg.text({margin + 91, margin + 206}, "the neighbours of P1,");
    svg.text({margin + 91, margin + 224}, "row i down, column j to the right");
    svg.text({margin, margin + 258}, "B: how many of P2 … P9 are 1", {.size = 12.5, .anchor = Anchor::start, .fill = muted});
    svg.text({margin, margin + 276}, "A: how often 0 is followed by 1", {.size = 12.5, .anchor = Anchor::start, .fill = muted});
    svg.text({margin, margin + 294}, "in P2, P3, …, P9, P2", {.size = 12.5, .anchor = Anchor::start, .fill = muted});
    const auto left = [](int i) { return margin + 224 + 204.0 * i; };
    draw_example(svg, {left(0), margin}, mask, find_pixel(mask, [](const Conditions& c) { return c.deletes() && c.b == 4; }), "(a) deleted: all four hold");
    draw_example(svg, {left(1), margin}, mask, find_pixel(mask, [](const Conditions& c) { return c.holds_a() && c.a == 1 && c.c == 1; }), "(b) kept for now: a western edge");
    const Mask thin = zhang_suen(mask);
    draw_example(svg, {left(2), margin}, thin, find_pixel(thin, [](const Conditions& c) { return c.b == 2 && c.a == 2; }), "(c) kept: between two parts of a line");
    return {"fig-4.10-neighbourhood.svg", svg.document("The neighbours of a pixel, and the conditions at three pixels")};
}

// --- sub-iterations ------------------------------------------------------------------------------------------------

// From light to dark; odd sub-iterations blue, even ones orange.
Rgb8 colour_of(int step, int last) {
    const double share = last > 1 ? static_cast<double>(step - 1) / (last - 1) : 0;
    return step % 2 == 1 ? mixed({206, 224, 250}, {24, 66, 160}, share) : mixed({253, 226, 190}, {170, 80, 10}, share);
}

RgbImage step_picture(const Thinning& thinning, int last) {
    RgbImage image(thinning.thinned.width(), thinning.thinned.height(), paper);
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (const int step = thinning.removed_in.data()[i]; step > 0) image.data()[i] = colour_of(step, last);
        if (thinning.thinned.data()[i]) image.data()[i] = {0, 0, 0};
    }
    return image;
}

void draw_window(Sheet& sheet, int index, const RgbImage& image, const Box& window, const std::string& caption) {
    Panel panel(sheet.svg(), sheet[index], window.width, window.height);
    panel.picture(crop(image, window), window.width, window.height, true);
    panel.border();
    panel.caption(caption);
}

Figure thinning_figure(Gallery& gallery) {
    const Skeletonization& s = gallery.run("humanoid.png").skeleton;
    const Thinning shape = zhang_suen_steps(s.mask);
    const int last = *std::max_element(shape.removed_in.begin(), shape.removed_in.end());
    const RgbImage steps = step_picture(shape, last);
    const Box whole{0, 0, s.mask.width(), s.mask.height()};
    const auto end = std::max_element(s.graph.vertices.begin(), s.graph.vertices.end(), [](const SkeletonVertex& a, const SkeletonVertex& b) { return a.y < b.y; });
    const int x = std::clamp(static_cast<int>(end->x) - 45, 0, whole.width - 90), y = whole.height - 112;
    const Box foot{x, y, 90, 112};

    Sheet sheet(3, 1, 290, 360, 26);
    legend(sheet.svg(), {margin, 24}, {{"deleted in an odd sub-iteration, first light, last dark", colour_of(7, 13)}, {"deleted in an even one", colour_of(8, 13)}, {"kept", {0, 0, 0}}});
    draw_window(sheet, 0, steps, whole, "(a) the whole silhouette is thinned in " + std::to_string(last));
    draw_window(sheet, 1, steps, foot, "(b) sub-iterations; a foot, larger");
    const Thinning ridges{s.thinned, s.thinned_in};
    const int ridge_last = *std::max_element(s.thinned_in.begin(), s.thinned_in.end());
    draw_window(sheet, 2, step_picture(ridges, std::max(ridge_last, 1)), foot,
                "(c) the Voronoi ridges are thinned in " + std::to_string(ridge_last));
    return {"alg-4.1-thinning.svg", sheet.svg().document("The sub-iteration in which thinning deletes each pixel")};
}

} // namespace

std::vector<Figure> thinning_figures(Gallery& gallery) { return {neighbourhood_figure(gallery), thinning_figure(gallery)}; }

} // namespace pantin::figures
