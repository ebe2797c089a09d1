// SPDX-License-Identifier: MIT
// Proportions in, a drawing of tools/doodle out.
#include "figures/drawn_dog.hpp"

#include <algorithm>

#include "doodle/canvas.hpp"

namespace pantin::figures {
namespace {

using namespace doodle;

void add_head(Builder& b, const DogShape& s, int trunk) {
    const Point2d c{s.trunk + 30, -25 - 70 * s.neck}; // of the skull
    const Path throat{{s.trunk - 25, -10}, {s.trunk + 10, -70 * s.neck}};
    const int neck = b.limb(Label::body, throat, {26, 22}, 0.1, {Cap::round, Cap::round, true, true});
    b.merge(neck, trunk);
    const int head = b.region(Label::head, ellipse(c, 42, 36), 1);
    const Path snout{c + Point2d{20, 10}, c + Point2d{55, 15}};
    const int muzzle = b.limb(Label::head, snout, {20, 17}, 1, {Cap::flat, Cap::round, true, false});
    b.merge(muzzle, head);
    b.region(Label::head, ellipse(c + Point2d{-30, -5}, 13, 30, 0.3), 2); // an ear
    b.spot(muzzle, ellipse(c + Point2d{67, 9}, 6, 5));
    b.mark(head, ellipse(c + Point2d{15, -11}, 3, 3), true);
}

void add_legs(Builder& b, const DogShape& s, int trunk) {
    for (int end = -1; end <= 1; end += 2)
        for (int side = -1; side <= 1; side += 2) {
            const double x = end * s.pairs;
            const Point2d hip{x + side * s.hips / 2, 20}, foot{x + side * s.feet / 2, 30 + s.leg};
            const int leg = b.limb(Label::limb, {hip, mix(hip, foot, 0.5), foot},
                                   {1.15 * s.leg_radius, s.leg_radius, s.leg_radius}, 0.5 * side,
                                   {Cap::flat, Cap::round, true, false});
            b.merge(leg, trunk);
        }
}

void add_tail(Builder& b, const DogShape& s) {
    const Point2d root{12 - s.trunk, -14},
        middle = root + (0.5 * s.tail) * direction(s.tail_angle),
        tip = middle + (0.5 * s.tail) * direction(s.tail_angle + s.tail_bend);
    b.limb(Label::tail, {root, middle, tip}, {s.tail_radius, s.tail_radius, 0.8 * s.tail_radius}, -1,
           {Cap::flat, Cap::round, true, false});
}

// Turned to the left, as large as the page allows.
void place(doodle::Figure& figure, int width, int height) {
    constexpr double margin = 30;
    Point2d low{1e9, 1e9}, high{-1e9, -1e9};
    for (const Part& part : figure.parts)
        for (const Point2d p : part.outline.points)
            low = {std::min(low.x, p.x), std::min(low.y, p.y)},
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    const Point2d size = high - low, middle = mix(low, high, 0.5);
    const double scale = std::min((width - 2 * margin) / size.x, (height - 2 * margin) / size.y);
    for (Part& part : figure.parts)
        for (Point2d& p : part.outline.points)
            p = {width / 2.0 - scale * (p.x - middle.x), height / 2.0 + scale * (p.y - middle.y)};
}

Hand even_hand() {
    Hand hand;
    hand.pen = 4;
    hand.gap = hand.again = hand.misplace = hand.pressure = hand.closure = 0;
    return hand;
}

} // namespace

DrawnDog draw_dog(const DogShape& shape, int width, int height) {
    Random random = Random::stream(1, 0);
    Builder b(random, "quadruped", "dog");
    const int trunk = b.region(Label::body, ellipse({0, 0}, shape.trunk, shape.girth), 0);
    add_head(b, shape, trunk);
    add_legs(b, shape, trunk);
    add_tail(b, shape);
    place(b.figure, width, height);
    Layer layer = draw_figure(b.figure, even_hand(), random, width, height);
    return {on_paper(layer.ink, random, Finish::screen), std::move(layer.labels)};
}

} // namespace pantin::figures
