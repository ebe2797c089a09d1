// SPDX-License-Identifier: MIT
// From the parts of a figure to lines: placing, hand-drawn outlines, what hides what, ink, labels.
#include "doodle/canvas.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"

namespace pantin::doodle {

using math::pi;

namespace {

Colour random_paint(Random& r) {
    static const std::vector<Colour> crayons = {
        {235, 80, 60},   {245, 165, 40}, {250, 220, 60},  {95, 175, 80},   {70, 140, 215},  {150, 95, 190},
        {240, 150, 180}, {150, 95, 55},  {205, 165, 120}, {170, 170, 170}, {110, 110, 115}, {250, 215, 185}};
    Colour colour = r.pick(crayons);
    for (float& c : colour) c = std::clamp(c + static_cast<float>(r.uniform(-18, 18)), 0.0f, 255.0f);
    return colour;
}

void choose_pen(Hand& hand, Random& r, double size) {
    const Colour black{static_cast<float>(r.uniform(0, 45)), static_cast<float>(r.uniform(0, 45)),
                       static_cast<float>(r.uniform(0, 50))};
    hand.ink = black;
    switch (r.integer(0, 7)) {
    case 0:
    case 1:
    case 2: // a program's pen
        hand.pen = size * r.uniform(0.006, 0.013), hand.pressure = 0.0;
        break;
    case 3: // ballpoint
        hand.pen = size * r.uniform(0.004, 0.008), hand.opacity = r.uniform(0.75, 0.95), hand.pressure = 0.3,
        hand.grain = 0.15;
        if (r.chance(0.5)) hand.ink = {30, 45, static_cast<float>(r.uniform(110, 190))};
        break;
    case 4: // felt tip
        hand.pen = size * r.uniform(0.009, 0.02), hand.opacity = r.uniform(0.85, 1.0), hand.pressure = 0.12;
        if (r.chance(0.3)) hand.ink = random_paint(r);
        break;
    case 5: // pencil
        hand.pen = size * r.uniform(0.005, 0.01), hand.opacity = r.uniform(0.5, 0.85),
        hand.grain = r.uniform(0.3, 0.7), hand.pressure = 0.25, hand.taper = 0.3;
        hand.ink = {60, 60, 66};
        break;
    case 6: // crayon
        hand.pen = size * r.uniform(0.012, 0.024), hand.opacity = r.uniform(0.8, 1.0),
        hand.grain = r.uniform(0.4, 0.8), hand.pressure = 0.2;
        if (r.chance(0.6)) hand.ink = random_paint(r);
        break;
    default: // brush
        hand.pen = size * r.uniform(0.007, 0.015), hand.pressure = 0.5, hand.taper = r.uniform(0.3, 0.8);
        break;
    }
    // A pale ink would not be a drawing.
    const float light = 0.299f * hand.ink[0] + 0.587f * hand.ink[1] + 0.114f * hand.ink[2];
    if (light > 150.0f)
        for (float& c : hand.ink) c *= 150.0f / light;
}

} // namespace

Hand random_hand(Random& r, const DoodleOptions& options) {
    Hand hand;
    const double size = std::min(options.width, options.height);
    choose_pen(hand, r, size);
    if (options.pen > 0.0) hand.pen = options.pen;
    hand.pen = std::max(hand.pen, 1.1);
    const double skill = r.uniform(); // 0 a practised hand, 1 a small child or a mouse
    hand.bulge = r.uniform(0.005, 0.012 + 0.06 * skill * skill);
    hand.misplace = size * r.uniform(0.0, 0.002 + 0.012 * skill);
    hand.closure = r.uniform(0.0, 0.01 + 0.06 * skill);
    hand.wobble = size * r.uniform(0.0, 0.001 + 0.004 * skill);
    hand.tremor = r.chance(0.5) ? 0.0 : size * r.uniform(0.0, 0.0012 + 0.0015 * skill);
    hand.corners = r.chance(0.35) ? size * r.uniform(0.002, 0.014) : 0.0;
    hand.overshoot = r.chance(0.2) ? 0.3 : size * r.uniform(0.002, 0.012);
    hand.gap = options.gaps * (r.chance(0.4) ? 0.0 : r.uniform(0.05, 0.45));
    hand.again = r.chance(0.65) ? 0.0 : r.uniform(0.05, 0.6);
    for (int i = 0; i < 8; ++i) hand.paints.push_back(random_paint(r));
    // People know the colour of skin: often the head has it, and the hands.
    static const std::vector<Colour> skins = {{250, 215, 185}, {225, 175, 135}, {165, 115, 80}};
    if (r.chance(0.4)) hand.paints[static_cast<std::size_t>(Label::head)] = r.pick(skins);
    if (r.chance(0.5))
        hand.paints[static_cast<std::size_t>(Label::limb)] =
            hand.paints[static_cast<std::size_t>(Label::head)];
    hand.coloured_lines = r.chance(options.colour * 0.3);
    if (r.chance(options.colour)) {
        hand.filling =
            r.pick(std::vector<Filling>{Filling::flat, Filling::hatched, Filling::hatched, Filling::wash});
        if (r.chance(0.25)) std::fill(hand.paints.begin(), hand.paints.end(), hand.paints.front());
        if (r.chance(0.06)) std::fill(hand.paints.begin(), hand.paints.end(), Colour{70, 70, 74});
    }
    return hand;
}

Hand natural_hand(const Hand& hand, Random& r) {
    static const std::vector<Colour> natural = {{250, 215, 50},  {245, 150, 40}, {225, 60, 50},
                                                {90, 170, 70},   {80, 150, 220}, {140, 90, 55},
                                                {150, 150, 155}, {240, 145, 175}};
    Hand out = hand;
    out.paints = natural;
    for (Colour& paint : out.paints)
        for (float& c : paint) c = std::clamp(c + static_cast<float>(r.uniform(-25, 25)), 0.0f, 255.0f);
    out.coloured_lines = hand.filling != Filling::none && r.chance(0.4);
    return out;
}

std::string place_figure(Figure& figure, Random& r, Box area, const DoodleOptions& options) {
    const bool mirror = r.chance(0.5) && figure.may_mirror;
    const double turn =
        figure.max_tilt * options.tilt * (figure.max_tilt < 1.0 ? 0.5 * r.normal() : r.uniform(-1.0, 1.0));
    const double tilt = std::clamp(turn, -figure.max_tilt, figure.max_tilt), aspect = r.uniform(0.85, 1.18);
    const double fill = options.fill > 0.0 ? options.fill : r.uniform(0.6, 0.95);
    double x0 = 1e9, y0 = 1e9, x1 = -1e9, y1 = -1e9;
    for (Part& part : figure.parts)
        for (Point2d& p : part.outline.points) {
            p = rotated({(mirror ? -1.0 : 1.0) * aspect * p.x, p.y}, tilt);
            if (part.kind == PartKind::mark || part.within >= 0) continue;
            x0 = std::min(x0, p.x), x1 = std::max(x1, p.x), y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
        }
    const double scale = fill * std::min(area.width / (x1 - x0), area.height / (y1 - y0));
    const double slack_x = std::max(0.0, area.width - scale * (x1 - x0)),
                 slack_y = std::max(0.0, area.height - scale * (y1 - y0));
    const Point2d corner{area.x + slack_x * r.uniform(0.15, 0.85), area.y + slack_y * r.uniform(0.15, 0.85)};
    for (Part& part : figure.parts)
        for (Point2d& p : part.outline.points) p = corner + scale * (p - Point2d{x0, y0});
    const double heading = (mirror ? pi - figure.heading : figure.heading) + tilt;
    static const char* const names[] = {"E", "SE", "S", "SW", "W", "NW", "N", "NE"};
    const int octant = static_cast<int>(std::floor(heading / (pi / 4) + 0.5));
    return names[((octant % 8) + 8) % 8];
}

namespace {

class Draughtsman {
public:
    Draughtsman(const Figure& figure, const Hand& hand, Random& random, int width, int height)
        : figure_(figure), hand_(hand), random_(random), width_(width),
          height_(height), layer_{Grid<Colour>(width, height, hand.ground), LabelMap(width, height)},
          top_(width, height, -1) {}

    Layer draw() {
        shape_outlines();
        paint_order();
        if (hand_.filling != Filling::none) colour_parts();
        for (std::size_t i = 0; i < parts_.size(); ++i) draw_part(i);
        label_parts();
        return std::move(layer_);
    }

private:
    bool hides(std::size_t a, std::size_t b) const { // a is in front of b
        return parts_[a].depth > parts_[b].depth || (parts_[a].depth == parts_[b].depth && a > b);
    }

    static bool has(const std::vector<std::pair<int, int>>& pairs, std::size_t a, std::size_t b) {
        const int i = static_cast<int>(a), j = static_cast<int>(b);
        for (const auto& [p, q] : pairs)
            if ((p == i && q == j) || (p == j && q == i)) return true;
        return false;
    }

    // Outlines as the hand makes them: swollen here, shrunken there.
    void shape_outlines() {
        parts_ = figure_.parts;
        std::vector<Point2d> shift;
        for (Part& part : parts_) {
            const double dx = hand_.misplace * random_.normal(), dy = hand_.misplace * random_.normal();
            const bool piece = part.within >= 0;
            if (piece)
                shift.push_back(shift[static_cast<std::size_t>(part.within)]);
            else
                shift.push_back(part.owner < 0 ? Point2d{dx, dy}
                                               : shift[static_cast<std::size_t>(part.owner)] +
                                                     Point2d{0.3 * dx, 0.3 * dy});
            for (Point2d& p : part.outline.points) p = p + shift.back();
            const double total = path_length(part.outline.points, part.outline.closed);
            part.outline = resample(part.outline, 1.5);
            if (part.kind == PartKind::mark) continue;
            const Waver bulge(random_, random_.integer(3, 7), 0.7);
            const double size = std::min(total / 4.0, 80.0), amplitude = hand_.bulge * size;
            Path& points = part.outline.points;
            Path moved = points;
            for (std::size_t i = 0; i < points.size(); ++i) {
                const Point2d along =
                    unit(points[(i + 1) % points.size()] - points[(i + points.size() - 1) % points.size()]);
                moved[i] = points[i] + (amplitude * bulge(static_cast<double>(i) / points.size())) *
                                           Point2d{-along.y, along.x};
            }
            if (!part.outline.closed) moved.front() = points.front(), moved.back() = points.back();
            points = std::move(moved);
        }
    }

    static void clip(Patch<std::uint8_t>& mask, const Patch<std::uint8_t>& to) {
        for (int y = 0; y < mask.box.height; ++y)
            for (int x = 0; x < mask.box.width; ++x)
                if (!to.at(mask.box.x + x, mask.box.y + y)) mask.values(x, y) = 0;
    }

    void paint_order() {
        masks_.resize(parts_.size());
        for (std::size_t i = 0; i < parts_.size(); ++i) order_.push_back(i);
        std::stable_sort(order_.begin(), order_.end(),
                         [&](std::size_t a, std::size_t b) { return parts_[a].depth < parts_[b].depth; });
        for (std::size_t i : order_) {
            if (parts_[i].kind != PartKind::region) continue;
            masks_[i] = fill_polygon(parts_[i].outline.points, width_, height_);
            const Box& box = masks_[i].box;
            if (parts_[i].within >= 0) clip(masks_[i], masks_[static_cast<std::size_t>(parts_[i].within)]);
            for (int y = 0; y < box.height; ++y)
                for (int x = 0; x < box.width; ++x)
                    if (masks_[i].values(x, y)) top_(box.x + x, box.y + y) = static_cast<int>(i);
        }
    }

    bool visible(std::size_t i, Point2d p) const {
        const int x = static_cast<int>(std::floor(p.x + 0.5)), y = static_cast<int>(std::floor(p.y + 0.5));
        const Part& part = parts_[i];
        if (part.kind == PartKind::mark) {
            if (part.owner < 0) return true;
            const int top = top_.value_or(x, y, -1);
            return top == part.owner || (top >= 0 && has(figure_.merged, static_cast<std::size_t>(top),
                                                         static_cast<std::size_t>(part.owner)));
        }
        if (part.within >= 0 && !masks_[static_cast<std::size_t>(part.within)].at(x, y)) return false;
        for (std::size_t j = 0; j < parts_.size(); ++j) {
            if (parts_[j].within >= 0 || part.within == static_cast<int>(j)) continue;
            if (j == i || parts_[j].kind != PartKind::region || !masks_[j].at(x, y)) continue;
            if (has(figure_.merged, i, j)) return false;
            if (hides(j, i) && !has(figure_.see_through, i, j)) return false;
        }
        return true;
    }

    const Colour& line_colour(const Part& part) const {
        if (part.kind == PartKind::mark && hand_.second_ink) return *hand_.second_ink;
        if (!hand_.coloured_lines || part.kind == PartKind::mark) return hand_.ink;
        return hand_.paints[static_cast<std::size_t>(part.paint) % hand_.paints.size()];
    }

    // One crayon after the other, wherever its parts are on top.
    void colour_parts() {
        const bool whole = random_.chance(0.7) || hand_.fill_all; // or only some crayons
        const int paints = static_cast<int>(hand_.paints.size());
        for (int paint = 0; paint < paints; ++paint) {
            if (!(whole || random_.chance(0.5))) continue;
            Grid<std::uint8_t> where(width_, height_);
            for (int y = 0; y < height_; ++y)
                for (int x = 0; x < width_; ++x) {
                    const int top = top_(x, y);
                    where(x, y) = top >= 0 && parts_[static_cast<std::size_t>(top)].paint % paints == paint;
                }
            const Box area = label_box(where);
            if (area.width > 0)
                colour_in(layer_, where, area, hand_, hand_.paints[static_cast<std::size_t>(paint)], random_);
        }
    }

    void draw_part(std::size_t i) {
        const Part& part = parts_[i];
        const std::size_t n = part.outline.points.size();
        if (part.solid) {
            const bool all = std::all_of(part.outline.points.begin(), part.outline.points.end(),
                                         [&](Point2d p) { return visible(i, p); });
            if (all) fill_ink(layer_, part.outline.points, hand_, hand_.second_ink.value_or(hand_.ink));
        }
        if (part.kind == PartKind::region && !hand_.outlines) return;
        std::vector<char> shown(n);
        for (std::size_t k = 0; k < n; ++k)
            shown[k] = !part.outline.undrawn[k] && visible(i, part.outline.points[k]);
        const auto label =
            static_cast<std::uint8_t>(part.kind == PartKind::mark ? Label::background : part.label);
        for (const Path& run : runs(part.outline, shown))
            ink_line(layer_, run, hand_, line_colour(part), part.ink_width, random_, label);
    }

    // The drawn stretches of an outline; a whole one starts anywhere and may run over its start.
    std::vector<Path> runs(const Outline& outline, const std::vector<char>& shown) {
        const Path& points = outline.points;
        const std::size_t n = points.size();
        std::vector<Path> out;
        std::size_t start = 0;
        const bool whole = std::all_of(shown.begin(), shown.end(), [](char c) { return c; });
        if (outline.closed && whole) {
            start = static_cast<std::size_t>(random_.integer(0, static_cast<int>(n) - 1));
            Path loop;
            const double error =
                random_.uniform(-0.7, 1.0) * (hand_.overshoot + hand_.closure * static_cast<double>(n));
            const long extra = 1 + static_cast<long>(error);
            const std::size_t count =
                static_cast<std::size_t>(std::max<long>(2, static_cast<long>(n) + extra));
            for (std::size_t k = 0; k < count; ++k) loop.push_back(points[(start + k) % n]);
            return {loop};
        }
        if (outline.closed)
            while (start < n && shown[start]) ++start;
        Path run;
        const auto finish = [&] {
            if (path_length(run) > 2.5) out.push_back(run);
            run.clear();
        };
        for (std::size_t k = 0; k < n; ++k) {
            const std::size_t i = (start + k) % n;
            if (shown[i])
                run.push_back(points[i]);
            else
                finish();
        }
        finish();
        return out;
    }

    // A limb of which most is behind something else is not seen; its root, inside the body, often is not.
    void count_limbs(const Grid<int>& shown, const std::vector<long>& area) {
        constexpr double least = 0.2; // of its area
        std::vector<long> visible(parts_.size());
        for (const int part : shown)
            if (part >= 0) ++visible[static_cast<std::size_t>(part)];
        for (std::size_t i = 0; i < parts_.size(); ++i)
            layer_.limbs += parts_[i].label == Label::limb && parts_[i].kind != PartKind::mark &&
                            !parts_[i].continues && visible[i] > 0 &&
                            static_cast<double>(visible[i]) >= least * static_cast<double>(area[i]);
    }

    // Parts in painter's order over the ink's own labels.
    void label_parts() {
        Grid<int> shown(width_, height_, -1); // the part of a pixel
        std::vector<long> area(parts_.size());
        for (std::size_t i : order_) {
            const Part& part = parts_[i];
            if (part.kind == PartKind::mark) continue;
            const auto set = [&](int x, int y) {
                layer_.labels(x, y) = static_cast<std::uint8_t>(part.label);
                shown(x, y) = static_cast<int>(i);
            };
            if (part.kind == PartKind::region) {
                const Box& box = masks_[i].box;
                for (int y = 0; y < box.height; ++y)
                    for (int x = 0; x < box.width; ++x)
                        if (masks_[i].values(x, y)) set(box.x + x, box.y + y), ++area[i];
                continue;
            }
            const double radius = std::max(0.5 * part.thickness * hand_.pen * part.ink_width, 0.8);
            const Patch<float> band =
                cover_line(part.outline.points, std::vector<double>(part.outline.points.size(), radius),
                           width_, height_);
            for (int y = 0; y < band.box.height; ++y)
                for (int x = 0; x < band.box.width; ++x) {
                    const int px = band.box.x + x, py = band.box.y + y;
                    const int top = top_(px, py);
                    area[i] += band.values(x, y) >= 0.5f;
                    if (band.values(x, y) >= 0.5f && !(top >= 0 && hides(static_cast<std::size_t>(top), i)))
                        set(px, py);
                }
        }
        count_limbs(shown, area);
        complete_silhouette(layer_.labels, hand_.pen);
    }

    const Figure& figure_;
    const Hand& hand_;
    Random& random_;
    int width_, height_;
    Layer layer_;
    Grid<int> top_;
    std::vector<Part> parts_;
    std::vector<std::size_t> order_;
    std::vector<Patch<std::uint8_t>> masks_;
};

} // namespace

Layer draw_figure(const Figure& figure, const Hand& hand, Random& random, int width, int height) {
    return Draughtsman(figure, hand, random, width, height).draw();
}

} // namespace pantin::doodle
