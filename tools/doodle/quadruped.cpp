// SPDX-License-Identifier: MIT
// Four-legged animals from the side (facing right) or half from the front. Units: the trunk is about 60 long,
// its middle the origin, y down.
#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "doodle/figure.hpp"

namespace pantin::doodle {
namespace {

using math::pi;

enum class HeadKind { round, snout, length }; // a ball; a ball with a muzzle; a long skull
enum class EarKind { none, pointed, round, floppy, tall, big };
enum class TailKind { thin, tuft, curly, bushy, thick, stub, strands };

struct Animal {
    double rx, ry; // half axes of the trunk
    double leg, leg_radius;
    double neck, neck_angle, neck_radius; // angle above the horizontal
    double head, head_height;
    HeadKind head_kind;
    EarKind ears;
    TailKind tail;
    double tail_length;
};

struct Kind {
    const char* name;
    Animal animal;
};

const std::vector<Kind>& kinds() {
    using H = HeadKind;
    using E = EarKind;
    using T = TailKind;
    static const std::vector<Kind> table = {
        {"dog", {30, 11, 22, 3.2, 9, 0.8, 5, 9, 8, H::snout, E::floppy, T::thin, 20}},
        {"cat", {28, 11, 18, 3.0, 4, 0.7, 5, 11, 10, H::round, E::pointed, T::thin, 34}},
        {"horse", {30, 11, 32, 3.0, 21, 0.9, 6, 17, 6, H::length, E::pointed, T::strands, 28}},
        {"zebra", {30, 11, 30, 3.0, 19, 0.9, 6, 16, 6, H::length, E::pointed, T::tuft, 24}},
        {"cow", {32, 14, 20, 3.2, 7, 0.45, 6.5, 14, 7, H::length, E::floppy, T::tuft, 26}},
        {"pig", {28, 15, 12, 3.2, 0, 0.3, 6, 12, 10, H::snout, E::pointed, T::curly, 18}},
        {"giraffe", {22, 10, 36, 2.6, 44, 1.25, 4, 12, 5, H::length, E::pointed, T::tuft, 18}},
        {"elephant", {30, 18, 18, 5.5, 0, 0.5, 8, 13, 13, H::round, E::big, T::thin, 16}},
        {"sheep", {28, 15, 14, 2.2, 2, 0.5, 5, 9, 7, H::length, E::floppy, T::stub, 5}},
        {"lion", {30, 11, 20, 3.4, 2, 0.7, 5, 10, 10, H::round, E::round, T::tuft, 30}},
        {"tiger", {31, 11, 18, 3.4, 4, 0.5, 6, 10, 9, H::round, E::round, T::thin, 32}},
        {"rabbit", {20, 12, 9, 3.0, 3, 0.9, 5, 10, 9, H::round, E::tall, T::stub, 6}},
        {"mouse", {24, 12, 8, 2.0, 0, 0.2, 5, 10, 8, H::snout, E::round, T::thin, 36}},
        {"fox", {28, 9, 19, 2.6, 6, 0.8, 4, 9, 7, H::snout, E::pointed, T::bushy, 32}},
        {"lizard", {30, 7, 9, 2.4, 2, 0.1, 6, 13, 6, H::length, E::none, T::thick, 45}},
        {"dinosaur", {28, 14, 16, 4.5, 36, 1.0, 5, 9, 6, H::length, E::none, T::thick, 45}},
        {"camel", {29, 11, 28, 2.8, 24, 0.8, 4.5, 11, 6, H::length, E::round, T::tuft, 18}},
        {"goat", {28, 11, 21, 2.6, 10, 0.8, 5, 12, 6, H::length, E::floppy, T::stub, 7}},
    };
    return table;
}

Animal vary(Builder& b, Animal a) {
    Random& r = b.random;
    for (double* value : {&a.rx, &a.ry, &a.leg, &a.leg_radius, &a.neck, &a.neck_radius, &a.head,
                          &a.head_height, &a.tail_length})
        *value = b.jitter(*value, 0.25);
    a.neck_angle += r.uniform(-0.25, 0.25);
    if (r.chance(0.15)) a.head *= 1.35, a.head_height *= 1.35; // a child's big head
    if (r.chance(0.12))
        a.ears = r.pick(std::vector<EarKind>{EarKind::pointed, EarKind::round, EarKind::floppy});
    if (r.chance(0.15))
        a.tail =
            r.pick(std::vector<TailKind>{TailKind::thin, TailKind::tuft, TailKind::bushy, TailKind::thick});
    return a;
}

int add_trunk(Builder& b, const Animal& a, const std::string& species) {
    Random& r = b.random;
    const double x = a.rx, y = a.ry;
    if (species == "sheep" && r.chance(0.8)) {
        const int bumps = r.integer(9, 15);
        return b.region(Label::body, fluffy(r, {{0, 0}, 0.95 * x, 0.9 * y, 0}, bumps), 0);
    }
    const double sag = r.uniform(-0.1, 0.15) * y, belly = r.uniform(0.8, 1.1) * y,
                 hump = species == "camel" ? -0.9 * y : 0;
    switch (r.integer(0, 4)) {
    case 0:
        return b.region(Label::body, ellipse({0, 0}, x, y, r.uniform(-0.08, 0.08)), 0);
    case 1: {
        const double exponent = r.uniform(2.6, 6.0);
        return b.region(Label::body, ellipse({0, 0}, x, 0.9 * y, r.uniform(-0.06, 0.06), exponent), 0);
    }
    default:
        return b.region(Label::body,
                        spline({{-x, -0.1 * y},
                                {-0.85 * x, -0.8 * y},
                                {-0.4 * x, -0.9 * y + sag},
                                {0, -0.85 * y + sag + hump},
                                {0.45 * x, -0.9 * y + sag},
                                {0.85 * x, -0.85 * y},
                                {x, -0.1 * y},
                                {0.9 * x, 0.7 * y},
                                {0.45 * x, belly},
                                {-0.3 * x, 0.95 * belly},
                                {-0.88 * x, 0.75 * y}},
                               true, 6),
                        0);
    }
}

// The knees of one leg from hip to toe; `hind` legs of slender animals bend backwards.
Path leg_line(Builder& b, const Animal& a, Point2d hip, double stride, bool hind) {
    Random& r = b.random;
    const double foot_y = a.ry * 0.9 + a.leg, mid = 0.5 * (hip.y + foot_y);
    const double bend = r.chance(0.4) ? (hind ? -1 : 1) * r.uniform(0.0, 0.14) * a.leg : 0.0;
    return {
        hip, {hip.x + 0.5 * stride + bend, mid}, {hip.x + stride, foot_y + r.uniform(-0.05, 0.05) * a.leg}};
}

void add_hoof(Builder& b, int leg, Point2d toe, double radius, bool stick, double depth) {
    Random& r = b.random;
    if (stick) {
        if (r.chance(0.3))
            b.merge(b.continued(b.stick(Label::limb, {toe, toe + Point2d{r.uniform(2.0, 4.5), 0}}, depth)),
                    leg);
        return;
    }
    const int kind = r.integer(0, 5);
    if (kind == 0) { // a paw
        const int paw = b.continued(b.region(
            Label::limb, ellipse(toe + Point2d{0.5 * radius, 0}, 1.5 * radius, 0.8 * radius), depth + 0.1));
        if (r.chance(0.7)) b.merge(paw, leg);
    } else if (kind == 1) { // toes
        for (int i = -1; i <= 1; ++i)
            b.mark(leg,
                   {toe + Point2d{0.6 * i * radius, -0.7 * radius}, toe + Point2d{0.6 * i * radius, radius}});
    } else if (kind == 2) { // a hoof's edge
        b.mark(leg, {toe + Point2d{-2 * radius, -radius}, toe + Point2d{2 * radius, -radius}});
    }
}

void add_leg(Builder& b, const Animal& a, int trunk, Point2d hip, double stride, bool hind, bool stick,
             double depth) {
    Random& r = b.random;
    const Path line = leg_line(b, a, hip, stride, hind);
    if (stick) {
        const Path visible{{hip.x, hip.y}, line[1], line[2]};
        const int leg =
            b.stick(Label::limb, r.chance(0.5) ? Path{line[0], line[2]} : visible, depth < 0 ? depth : -1.0);
        add_hoof(b, leg, line[2], 0, true, depth);
        return;
    }
    const double radius = b.jitter(a.leg_radius, 0.12), thigh = radius * r.uniform(1.0, hind ? 2.0 : 1.5);
    const bool open = r.chance(b.manner.open_feet), seam = !r.chance(0.3);
    const Cap foot = r.chance(0.5) ? Cap::flat : Cap::round;
    const int leg = b.limb(Label::limb, line, {thigh, radius, radius * r.uniform(0.8, 1.15)}, depth,
                           {Cap::round, foot, seam, open});
    b.attach(leg, trunk);
    if (!open) add_hoof(b, leg, line[2], radius, false, depth);
}

void add_legs(Builder& b, const Animal& a, int trunk) {
    Random& r = b.random;
    const bool stick = r.chance(0.75 * b.manner.stick_limbs);
    const int layout = r.integer(0, 5); // 0, 1: four in a row; 2, 3, 4: a far pair behind; 5: two legs only
    const double lift = stick ? 0.55 : r.uniform(0.1, 0.5), near_depth = r.chance(0.6) ? -0.5 : 1.0;
    const double x0 = r.uniform(0.6, 0.82) * a.rx, far = r.uniform(0.22, 0.42) * a.rx;
    const bool walking = r.chance(0.35);
    const auto stride = [&] {
        return walking ? r.uniform(-0.4, 0.4) * a.leg : r.uniform(-0.08, 0.08) * a.leg;
    };
    for (int end = -1; end <= 1; end += 2) {
        const bool hind = end < 0;
        const double outer = end * x0, inner = layout <= 1 ? end * (x0 - 2 * far * r.uniform(0.5, 0.9))
                                                           : outer + (r.chance(0.7) ? -end : end) * far * 0.6;
        const double curve = std::sqrt(std::max(0.05, 1.0 - (outer / a.rx) * (outer / a.rx)));
        const double hip = lift * a.ry * (0.4 + 0.6 * curve);
        if (layout != 5) {
            const double step = stride();
            add_leg(b, a, trunk, {inner, hip}, step, hind, stick, layout <= 1 ? near_depth : -2.0);
        }
        const double step = stride();
        add_leg(b, a, trunk, {outer, hip}, step, hind, stick, near_depth);
    }
}

struct EarPlace {
    Point2d root, up; // where it grows and to where
    double size, way, depth;
};

int add_ear(Builder& b, EarKind kind, const EarPlace& e) {
    Random& r = b.random;
    const double size = e.size;
    switch (kind) {
    case EarKind::pointed: {
        const double w = r.uniform(0.25, 0.45) * size, l = r.uniform(0.6, 1.0) * size;
        const Point2d across{-e.up.y, e.up.x}, base = e.root - (0.2 * size) * e.up;
        return b.region(Label::head, {base - w * across, e.root + l * e.up, base + w * across}, e.depth);
    }
    case EarKind::floppy: {
        const double l = r.uniform(0.7, 1.2) * size;
        const Path line{e.root, e.root + Point2d{0.5 * e.way * l, -0.1 * l},
                        e.root + Point2d{0.6 * e.way * l, 0.7 * l}};
        return b.limb(Label::head, line, {0.12 * size, 0.26 * size, 0.12 * size}, e.depth);
    }
    case EarKind::tall: {
        const double l = r.uniform(1.3, 2.2) * size, w = r.uniform(0.16, 0.26) * size;
        const Path line{e.root, e.root + (0.5 * l) * e.up, e.root + l * e.up};
        return b.limb(Label::head, line, {w, 1.2 * w, 0.6 * w}, e.depth);
    }
    case EarKind::big: {
        const double w = r.uniform(0.6, 0.9) * size;
        return b.region(Label::head, ellipse(e.root, 0.75 * w, w), e.depth);
    }
    default: {
        const double w = r.uniform(0.3, 0.5) * size;
        return b.region(Label::head, ellipse(e.root + (0.3 * w) * e.up, w, w), e.depth);
    }
    }
}

void add_ear_pair(Builder& b, int head, Frame f, EarKind kind, bool profile) {
    Random& r = b.random;
    if (kind == EarKind::none) return;
    for (int s = profile && r.chance(0.4) ? 1 : -1; s <= 1; s += 2) {
        const double u = profile ? -0.35 + 0.25 * s : 0.65 * s;
        const double lean = profile ? r.uniform(-0.3, 0.1) : 0.45 * s;
        EarPlace place{f.at(u, profile ? -0.75 : -0.65), rotated({0, -1}, lean + f.angle),
                       std::min(f.rx, f.ry), profile ? -1.0 : s, r.chance(0.5) ? 1.2 : 0.7};
        if (kind == EarKind::big) { // an elephant's, at the side of the head
            place.root = profile ? f.at(-0.6, 0.0) : f.at(1.2 * s, 0);
            place.depth = profile ? 1.5 : 0.7;
            if (profile) s = 1;
        }
        b.attach(add_ear(b, kind, place), head);
    }
}

void add_horns(Builder& b, const Frame& f, const std::string& species) {
    Random& r = b.random;
    for (int s = -1; s <= 1; s += 2) {
        const Point2d root = f.at(-0.2 + 0.4 * s, -0.8);
        const double l = (species == "giraffe" ? 0.8 : r.uniform(0.9, 1.6)) * f.ry;
        const Point2d tip = root + Point2d{0.3 * s * l, -l};
        const double depth = s < 0 ? 0.6 : 1.3;
        if (species == "giraffe") {
            b.stick(Label::head, {root, tip}, depth, 1.2);
            b.region(Label::head, ellipse(tip, 1.0, 1.0), depth);
        } else {
            b.limb(Label::head, {root, root + Point2d{0.5 * s * l, -0.4 * l}, tip},
                   {0.2 * f.ry, 0.16 * f.ry, 0.05 * f.ry}, depth, {Cap::flat, Cap::pointed, true, false});
        }
    }
}

// A head from the front on a body from the side, as children draw cats, lions and pigs.
int add_facing_head(Builder& b, const Animal& a, Point2d c, const std::string& species) {
    Random& r = b.random;
    const double rx = std::max(a.head, 9.0) * r.uniform(0.9, 1.2), ry = rx * r.uniform(0.8, 1.05);
    if (species == "lion") {
        const int bumps = r.integer(9, 18);
        const double size = r.uniform(1.3, 1.7);
        b.region(Label::head, fluffy(r, {c, size * rx, size * ry, 0}, bumps), 0.5);
    }
    const int head = b.region(Label::head, ellipse(c, rx, ry), 1);
    const Frame frame{c, rx, ry, r.uniform(-0.1, 0.1)};
    if (species != "sheep") add_frontal_face(b, head, frame);
    add_ear_pair(b, head, frame, a.ears == EarKind::none ? EarKind::pointed : a.ears, false);
    if (species == "pig") {
        b.mark(head, ellipse(frame.at(0, 0.25), 0.35 * rx, 0.25 * ry), true);
    } else if (species == "cat" || species == "tiger" || species == "mouse") {
        for (int s = -1; s <= 1 && r.chance(0.8); s += 2)
            for (int i = -1; i <= 1; ++i)
                b.stick(Label::head, {frame.at(0.3 * s, 0.3), frame.at(1.25 * s, 0.3 + 0.2 * i)}, 1.1, 1.0);
    }
    if (species == "cow" || species == "goat") add_horns(b, frame, species);
    if (species == "elephant") {
        const double l = ry * r.uniform(1.4, 2.2), w = 0.25 * rx;
        b.attach(b.limb(Label::head,
                        {frame.at(0, 0.2), c + Point2d{0.1 * rx, 0.8 * l}, c + Point2d{0.5 * rx, l}},
                        {w, w, 0.7 * w}, 1.4),
                 head);
    }
    return head;
}

// A muzzle or trunk that flows into the skull.
void add_muzzle(Builder& b, const Animal& a, int head, const Frame& f, const std::string& species) {
    Random& r = b.random;
    if (species == "elephant") {
        const double l = a.ry + a.leg * r.uniform(0.3, 0.9), w = 0.3 * f.ry;
        const Point2d root = f.at(0.6, 0.1), tip = root + Point2d{r.uniform(0.2, 0.9) * f.rx, l};
        b.merge(b.limb(Label::head, {root, root + Point2d{0.6 * f.rx, 0.35 * l}, tip}, {1.3 * w, w, 0.7 * w},
                       1.1),
                head);
        if (r.chance(0.5))
            b.limb(Label::head, {f.at(0.5, 0.5), f.at(1.1, 0.9), f.at(1.5, 0.6)}, {1.4, 1.1, 0.4}, 1.3);
        return;
    }
    const double l = (species == "pig" ? 0.5 : r.uniform(0.7, 1.1)) * f.rx, w = f.ry * r.uniform(0.38, 0.55);
    const Point2d root = f.at(0.4, 0.3),
                  tip = f.at(0.95, 0.35) + l * direction(f.angle + r.uniform(-0.05, 0.2));
    const Cap end = r.chance(0.6) ? Cap::round : Cap::flat;
    const int muzzle = b.limb(Label::head, {root, tip}, {1.15 * w, w * r.uniform(0.7, 1.0)}, 1,
                              {Cap::flat, end, true, false});
    b.merge(muzzle, head);
    const Point2d nose = tip + Point2d{0.5 * w, -0.5 * w};
    if (species == "pig") {
        b.region(Label::head, ellipse(tip, 0.35 * w, 0.95 * w), 1.1);
    } else if (r.chance(0.5)) {
        b.spot(muzzle, ellipse(nose - Point2d{0.3 * w, 0}, 0.35 * w, 0.3 * w));
    }
    if (r.chance(0.6))
        b.mark(muzzle, {tip + Point2d{w, 0.25 * w}, mix(tip, root, 0.8) + Point2d{0, 0.45 * w}});
}

int add_profile_head(Builder& b, const Animal& a, Point2d c, const std::string& species) {
    Random& r = b.random;
    const double droop = a.head_kind == HeadKind::length ? r.uniform(0.0, 0.7) : r.uniform(-0.1, 0.3);
    if (a.head_kind == HeadKind::length) {
        const Point2d along = direction(droop), tip = c + (0.75 * a.head) * along,
                      poll = c - (0.4 * a.head) * along;
        const double h = a.head_height;
        const int head =
            b.limb(Label::head, {poll, c, tip}, {0.8 * h, h, 0.6 * h * r.uniform(0.8, 1.2)}, 1, {});
        const Frame f{c - (0.15 * a.head) * along, 0.5 * a.head, h, droop};
        add_eye(b, head, f.at(0.1, -0.35), 0.25 * h);
        if (r.chance(0.5)) b.spot(head, ellipse(tip + Point2d{0.2 * h, -0.2 * h}, 0.09 * h, 0.09 * h));
        if (r.chance(0.6))
            b.mark(head,
                   {tip + (0.7 * h) * along + Point2d{0, 0.2 * h}, mix(tip, c, 0.6) + Point2d{0, 0.4 * h}});
        add_ear_pair(b, head, f, a.ears, true);
        if (species == "cow" || species == "goat" || species == "giraffe") add_horns(b, f, species);
        return head;
    }
    const Frame f{c, a.head, a.head_height, droop};
    const int head = b.region(Label::head, ellipse(c, f.rx, f.ry, droop), 1);
    if (a.head_kind == HeadKind::snout || species == "elephant" || r.chance(0.6))
        add_muzzle(b, a, head, f, species);
    add_eye(b, head, f.at(r.uniform(0.1, 0.45), -0.25), 0.18 * f.ry);
    add_ear_pair(b, head, f, a.ears, true);
    return head;
}

void add_mane(Builder& b, Point2d from, Point2d to, double size) {
    Random& r = b.random;
    Path line;
    const int n = r.integer(6, 12);
    const Point2d along = unit(to - from), back{along.y, -along.x};
    for (int i = 0; i <= n; ++i) {
        const Point2d p = mix(from, to, static_cast<double>(i) / n);
        line.push_back(p + (i % 2 ? size : 0.1 * size) * back);
    }
    b.stick(Label::body, line, -0.2, 1.2);
}

int add_neck_and_head(Builder& b, const Animal& a, int trunk, const std::string& species) {
    Random& r = b.random;
    const Point2d base{0.74 * a.rx, -0.35 * a.ry};
    const Point2d along = direction(-a.neck_angle);
    const bool facing = a.head_kind == HeadKind::round ? r.chance(0.55) : r.chance(0.12);
    const double reach = a.neck + (a.neck > 3 ? 0.0 : 0.32 * a.rx);
    const Point2d end = base + reach * along;
    const Point2d c = end + (a.head_kind == HeadKind::length && !facing ? 0.3 : 0.45) * a.head *
                                direction(-0.3 * a.neck_angle);
    const int head = facing ? add_facing_head(b, a, c, species) : add_profile_head(b, a, c, species);
    if (a.neck > 3) {
        const bool thin = r.chance(0.35 * b.manner.stick_limbs) && a.neck > 12;
        if (thin) {
            b.stick(Label::body, {{0.8 * a.rx, -0.6 * a.ry}, end}, 0.1);
            return head;
        }
        const double w = a.neck_radius;
        const Point2d middle =
            mix(base, end, 0.5) + r.uniform(-0.08, 0.08) * a.neck * Point2d{along.y, -along.x};
        const int neck = b.limb(Label::body, {base, middle, end}, {1.5 * w, w, 0.85 * w}, 0,
                                {Cap::round, Cap::round, true, true});
        if (r.chance(0.85))
            b.merge(neck, trunk);
        else
            b.attach(neck, trunk);
        if (r.chance(0.5)) b.merge(neck, head);
        const bool maned = species == "horse" || species == "zebra";
        if (maned && r.chance(0.6))
            add_mane(b, base + Point2d{0, -1.2 * w}, end + (0.8 * w) * Point2d{along.y, -along.x},
                     r.uniform(2.0, 5.0));
    } else {
        b.attach(head, trunk);
    }
    return head;
}

// A pointed brush or three hairs at the end of a tail.
void add_tuft(Builder& b, const Path& line, double depth) {
    Random& r = b.random;
    const Point2d tip = line[2], along = unit(line[2] - line[1]);
    const double s = r.uniform(2.0, 3.5);
    if (r.chance(0.5))
        b.limb(Label::tail, {tip, tip + s * along, tip + (2 * s) * along}, {0.3, 0.6 * s, 0.1}, depth + 0.1,
               {Cap::flat, Cap::pointed});
    else
        for (int i = -1; i <= 1; ++i)
            b.stick(Label::tail, {tip, tip + (1.6 * s) * rotated(along, 0.4 * i)}, depth, 2.0);
}

// A horse's tail of single hairs.
void add_strands(Builder& b, const Path& line, double l, Point2d side, double depth) {
    Random& r = b.random;
    for (int i = 0, n = r.integer(3, 6); i < n; ++i) {
        const double d = r.uniform(-0.12, 0.12) * l;
        b.stick(Label::tail, spline({line[0], line[1] + d * side, line[2] + (3 * d) * side}, false), depth);
    }
}

void add_tail(Builder& b, const Animal& a, int trunk) {
    Random& r = b.random;
    const Point2d root{-0.94 * a.rx, -0.35 * a.ry};
    const double l = a.tail_length, up = r.uniform(-1.2, 1.0); // rises or hangs
    const Point2d way = direction(pi - up);
    const double bend = r.uniform(-0.35, 0.35);
    const Point2d side{way.y, -way.x};
    const Path line{root, root + (0.5 * l) * way + (bend * l) * side,
                    root + l * way + (r.uniform(-0.4, 0.4) * l) * side};
    const double depth = r.chance(0.7) ? -1.0 : 0.8;
    const bool pen_thin = r.chance(0.55);
    switch (a.tail) {
    case TailKind::thin:
        if (pen_thin)
            b.stick(Label::tail, spline(line, false), depth);
        else
            b.attach(b.limb(Label::tail, line, {2.0, 1.7, 1.3}, depth, {Cap::round, Cap::round, true, false}),
                     trunk);
        break;
    case TailKind::tuft:
        b.stick(Label::tail, spline(line, false), depth);
        add_tuft(b, line, depth);
        break;
    case TailKind::curly: {
        const double turns = r.uniform(0.8, 1.8);
        b.stick(Label::tail, curl(root, pi + 0.5, l * 1.5, turns, 0.6), depth);
        break;
    }
    case TailKind::bushy: {
        const double w = r.uniform(0.12, 0.2) * l;
        b.attach(
            b.limb(Label::tail, line, {1.5, w, 0.9 * w, 0.3}, depth, {Cap::round, Cap::pointed, true, false}),
            trunk);
        break;
    }
    case TailKind::thick: {
        const Path low{{-0.7 * a.rx, 0.0},
                       {-a.rx - 0.45 * l, 0.2 * a.ry + r.uniform(-0.1, 0.2) * l},
                       {-a.rx - 0.9 * l, r.uniform(-0.2, 0.3) * l}};
        b.attach(b.limb(Label::tail, low, {0.75 * a.ry, 0.4 * a.ry, 0.6}, -0.2,
                        {Cap::flat, Cap::pointed, true, false}),
                 trunk);
        break;
    }
    case TailKind::stub: {
        const double s = 0.6 * l;
        b.attach(b.region(Label::tail, ellipse(root + Point2d{-0.4 * s, 0}, s, 0.8 * s), depth), trunk);
        break;
    }
    case TailKind::strands:
        if (pen_thin) {
            add_strands(b, line, l, side, depth);
        } else {
            b.attach(b.limb(Label::tail, line, {1.5, 3.0, 3.4, 1.0}, depth,
                            {Cap::round, Cap::pointed, true, false}),
                     trunk);
        }
        break;
    }
}

void decorate(Builder& b, const Animal& a, int trunk, const std::string& species) {
    Random& r = b.random;
    const Frame frame{{0, 0}, a.rx, a.ry, 0};
    if (species == "zebra" || species == "tiger") {
        if (r.chance(0.85)) add_pattern(b, trunk, frame, "stripes");
    } else if (species == "cow" || species == "giraffe") {
        if (r.chance(0.6)) add_pattern(b, trunk, frame, "patches");
    } else if (r.chance(0.18)) {
        add_pattern(b, trunk, frame);
    }
    if (species == "cow" && r.chance(0.4))
        b.attach(b.region(Label::body, ellipse({-0.45 * a.rx, 0.95 * a.ry}, 0.16 * a.rx, 0.25 * a.ry), -0.6),
                 trunk);
}

// Half from the front or sitting towards us: trunk foreshortened, the face in front of it.
void build_facing(Builder& b, Animal a, const std::string& species) {
    Random& r = b.random;
    const bool sitting = r.chance(0.4);
    b.figure.heading = sitting ? 0.5 * pi : 0.25 * pi;
    const double w = sitting ? r.uniform(11, 15) : r.uniform(15, 21),
                 h = sitting ? r.uniform(17, 23) : r.uniform(11, 15);
    const int trunk = b.region(Label::body,
                               sitting ? spline({{-0.5 * w, -h},
                                                 {-w, 0.3 * h},
                                                 {-0.9 * w, 0.9 * h},
                                                 {0, h},
                                                 {0.9 * w, 0.9 * h},
                                                 {w, 0.3 * h},
                                                 {0.5 * w, -h}},
                                                true, 6)
                                       : ellipse({0, 0}, w, h),
                               0);
    a.neck = 0;
    const Point2d face{sitting ? 0.0 : 0.75 * w, -h * r.uniform(0.75, 1.05)};
    const int head = add_facing_head(b, a, face, species);
    b.attach(head, trunk);
    const double leg = sitting ? 0.55 * h : 0.7 * a.leg, radius = a.leg_radius;
    for (int i = 0; i < 4; ++i) {
        const bool front = i >= 2;
        const double x = sitting ? (front ? 0.3 : 0.85) * w * (i % 2 ? 1 : -1)
                                 : (front ? 0.25 + 0.5 * (i % 2) : -0.75 + 0.4 * (i % 2)) * w;
        const double top = sitting ? (front ? 0.1 : 0.75) * h : 0.55 * h,
                     foot = h + (sitting ? 0.08 * leg : leg * (front ? 1.0 : 0.85));
        const Path line{{x, top}, {x + r.uniform(-1.0, 1.0), foot}};
        const int limb = b.limb(Label::limb, line, {radius, radius * r.uniform(0.8, 1.2)}, front ? 0.6 : -0.5,
                                {Cap::round, Cap::round, true, false});
        b.attach(limb, trunk);
    }
    const Animal rear = [&] {
        Animal t = a;
        t.rx = w;
        t.ry = h * 0.5;
        return t;
    }();
    add_tail(b, rear, trunk);
}

} // namespace

std::vector<std::string> quadruped_species() { return names_of(kinds()); }

// Used by the dragon too.
Figure build_quadruped(Random& random, const std::string& species) {
    Builder b(random, "quadruped", species);
    const Animal animal = vary(b, row_of(kinds(), species).animal);
    if (animal.head_kind != HeadKind::length && random.chance(0.14)) {
        build_facing(b, animal, species);
        return std::move(b.figure);
    }
    const int trunk = add_trunk(b, animal, species);
    add_tail(b, animal, trunk);
    add_legs(b, animal, trunk);
    add_neck_and_head(b, animal, trunk, species);
    decorate(b, animal, trunk, species);
    b.figure.heading = 0;
    return std::move(b.figure);
}

} // namespace pantin::doodle
