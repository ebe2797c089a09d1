// SPDX-License-Identifier: MIT
// Triangles with links to their neighbours that can be flipped and split: what constrained triangulation and
// refinement work on.
#pragma once

#include <array>
#include <vector>

#include "pantin/geometry.hpp"
#include "pantin/triangulation.hpp"

namespace pantin {

class TriangleLinks {
public:
    struct Side { // the edge of `triangle` opposite its corner `corner`
        int triangle = -1, corner = 0;
    };
    struct Place { // where a point lies: in a triangle, on its side `on`, or hidden behind its side `behind`
                   // of the border
        int triangle = -1, on = -1, behind = -1;
    };

    std::vector<Point2i> points;
    std::vector<std::array<int, 3>> corners, neighbours;
    std::vector<std::array<char, 3>> fixed; // constrained sides, never flipped

    TriangleLinks(std::vector<Point2i> p, std::vector<std::array<int, 3>> t,
                  std::vector<std::array<int, 3>> n);

    int from(Side s) const { return corners[s.triangle][(s.corner + 1) % 3]; }
    int to(Side s) const { return corners[s.triangle][(s.corner + 2) % 3]; }
    Side opposite(Side s) const; // triangle −1 at the border
    // The side from a to b, or else from b to a; triangle −1 when there is none.
    Side find(int a, int b) const;
    // The triangles around a point, each as the side opposite to it, counter-clockwise; from the border on
    // when it lies there.
    std::vector<Side> around(int point) const;

    bool can_flip(Side s) const;              // the two triangles are a strictly convex quadrilateral
    void flip(Side s);                        // the new edge is the side `s.corner` + 1 of the same triangle
    void legalise(std::vector<Side> pending); // flips until every free edge is Delaunay (Lawson 1977)
    void legalise_all();

    // Visibility walk; on the way only the border stops it.
    Place locate(Point2i p, int start) const;
    // Splits the triangle, or the two beside the side that it is on. False, and nothing happens, when a new
    // triangle would not be positively oriented.
    bool insert(Point2i p, const Place& place);

private:
    void link(int triangle, int corner, int neighbour);
    bool positive(int a, int b, int c) const { return orientation(points[a], points[b], points[c]) > 0; }
    bool split_inside(int t, int p, std::vector<Side>& changed);
    bool split_side(Side s, int p, std::vector<Side>& changed);

    std::vector<int> triangle_of_; // one triangle of each point
};

} // namespace pantin
