// SPDX-License-Identifier: MIT
// The chordal axis: L. Prasad, "Morphological analysis of shapes", 1997; with finely and evenly sampled
// outlines as in P. Borosán et al., "RigMesh: automatic rigging for part-based shape modeling and
// deformation", 2012, so that the triangles between the two sides of a limb are needles and lie across it.
//
// A triangle of the constrained Delaunay triangulation of the outline is terminal, a sleeve or a junction
// when two, one or none of its edges are the outline's. The axis joins the midpoints of the other edges, the
// chords, through the centre of a junction; a terminal triangle has none of it. Every corner of the outline
// makes a branch, so:
// 1. All behind a chord goes whose outline is hardly longer than the chord: the chord residual of R.
// Ogniewicz, M. Ilg, "Voronoi
//    skeletons: theory and applications", 1992, which the Voronoi skeleton goes by, too. It grows on every
//    way inwards, so that going triangle by triangle from the terminal ones finds all of it; a cycle never
//    opens.
// 2. That shortens thin limbs. They get back the branch with the most outline as far as it is longer than
// twice its chord, which
//    is half a width before a blunt tip, and up to where it forks. (T. Igarashi et al., "Teddy: a sketching
//    interface for 3D freeform design", 1999, prunes what lies in the half disc over a chord.) A head does
//    not grow back into its hair.
#include "skeletonization/chordal_ridges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "image/nearest_pixel.hpp"
#include "pantin/triangulation.hpp"
#include "skeletonization/outline.hpp"
#include "skeletonization/voronoi_skeleton.hpp"

namespace pantin {
namespace {

constexpr double blunt =
    2; // outline by chord of a tip without an axis; of a half disc it is π/2, of a half square 2
constexpr double forked = 0.5; // share of the larger branch from which on the smaller one counts
constexpr int smoothing_rounds =
    60; // of steps of half a pixel to one: a mean over three to five pixels to each side

struct Axis {
    std::vector<Point2d> nodes;
    std::vector<std::pair<int, int>> edges;

    int add(Point2d node) {
        nodes.push_back(node);
        return static_cast<int>(nodes.size()) - 1;
    }
    // By steps of at most a pixel, so that smoothing reaches equally far everywhere.
    void join(int a, int b) {
        const Point2d from = nodes[a], way = nodes[b] - from;
        const int steps = std::max(1, static_cast<int>(std::ceil(length(way))));
        for (int i = 1; i <= steps; ++i) {
            const int next = i < steps ? add(from + (static_cast<double>(i) / steps) * way) : b;
            edges.emplace_back(std::exchange(a, next), next);
        }
    }
};

bool inside(const Mask& mask, Point2i p) { return mask.value_or(p.x, p.y, 0) != 0; }

// Chords are not quite at right angles to the limb, so that their midpoints waver; Laplacian smoothing
// follows. Ends and junctions stay, and a cycle does not shrink into its hole.
void smooth(Axis& axis, const Mask& mask) {
    std::vector<int> degrees(axis.nodes.size());
    for (const auto& [a, b] : axis.edges) ++degrees[a], ++degrees[b];
    for (int round = 0; round < smoothing_rounds; ++round) {
        std::vector<Point2d> sums(axis.nodes.size());
        for (const auto& [a, b] : axis.edges) {
            sums[a] = sums[a] + axis.nodes[b];
            sums[b] = sums[b] + axis.nodes[a];
        }
        for (std::size_t i = 0; i < sums.size(); ++i) {
            const Point2d to = 0.5 * axis.nodes[i] + 0.25 * sums[i];
            if (degrees[i] == 2 && inside(mask, pixel_at(to))) axis.nodes[i] = to;
        }
    }
}

// The triangles with the outline's length of each and of what was cut off behind it.
class ChordalTriangles {
public:
    explicit ChordalTriangles(const Triangulation& triangulation)
        : triangulation_(triangulation), links_(triangulation.neighbours), outline_(links_.size()) {
        for (int t = 0; t < count(); ++t)
            for (int side = 0; side < 3; ++side)
                if (links_[t][side] < 0) outline_[t] += length_of(t, side);
    }

    void prune(double least_residual) {
        std::vector<int> leaves = all_leaves();
        while (!leaves.empty()) {
            const int leaf = leaves.back();
            leaves.pop_back();
            const int side = way_on(leaf);
            if (side < 0 || outline_[leaf] - length_of(leaf, side) >= least_residual)
                continue; // none: two tips have met
            const int next = links_[leaf][side];
            links_[leaf][side] = links_[next][side_between(next, leaf)] = -1;
            outline_[next] += outline_[leaf];
            if (degree(next) == 1) leaves.push_back(next);
        }
    }

    void lead_ends_out() {
        for (int leaf : all_leaves())
            for (int side = way_out(leaf); side >= 0; side = way_out(leaf)) {
                const int next = neighbour(leaf, side);
                if (outline_[next] <= blunt * length_of(leaf, side)) break;
                links_[leaf][side] = next;
                links_[next][side_between(next, leaf)] = leaf;
                leaf = next;
            }
    }

    // In pixels.
    Axis axis() const {
        Axis result;
        std::vector<std::array<int, 3>> middles(links_.size()); // nodes of the chords
        for (int t = 0; t < count(); ++t)
            for (int side = 0; side < 3; ++side) {
                const int n = links_[t][side];
                middles[t][side] =
                    n < 0   ? -1
                    : n < t ? middles[n][side_between(n, t)]
                            : result.add(0.5 / outline_units * (corner(t, side + 1) + corner(t, side + 2)));
            }
        for (int t = 0; t < count(); ++t) {
            std::vector<int> ends;
            std::copy_if(middles[t].begin(), middles[t].end(), std::back_inserter(ends),
                         [](int node) { return node >= 0; });
            if (ends.size() == 2) result.join(ends[0], ends[1]);
            if (ends.size() < 3) continue;
            const int middle = result.add(1.0 / outline_units * centre(t));
            for (const int end : ends) result.join(end, middle);
        }
        return result;
    }

private:
    int count() const { return static_cast<int>(links_.size()); }
    Point2d corner(int t, int i) const {
        return to_double(triangulation_.points[triangulation_.triangles[t][i % 3]]);
    }
    double length_of(int t, int side) const { return distance(corner(t, side + 1), corner(t, side + 2)); }
    int degree(int t) const {
        return static_cast<int>(
            std::count_if(links_[t].begin(), links_[t].end(), [](int n) { return n >= 0; }));
    }
    std::vector<int> all_leaves() const {
        std::vector<int> leaves;
        for (int t = 0; t < count(); ++t)
            if (degree(t) == 1) leaves.push_back(t);
        return leaves;
    }
    int neighbour(int t, int side) const { return triangulation_.neighbours[t][side]; }
    int side_between(int t, int other) const {
        const std::array<int, 3>& around = triangulation_.neighbours[t];
        return static_cast<int>(std::find(around.begin(), around.end(), other) - around.begin());
    }
    // The side of a leaf where the axis goes on; −1 when nothing is left.
    int way_on(int leaf) const {
        for (int side = 0; side < 3; ++side)
            if (links_[leaf][side] >= 0) return side;
        return -1;
    }
    // The side of a leaf behind which the most was cut off; −1 when nothing was, or as much behind another
    // one.
    int way_out(int leaf) const {
        int best = -1;
        double most = 0, second = 0;
        for (int side = 0; side < 3; ++side) {
            const int n = neighbour(leaf, side);
            if (n < 0 || links_[leaf][side] >= 0) continue;
            if (outline_[n] > most) best = side;
            second = std::max(second, std::min(most, outline_[n]));
            most = std::max(most, outline_[n]);
        }
        return second > forked * most ? -1 : best;
    }

    // The circumcentre where it lies inside, else the midpoint of the longest side, which is what it reaches
    // as the junction becomes obtuse: the axis does not jump.
    Point2d centre(int t) const {
        const Point2d a = corner(t, 0), u = corner(t, 1) - a, v = corner(t, 2) - a;
        for (int i = 0; i < 3; ++i) {
            const Point2d p = corner(t, i + 1), q = corner(t, i + 2);
            if (dot(p - corner(t, i), q - corner(t, i)) <= 0) return 0.5 * (p + q);
        }
        const double uu = dot(u, u), vv = dot(v, v);
        return a + (0.5 / cross(u, v)) * Point2d{v.y * uu - u.y * vv, u.x * vv - v.x * uu};
    }

    const Triangulation& triangulation_;
    std::vector<std::array<int, 3>> links_;
    std::vector<double> outline_;
};

} // namespace

Mask chordal_ridges(const Mask& mask, double least_residual) {
    Mask ridges(mask.width(), mask.height());
    const Triangulation triangulation = constrained_delaunay(smooth_outline(mask));
    ChordalTriangles triangles(triangulation);
    triangles.prune(least_residual * outline_units);
    triangles.lead_ends_out();
    Axis axis = triangles.axis();
    smooth(axis, mask);
    for (const auto& [a, b] : axis.edges)
        for (const Point2i p : straight_line(pixel_at(axis.nodes[a]), pixel_at(axis.nodes[b])))
            if (inside(mask, p)) ridges(p.x, p.y) = 1;
    return ridges;
}

} // namespace pantin
