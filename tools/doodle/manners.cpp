// SPDX-License-Identifier: MIT
// Ways of drawing that `variety` adds to a hand: open and repeated strokes, dashes, felt pens, shading,
// silhouettes, areas without outlines.
#include <algorithm>

#include "doodle/canvas.hpp"

namespace pantin::doodle {
namespace {

void silhouette(Hand& hand) {
    std::fill(hand.paints.begin(), hand.paints.end(), hand.ink);
    hand.filling = Filling::flat, hand.fill_all = hand.solid = true;
    hand.opacity = 1.0, hand.grain = 0.0;
    hand.second_ink = hand.ground;
}

void pale_areas(Hand& hand, Random& r) {
    const bool one = r.chance(0.5);
    for (Colour& paint : hand.paints)
        for (std::size_t c = 0; c < 3; ++c) paint[c] = 0.45f * paint[c] + 0.45f * 255.0f;
    if (one) std::fill(hand.paints.begin(), hand.paints.end(), hand.paints.front());
    hand.filling = r.chance(0.7) ? Filling::flat : Filling::wash;
    hand.fill_all = hand.solid = true, hand.outlines = false;
}

void shading(Hand& hand, Random& r) {
    std::fill(hand.paints.begin(), hand.paints.end(), hand.ink);
    hand.filling = Filling::hatched, hand.hatch = r.uniform(1.6, 4.0);
}

} // namespace

void vary_hand(Hand& hand, Random& r, const DoodleOptions& options) {
    const double size = std::min(options.width, options.height);
    switch (r.integer(0, 15)) {
    case 0:
    case 1:
    case 2:
        hand.open = r.uniform(0.3, 1.0);
        break;
    case 3:
    case 4: // sketched over and over
        hand.again = r.uniform(0.7, 1.0), hand.strokes = r.integer(1, 3), hand.open = r.uniform(0.0, 0.6);
        hand.wobble = std::max(hand.wobble, size * r.uniform(0.002, 0.005));
        hand.overshoot = size * r.uniform(0.005, 0.02);
        break;
    case 5:
        if (options.pen <= 0.0) hand.pen = size * r.uniform(0.018, 0.035);
        hand.opacity = 1.0;
        break;
    case 6:
        hand.dash = size * r.uniform(0.015, 0.05);
        break;
    case 7:
        silhouette(hand);
        break;
    case 8:
        pale_areas(hand, r);
        break;
    case 9:
        shading(hand, r);
        break;
    case 10: // straight strokes of a mouse
        hand.corners = size * r.uniform(0.012, 0.03), hand.overshoot = size * r.uniform(0.0, 0.015);
        hand.open = r.uniform(0.0, 0.5);
        break;
    case 11: // outlines far from closed
        hand.closure = r.uniform(0.05, 0.15), hand.misplace = size * r.uniform(0.006, 0.016);
        break;
    default:
        break;
    }
}

} // namespace pantin::doodle
