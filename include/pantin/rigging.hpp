// SPDX-License-Identifier: MIT
// Step 5 (thesis 4.6): end-effector mapping, mesh, bones, skin weights, texture coordinates.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/identification.hpp"
#include "pantin/point.hpp"
#include "pantin/skeletonization.hpp"

namespace pantin {

// --- end-effector mapping ----------------------------------------------------------------------------------

// M samples along the skeleton path between two end-effectors.
struct PathSamples {
    std::vector<double>
        radii;         // DT(p) / mean DT over the mask, at M points of equal arc length (Eq. 4.8, ERRATA 14)
    double length = 0; // of the path; in pixels, or divided by the mean DT (ERRATA 15)
};
// Σ (r − r')² / (r + r') + α (l − l')² / (l + l'), no unit; of as many samples as both have. No errors.
// Thesis Eq. 4.9; Bai & Latecki 2008.
double path_distance(const PathSamples& a, const PathSamples& b, double alpha);

enum class OsbForm { icdm2007, printed }; // Eq. 4.12, ERRATA 17
struct OsbResult {
    double cost = 0;
    std::vector<std::pair<int, int>> path; // matched (row, column), both ascending; may be empty
};
// The cheapest order-preserving matching of some rows with some columns of costs[i][j]; the cost in their
// unit, κ for a skipped row: that of Eq. 4.13 unless given (≥ 0). Error(internal) when the costs are not
// rectangular. Latecki et al. 2007; thesis Eq. 4.12, 4.13 (ERRATA 17).
OsbResult optimal_subsequence_bijection(const std::vector<std::vector<double>>& costs,
                                        OsbForm form = OsbForm::icdm2007, double jump_cost = -1);
// Minimum-cost assignment of costs[row][column]; rows and columns need not be as many. Result[i] = column of
// row i, −1 when unassigned (the shorter side is assigned completely). Error(internal) when the costs are not
// rectangular or not finite. Kuhn 1955, Jonker & Volgenant 1987; thesis Eq. 4.14 (ERRATA 18).
std::vector<int> hungarian(const std::vector<std::vector<double>>& costs);

// The path similarity alone is weak on parts: tails meet the right part 23 % of the time (ERRATA 19). With
// `label_aware` the assignment is found on
//     path_weight · c / mean c + position_weight · d² + trunk_weight · t² +
//     label_penalty · [other label] − prior_weight · [matched],
// c the similarity cost of the thesis, d the distance of the two ends, each in the bounding box of its own
// figure, t in the box of the body (places farther outside than 0.75 of its sides are clamped), and `matched`
// when identification matched the two. A pair of different labels is allowed only where it makes sense (a
// limb for a tail or a wing, a wing for a limb of a reference without wings, a body end for the head) and d ≤
// mixed_reach; every other one costs `unmatched_cost` and is dropped after the assignment. Pairs of one label
// are then put into cyclic order, so that no two limbs cross.
struct MappingOptions {
    int samples = 50;              // M
    double alpha = 0.1;            // thesis 4.6
    bool length_in_pixels = false; // `thesis`: true; default divides by the mean DT (ERRATA 15)
    OsbForm osb = OsbForm::icdm2007;
    bool label_aware = true; // `thesis`: false, none of the following is used
    double path_weight = 0.5;
    double position_weight = 4;
    double trunk_weight = 1;
    double prominence_weight = 2;
    double label_penalty = 8; // above every difference of places
    double prior_weight = 0.5;
    double mixed_reach = 0.4;
    double unmatched_cost = 12;
};
// What Eq. 4.9 to 4.13 find for one end-effector of the character and one of the reference (Fig. 4.15, 4.16).
struct EndComparison {
    std::vector<std::vector<double>>
        distances; // of the paths from the one (rows) to those from the other (columns), Eq. 4.11
    OsbResult osb; // its cost is the similarity cost of the two ends
};
struct EndPair {
    int end = 0;           // skeleton vertex
    int reference_end = 0; // reference node
    double cost = 0;       // its entry of `costs`
};
struct Mapping {
    std::vector<int> ends;                  // the character's end-effectors, clockwise (Algorithm 4.2)
    std::vector<int> reference_ends;        // the reference's, clockwise
    std::vector<std::vector<double>> costs; // [ends][reference_ends], what the assignment minimises
    std::vector<EndPair> pairs;             // ascending by end
    std::vector<int> unmatched_ends;        // skeleton vertices without a partner, ascending
    // How the costs came about; empty in a mapping that was read from a file. paths[i][k]: from the i-th end
    // to the (i + 1 + k)-th, cyclically.
    std::vector<std::vector<PathSamples>> paths, reference_paths;
    std::vector<std::vector<EndComparison>> comparisons; // [ends][reference_ends]
};
// `labels` has the size of the graph; `match` is the candidate that identification chose for `reference`.
// Pairs may be none; no errors. Thesis 4.6, Algorithms 4.2 and 4.3, Eq. 4.8 to 4.14 (ERRATA 14 to 19).
Mapping map_end_effectors(const SkeletonGraph& graph, const LabelMap& labels,
                          const ReferenceSkeleton& reference, const Candidate& match,
                          const MappingOptions& options = {});

// --- mesh ---------------------------------------------------------------------------------------------

struct Mesh {
    std::vector<Point2d> vertices;       // working pixels
    std::vector<std::vector<int>> faces; // 3 to 6 corners, convex at rest, clockwise on screen (y down)
    // Of marching squares, per face: which corners of its voxel lie inside, 1 top left, 2 top right, 4 bottom
    // right, 8 bottom left, so 1 … 15 (Fig. 4.17); else empty.
    std::vector<std::uint8_t> cases{};
};
enum class MeshMethod {
    marching_squares, // the voxel-based mesh of the thesis
    voronoi_regions   // what it is compared with in Fig. 4.18(b); takes the margin alone of the options below
};
struct MeshOptions {
    MeshMethod method = MeshMethod::marching_squares;
    int cell = 0; // side of a voxel in working pixels; 0: from the size and the thinnest limb (ERRATA 21)
    double margin = -1; // the silhouette is grown by this many pixels first; −1: `ink_margin`; `thesis`: 0
    bool interpolate_distance = true; // `thesis`: false, the midpoint
    double snap =
        0.35; // share of the cell: a voxel corner so close to the border is moved onto it; `thesis`: 0
    bool cut_touching_parts = true; // ERRATA 22; `thesis`: false
};
// Marching squares quad mesh (thesis 4.6, Fig. 4.17; Maple 2003) of the silhouette grown by `options.margin`
// (negative: 0). Voxel corners lie at multiples of the cell. Every vertex is shared, no two lie at one place,
// every edge has one or two faces. With `cell` 0 the cell starts at side/64 and shrinks until the mesh has as
// many pieces as the grown silhouette and all its holes of more than four voxels (or the cell is 2). Vertices
// in pixels of the silhouette. No errors; an empty silhouette gives an empty mesh.
Mesh marching_squares(const Mask& silhouette, const MeshOptions& options);

// The Voronoi regions of the border's pixels inside the silhouette (thesis 4.6, Fig. 4.18(b)) grown by
// `margin` pixels (negative: 0), each cut into a fan of triangles about its site. Borders run 1/4 pixel
// inside the pixels' outer sides. Vertices and edges are shared as above; pieces and holes are those of the
// grown silhouette. About four vertices and six faces a border pixel, long and thin: such a mesh tears where
// weights differ, which is why it is not the default. Vertices in pixels of the silhouette. No errors; an
// empty silhouette gives an empty mesh.
Mesh voronoi_mesh(const Mask& silhouette, double margin = 0);

// The mesh of one of the two, by the method of the options; vertices in pixels of the silhouette. No errors.
// Thesis 4.6.
Mesh make_mesh(const Mask& silhouette, const MeshOptions& options);

// Half of a pen's stroke may lie outside a silhouette whose border runs along the stroke's middle. Mesh and
// texture reach this many working pixels beyond it: 1.2 % of the longer side of a crop of width × height
// pixels, at least 2. No errors. Own.
double ink_margin(int width, int height);

// --- bones and weights --------------------------------------------------------------------------------

// Bone i turns about `head` and reaches to `tail`. The root bone (index 0) is the body.
struct Bone {
    std::string name;   // "hips", "leg_front_left", "leg_front_left.1" (next segment outward), …
    int parent = -1;    // parents come first
    Point2d head, tail; // working pixels
    Label label = Label::body;
    int reference_joint = -1; // which reference joint drives it; −1: it rests on its parent
    int segment = 0;          // 0 = innermost segment of its limb
    bool mirrored = false;    // rotations in the plane change sign
    double phase_shift = 0;   // in cycles: an unmatched limb follows its neighbour half a cycle later
    double freedom = 1;       // share of a clip's amplitude that suits the limb's shape, 0 … 1
    double head_depth = 0, tail_depth = 0; // z at rest in world units; 0 in a drawing
};
struct VertexWeights {
    std::array<int, 4> bones{};      // unused: 0
    std::array<double, 4> weights{}; // non-negative multiples of 2^-16, descending, sum exactly 1
};
// The set EF of Algorithm 4.4, among which a vertex belongs to the nearest: the ends that have a partner in
// the reference, or all ends of the skeleton (an end without a partner then keeps its vertices for the body).
enum class WeightEnds { mapped, all };

struct RigOptions {
    MappingOptions mapping;
    MeshOptions mesh;
    bool thesis_weights = false;                 // Algorithm 4.4, one bone per end-effector
    WeightEnds weight_ends = WeightEnds::mapped; // of `thesis_weights`; `thesis`: all
    int limb_segments = 2; // bones per limb, wing or tail (1 to 4), a short one has 1; `thesis`: 1
};
struct Rig {
    int width = 0, height = 0; // of the working crop
    Mapping mapping;
    Mesh mesh;
    std::vector<Bone> bones;
    std::vector<VertexWeights> weights; // per mesh vertex
    std::vector<Point2d> texture;       // per mesh vertex, [0, 1] inside the crop, v down
    std::vector<double> depth; // per mesh vertex, z at rest in world units: small offsets for the draw order
    std::vector<Rgb8> colours; // per mesh vertex, of a solid that no drawing is projected on; else empty
    bool solid = false; // a closed surface in 3D (modeling), which is lit; else a flat drawing, which is not
};
// Step 5 as a whole (thesis 4.6): mapping, mesh, bones, weights. `labels` has the size of the graph; the rig
// is in its pixels. Throws CharacterRejected("rig", …) when no end-effector can be mapped (with
// `thesis_weights` the body is then the only bone) or the silhouette
// is empty; Error(input) when the identified reference is none of the references.
Rig rig(const SkeletonGraph& graph, const LabelMap& labels, const Identification& identification,
        const std::vector<ReferenceSkeleton>& references, const RigOptions& options = {});
// The same for a given mapping (mapping.json, corrected by hand). `mirrored`: the reference left for right.
// Throws CharacterRejected as above. Thesis 4.6, Algorithm 4.4 with `thesis_weights`; else own.
Rig rig_with_mapping(const SkeletonGraph& graph, const LabelMap& labels, const ReferenceSkeleton& reference,
                     bool mirrored, const Mapping& mapping, const RigOptions& options = {});

} // namespace pantin
