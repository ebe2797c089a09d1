// SPDX-License-Identifier: MIT
// Whatever has wings: birds from the side and from above, butterflies, bats, insects, owls, angels, dragons.
// Units: the trunk is about 50 long, its middle the origin, y down.
#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "doodle/figure.hpp"

namespace pantin::doodle {
namespace {

using math::pi;

enum class Edge { smooth, scalloped, feathered, zigzag };

// A wing from its root (front end a, rear end b on the trunk) to the tip: a bulging leading edge and a
// trailing edge of some kind. `bulge` is relative to the wing's length.
Path wing_outline(Random& r, Point2d a, Point2d b, Point2d tip, double bulge, Edge edge, int feathers) {
    const Point2d lead = tip - a, side = [&] {
        const Point2d n{lead.y, -lead.x};
        return dot(n, b - a) > 0 ? -1.0 * n : n; // away from the trailing edge
    }();
    Path front = spline({a, mix(a, tip, 0.35) + bulge * side, mix(a, tip, 0.75) + (0.7 * bulge) * side, tip},
                        false, 5);
    const Path rear_line = spline(
        {tip, mix(tip, b, 0.4) + (0.25 * bulge) * (b - a), mix(tip, b, 0.8) + (0.1 * bulge) * (b - a), b},
        false, 6);
    Path rear;
    if (edge == Edge::smooth) {
        rear = rear_line;
    } else {
        const Path spine = resample(rear_line, path_length(rear_line) / feathers * 0.999);
        for (std::size_t i = 0; i + 1 < spine.size(); ++i) {
            const Point2d p = spine[i], q = spine[i + 1], along = q - p;
            Point2d out{-along.y, along.x};
            if (dot(out, mix(a, b, 0.5) - mix(p, q, 0.5)) * 1.0 > 0)
                out = -1.0 * out; // away from the root's middle
            const double depth = (edge == Edge::scalloped   ? -0.35
                                  : edge == Edge::feathered ? 0.45
                                                            : 0.5) *
                                 r.uniform(0.7, 1.2);
            rear.push_back(p);
            if (edge == Edge::zigzag) {
                rear.push_back(mix(p, q, 0.5) + depth * out);
            } else {
                for (int k = 1; k < 5; ++k) {
                    const double t = k / 5.0;
                    rear.push_back(mix(p, q, t) + (4 * t * (1 - t) * depth) * out);
                }
            }
        }
        rear.push_back(b);
    }
    front.insert(front.end(), rear.begin() + 1, rear.end());
    return front;
}

Edge random_edge(Random& r) {
    return r.pick(std::vector<Edge>{Edge::smooth, Edge::smooth, Edge::feathered, Edge::zigzag});
}

void feather_marks(Builder& b, int wing, Point2d root, Point2d tip, Point2d rear) {
    Random& r = b.random;
    if (!r.chance(0.35)) return;
    for (int i = 1, n = r.integer(2, 5); i <= n; ++i) {
        const double t = static_cast<double>(i) / (n + 1);
        const Point2d p = mix(mix(root, tip, 0.25 + 0.6 * t), rear, 0.25),
                      q = mix(mix(root, tip, t), rear, 0.75);
        b.mark(wing, {p, q}, false, 0.8);
    }
}

struct Bird {
    double rx, ry, head, neck, neck_angle, beak, tail, leg;
};

Bird random_bird(Random& r, const std::string& species) {
    Bird bird{26,
              r.uniform(7, 13),
              r.uniform(5.5, 8.5),
              2,
              r.uniform(0.2, 0.7),
              r.uniform(4, 9),
              r.uniform(12, 22),
              r.uniform(8, 15)};
    if (species == "duck")
        bird.neck = r.uniform(3, 10), bird.neck_angle = r.uniform(0.9, 1.4), bird.tail = r.uniform(5, 10),
        bird.ry = r.uniform(10, 14);
    if (species == "swan" || species == "flamingo")
        bird.neck = r.uniform(20, 36), bird.neck_angle = r.uniform(1.1, 1.5), bird.tail = r.uniform(5, 10),
        bird.head = r.uniform(4.5, 6);
    if (species == "flamingo") bird.leg = r.uniform(28, 42), bird.rx = 20, bird.ry = r.uniform(8, 11);
    if (species == "chicken")
        bird.ry = r.uniform(13, 18), bird.neck = r.uniform(2, 8), bird.neck_angle = r.uniform(0.8, 1.2),
        bird.rx = 21;
    return bird;
}

int add_bird_trunk(Builder& b, const Bird& s) {
    Random& r = b.random;
    const double x = s.rx, y = s.ry;
    if (r.chance(0.35)) return b.region(Label::body, ellipse({0, 0}, x, y, r.uniform(-0.15, 0.05)), 0);
    const double back = r.uniform(0.6, 1.0) * y, belly = r.uniform(0.8, 1.2) * y;
    return b.region(Label::body,
                    spline({{-x, 0.1 * y},
                            {-0.5 * x, -0.55 * back},
                            {0.1 * x, -back},
                            {0.7 * x, -0.75 * y},
                            {x, -0.05 * y},
                            {0.7 * x, 0.75 * belly},
                            {0.1 * x, belly},
                            {-0.55 * x, 0.6 * belly}},
                           true, 6),
                    0);
}

void add_beak(Builder& b, int head, Point2d c, double r0, double l, double angle,
              const std::string& species) {
    Random& r = b.random;
    const Point2d along = direction(angle), up{along.y, -along.x};
    const Point2d base = c + (0.8 * r0) * along;
    int beak = 0;
    if (species == "duck" || species == "swan" || species == "flamingo") {
        const double droop = species == "flamingo" ? 0.6 : 0.1;
        beak = b.limb(Label::head, {base, base + (0.6 * l) * along, base + l * along - (droop * l) * up},
                      {0.35 * r0, 0.26 * r0, 0.22 * r0}, 1.1, {Cap::flat, Cap::round, true, false});
    } else {
        const double w = r0 * r.uniform(0.28, 0.5);
        beak = b.region(Label::head, {base + w * up, base + l * along, base - w * up}, 1.1);
        if (r.chance(0.4)) b.mark(beak, {base, base + (0.9 * l) * along});
    }
    b.attach(beak, head);
    b.part(beak).paint = 6;
    (void)c;
}

// The head of a bird in profile, on its neck; returns the head.
int add_bird_head(Builder& b, const Bird& s, int trunk, const std::string& species) {
    Random& r = b.random;
    const Point2d base{0.8 * s.rx, -0.35 * s.ry};
    const Point2d along = direction(-s.neck_angle);
    Point2d c = base + (s.neck + 0.4 * s.head) * along;
    if (s.neck > 12) {
        c = base + s.neck * along + Point2d{0.25 * s.neck, -0.1 * s.neck};
        const double w = r.uniform(1.8, 3.2), swing = r.uniform(-0.2, 0.3) * s.neck;
        const Path line{base - Point2d{0.1 * s.rx, -2.0}, mix(base, c, 0.35) + Point2d{swing, 0},
                        mix(base, c, 0.8) - Point2d{0.6 * swing, 0}, c};
        if (r.chance(0.4 * b.manner.stick_limbs + 0.1))
            b.stick(Label::body, spline(line, false), 0.1);
        else
            b.merge(b.limb(Label::body, line, {2.0 * w, w, w}, 0, {Cap::round, Cap::round, true, true}),
                    trunk);
    } else if (s.neck > 3) {
        b.merge(b.limb(Label::body, {base - 3.0 * along, c}, {0.95 * s.head, 0.75 * s.head}, 0,
                       {Cap::round, Cap::round, true, true}),
                trunk);
    }
    const double angle = r.uniform(-0.15, 0.25);
    const int head = b.region(Label::head, ellipse(c, s.head, s.head * r.uniform(0.8, 1.0), angle), 1);
    if (r.chance(0.6)) b.merge(head, trunk);
    add_beak(b, head, c, s.head, s.beak, angle, species);
    add_eye(b, head, c + Point2d{0.2 * s.head, -0.2 * s.head}, 0.2 * s.head);
    if (species == "chicken") {
        b.part(b.region(Label::head, fluffy(r, {c + Point2d{0, -s.head}, 0.5 * s.head, 0.35 * s.head, 0}, 4),
                        0.5))
            .paint = 7;
        if (r.chance(0.6))
            b.part(b.region(Label::head,
                            ellipse(c + Point2d{0.7 * s.head, s.head}, 0.2 * s.head, 0.4 * s.head), 1.2))
                .paint = 7;
    } else if (r.chance(0.12)) {
        for (int i = -1; i <= 1; ++i)
            b.stick(Label::head, {c + Point2d{0, -0.9 * s.head}, c + Point2d{-3.0 + 2 * i, -1.7 * s.head}},
                    0.9, 1.0);
    }
    return head;
}

void add_bird_tail(Builder& b, Point2d root, double angle, double width, double l, int trunk) {
    Random& r = b.random;
    const Point2d along = direction(angle), side{along.y, -along.x};
    const double flare = width * r.uniform(1.0, 2.2);
    const Point2d base = root - (0.25 * l) * along;
    Path p = {base + width * side, root + l * along + flare * side};
    const int kind = r.integer(0, 3);
    if (kind == 0) p.push_back(root + (0.65 * l) * along); // forked
    if (kind == 1) p.push_back(root + (1.15 * l) * along);
    if (kind == 2)
        for (int i = 1; i <= 3; ++i)
            p.push_back(root + (i % 2 ? 0.8 : 1.05) * l * along + (flare * (1 - 0.5 * i)) * side);
    p.push_back(root + l * along - flare * side);
    p.push_back(base - width * side);
    if (kind == 3) p = spline(p, true, 5);
    const int tail = b.region(Label::tail, p, r.chance(0.7) ? -0.5 : 0.5);
    b.attach(tail, trunk);
    if (r.chance(0.3)) b.mark(tail, {root + (0.2 * l) * along, root + (0.7 * l) * along});
}

void add_bird_legs(Builder& b, const Bird& s, bool standing) {
    Random& r = b.random;
    const double y0 = 0.8 * s.ry;
    for (int i = 0; i < 2; ++i) {
        const double x = (i == 0 ? -0.12 : 0.14) * s.rx + r.uniform(-1.5, 1.5);
        const Point2d hip{x, y0 - 1.0};
        const Point2d foot = standing ? Point2d{x + r.uniform(-2.0, 3.0), s.ry + s.leg}
                                      : Point2d{x - 0.6 * s.leg, y0 + 0.45 * s.leg};
        if (r.chance(0.2) && standing) {
            const double w = r.uniform(1.2, 2.0);
            b.limb(Label::limb, {hip, foot}, {1.6 * w, w}, -1, {Cap::flat, Cap::round, true, false});
        } else {
            b.stick(Label::limb, {hip, mix(hip, foot, 0.5) + Point2d{r.uniform(-1.0, 1.0), 0}, foot}, -1);
        }
        const double t = r.uniform(2.5, 4.5), heading = standing ? 0.15 : 2.6;
        for (int k = -1, toes = r.integer(0, 2); k <= 1 && toes > 0; ++k)
            b.continued(b.stick(Label::limb, {foot, foot + t * direction(heading + 0.6 * k)}, -1, 2.0));
        if (!standing && r.chance(0.4)) break;
    }
}

void build_flying_bird(Builder& b, const std::string& species) {
    Random& r = b.random;
    Bird s = random_bird(r, species);
    const int trunk = add_bird_trunk(b, s);
    add_bird_tail(b, {-0.92 * s.rx, 0}, pi + r.uniform(-0.35, 0.35), 0.3 * s.ry, s.tail, trunk);
    add_bird_head(b, s, trunk, species);
    const Edge edge = random_edge(r);
    const double l = r.uniform(24, 48), x = r.uniform(-0.1, 0.35) * s.rx, w = r.uniform(0.35, 0.6) * s.rx;
    const double lean = r.uniform(-0.3, 0.5);
    const int feathers = r.integer(4, 8), arrangement = r.integer(0, 3);
    const double bulge = r.uniform(0.05, 0.25);
    for (int i = 0; i < 2; ++i) {
        // the near wing up (or down), the far one behind
        const bool near = i == 1;
        if (!near && arrangement == 0) continue;
        const bool down = near ? arrangement == 3 : arrangement == 2;
        const double shift = near ? 0.0 : r.uniform(0.1, 0.35) * s.rx, y = (down ? 0.45 : -0.45) * s.ry;
        const Point2d front{x + w * 0.6 + shift, y}, rear{x - w * 0.7 + shift, y};
        const double turn = lean + (near ? 0 : r.uniform(-0.5, -0.1));
        const Point2d tip =
            mix(front, rear, 0.5) + l * (near ? 1.0 : r.uniform(0.75, 1.0)) *
                                        Point2d{-math::sin(turn), down ? math::cos(turn) : -math::cos(turn)};
        const double depth = near ? (r.chance(0.6) ? 2.0 : -0.6) : -2.0;
        const int wing =
            b.region(Label::wing, wing_outline(r, front, rear, tip, bulge, edge, feathers), depth);
        if (near) b.attach(wing, trunk);
        feather_marks(b, wing, front, tip, rear);
    }
    if (r.chance(0.3)) add_bird_legs(b, s, false);
    b.figure.max_tilt = 0.5;
}

void build_standing_bird(Builder& b, const std::string& species) {
    Random& r = b.random;
    const Bird s = random_bird(r, species);
    const int trunk = add_bird_trunk(b, s);
    add_bird_tail(b, {-0.9 * s.rx, 0}, pi + r.uniform(-0.2, species == "chicken" ? 0.9 : 0.5), 0.35 * s.ry,
                  s.tail * 0.8, trunk);
    add_bird_head(b, s, trunk, species);
    if (species == "swan" || (species == "duck" && r.chance(0.4))) {
        if (r.chance(0.3)) add_bird_legs(b, s, true);
    } else {
        add_bird_legs(b, s, true);
    }
    // the folded wing inside the trunk
    const double l = r.uniform(0.9, 1.35) * s.rx, h = r.uniform(0.4, 0.7) * s.ry,
                 x = r.uniform(0.2, 0.5) * s.rx;
    Outline wing{{}, {}, true};
    const double dip = r.uniform(-0.1, 0.3) * s.ry;
    const Edge edge = random_edge(r);
    const int feathers = r.integer(3, 5);
    wing.points = r.chance(0.4) ? wing_outline(r, {x, -0.6 * h}, {x - 0.2 * l, 0.9 * h}, {x - l, dip}, 0.1,
                                               edge, feathers)
                                : spline({{x, -0.3 * h},
                                          {x - 0.4 * l, -0.8 * h},
                                          {x - l, dip},
                                          {x - 0.55 * l, 0.9 * h},
                                          {x - 0.1 * l, 0.8 * h}},
                                         true, 6);
    const int index = b.region(Label::wing, wing, 2);
    if (r.chance(0.35)) { // only its lower edge is drawn
        Part& part = b.part(index);
        const std::size_t n = part.outline.points.size();
        for (std::size_t i = 0; i < n * 2 / 5; ++i) part.outline.undrawn[i] = 1;
    }
    feather_marks(b, index, {x, -0.2 * h}, {x - l, dip}, {x - 0.4 * l, 0.8 * h});
}

struct Spread {                // a symmetric pair of wings around a vertical trunk
    double length, root, lift; // lift: angle of the tips above the shoulder
    double bulge;
    Edge edge;
    int feathers;
};

void add_wing_pair(Builder& b, int trunk, Point2d shoulder, const Spread& s, double depth) {
    Random& r = b.random;
    for (int side = -1; side <= 1; side += 2) {
        const double lift = s.lift + r.uniform(-0.08, 0.08), l = b.jitter(s.length, 0.06);
        const Point2d a{side * shoulder.x, shoulder.y}, rear{side * shoulder.x, shoulder.y + s.root};
        const Point2d tip = a + l * Point2d{side * math::cos(lift), -math::sin(lift)};
        const int wing =
            b.region(Label::wing, wing_outline(r, a, rear, tip, s.bulge, s.edge, s.feathers), depth);
        if (trunk >= 0) b.attach(wing, trunk);
        feather_marks(b, wing, a, tip, rear);
    }
}

// A bird from above or below: the head up, the tail down.
void build_spread_bird(Builder& b) {
    Random& r = b.random;
    const double w = r.uniform(4.5, 8), l = r.uniform(17, 25);
    const int trunk = b.region(Label::body, ellipse({0, 0}, w, l, 0, r.uniform(1.8, 2.4)), 0);
    const double h = r.uniform(4.5, 7.5);
    const Point2d c{r.uniform(-1.0, 1.0), -l - 0.35 * h};
    const int head = b.region(Label::head, ellipse(c, h, h * r.uniform(0.9, 1.2)), 1);
    b.attach(head, trunk);
    const double turn = r.chance(0.5) ? 0 : r.uniform(-1.2, 1.2);
    add_beak(b, head, c, h, h * r.uniform(0.5, 1.1), -0.5 * pi + turn, "bird");
    if (r.chance(0.4)) add_eye(b, head, c, 0.2 * h);
    const double sway = r.uniform(-0.15, 0.15), tail = r.uniform(10, 20);
    add_bird_tail(b, {0, 0.92 * l}, 0.5 * pi + sway, 0.45 * w, tail, trunk);
    const Spread spread{r.uniform(28, 58),    r.uniform(9, 20), r.uniform(-0.4, 0.6),
                        r.uniform(0.02, 0.3), random_edge(r),   r.integer(4, 9)};
    const double depth = r.chance(0.6) ? -0.5 : 0.5;
    add_wing_pair(b, trunk, {0.6 * w, r.uniform(-0.75, -0.4) * l}, spread, depth);
    b.figure.heading = -0.5 * pi;
    b.figure.max_tilt = r.chance(0.4) ? pi : 0.2;
}

void build_bat(Builder& b) {
    Random& r = b.random;
    const double w = r.uniform(5, 9), l = r.uniform(9, 16);
    const int trunk = b.region(Label::body, ellipse({0, 0}, w, l), 0);
    const double h = r.uniform(5, 9);
    const Frame f{{0, -l - 0.4 * h}, h, 0.9 * h, 0};
    const int head = b.region(Label::head, ellipse(f.centre, f.rx, f.ry), 1);
    b.attach(head, trunk);
    for (int s = -1; s <= 1; s += 2)
        b.attach(b.region(Label::head,
                          {f.at(0.9 * s, -0.3), f.at(0.8 * s, r.uniform(-2.1, -1.4)), f.at(0.1 * s, -0.9)},
                          0.8),
                 head);
    add_frontal_face(b, head, f);
    const Spread spread{r.uniform(30, 48),
                        r.uniform(8, 16),
                        r.uniform(0.1, 0.7),
                        r.uniform(0.0, 0.25),
                        r.chance(0.8) ? Edge::scalloped : Edge::zigzag,
                        r.integer(3, 4)};
    add_wing_pair(b, trunk, {0.6 * w, -0.6 * l}, spread, -0.5);
    if (r.chance(0.6))
        for (int s = -1; s <= 1; s += 2)
            b.stick(Label::limb, {{0.4 * s * w, 0.85 * l}, {0.5 * s * w, l + r.uniform(3.0, 6.0)}}, -1);
    b.figure.heading = 0.5 * pi;
    b.figure.max_tilt = 0.25;
}

void add_antennae(Builder& b, Point2d root, double l, double angle) {
    Random& r = b.random;
    for (int s = -1; s <= 1; s += 2) {
        const Point2d d = rotated(direction(angle), 0.4 * s), e = rotated(direction(angle), 0.75 * s);
        const Point2d tip = root + (0.5 * l) * d + (0.6 * l) * e;
        b.stick(Label::head, spline({root, root + (0.5 * l) * d, tip}, false), 0.5, 1.0);
        if (r.chance(0.4)) b.region(Label::head, ellipse(tip, 1.0, 1.0), 0.6);
    }
}

void build_butterfly(Builder& b) {
    Random& r = b.random;
    const double w = r.uniform(2.2, 4.5), l = r.uniform(15, 25), h = w * r.uniform(1.0, 1.5);
    const bool line_body = r.chance(0.2);
    const int trunk = line_body ? b.stick(Label::body, {{0, -l}, {0, l}}, 0.5)
                                : b.region(Label::body, ellipse({0, 0}, w, l), 0.5);
    const Point2d c{0, -l - 0.5 * h};
    const int head = b.region(Label::head, ellipse(c, h, h), 1);
    if (r.chance(0.3)) add_frontal_face(b, head, {c, h, h, 0});
    if (r.chance(0.85)) add_antennae(b, c - Point2d{0, 0.8 * h}, r.uniform(6, 12), -0.5 * pi);
    const double a1 = r.uniform(0.35, 0.85), l1 = r.uniform(20, 32), l2 = l1 * r.uniform(0.6, 0.95),
                 w1 = r.uniform(0.32, 0.5), w2 = r.uniform(0.32, 0.5);
    const bool one_line = r.chance(0.3);
    for (int s = -1; s <= 1; s += 2) {
        const auto lobe = [&](double angle, double size, double width, double y) {
            const Point2d d{s * math::cos(angle), -math::sin(angle)}, n{-d.y, d.x};
            const Point2d root{0.2 * s * w, y};
            return spline({root, root + (0.45 * size) * d + (width * 0.8 * size) * n,
                           root + (0.9 * size) * d + (width * 0.75 * size) * n, root + (1.1 * size) * d,
                           root + (0.9 * size) * d - (width * 0.75 * size) * n,
                           root + (0.45 * size) * d - (width * 0.6 * size) * n},
                          true, 6);
        };
        const double up = a1 + r.uniform(-0.05, 0.05), down = -a1 + r.uniform(-0.1, 0.1);
        const double upper_length = b.jitter(l1, 0.05), lower_length = b.jitter(l2, 0.05);
        const int upper = b.region(Label::wing, lobe(up, upper_length, w1, -0.25 * l), -0.5);
        const int lower = b.region(Label::wing, lobe(down, lower_length, w2, 0.2 * l), -0.7);
        if (one_line) b.merge(upper, lower);
        if (r.chance(0.4)) {
            b.mark(upper,
                   ellipse({s * l1 * 0.7 * math::cos(a1), -0.25 * l - l1 * 0.7 * math::sin(a1)}, 0.15 * l1,
                           0.15 * l1),
                   true);
            b.mark(lower,
                   ellipse({s * l2 * 0.7 * math::cos(a1), 0.2 * l + l2 * 0.7 * math::sin(a1)}, 0.13 * l2,
                           0.13 * l2),
                   true);
        }
    }
    if (!line_body && r.chance(0.4)) add_pattern(b, trunk, {{0, 0}, l, w, 0.5 * pi}, "stripes");
    b.figure.heading = -0.5 * pi;
    b.figure.max_tilt = r.chance(0.3) ? 1.2 : 0.3;
}

// Bees, flies and dragonflies: a striped trunk, thin legs.
void build_insect(Builder& b, const std::string& species) {
    Random& r = b.random;
    const bool dragonfly = species == "dragonfly";
    const double x = dragonfly ? r.uniform(12, 16) : r.uniform(15, 21),
                 y = dragonfly ? r.uniform(3, 4.5) : r.uniform(8, 12);
    const int trunk = b.region(Label::body, ellipse({0, 0}, x, y), 0);
    const double h = dragonfly ? 1.3 * y : y * r.uniform(0.6, 0.85);
    const Point2d c{x + 0.5 * h, -0.1 * y};
    const int head = b.region(Label::head, ellipse(c, h, h), r.chance(0.5) ? 1 : -0.1);
    b.attach(head, trunk);
    add_eye(b, head, c + Point2d{0.25 * h, -0.2 * h}, 0.2 * h);
    if (r.chance(0.8)) add_antennae(b, c - Point2d{-0.1 * h, 0.85 * h}, r.uniform(5, 9), -1.2);
    if (r.chance(0.9) && !dragonfly) add_pattern(b, trunk, {{0, 0}, x, y, 0}, "stripes");
    const int wings = dragonfly ? 4 : r.integer(1, 3);
    for (int i = 0; i < wings; ++i) {
        const bool down = dragonfly && i >= 2;
        const double lean = dragonfly ? (i % 2 ? 0.3 : -0.25) : -0.5 + 0.5 * i + r.uniform(-0.15, 0.15);
        const double l = dragonfly ? r.uniform(24, 32) : r.uniform(16, 26), w = (dragonfly ? 0.13 : 0.3) * l;
        const Point2d d{math::sin(lean), down ? math::cos(lean) : -math::cos(lean)},
            root{dragonfly ? 0.3 * x : 2.0 - 2.0 * i, (down ? 0.6 : -0.6) * y};
        b.limb(Label::wing, {root, root + (0.5 * l) * d, root + l * d}, {0.35 * w, w, 0.8 * w},
               i == 0 ? 0.8 : -0.5 - 0.1 * i, {Cap::round, Cap::round, false, false});
    }
    if (dragonfly) {
        const Path tail{{-0.8 * x, 0}, {-1.8 * x, r.uniform(-4.0, 2.0)}, {-3.2 * x, r.uniform(-8.0, 6.0)}};
        b.attach(b.limb(Label::tail, tail, {0.55 * y, 0.4 * y, 0.35 * y}, -0.2), trunk);
    } else if (r.chance(0.6)) {
        b.region(Label::tail,
                 {{-0.97 * x, -1.2}, {-x - r.uniform(3.0, 6.0), r.uniform(-1.0, 1.0)}, {-0.97 * x, 1.2}},
                 -0.1);
    }
    if (r.chance(0.5))
        for (int i = 0, n = r.integer(2, 4); i < n; ++i) {
            const double at = (-0.5 + 1.0 * i / (n - 1)) * x, drop = r.uniform(4.0, 8.0),
                         kick = r.uniform(-3.0, 3.0);
            b.stick(Label::limb, {{at, 0.85 * y}, {at + kick, y + drop}}, -1);
        }
    b.figure.heading = 0;
    b.figure.max_tilt = 0.5;
}

// Sitting towards us, wings at its sides.
void build_owl(Builder& b) {
    Random& r = b.random;
    const double w = r.uniform(13, 19), l = r.uniform(17, 24);
    const int trunk = b.region(Label::body, ellipse({0, 0}, w, l, 0, r.uniform(2.0, 2.8)), 0);
    const double h = w * r.uniform(0.75, 1.0);
    const Frame f{{0, -l - 0.3 * h}, h, 0.8 * h, 0};
    const int head = b.region(Label::head, ellipse(f.centre, f.rx, f.ry), 1);
    b.attach(head, trunk);
    for (int s = -1; s <= 1; s += 2) {
        b.attach(b.region(Label::head, {f.at(0.9 * s, -0.4), f.at(0.8 * s, -1.35), f.at(0.3 * s, -0.9)}, 0.8),
                 head);
        b.mark(head, ellipse(f.at(0.42 * s, -0.1), 0.34 * h, 0.34 * h), true);
        b.spot(head, ellipse(f.at(0.42 * s, -0.1), 0.13 * h, 0.13 * h));
        const double out = r.uniform(1.05, 1.5), drop = r.uniform(0.4, 0.9);
        const Path line{{0.85 * s * w, -0.6 * l}, {out * s * w, 0.0}, {0.95 * s * w * out, drop * l}};
        b.attach(b.limb(Label::wing, line, {2.0, 0.28 * w, 0.6}, r.chance(0.5) ? 0.7 : -0.6), trunk);
        const Point2d foot{0.4 * s * w, 0.95 * l};
        for (int k = -1; k <= 1; ++k) { // three toes are one foot
            const int toe =
                b.stick(Label::limb, {foot, foot + Point2d{1.8 * k, r.uniform(3.0, 5.0)}}, -0.3, 2.0);
            if (k > -1) b.continued(toe);
        }
    }
    b.mark(head, {f.at(-0.12, 0.2), f.at(0, 0.55), f.at(0.12, 0.2)}, true);
    if (r.chance(0.5)) add_pattern(b, trunk, {{0, 0}, w, l, 0}, "spots");
    b.figure.heading = 0.5 * pi;
}

// A figure with wings added behind its trunk.
void give_wings(Builder& b, bool from_the_side) {
    Random& r = b.random;
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (const Part& part : b.figure.parts) {
        if (part.label != Label::body || part.kind == PartKind::mark) continue;
        for (Point2d p : part.outline.points)
            left = std::min(left, p.x), right = std::max(right, p.x), top = std::min(top, p.y),
            bottom = std::max(bottom, p.y);
        break;
    }
    const double l = r.uniform(24, 42), h = std::min(bottom - top, 40.0);
    if (from_the_side) {
        const double x = 0.1 * (right - left), y = top + 0.3 * h;
        for (int i = 0, n = r.integer(1, 2); i < n; ++i) {
            const Point2d a{x + 6 - 7 * i, y}, rear{x - 8 - 7 * i, y},
                tip{x - r.uniform(0.0, 0.6) * l, y - l};
            const double bulge = r.uniform(0.1, 0.3);
            const Edge edge = r.chance(0.7) ? Edge::scalloped : Edge::smooth;
            const int feathers = r.integer(3, 4);
            b.region(Label::wing, wing_outline(r, a, rear, tip, bulge, edge, feathers), i == 0 ? 1.5 : -1.5);
        }
        return;
    }
    const double inset = 0.25 * (right - left);
    if (r.chance(0.5)) {
        const Spread spread{l,
                            r.uniform(0.3, 0.7) * h,
                            r.uniform(0.1, 0.8),
                            r.uniform(0.1, 0.3),
                            r.pick(std::vector<Edge>{Edge::smooth, Edge::feathered, Edge::zigzag}),
                            r.integer(3, 6)};
        add_wing_pair(b, -1, {inset, top + 0.15 * h}, spread, -5);
    } else {
        for (int s = -1; s <= 1; s += 2) {
            const Point2d c{s * (inset + 0.5 * l), top + r.uniform(0.1, 0.35) * h};
            b.region(Label::wing, ellipse(c, 0.55 * l, 0.38 * l, -0.5 * s), -5);
        }
    }
}

} // namespace

std::vector<std::string> flyer_species() {
    return {"bird", "gull",      "duck", "swan", "chicken", "flamingo", "standing bird", "butterfly",
            "bee",  "dragonfly", "bat",  "owl",  "angel",   "dragon",   "flying duck"};
}

Figure build_flyer(Random& random, const std::string& species) {
    Builder b(random, "flying", species);
    b.figure.heading = 0;
    if (species == "bird")
        build_flying_bird(b, "bird");
    else if (species == "flying duck")
        build_flying_bird(b, "duck");
    else if (species == "gull")
        build_spread_bird(b);
    else if (species == "butterfly")
        build_butterfly(b);
    else if (species == "bee" || species == "dragonfly")
        build_insect(b, species);
    else if (species == "bat")
        build_bat(b);
    else if (species == "owl")
        build_owl(b);
    else if (species == "angel" || species == "dragon") {
        const bool dragon = species == "dragon";
        b.figure = dragon ? build_quadruped(random, "dinosaur")
                          : build_humanoid(random, random.chance(0.3) ? "stick person" : "person");
        b.figure.type = "flying", b.figure.species = species;
        give_wings(b, dragon && std::abs(b.figure.heading) < 0.1);
    } else
        build_standing_bird(b, species);
    return std::move(b.figure);
}

} // namespace pantin::doodle
