// SPDX-License-Identifier: MIT
// Step 3 as a whole (thesis 4.4): silhouette → borders → Voronoi skeleton (or another one) → thinning → graph
// → heuristics.
#include "pantin/skeletonization.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "core/reference_scale.hpp"
#include "image/label_map.hpp"
#include "pantin/image.hpp"
#include "skeletonization/chordal_ridges.hpp"
#include "skeletonization/parts.hpp"
#include "skeletonization/straight_ridges.hpp"
#include "skeletonization/topology.hpp"
#include "skeletonization/voronoi_skeleton.hpp"

namespace pantin {
namespace {

constexpr double lowest_threshold =
    7; // at reference_side; below it the skeleton shows the pen, not the shape
constexpr long most_border_points =
    100'000; // a drawing has some thousand; each is a site of the Voronoi diagram

long area(const Mask& mask) { return std::count(mask.begin(), mask.end(), 1); }

// The largest component, holes up to the share of its area filled.
Mask silhouette(const LabelMap& labels, double fill_holes_share) {
    const Mask largest = largest_component(foreground(labels));
    const double limit = fill_holes_share * static_cast<double>(area(largest));
    if (limit < 1) return largest;
    return fill_holes(largest, fill_holes_share >= 1 ? max_image_pixels : static_cast<long>(limit));
}

// Every pixel of the mask with a part: filled holes take the nearest one. Nothing outside.
LabelMap labels_on(const Mask& mask, const LabelMap& labels) {
    bool missing = false;
    for (std::size_t i = 0; i < mask.size(); ++i) missing |= mask.data()[i] && labels.data()[i] == 0;
    LabelMap complete = missing ? nearest_labels(labels) : labels;
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (!mask.data()[i]) complete.data()[i] = 0;
    return complete;
}

void find_voronoi(Skeletonization& s, const BorderSites& sites, Residual residual) {
    for (const VoronoiEdge& edge : voronoi_edges(sites.points, delaunay(sites.points))) {
        if (edge.from == edge.to || !edge_inside(edge, s.mask)) continue;
        s.voronoi.push_back(edge);
        s.residuals.push_back(residual_between(sites, edge.site_a, edge.site_b, residual));
    }
}

bool takes_threshold(SkeletonMethod method) {
    return method == SkeletonMethod::voronoi || method == SkeletonMethod::chordal;
}

Mask ridges_of(const Skeletonization& s, const BorderSites& sites, double threshold, SkeletonMethod method) {
    switch (method) {
    case SkeletonMethod::voronoi:
        return rasterise(s.voronoi, s.residuals, sites, s.mask, threshold);
    case SkeletonMethod::straight:
        return straight_ridges(s.contour, s.mask);
    case SkeletonMethod::chordal:
        return chordal_ridges(s.mask, threshold);
    case SkeletonMethod::thinning:
        break;
    }
    return s.mask;
}

// From the ridges to the labelled graph.
void find_graph(Skeletonization& s, const BorderSites& sites, const LabelMap& parts, double threshold,
                const SkeletonizationOptions& options, double scale) {
    s.threshold = threshold;
    Mask ridges = ridges_of(s, sites, threshold, options.method);
    if (options.recover_parts_share > 0)
        ridges = anchor_missing_parts(ridges, s.mask, parts, options.recover_parts_share);
    s.voronoi_raster = restore_topology(ridges, s.mask, options.fill_pockets);
    Thinning thinning = zhang_suen_steps(s.voronoi_raster, options.thinning_stop);
    s.thinned = std::move(thinning.thinned);
    s.thinned_in = std::move(thinning.removed_in);
    // It deletes a 2×2 square as a whole; the shape then keeps its deepest pixel.
    if (area(s.thinned) == 0) s.thinned = restore_topology(s.thinned, s.mask);
    s.skeleton = remove_redundant_pixels(s.thinned);
    if (options.cut_cycles) s.skeleton = cut_cycles(s.skeleton, parts, options.merge_distance * scale);
    s.raw = extract_graph(s.skeleton, parts);
    s.after_h1 = apply_h1(s.raw);
    s.graph = apply_h2(s.after_h1, options.merge_distance * scale, options.merge_weighting);
}

} // namespace

Skeletonization skeletonize(const LabelMap& labels, const SkeletonizationOptions& options) {
    const double scale = reference_scale(labels.width(), labels.height());
    double threshold = options.residual_threshold * scale;

    Skeletonization s;
    s.mask = silhouette(labels, options.fill_holes_share);
    if (area(s.mask) == 0) throw CharacterRejected("skeletonize", "the silhouette is empty");
    s.contour = follow_borders(s.mask);
    long points = 0;
    for (const Border& border : s.contour) points += static_cast<long>(border.points.size());
    if (points > most_border_points)
        throw CharacterRejected("skeletonize", "the silhouette's border has " + std::to_string(points) +
                                                   " points; the limit is " +
                                                   std::to_string(most_border_points));
    const BorderSites sites = border_sites(s.contour, s.mask.width(), s.mask.height());
    if (options.method == SkeletonMethod::voronoi) find_voronoi(s, sites, options.residual);
    const LabelMap parts = labels_on(s.mask, labels);
    find_graph(s, sites, parts, threshold, options, scale);
    const bool lower = options.lower_threshold && takes_threshold(options.method);
    for (; lower && s.graph.edges.empty() && threshold / 2 > lowest_threshold * scale; threshold /= 2)
        find_graph(s, sites, parts, threshold / 2, options, scale);
    if (s.graph.vertices.empty() || (options.reject_point && s.graph.edges.empty()))
        throw CharacterRejected("skeletonize", "the skeleton is a single point");
    return s;
}

} // namespace pantin
