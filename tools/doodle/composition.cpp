// SPDX-License-Identifier: MIT
// Figures in page coordinates in; ink, part labels and instances of the page out.
#include "doodle/composition.hpp"

#include <algorithm>
#include <cmath>

namespace pantin::doodle {

Composition::Composition(int width, int height, const Colour& ground)
    : ink(width, height, ground), ground_(ground) {
    page.labels = LabelMap(width, height);
    page.instances = GreyImage(width, height);
}

// On a canvas that the figure fits on, with the margin that an unsteady hand needs.
Composition::Drawn Composition::draw_apart(Figure& figure, const Hand& hand, Random& random) const {
    double x0 = 1e9, y0 = 1e9, x1 = -1e9, y1 = -1e9;
    for (const Part& part : figure.parts)
        for (Point2d p : part.within < 0 ? part.outline.points : Path{})
            x0 = std::min(x0, p.x), x1 = std::max(x1, p.x), y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
    const double margin = 4.0 + 3.0 * hand.pen + hand.overshoot + 4.0 * hand.misplace;
    Drawn drawn;
    drawn.left = static_cast<int>(std::floor(x0 - margin)),
    drawn.top = static_cast<int>(std::floor(y0 - margin));
    const Point2d shift{static_cast<double>(drawn.left), static_cast<double>(drawn.top)};
    for (Part& part : figure.parts)
        for (Point2d& p : part.outline.points) p = p - shift;
    drawn.layer = draw_figure(figure, hand, random, static_cast<int>(x1 + margin - shift.x) + 1,
                              static_cast<int>(y1 + margin - shift.y) + 1);
    return drawn;
}

// Ink over ink; inside a silhouette what was drawn before is hidden. Returns the box of what was laid.
Box Composition::lay(const Drawn& drawn, std::uint8_t id) {
    const int w = ink.width(), h = ink.height();
    int x0 = w, y0 = h, x1 = -1, y1 = -1;
    for (int y = 0; y < drawn.layer.ink.height(); ++y)
        for (int x = 0; x < drawn.layer.ink.width(); ++x) {
            const int px = drawn.left + x, py = drawn.top + y;
            if (!ink.contains(px, py)) continue;
            const Colour& colour = drawn.layer.ink(x, y);
            const std::uint8_t label = drawn.layer.labels(x, y);
            if (label == 0 && colour == ground_) continue;
            Colour& there = ink(px, py);
            for (std::size_t k = 0; k < 3; ++k)
                there[k] =
                    label != 0 ? colour[k] : std::clamp(there[k] + colour[k] - ground_[k], 0.0f, 255.0f);
            if (label != 0) page.labels(px, py) = label, page.instances(px, py) = id;
            if (label == 0 && id != 0) continue;
            x0 = std::min(x0, px), x1 = std::max(x1, px), y0 = std::min(y0, py), y1 = std::max(y1, py);
        }
    return x1 < 0 ? Box{} : Box{x0, y0, x1 - x0 + 1, y1 - y0 + 1};
}

void Composition::add_character(Figure figure, const std::string& pose, const Hand& hand, Random& random) {
    const Drawn drawn = draw_apart(figure, hand, random);
    const Box box = lay(drawn, static_cast<std::uint8_t>(page.characters.size() + 1));
    page.characters.push_back({figure.type, figure.species, pose, box, drawn.layer.limbs});
}

void Composition::add_thing(Figure figure, const Hand& hand, Random& random) {
    const Box box = lay(draw_apart(figure, hand, random), 0);
    page.things.push_back({figure.type, figure.species, "S", box, -1});
}

} // namespace pantin::doodle
