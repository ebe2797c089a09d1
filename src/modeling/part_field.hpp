// SPDX-License-Identifier: MIT
// How far a point is from an inflated part, as a function that unite() samples.
#pragma once

#include <algorithm>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/model.hpp"

namespace pantin {

struct Box3 {
    Vec3 low, high;
    bool holds(Vec3 p) const {
        return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y && p.z >= low.z &&
               p.z <= high.z;
    }
    void include(Vec3 p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
};

class PartField {
public:
    // spacing: of the table of the half thickness; least: half thickness of the part all over but for its
    // rim, which is round; model's units, at most 3 spacings.
    PartField(const InflatedPart& part, double spacing, double least = 0);

    const Box3& box() const { return box_; } // of the part in the model's frame
    // Negative inside, positive outside, zero on the surface; near it about the distance, model's units.
    double operator()(Vec3 p) const;

private:
    void tabulate(const Inflation& inflation);
    void continue_outside(const Inflation& inflation, double least);

    Frame frame_;
    double size_ = 1, height_ = 1, spacing_ = 1; // size: of a canvas unit in the model; spacing on the canvas
    double slope_ = 1;                           // of the squared thickness beyond the outline
    Point2d corner_;
    Grid<double> squared_; // as Inflation::squared; negative outside the outline
    Box3 box_;
};

} // namespace pantin
