// SPDX-License-Identifier: MIT
// Where the thesis (4.6) has one bone per end-effector, between the end and its neighbour in the graph, the
// limbs here run along the skeleton's pixels from where they leave the body, so that bones can follow bent
// limbs and weights can be measured along them. Unmatched end-effectors become side branches of a limb, or
// followers of their nearest mapped neighbour of the same label.
#include "rigging/limbs.hpp"

#include <algorithm>
#include <cmath>

#include "image/nearest_pixel.hpp"
#include "rigging/branches.hpp"
#include "rigging/limb_references.hpp"
#include "rigging/part_components.hpp"

namespace pantin {
namespace {

// An unmatched branch shorter than this share of the limb beyond the fork, or of the whole limb, is a side
// branch.
constexpr double side_branch_share = 0.6, side_branch_share_of_limb = 0.4;
// A stem shared by two limbs and shorter than this share of both branches counts as body.
constexpr double stub_share = 0.35;
// A part without end-effector is a limb from this share of the silhouette on, if this share of its border
// meets the background (a folded wing inside the body does not move).
constexpr double part_share = 0.005, free_border = 0.35;

// The limbs so far, and the branch of each.
struct LimbTree {
    Limbs result;
    std::vector<Branch> branches; // parallel to result.limbs
};

void set_path(Limb& limb, std::vector<Point2d> path) {
    limb.path = std::move(path);
    limb.position.assign(1, 0);
    for (std::size_t i = 1; i < limb.path.size(); ++i)
        limb.position.push_back(limb.position.back() + distance(limb.path[i - 1], limb.path[i]));
}

// From the attachment outwards.
std::vector<Point2d> outward_path(const Branch& branch) {
    std::vector<Point2d> path(branch.path->points.begin(), branch.path->points.begin() + branch.extent);
    std::reverse(path.begin(), path.end());
    return path;
}

// --- branches of the skeleton: limbs and their side branches -----------------------------------------------

// First point of the branch that is a vertex of a limb: (point index, limb), or (−1, −1).
std::pair<int, int> meeting(const Branch& branch, const std::vector<Branch>& accepted) {
    for (int i = 1; i < branch.extent; ++i) {
        const int vertex = branch.path->vertex[i];
        if (vertex < 0) continue;
        for (std::size_t d = 0; d < accepted.size(); ++d)
            for (int j = 0; j < accepted[d].extent; ++j)
                if (accepted[d].path->vertex[j] == vertex) return {i, static_cast<int>(d)};
    }
    return {-1, -1};
}

// Moves a limb's attachment outward to its point `there`; the stem becomes body.
void trim(LimbTree& tree, int index, int there, double stem) {
    tree.branches[index].extent = there + 1;
    set_path(tree.result.limbs[index], outward_path(tree.branches[index]));
    for (Limb& limb : tree.result.limbs)
        if (limb.parent == index) limb.parent_position = std::max(0.0, limb.parent_position - stem);
    for (SideBranch& side : tree.result.side_branches)
        if (side.limb == index) side.position = std::max(0.0, side.position - stem);
}

void add_branch(LimbTree& tree, Branch branch) {
    const auto [here, other] = meeting(branch, tree.branches);
    Limb limb;
    // A fork: a side branch of the other limb, a limb on it, or, on a short stem, two limbs on the body.
    if (other >= 0) {
        const Branch& d = tree.branches[other];
        int there = 0;
        while (d.path->vertex[there] != branch.path->vertex[here]) ++there;
        const double own = arc_length(*branch.path, 0, here), outer = arc_length(*d.path, 0, there);
        const double stem = arc_length(*d.path, there, d.extent - 1);
        const bool is_short =
            own < side_branch_share * outer || own < side_branch_share_of_limb * (outer + stem);
        if (!branch.matched && (is_short || branch.label == Label::head)) {
            const auto& points = branch.path->points;
            tree.result.side_branches.push_back({other, stem, {points.begin(), points.begin() + here + 1}});
            return;
        }
        branch.extent = here + 1;
        limb.parent = other, limb.parent_position = stem;
        if (stem < stub_share * std::min(own, outer)) {
            trim(tree, other, there, stem);
            const Limb& trimmed = tree.result.limbs[other];
            limb.parent = trimmed.parent, limb.parent_position = trimmed.parent_position;
        }
    }
    limb.end = branch.path->end;
    limb.reference_end = branch.reference_end;
    limb.matched = branch.matched;
    limb.label = branch.label;
    set_path(limb, outward_path(branch));
    tree.result.limbs.push_back(std::move(limb));
    tree.branches.push_back(branch);
}

// --- parts in which the skeleton has no end ----------------------------------------------------------------

// Whether a limb or a side branch of one runs through the part, or the body's root lies in it.
bool is_covered(const PartComponent& part, const Limbs& limbs) {
    const auto inside = [&](Point2d p) {
        return std::binary_search(part.pixels.begin(), part.pixels.end(), pixel_at(p),
                                  [](Point2i a, Point2i b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
    };
    const auto runs_through = [&](const std::vector<Point2d>& path) {
        return std::count_if(path.begin(), path.end(), inside) >= 3;
    };
    for (const Limb& limb : limbs.limbs)
        if (runs_through(limb.path)) return true;
    for (const SideBranch& side : limbs.side_branches)
        if (runs_through(side.path)) return true;
    return inside(limbs.root);
}

// Parts that segmentation sees and the skeleton does not (a short leg, a stub of a tail): pruning took their
// end-effector. They move as well, along a path of their own.
void add_parts_without_end(LimbTree& tree, const SkeletonGraph& graph, const LabelMap& labels,
                           const Grid<float>& depth) {
    std::vector<Limb>& limbs = tree.result.limbs;
    const auto area = std::count_if(depth.begin(), depth.end(), [](float d) { return d > 0; });
    const int min_area = std::max(30, static_cast<int>(part_share * static_cast<double>(area)));
    for (PartComponent& part : part_components(labels, depth, min_area)) {
        if (part.free_share < free_border || part.path.size() < 3 || is_covered(part, tree.result)) continue;
        const bool has_head = std::any_of(limbs.begin(), limbs.end(),
                                          [](const Limb& limb) { return limb.label == Label::head; });
        if (part.label == Label::head && has_head) continue;
        Limb limb;
        limb.end = static_cast<int>(graph.vertices.size() + limbs.size()); // no vertex; keeps the order
        limb.label = part.label;
        set_path(limb, std::move(part.path));
        limbs.push_back(std::move(limb));
        tree.branches.push_back({});
    }
}

// --- the finished tree -------------------------------------------------------------------------------------

double width_of(const Limb& limb, const Grid<float>& depth) {
    double sum = 0;
    for (const Point2d& p : limb.path) sum += at_nearest(depth, p);
    return 2 * sum / static_cast<double>(limb.path.size());
}

// An arm that leaves the head (a figure without a neck, a face with legs) hangs on the head's limb.
void hang_on_heads(LimbTree& tree, const LabelMap& labels) {
    std::vector<Limb>& limbs = tree.result.limbs;
    const auto head = [](const Limb& limb) { return limb.label == Label::head && limb.parent < 0; };
    for (std::size_t i = 0; i < limbs.size(); ++i) {
        const Branch& branch = tree.branches[i];
        if (limbs[i].parent >= 0 || limbs[i].label == Label::head || !branch.path) continue;
        if (branch.extent >= static_cast<int>(branch.path->points.size())) continue;
        const Point2d beyond = branch.path->points[branch.extent];
        if (at_nearest(labels, beyond) != static_cast<std::uint8_t>(Label::head)) continue;
        const auto found = std::find_if(limbs.begin(), limbs.end(), head);
        if (found == limbs.end()) continue;
        limbs[i].parent = static_cast<int>(found - limbs.begin());
        limbs[i].parent_position = found->length();
    }
}

// Limbs that nothing drives are body again; parents first, otherwise in the order of the end-effectors.
Limbs driven_and_sorted(Limbs all) {
    const auto drives = [&](int i) { return all.limbs[i].reference_end >= 0; };
    const auto parent_of = [&](int i) {
        int p = all.limbs[i].parent;
        while (p >= 0 && !drives(p)) p = all.limbs[p].parent;
        return p;
    };
    std::vector<int> waiting, order, place(all.limbs.size(), -1);
    for (int i = 0; i < std::ssize(all.limbs); ++i)
        if (drives(i)) waiting.push_back(i);
    std::sort(waiting.begin(), waiting.end(),
              [&](int a, int b) { return all.limbs[a].end < all.limbs[b].end; });
    while (order.size() < waiting.size()) // a tree has a limb whose parent is placed
        for (const int i : waiting)
            if (place[i] < 0 && (parent_of(i) < 0 || place[parent_of(i)] >= 0)) {
                place[i] = static_cast<int>(order.size());
                order.push_back(i);
            }
    Limbs sorted{all.root, {}, {}};
    for (const int i : order) {
        sorted.limbs.push_back(all.limbs[i]);
        sorted.limbs.back().parent = parent_of(i) < 0 ? -1 : place[parent_of(i)];
    }
    for (SideBranch& side : all.side_branches)
        if (place[side.limb] >= 0)
            sorted.side_branches.push_back({place[side.limb], side.position, std::move(side.path)});
    return sorted;
}

} // namespace

Point2d Limb::at(double s) const {
    if (s <= 0) return path.front();
    for (std::size_t i = 1; i < path.size(); ++i)
        if (position[i] >= s) {
            const double step = position[i] - position[i - 1];
            const double t = step > 0 ? (s - position[i - 1]) / step : 0;
            return path[i - 1] + t * (path[i] - path[i - 1]);
        }
    return path.back();
}

Limbs find_limbs(const SkeletonGraph& graph, const LabelMap& labels, const Grid<float>& depth,
                 const ReferenceSkeleton& reference, const Mapping& mapping) {
    const InwardPaths paths = inward_paths(graph, labels, depth);
    LimbTree tree{{paths.root, {}, {}}, {}};
    // Branches of the skeleton become limbs or side branches of limbs, the surest first.
    for (const Branch& branch : find_branches(paths, graph, labels, depth, reference, mapping))
        add_branch(tree, branch);
    // Parts in which the skeleton has no end become limbs, too.
    add_parts_without_end(tree, graph, labels, depth);
    // A reference end drives each, where there is one of its label.
    assign_reference_ends(tree.result.limbs, graph, reference);
    for (Limb& limb : tree.result.limbs) limb.width = width_of(limb, depth);
    // What leaves the head hangs on it, and what nothing drives is body.
    hang_on_heads(tree, labels);
    return driven_and_sorted(std::move(tree.result));
}

} // namespace pantin
