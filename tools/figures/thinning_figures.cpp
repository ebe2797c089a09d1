// SPDX-License-Identifier: MIT
// Zhang and Suen's thinning: the neighbourhood, its conditions, its sub-iterations (thesis 4.4,
// Algorithm 4.1).
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
    const auto box = [&](int column, int row, const std::string& name, const std::string& place,
                         bool centre) {
        const Point2d p{at.x + cell * column, at.y + cell * row};
        svg.rectangle({p.x, p.y, cell, cell}, outlined(centre ? pale(second) : paper, muted));
        svg.text({p.x + cell / 2, p.y + cell / 2 - 2}, name, {.size = 16, .bold = true});
        svg.text({p.x + cell / 2, p.y + cell / 2 + 16}, place, {.size = 11, .fill = muted});
    };
    box(1, 1, "P1", "I(i, j)", true);
    const auto shift = [](const char* name, int d) {
        return std::string(name) + (d == 0 ? "" : d > 0 ? "+1" : "−1");
    };
    for (std::size_t k = 0; k < neighbour_offsets.size(); ++k) {
        const Point2i d = neighbour_offsets[k];
        box(1 + d.x, 1 + d.y, "P" + std::to_string(k + 2),
            "I(" + shift("i", d.y) + ", " + shift("j", d.x) + ")", false);
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
    Panel panel(svg, {at.x, at.y, side, side},
                {p.x - reach - 0.5, p.y - reach - 0.5, 2 * reach + 1.0, 2 * reach + 1.0});
    std::vector<Point2i> pixels;
    for (int y = p.y - reach; y <= p.y + reach; ++y)
        for (int x = p.x - reach; x <= p.x + reach; ++x)
            if (mask.value_or(x, y, 0)) pixels.push_back({x, y});
    panel.pixels(pixels, silhouette_colour);
    for (int i = 0; i <= 2 * reach + 1; ++i) {
        const double c = i - reach - 0.5;
        panel.segments({{{p.x + c, p.y - reach - 0.5}, {p.x + c, p.y + reach + 0.5}},
                        {{p.x - reach - 0.5, p.y + c}, {p.x + reach + 0.5, p.y + c}}},
                       stroked(faint, 0.7));
    }
    const Point2d corner = panel.at(p.x - 1.5, p.y - 1.5), inner = panel.at(p.x - 0.5, p.y - 0.5);
    svg.rectangle({corner.x, corner.y, 3 * panel.scale(), 3 * panel.scale()}, stroked(second, 2));
    svg.rectangle({inner.x, inner.y, panel.scale(), panel.scale()}, outlined(accent, accent, 1));

    const Conditions conditions(neighbourhood(mask, p.x, p.y));
    const auto row = [&](int i, const std::string& text, bool holds) {
        svg.text({at.x, at.y + side + 24 + 20 * i}, (holds ? "✓ " : "✗ ") + text,
                 {.size = 12.5, .anchor = Anchor::start, .fill = holds ? third : accent});
    };
    row(0, "Ca: 2 ≤ B(P1) ≤ 6, B = " + std::to_string(conditions.b), conditions.holds_a());
    row(1, "Cb: A(P1) = 1, A = " + std::to_string(conditions.a), conditions.a == 1);
    row(2, "Cc: P2·P4·P6 = " + std::to_string(conditions.c), conditions.c == 0);
    row(3, "Cd: P4·P6·P8 = " + std::to_string(conditions.d), conditions.d == 0);
    svg.text({at.x + side / 2, at.y + side + 112}, verdict);
}

Figure neighbourhood_figure(Gallery& gallery) {
    const Mask& mask = gallery.run("person.png").skeleton.mask;
    Svg svg(848, 318);
    draw_names(svg, {margin, margin}, 61);
    svg.text({margin + 91, margin + 206}, "the neighbours of P1");
    svg.text({margin + 91, margin + 224}, "(row i, column j)");
    svg.text({margin, margin + 252}, "B: how many of P2 … P9 are 1",
             {.size = 12.5, .anchor = Anchor::start, .fill = muted});
    svg.text({margin, margin + 270}, "A: how often 0 is followed by 1",
             {.size = 12.5, .anchor = Anchor::start, .fill = muted});
    svg.text({margin, margin + 288}, "in P2, P3, …, P9, P2",
             {.size = 12.5, .anchor = Anchor::start, .fill = muted});
    const auto left = [](int i) { return margin + 232 + 204.0 * i; };
    draw_example(svg, {left(0), margin}, mask,
                 find_pixel(mask, [](const Conditions& c) { return c.deletes() && c.b == 4; }),
                 "(a) deleted: all hold");
    draw_example(svg, {left(1), margin}, mask,
                 find_pixel(mask, [](const Conditions& c) { return c.holds_a() && c.a == 1 && c.c == 1; }),
                 "(b) kept: Cc fails");
    const Mask thin = zhang_suen(mask);
    draw_example(svg, {left(2), margin}, thin,
                 find_pixel(thin, [](const Conditions& c) { return c.b == 2 && c.a == 2; }),
                 "(c) kept: Cb fails");
    return {"fig-4.10-neighbourhood.svg",
            svg.document("The neighbours of a pixel, and the conditions at three pixels")};
}

// --- sub-iterations
// ------------------------------------------------------------------------------------------------

// From light to dark; odd sub-iterations blue, even ones orange.
Rgb8 colour_of(int step, int last) {
    const double share = last > 1 ? static_cast<double>(step - 1) / (last - 1) : 0;
    return step % 2 == 1 ? mixed({206, 224, 250}, {24, 66, 160}, share)
                         : mixed({253, 226, 190}, {170, 80, 10}, share);
}

RgbImage step_picture(const Thinning& thinning, int last) {
    RgbImage image(thinning.thinned.width(), thinning.thinned.height(), paper);
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (const int step = thinning.removed_in.data()[i]; step > 0) image.data()[i] = colour_of(step, last);
        if (thinning.thinned.data()[i]) image.data()[i] = {0, 0, 0};
    }
    return image;
}

// Every pixel with the number of its sub-iteration.
void draw_numbers(Panel& panel, const Thinning& thinning, int last, const Box& window) {
    std::vector<std::vector<Point2i>> pixels(static_cast<std::size_t>(last) + 1); // by sub-iteration; 0: kept
    for (int y = 0; y < window.height; ++y)
        for (int x = 0; x < window.width; ++x) {
            const int step = thinning.removed_in(window.x + x, window.y + y);
            if (step > 0 || thinning.thinned(window.x + x, window.y + y))
                pixels[static_cast<std::size_t>(step)].push_back({x, y});
        }
    for (int step = 0; step <= last; ++step)
        panel.pixels(pixels[static_cast<std::size_t>(step)],
                     step == 0 ? Rgb8{0, 0, 0} : colour_of(step, last));
    for (int step = 1; step <= last; ++step)
        for (const Point2i pixel : pixels[static_cast<std::size_t>(step)]) {
            const Point2d p = panel.at(to_double(pixel));
            panel.svg().text({p.x, p.y + 3.2}, std::to_string(step), {.size = 8.5, .fill = ink});
        }
}

// About the lowest pixel of the skeleton, which is in a foot.
Box foot_window(const Mask& skeleton, int width, int height) {
    const Point2i lowest = foreground_pixels(skeleton).back();
    return {std::clamp(lowest.x - width / 2, 0, skeleton.width() - width),
            std::clamp(lowest.y - height / 2, 0, skeleton.height() - height), width, height};
}

Figure thinning_figure(Gallery& gallery) {
    const Skeletonization& s = gallery.run("person.png").skeleton;
    const Thinning thinning = zhang_suen_steps(s.mask);
    const int last = *std::max_element(thinning.removed_in.begin(), thinning.removed_in.end());
    const RgbImage steps = step_picture(thinning, last);
    const Box whole{0, 0, s.mask.width(), s.mask.height()}, foot = foot_window(thinning.thinned, 33, 27);
    Svg svg(3 * margin + 320 + 540, margin + 26 + 444 + caption_height + 6);
    legend(svg, {margin, 24},
           {{"odd sub-iteration", colour_of(7, 13)},
            {"even sub-iteration", colour_of(8, 13)},
            {"kept", {0, 0, 0}},
            {"(light: early, dark: late)", paper}});
    Panel left(svg, {margin, margin + 26, 320, 444}, whole.width, whole.height);
    left.picture(steps, whole.width, whole.height, true);
    left.border();
    left.caption("(a) " + std::to_string(last) + " sub-iterations thin the silhouette");
    const Point2d corner = left.at(foot.x - 0.5, foot.y - 0.5);
    svg.rectangle({corner.x, corner.y, left.scale() * foot.width, left.scale() * foot.height},
                  stroked(accent, 1.5));
    Panel right(svg, {2 * margin + 320, margin + 26, 540, 444}, foot.width, foot.height);
    draw_numbers(right, thinning, last, foot);
    right.border();
    right.caption("(b) the red window: which sub-iteration deletes each pixel");
    return {"alg-4.1-thinning.svg", svg.document("The sub-iteration in which thinning deletes each pixel")};
}

} // namespace

std::vector<Figure> thinning_figures(Gallery& gallery) {
    return {neighbourhood_figure(gallery), thinning_figure(gallery)};
}

} // namespace pantin::figures
