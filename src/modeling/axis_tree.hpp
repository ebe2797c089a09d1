// SPDX-License-Identifier: MIT
// From the straight skeleton of an outline to what of it is the axis of a shape.
#pragma once

#include <vector>

#include "pantin/modeling.hpp"
#include "pantin/straight_skeleton.hpp"

namespace pantin {

// A tree of joints, some of which may be gone.
struct AxisTree {
    std::vector<SubSkeleton::Joint> joints;
    std::vector<std::vector<int>> neighbours;

    int add(const SubSkeleton::Joint& joint) {
        joints.push_back(joint);
        neighbours.emplace_back();
        return static_cast<int>(joints.size()) - 1;
    }
    void join(int a, int b) {
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
    }
    // `gone` becomes `kept`, which moves to the place of `joint`.
    void merge(int kept, int gone, const SubSkeleton::Joint& joint);
};

// As printed: all edges but those that begin at the outline. RealSkel 3.1.
AxisTree printed_axis(const StraightSkeleton& skeleton);

// The edges behind which the shape reaches beyond the discs along them: the axes of its arms, sharp ones too.
// An arm ends where its disc reaches its tip; a shape without arms that is long has its long axis, a round
// one its widest place. Own (errata 23).
AxisTree contributing_axis(const StraightSkeleton& skeleton);

// The skeleton of a polygon with holes as a tree: a cycle is cut in the middle of its thinnest edge, whose
// halves end there, a quarter of it apart. No error. Own (errata 23).
StraightSkeleton without_cycles(StraightSkeleton skeleton);

// From p along the unit vector to the border, at most `farthest`.
double reach(const PartOutline& outline, Point2d p, Point2d direction, double farthest);
// Whether p lies inside the border and in no hole.
bool holds(const PartOutline& outline, Point2d p);
// Whether the way from a to b, a inside, touches the border.
bool leaves(const PartOutline& outline, Point2d a, Point2d b);
// The distance to the border.
double radius_at(const PartOutline& outline, Point2d p);

} // namespace pantin
