// SPDX-License-Identifier: MIT
// Labelled figures painted from thick lines, for the tests of identification and mapping.
#pragma once

#include <algorithm>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/label.hpp"
#include "pantin/point.hpp"

namespace pantin::figures {

struct Stroke {
    Label label;
    Point2d from, to;
    double radius;
};

inline LabelMap paint(int width, int height, const std::vector<Stroke>& strokes) {
    LabelMap labels(width, height);
    for (const Stroke& s : strokes)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const Point2d p{double(x), double(y)}, d = s.to - s.from;
                const double t = dot(d, d) > 0 ? std::clamp(dot(p - s.from, d) / dot(d, d), 0.0, 1.0) : 0;
                if (distance(p, s.from + t * d) <= s.radius)
                    labels(x, y) = static_cast<std::uint8_t>(s.label);
            }
    return labels;
}

inline LabelMap mirrored(const LabelMap& labels) {
    LabelMap out(labels.width(), labels.height());
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x) out(labels.width() - 1 - x, y) = labels(x, y);
    return out;
}

inline std::vector<Stroke> humanoid() {
    return {{Label::limb, {100, 85}, {45, 115}, 7},   {Label::limb, {100, 85}, {155, 115}, 7},
            {Label::limb, {95, 145}, {75, 225}, 8},   {Label::limb, {105, 145}, {125, 225}, 8},
            {Label::body, {100, 85}, {100, 145}, 20}, {Label::head, {100, 40}, {100, 45}, 24}};
}
// Facing left.
inline std::vector<Stroke> quadruped() {
    return {{Label::limb, {70, 110}, {60, 180}, 7},   {Label::limb, {85, 110}, {95, 180}, 7},
            {Label::limb, {170, 110}, {160, 180}, 7}, {Label::limb, {180, 110}, {195, 180}, 7},
            {Label::tail, {190, 95}, {235, 70}, 5},   {Label::body, {75, 100}, {180, 100}, 24},
            {Label::head, {40, 60}, {50, 70}, 20}};
}
// Seen from above, wings out.
inline std::vector<Stroke> flyer() {
    return {{Label::wing, {110, 100}, {30, 60}, 14},  {Label::wing, {130, 100}, {210, 60}, 14},
            {Label::limb, {112, 150}, {100, 195}, 4}, {Label::limb, {128, 150}, {140, 195}, 4},
            {Label::tail, {120, 150}, {120, 210}, 6}, {Label::body, {120, 95}, {120, 150}, 16},
            {Label::head, {120, 25}, {120, 75}, 13}};
}

} // namespace pantin::figures
