// SPDX-License-Identifier: MIT
// The surface where a function that is known on a body-centred cubic lattice changes its sign, by marching
// tetrahedra (Doi & Koide 1991). In a tetrahedron the surface is flat and cannot be cut in two ways, so it is
// closed and never meets itself. Lattice points that are close to the surface are moved onto it, as in
// isosurface stuffing (Labelle & Shewchuk 2007), so that triangles are well shaped; not where the surface
// would touch itself.
#pragma once

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "pantin/model.hpp"

namespace pantin {

class TetrahedraLattice {
public:
    TetrahedraLattice(Vec3 low, Vec3 high, double cell); // the surface must lie inside
    // Calls visit(place, value) for every lattice point in the box; values are infinite at first, negative
    // ones are inside.
    template <class Visit> void each(Vec3 low, Vec3 high, const Visit& visit) {
        for (int odd = 0; odd < 2; ++odd) {
            const Range x = range(low.x, high.x, origin_.x, count_[0], odd),
                        y = range(low.y, high.y, origin_.y, count_[1], odd),
                        z = range(low.z, high.z, origin_.z, count_[2], odd);
            for (int k = z.first; k <= z.last; ++k)
                for (int j = y.first; j <= y.last; ++j)
                    for (int i = x.first; i <= x.last; ++i)
                        visit(rest({2 * i + odd, 2 * j + odd, 2 * k + odd}),
                              values_[index({2 * i + odd, 2 * j + odd, 2 * k + odd})]);
        }
    }
    using Field = std::function<double(Vec3)>;
    SolidMesh surface(const Field& field);

private:
    struct Node { // twice the coordinates in cells: all even, a corner, or all odd, a centre
        int x = 0, y = 0, z = 0;
    };
    struct Range {
        int first, last;
    };
    Range range(double low, double high, double origin, int count, int odd) const;
    std::uint32_t index(Node n) const {
        const int odd = n.x & 1;
        return static_cast<std::uint32_t>(
                   2 *
                   ((static_cast<std::size_t>(n.z >> 1) * (count_[1] + 1) + (n.y >> 1)) * (count_[0] + 1) +
                    (n.x >> 1))) +
               odd;
    }
    Vec3 rest(Node n) const {
        return origin_ +
               0.5 * cell_ *
                   Vec3{static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)};
    }

    using Index = std::uint32_t;
    using Corner = std::uint64_t; // of the surface: a lattice edge (two indices), or a lattice point that
                                  // lies on it (twice its index)
    using Tetrahedron = std::array<Index, 4>;
    using Piece = std::array<Corner, 3>;

    bool inside(Index n) const { return values_[n] < 0 && snapped_[n] == 0; }
    Node node(Index n) const;
    bool holds(Node n) const;
    void find_crossings(const Field& field);
    double crossing(Vec3 from, double value, Vec3 to, double other, const Field& field) const;
    void snap();
    bool is_simple(Index n) const;
    void collect(std::vector<Tetrahedron>& active) const;
    std::vector<Piece> pieces(const std::vector<Tetrahedron>& active) const;
    int release_bad(const std::vector<Piece>& pieces);
    Vec3 place_of(Corner corner) const;

    Vec3 origin_;
    double cell_;
    int count_[3]; // cells
    std::vector<double> values_;
    std::vector<Index>
        snapped_; // per point: 1 + the other end of the edge on whose crossing it lies; 0: it is where it was
    std::unordered_map<Corner, double>
        crossed_; // lattice edges that the surface crosses: share of the way from the smaller index
};

} // namespace pantin
