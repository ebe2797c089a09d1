// SPDX-License-Identifier: MIT
// Step 3 (thesis 3.4, 4.4): part labels to the skeleton graph.
#pragma once

#include <cstdint>
#include <vector>

#include "pantin/geometry.hpp"
#include "pantin/grid.hpp"
#include "pantin/label.hpp"
#include "pantin/point.hpp"

namespace pantin {

enum class Residual {
    arc,   // contour length between the two sites: what the thesis describes (ERRATA 1)
    chord, // minus the straight distance: Ogniewicz & Ilg's chord residual
};

// Where the ridges come from that Zhang and Suen's thinning makes one pixel wide.
enum class SkeletonMethod {
    voronoi,  // edges of the Voronoi diagram of the border's pixels with a large residual (thesis 4.4)
    straight, // inner arcs of the straight skeleton of the simplified borders (Ma et al. 2021, 3.1)
    thinning, // the whole silhouette
    chordal   // midpoints of the chords of the smoothed borders' triangulation (Prasad 1997; Borosán et al.
              // 2012)
};

// When the thinning has come to its end: after an iteration both halves of which deleted nothing (Zhang and
// Suen), or after the first half that did, as Algorithm 4.1 has it (lines 11 and 21).
enum class ThinningStop { both, either };

// Where H2 puts a vertex that two become: in the middle, as Eq. 4.2 has it; nearer to the one with more
// edges; or at the centroid of all vertices that have become one, however many there were.
enum class MergeWeighting { equal, edges, vertices };

struct SkeletonizationOptions {
    SkeletonMethod method = SkeletonMethod::voronoi;
    Residual residual = Residual::chord; // `thesis`: arc
    double residual_threshold =
        30; // voronoi, chordal; at 321 px, scales with the longer side of the mask (thesis ch. 5)
    double merge_distance = 5; // ε of H2 at 321 px, scales likewise (thesis 4.4)
    MergeWeighting merge_weighting = MergeWeighting::equal; // Eq. 4.2
    double fill_holes_share =
        0.02; // holes smaller than this share of the shape are filled; `thesis`: 0 (ERRATA 4)
    // A head, limb, tail or wing of at least this share of the shape that no ridge enters gets a branch; 0
    // (`thesis`): none. Parts with a vertex of their own, on 317 label maps and 221 labelled stroke drawings:
    // limbs .919 → .949 and .965 → .986, tails .848 → .975 and .889 → 1.0, wings .884 → .899 and .875 → .938,
    // for 0.1 more ends a figure; identification stays as it was (five folds, 480 drawings: .935 → .931).
    double recover_parts_share = 0.005;
    // Limbs, tails or wings that touch are cut apart where they are farthest from the body, since a cycle has
    // no end that could move (11 of 562 figures); `thesis`: false.
    bool cut_cycles = true;
    ThinningStop thinning_stop = ThinningStop::both; // `thesis`: either
    // Ridges that run beside each other enclose pixels of the shape, which thinning keeps as small cycles.
    // They are filled before; `thesis`: false.
    bool fill_pockets = true;
    // A shape whose skeleton is a single point (a round duck) gets half the threshold, again and again;
    // `thesis`: false.
    bool lower_threshold = true;
    // A skeleton that is a single point after H1 and H2 has nothing that could move: no character. `thesis`:
    // false, it rests.
    bool reject_point = true;
};

struct SkeletonVertex {
    double x = 0, y = 0;
    Label label = Label::body;
    bool end = false; // end-effector (degree 1), else junction
    bool operator==(const SkeletonVertex&) const = default;
};
// In pixels of the working crop. No errors. Own.
inline Point2d position_of(const SkeletonVertex& v) { return {v.x, v.y}; }
struct SkeletonEdge {
    int u = 0, v = 0;            // u < v
    double length = 0;           // sum of the steps of `pixels`
    std::vector<Point2i> pixels; // from u to v
    bool operator==(const SkeletonEdge&) const = default;
};
struct SkeletonGraph {
    int width = 0, height = 0; // of the working crop
    std::vector<SkeletonVertex> vertices;
    std::vector<SkeletonEdge> edges;
    bool operator==(const SkeletonGraph&) const = default;
};

// Everything that Figures 3.14, 4.9, 4.11 and 4.12 show.
struct Skeletonization {
    Mask mask; // largest component of the silhouette, holes filled
    std::vector<Border> contour;
    std::vector<VoronoiEdge> voronoi; // all edges inside the mask
    std::vector<double> residuals;    // per Voronoi edge
    double threshold =
        0; // of residuals, in pixels of the mask; as asked for, or lowered (options.lower_threshold)
    Mask voronoi_raster; // edges over the threshold (or the other method's ridges), homotopic to the mask
    Mask thinned;        // after Zhang–Suen
    Grid<std::uint16_t>
        thinned_in; // the sub-iteration, 1, 2, …, that took a pixel of `voronoi_raster` away; 0: none did
    Mask skeleton;  // after removal of redundant pixels and cutting of cycles
    SkeletonGraph raw, after_h1, graph; // `graph`: after H1 and H2
};

// Step 3 as a whole (thesis 4.4). `labels`: working size, any sides; ≠ 0 is the silhouette, of which the
// largest component counts. The skeleton is homotopic to the mask before cycles are cut, so it is connected.
// A silhouette with neither end nor junction (a ring) gives a triangle. Throws
// CharacterRejected("skeletonize", …) when the silhouette is empty, its borders have more than 100,000
// points, or, with `reject_point`, the skeleton shrinks to a single point after H1 and H2 (a disc, a head
// alone).
Skeletonization skeletonize(const LabelMap& labels, const SkeletonizationOptions& options = {});

// --- the sub-steps, each usable alone; masks and label maps of one size ------------------------------------

struct Thinning {
    Mask thinned;
    Grid<std::uint16_t> removed_in; // sub-iteration, 1, 2, …; odd ones test C_c and C_d, even ones C_c' and
                                    // C_d'; 0: kept, or background
};
// Thinning of a mask, outside of which is background. No errors. Zhang & Suen 1984, as Algorithm 4.1 of the
// thesis with ERRATA 5.
Thinning zhang_suen_steps(const Mask& mask, ThinningStop stop = ThinningStop::both);
// Its result alone, of the mask's size. No errors. Algorithm 4.1.
Mask zhang_suen(const Mask& mask, ThinningStop stop = ThinningStop::both);
// The skeleton without the pixels of staircases that thinning leaves and that connect nothing, of its size.
// No errors. Own (ERRATA 6).
Mask remove_redundant_pixels(const Mask& skeleton);
// The graph of a skeleton that is one pixel wide: vertices in the order of junctions, ends and loops, each in
// raster order; edges by (u, v). A vertex has the label of its pixel. Lengths in pixels. No errors; an empty
// skeleton gives an empty graph. Thesis 4.4.
SkeletonGraph extract_graph(const Mask& skeleton, const LabelMap& labels);
// The graph without ends in head and body, where C_1 to C_3 hold, again and again. No errors. Thesis 4.4, H1,
// Fig. 4.11 (ERRATA 7).
SkeletonGraph apply_h1(const SkeletonGraph& graph);
// The graph with vertices of one label closer than `merge_distance` (pixels) made one, the closest pair
// first; the weighting says where, in the middle of both unless told otherwise. No errors. Thesis 4.4, H2,
// Eq. 4.1 and 4.2, Fig. 4.12 (ERRATA 7).
SkeletonGraph apply_h2(const SkeletonGraph& graph, double merge_distance,
                       MergeWeighting weighting = MergeWeighting::equal);

} // namespace pantin
