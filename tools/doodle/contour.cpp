// SPDX-License-Identifier: MIT
// Contours; legs and folded wings of few strokes.
#include "doodle/contour.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"

namespace pantin::doodle {

using math::pi;

Contour& Contour::through(Path controls) {
    if (!points.empty()) {
        controls.insert(controls.begin(), points.back());
        points.pop_back();
    }
    const Path smooth = spline(controls, false, 6);
    points.insert(points.end(), smooth.begin(), smooth.end());
    return *this;
}

Path beyond(Point2d at, Point2d along, double half_width, double length) {
    const Point2d a = unit(along), side{-a.y, a.x};
    return {at - half_width * side, at - half_width * side + length * a, at + half_width * side + length * a,
            at + half_width * side};
}

Path outside(const Path& path, Point2d c, double r) {
    Path out;
    for (Point2d p : path)
        if (distance(p, c) >= r) out.push_back(p);
    return out;
}

void add_toes(Builder& b, Point2d foot, double size, double heading) {
    Random& r = b.random;
    switch (r.integer(0, 5)) {
    case 0:
        return;
    case 1: // one line
        b.continued(b.stick(
            Label::limb,
            {foot - (r.uniform(0.0, 0.6) * size) * direction(heading), foot + size * direction(heading)}, -1,
            2.0));
        return;
    case 2: // a webbed foot
        b.continued(b.region(
            Label::limb,
            {foot, foot + size * direction(heading - 0.25), foot + (0.9 * size) * direction(heading + 0.5)},
            -0.9));
        return;
    default: {
        const double fan = r.uniform(0.45, 0.8),
                     turn = r.chance(0.4) ? 0.5 * pi - heading : r.uniform(0.0, 0.5);
        for (int k = -1; k <= 1; ++k)
            b.continued(b.stick(Label::limb,
                                {foot, foot + b.jitter(size, 0.2) * direction(heading + turn + fan * k)}, -1,
                                2.0));
        if (r.chance(0.3))
            b.continued(b.stick(Label::limb, {foot, foot - (0.6 * size) * direction(heading)}, -1, 2.0));
    }
    }
}

void add_line_leg(Builder& b, int trunk, Point2d hip, Point2d foot, double heading, int manner) {
    Random& r = b.random;
    const double l = distance(hip, foot), size = std::min(l * r.uniform(0.3, 0.6), 7.0);
    if (manner <= 1) {
        const double share = r.uniform(0.35, 0.6), bent = r.uniform(-0.15, 0.15) * l;
        const Point2d knee = mix(hip, foot, share) + Point2d{bent, 0};
        b.stick(Label::limb, manner == 0 ? Path{hip, foot} : Path{hip, knee, foot}, -1);
        add_toes(b, foot, size, heading);
    } else if (manner == 2) { // two lines
        const double w = std::max(0.8, l * r.uniform(0.06, 0.14));
        const bool open = r.chance(0.3);
        const double thigh = w * r.uniform(1.0, 2.0);
        const Cap end = r.chance(0.5) ? Cap::flat : Cap::round;
        b.attach(b.limb(Label::limb, {hip, foot}, {thigh, w}, -1, {Cap::flat, end, true, open}), trunk);
        if (r.chance(0.7)) add_toes(b, foot, size, heading);
    } else { // a V or a loop
        const double w = std::clamp(l * r.uniform(0.12, 0.3), 1.5, 3.5);
        Outline leg{{hip - Point2d{w, 0}, foot - Point2d{0.2 * w, 0}, foot + Point2d{0.2 * w, 0},
                     hip + Point2d{w, 0}},
                    {0, 0, 0, 1},
                    true};
        b.region(Label::limb, leg, -1);
        if (r.chance(0.4)) add_toes(b, foot, size, heading);
    }
}

namespace {

// What is drawn of a closed outline: the stretch of points [from, to) only.
void leave_out(Builder& b, int index, double from, double to) {
    Part& part = b.part(index);
    const double n = static_cast<double>(part.outline.points.size());
    for (std::size_t i = 0; i < part.outline.points.size(); ++i) {
        const double t = static_cast<double>(i) / n;
        if (t >= from && t < to) part.outline.undrawn[i] = 1;
    }
}

} // namespace

void add_folded_wing(Builder& b, Frame f, double depth) {
    Random& r = b.random;
    const double tip = r.uniform(-1.15, -0.75), tip_y = r.uniform(-0.2, 0.5), top = r.uniform(-0.75, -0.2),
                 low = r.uniform(0.3, 0.9), front = r.uniform(0.3, 1.0);
    const Path drop = spline({f.at(tip, tip_y), f.at(-0.45, 0.55 * top + 0.3 * tip_y), f.at(0.15, top),
                              f.at(0.75 * front, 0.8 * top), f.at(front, 0.1), f.at(0.6 * front, 0.8 * low),
                              f.at(0.0, low), f.at(-0.5, 0.7 * low + 0.2 * tip_y)},
                             true, 6);
    const int kind = r.integer(0, 9);
    if (kind == 8) { // a V or triangle
        const int wing =
            b.region(Label::wing, {f.at(front, top), f.at(tip, tip_y), f.at(0.3 * front, low)}, depth);
        if (r.chance(0.5)) leave_out(b, wing, 0.62, 1.1);
        return;
    }
    if (kind == 9) { // scalloped below
        Path p = {f.at(tip, tip_y)};
        const int n = r.integer(2, 4);
        for (int i = 0; i < n; ++i)
            for (int k = 1; k <= 5; ++k) {
                const double t = k / 5.0, u = (i + t) / n;
                p.push_back(f.at(tip + (front - tip) * u, tip_y * (1 - u) + low * 4 * t * (1 - t) * 0.8));
            }
        const std::size_t drawn = p.size();
        const Path back = spline({p.back(), f.at(0.3, top), f.at(-0.4, 0.7 * top), p.front()}, false, 6);
        p.insert(p.end(), back.begin() + 1, back.end() - 1);
        const int wing = b.region(Label::wing, p, depth);
        if (r.chance(0.6)) leave_out(b, wing, static_cast<double>(drawn - 1) / p.size(), 1.1);
        return;
    }
    const int wing = b.region(Label::wing, drop, depth);
    // The tip is point 0; upwards and to the front first, then back along the lower edge.
    if (kind >= 3 && kind <= 4) leave_out(b, wing, 0.0, r.uniform(0.3, 0.55)); // a U, open above
    if (kind == 5) leave_out(b, wing, 0.4, 0.65);                              // open in front
    if (kind == 6) leave_out(b, wing, r.uniform(0.8, 0.9), 1.1);
    if (kind == 7) { // filled with scribble
        Path zigzag;
        for (int i = 0, n = r.integer(8, 30); i <= n; ++i) {
            const double u = tip * 0.85 + (0.9 * front - tip * 0.85) * i / n;
            zigzag.push_back(f.at(u, i % 2 ? 0.7 * top : 0.75 * low));
        }
        b.mark(wing, zigzag);
        if (r.chance(0.5)) leave_out(b, wing, 0.0, 1.1);
    }
    if (r.chance(0.25)) // feathers
        for (int i = 0, n = r.integer(2, 5); i < n; ++i) {
            const double u = -0.7 + 1.2 * i / n;
            b.mark(wing, {f.at(u + 0.15, 0.3 * top), f.at(u - 0.1, 0.8 * low)}, false, 0.9);
        }
}

} // namespace pantin::doodle
