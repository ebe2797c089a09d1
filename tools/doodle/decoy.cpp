// SPDX-License-Identifier: MIT
// What a page may hold besides characters: a head alone, a blob, a scribble.
#include "core/math.hpp"
#include "doodle/figure.hpp"

namespace pantin::doodle {

Figure build_decoy(Random& random, const std::string& type) {
    Builder b(random, type, type);
    b.figure.heading = 0.5 * math::pi;
    if (type == "head") {
        const Frame frame{{0, 0}, random.uniform(18, 24), random.uniform(20, 26), 0};
        const int head = b.region(Label::head, ellipse(frame.centre, frame.rx, frame.ry), 1);
        add_frontal_face(b, head, frame);
        add_hair(b, head, frame);
    } else if (type == "blob") {
        Path points;
        const int n = random.integer(5, 8);
        for (int i = 0; i < n; ++i)
            points.push_back(random.uniform(16, 26) * direction(2 * math::pi * i / n));
        b.region(Label::body, spline(points, true, 8), 0);
    } else { // one long line that goes astray
        Path points;
        for (int i = 0, n = random.integer(12, 20); i < n; ++i) {
            const double x = random.uniform(-30, 30);
            points.push_back({x, random.uniform(-20, 20)});
        }
        b.stick(Label::body, spline(points, false, 10), 0, 1.0);
    }
    return std::move(b.figure);
}

} // namespace pantin::doodle
