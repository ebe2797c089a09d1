// SPDX-License-Identifier: MIT
// A view, moves and a symmetry in, the frame of a part's canvas out (strokes.hpp; RealSkel 4.1, utilities).
#include "modeling/frames.hpp"

#include <algorithm>

#include "core/math.hpp"

namespace pantin {

Frame frame_of(Viewpoint view, Point2d origin, double depth) {
    Frame frame;
    if (view == Viewpoint::side) frame = {{}, {0, 0, -1}, {0, -1, 0}, {1, 0, 0}};
    if (view == Viewpoint::top) frame = {{}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
    frame.origin = depth * frame.out - origin.x * frame.right - origin.y * frame.down;
    return frame;
}

Frame moved(const Frame& frame, Vec3 centre, const MovePart& move) {
    const double angle = move.degrees * math::pi / 180, cosine = math::cos(angle), sine = math::sin(angle);
    const Vec3 axis{move.axis == 'x' ? 1.0 : 0.0, move.axis == 'y' ? 1.0 : 0.0, move.axis == 'z' ? 1.0 : 0.0};
    const auto turned = [&](Vec3 v) { // Rodrigues' formula
        return move.scale * (cosine * v + sine * cross(axis, v) + (1 - cosine) * dot(axis, v) * axis);
    };
    return {centre + turned(frame.origin - centre) + move.translate, turned(frame.right), turned(frame.down),
            turned(frame.out)};
}

Frame mirrored(const Frame& frame, Symmetry symmetry) {
    const Vec3 sign{symmetry == Symmetry::x ? -1.0 : 1.0, symmetry == Symmetry::y ? -1.0 : 1.0,
                    symmetry == Symmetry::z ? -1.0 : 1.0};
    const auto flipped = [&](Vec3 v) { return Vec3{sign.x * v.x, sign.y * v.y, sign.z * v.z}; };
    return {flipped(frame.origin), flipped(frame.right), flipped(frame.down), flipped(frame.out)};
}

Point2d middle_of(const std::vector<Point2d>& points) {
    Point2d low = points.front(), high = low;
    for (const Point2d& p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return 0.5 * (low + high);
}

} // namespace pantin
