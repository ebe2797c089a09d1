// SPDX-License-Identifier: MIT
// Where parts are thinner than the lattice of unite() can hold, and what is put there instead.
#pragma once

#include <vector>

#include "modeling/part_field.hpp"

namespace pantin {

// A round bar with round ends along a stretch of a part's axis.
class ThinBar {
public:
    ThinBar(Vec3 from, Vec3 to, double radius, int part);
    const Box3& box() const { return box_; } // of what is near, as PartField::box()
    int part() const { return part_; }
    double operator()(Vec3 p) const; // distance to the surface, negative inside; model's units

private:
    Vec3 from_, to_;
    double radius_;
    int part_;
    Box3 box_;
};

// Of the bars: a lattice of that cell holds such a bar with all of its axis, whatever its direction (measured
// by tests/modeling/thin_parts_test.cpp). Model's units. No error. Own.
double least_radius(double cell);

// Half the thickness of a part that is wide but too flat for the lattice: at least that of a bar
// (PartField); 0 for every other part. No error. Own.
double least_half_thickness(const InflatedPart& part, double cell);

// Bars along the axes of the parts that would be lost on the lattice, as a whole or over a length of some
// cells; there they lie wherever the part is thinner than a bar and no other part lies about it. `fields` are
// those of the parts. Where such a part hangs on another one a bar leads there, unless
// there is a gap wider than a bar. In the order of the parts. No error. Own.
std::vector<ThinBar> thin_bars(const std::vector<InflatedPart>& parts, const std::vector<PartField>& fields,
                               double cell);

} // namespace pantin
