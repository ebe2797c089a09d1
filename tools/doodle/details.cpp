// SPDX-License-Identifier: MIT
// Faces, hair, hats, patterns: what makes a scribbled shape somebody.
#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "doodle/figure.hpp"

namespace pantin::doodle {
namespace {

using math::pi;

Path arc(Point2d centre, double rx, double ry, double from, double to) {
    Path out;
    for (int i = 0; i <= 12; ++i) {
        const Point2d d = direction(from + (to - from) * i / 12);
        out.push_back({centre.x + rx * d.x, centre.y + ry * d.y});
    }
    return out;
}

Path in_frame(const Frame& frame, const Path& path) {
    Path out;
    for (Point2d p : path) out.push_back(frame.at(p.x, p.y));
    return out;
}

void add_mouth(Builder& b, int head, const Frame& f) {
    Random& random = b.random;
    const double y = random.uniform(0.3, 0.5), w = random.uniform(0.2, 0.5);
    const int kind = random.integer(0, 5);
    if (kind <= 2) { // a smile, now and then a sad one
        const bool sad = random.chance(0.12);
        const double h = random.uniform(0.1, 0.3);
        Path line =
            sad ? arc({0, y + h}, w, h, 1.1 * pi, 1.9 * pi) : arc({0, y - 0.05}, w, h, 0.05 * pi, 0.95 * pi);
        b.mark(head, in_frame(f, line));
    } else if (kind == 3) {
        b.mark(head, {f.at(-w, y), f.at(w, y + random.uniform(-0.1, 0.1))});
    } else if (kind == 4) { // laughing: a half moon
        Path line = arc({0, y - 0.08}, w, 0.3, 0, pi);
        b.mark(head, in_frame(f, line), true);
    } else {
        b.mark(head, in_frame(f, ellipse({0, y}, 0.3 * w, 0.4 * w)), true);
    }
}

void add_nose(Builder& b, int head, const Frame& f) {
    Random& random = b.random;
    const double s = random.uniform(0.08, 0.16);
    switch (random.integer(0, 4)) {
    case 0:
        b.spot(head, in_frame(f, ellipse({0, 0.12}, s, s)));
        break;
    case 1:
        b.mark(head, {f.at(0, -0.05), f.at(s, 0.2), f.at(-0.4 * s, 0.2)});
        break;
    case 2:
        b.mark(head, in_frame(f, arc({0, 0.1}, s, s, 0, pi)));
        break;
    case 3:
        b.mark(head, {f.at(0, -0.05), f.at(0, 0.2)});
        break;
    default:
        b.mark(head, in_frame(f, ellipse({0, 0.12}, s, s)), true);
        break;
    }
}

void add_spikes(Builder& b, const Frame& f) {
    Random& random = b.random;
    const int count = random.integer(4, 11);
    for (int i = 0; i < count; ++i) {
        const double a = -pi * (0.12 + 0.76 * (i + random.uniform(0.0, 0.6)) / count);
        const Point2d d = direction(a), e = direction(a + random.uniform(-0.2, 0.2));
        const double out = random.uniform(1.15, 1.35);
        b.stick(Label::head, {f.at(0.97 * d.x, 0.97 * d.y), f.at(out * e.x, out * e.y)}, 0, 1.0);
    }
}

void add_long_hair(Builder& b, int head, const Frame& f) {
    Random& random = b.random;
    const double l = random.uniform(0.9, 2.0), w = random.uniform(1.15, 1.5);
    Path p = {f.at(-0.2, -1.15),    f.at(-0.9 * w, -0.7),
              f.at(-w, 0.3),        f.at(-w * random.uniform(0.9, 1.2), l),
              f.at(-0.5, l * 0.95), f.at(0, 0.6),
              f.at(0.5, l * 0.95),  f.at(w * random.uniform(0.9, 1.2), l),
              f.at(w, 0.3),         f.at(0.9 * w, -0.7),
              f.at(0.2, -1.15)};
    b.part(b.region(Label::head, spline(p, true, 5), -3)).paint = 6;
    b.mark(head,
           spline({f.at(-0.95, -0.2), f.at(-0.3, -0.75), f.at(0, -0.9), f.at(0.3, -0.75), f.at(0.95, -0.2)},
                  false));
}

} // namespace

void add_eye(Builder& b, int head, Point2d c, double size) {
    if (b.random.chance(0.55 - 0.6 * b.manner.details)) return;
    switch (b.random.integer(0, 4)) {
    case 0: // a ring with a pupil
        b.mark(head, ellipse(c, size, 1.2 * size), true);
        b.spot(head, ellipse(c + Point2d{0.3 * size, 0.2 * size}, 0.4 * size, 0.45 * size));
        break;
    case 1:
        b.mark(head, ellipse(c, 0.8 * size, 0.9 * size), true);
        break;
    case 2:
        b.mark(head, {c - Point2d{0, 0.6 * size}, c + Point2d{0, 0.6 * size}});
        break;
    default:
        b.spot(head, ellipse(c, 0.45 * size, 0.55 * size));
        break;
    }
}

void add_frontal_face(Builder& b, int head, Frame f) {
    Random& random = b.random;
    if (random.chance(0.45 - 0.45 * b.manner.details)) return; // no face at all
    const double dx = random.uniform(0.28, 0.42), y = random.uniform(-0.3, -0.05);
    const double size = random.uniform(0.09, 0.18);
    const int kind = random.integer(0, 6);
    for (int side = -1; side <= 1; side += 2) {
        const double tilt = random.uniform(-0.03, 0.03);
        const Frame eye{f.at(side * dx, y + tilt), f.rx * size, f.ry * size, f.angle};
        if (kind <= 2) {
            b.spot(head, ellipse(eye.centre, 0.55 * eye.rx, 0.65 * eye.ry));
        } else if (kind == 3) {
            b.mark(head, ellipse(eye.centre, eye.rx, 1.2 * eye.ry), true);
            b.spot(head, ellipse(eye.at(0.2, 0.2), 0.4 * eye.rx, 0.45 * eye.ry));
        } else if (kind == 4) {
            b.mark(head, {eye.at(0, -0.8), eye.at(0, 0.8)});
        } else if (kind == 5) { // closed, smiling
            b.mark(head, in_frame(eye, arc({0, 0}, 1.1, 0.8, pi, 2 * pi)));
        } else {
            b.mark(head, {eye.at(-0.9, 0), eye.at(0.9, 0)});
        }
        if (random.chance(0.15)) b.mark(head, {eye.at(-1.1, -1.8), eye.at(1.1, -1.8 - 0.5 * side)});
    }
    if (random.chance(0.5)) add_nose(b, head, f);
    if (random.chance(0.9)) add_mouth(b, head, f);
    if (random.chance(0.12))
        for (int side = -1; side <= 1; side += 2)
            b.mark(head, in_frame(f, ellipse({0.6 * side, 0.25}, 0.15, 0.12)), true, 0.7);
}

void add_hair(Builder& b, int head, Frame f) {
    Random& random = b.random;
    const int kind = random.integer(0, 5);
    if (kind == 0) { // spikes
        add_spikes(b, f);
    } else if (kind == 1) { // long hair at both sides, behind the head
        add_long_hair(b, head, f);
    } else if (kind == 2) { // a scribbled mop
        Path p;
        const int n = random.integer(14, 30);
        for (int i = 0; i <= n; ++i) {
            const double a = -pi * (0.02 + 0.96 * i / n),
                         r = i % 2 ? random.uniform(1.02, 1.2) : random.uniform(0.75, 0.92);
            p.push_back(f.at(r * direction(a).x, r * direction(a).y));
        }
        b.stick(Label::head, random.chance(0.5) ? spline(p, false, 4) : p, 2, 1.0);
    } else if (kind == 3) { // two pigtails
        for (int side = -1; side <= 1; side += 2) {
            const double l = random.uniform(0.7, 1.3);
            const Path line = {f.at(0.8 * side, -0.5), f.at(1.3 * side, -0.6), f.at(1.5 * side, -0.6 + l)};
            const double r = 0.22 * f.rx;
            b.part(b.limb(Label::head, line, {0.3 * r, r, 0.3 * r}, -2, {})).paint = 6;
        }
    } else if (kind == 4) { // a bun or a ponytail
        const double side = random.pick(std::vector<double>{-0.6, 0.0, 0.6});
        b.part(b.region(Label::head, ellipse(f.at(side, -1.15), 0.35 * f.rx, 0.3 * f.ry), -2)).paint = 6;
        b.mark(head,
               spline({f.at(-0.97, -0.1), f.at(-0.4, -0.6), f.at(0.4, -0.65), f.at(0.97, -0.1)}, false));
    } else { // a fringe
        const int count = random.integer(4, 9);
        Path p;
        for (int i = 0; i <= count; ++i) {
            const double x = -0.9 + 1.8 * i / count;
            p.push_back(f.at(x, -std::sqrt(1 - x * x) * 0.95));
            if (i < count)
                p.push_back(f.at(x + 0.9 / count, -0.35 - 0.2 * (1 - x * x) + random.uniform(-0.1, 0.1)));
        }
        b.mark(head, p);
    }
}

void add_hat(Builder& b, int head, Frame f) {
    Random& random = b.random;
    const double y = random.uniform(-0.85, -0.6), w = random.uniform(0.7, 0.95);
    int hat = 0;
    switch (random.integer(0, 3)) {
    case 0: { // top hat
        const double h = random.uniform(0.7, 1.3), brim = w + random.uniform(0.3, 0.6);
        hat =
            b.region(Label::head,
                     {f.at(-w * 0.8, y), f.at(-w * 0.75, y - h), f.at(w * 0.8, y - h), f.at(w * 0.8, y)}, 3);
        const int line =
            b.stick(Label::head, {f.at(-brim, y), f.at(brim, y + random.uniform(-0.1, 0.1))}, 3, 1.2);
        b.merge(line, hat);
        break;
    }
    case 1: { // party or witch's hat
        const double lean = random.uniform(-0.3, 0.3), height = random.uniform(0.9, 1.6);
        hat = b.region(Label::head, {f.at(-w, y), f.at(lean, y - height), f.at(w, y)}, 3);
        if (random.chance(0.5))
            b.region(Label::head, ellipse(f.at(0, y), (w + 0.4) * f.rx, 0.16 * f.ry, f.angle), 4);
        break;
    }
    case 2: { // cap with a peak
        hat = b.region(Label::head, in_frame(f, arc({0, y + 0.1}, w + 0.15, 0.75, pi, 2 * pi)), 3);
        const double side = random.chance(0.5) ? 1 : -1;
        b.region(Label::head, in_frame(f, ellipse({side * (w + 0.25), y + 0.08}, 0.45, 0.1)), 3.5);
        break;
    }
    default: // crown
        hat = b.region(Label::head,
                       {f.at(-w, y), f.at(-w * 1.1, y - 0.8), f.at(-w * 0.5, y - 0.4), f.at(0, y - 0.9),
                        f.at(w * 0.5, y - 0.4), f.at(w * 1.1, y - 0.8), f.at(w, y)},
                       3);
        break;
    }
    b.part(hat).paint = 7;
    (void)head;
}

void add_pattern(Builder& b, int region, Frame f, const std::string& wanted) {
    Random& random = b.random;
    const std::vector<std::string> kinds = {"stripes", "spots", "hatching", "patches"};
    const std::string kind = wanted.empty() ? random.pick(kinds) : wanted;
    if (kind == "stripes") {
        const int count = random.integer(3, 9);
        const double lean = random.uniform(-0.3, 0.3),
                     reach = random.chance(0.5) ? 1.2 : random.uniform(-0.3, 0.4);
        for (int i = 0; i < count; ++i) {
            const double u = -0.9 + 1.8 * (i + 0.5) / count + random.uniform(-0.05, 0.05);
            b.mark(region, spline({f.at(u, -1.3), f.at(u + lean * 0.5 + random.uniform(-0.08, 0.08), -0.2),
                                   f.at(u + lean, reach)},
                                  false));
        }
    } else if (kind == "spots" || kind == "patches") {
        const bool patches = kind == "patches";
        const int count = patches ? random.integer(2, 4) : random.integer(4, 14);
        for (int i = 0; i < count; ++i) {
            const double u = random.uniform(-0.8, 0.8), v = random.uniform(-0.8, 0.8);
            const double r = patches ? random.uniform(0.2, 0.4) : random.uniform(0.06, 0.14);
            const double stretch = random.uniform(0.8, 1.6), turn = random.uniform(0.0, 3.0);
            const Path spot = ellipse(f.at(u, v), stretch * r * f.ry, r * f.ry, turn);
            if (random.chance(patches ? 0.3 : 0.4))
                b.spot(region, spot);
            else
                b.mark(region, spot, true);
        }
    } else {
        const int count = random.integer(5, 16);
        const double u0 = random.uniform(-0.9, 0.0), u1 = random.uniform(0.2, 0.9);
        Path zigzag;
        for (int i = 0; i < count; ++i) {
            const double u = u0 + (u1 - u0) * i / count;
            zigzag.push_back(f.at(u + 0.15, random.uniform(-0.9, -0.5)));
            zigzag.push_back(f.at(u, random.uniform(0.3, 0.8)));
        }
        b.mark(region, zigzag, false, 0.8);
    }
}

Path curl(Point2d start, double angle, double size, double turns, double tightness) {
    Path out = {start};
    const int n = 40;
    double heading = angle;
    Point2d p = start;
    for (int i = 0; i < n; ++i) {
        const double t = static_cast<double>(i) / n;
        heading += 2 * pi * turns / n * (1.0 + tightness * t);
        p = p + (size / n) * direction(heading);
        out.push_back(p);
    }
    return out;
}

Path fluffy(Random& random, Frame f, int bumps) {
    Path out;
    for (int i = 0; i < bumps; ++i) {
        const double a = 2 * pi * (i + random.uniform(-0.2, 0.2)) / bumps, b = 2 * pi * (i + 1) / bumps;
        const Point2d p = direction(a), q = direction(b), m = direction((a + b) / 2);
        const double depth = random.uniform(1.12, 1.3);
        const Point2d left = f.at(p.x, p.y), right = f.at(q.x, q.y), top = f.at(depth * m.x, depth * m.y);
        for (int k = 0; k < 6; ++k) {
            const double t = k / 6.0;
            out.push_back(mix(left, right, t) + (4 * t * (1 - t)) * (top - mix(left, right, 0.5)));
        }
    }
    return out;
}

} // namespace pantin::doodle
