// SPDX-License-Identifier: MIT
// Ma et al. 2021, section 3.1: straight skeleton of a part, cleaned and simplified.
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/disjoint_sets.hpp"
#include "geometry/extent.hpp"
#include "modeling/axis_tree.hpp"
#include "modeling/chains.hpp"
#include "modeling/holes.hpp"
#include "pantin/geometry.hpp"
#include "pantin/modeling.hpp"
#include "pantin/straight_skeleton.hpp"

namespace pantin {
namespace {

constexpr int slices_a_diagonal = 100; // samples along a branch as long as the stroke's diagonal
constexpr double widest_slice = 2; // of the distance to the border: beyond, a slice runs into another branch
constexpr double least_edge = 0.005; // of the diagonal: shorter edges are collapsed whatever the mean is
constexpr double coarse_hole = 0.1;  // of a hole's diagonal: it is simplified so far at most
constexpr int spline_steps = 8;      // points of the spline between two nodes, before it is sliced evenly

bool leaves(const PartOutline& outline, const std::vector<Point2d>& line) {
    for (std::size_t i = 1; i < line.size(); ++i)
        if (leaves(outline, line[i - 1], line[i])) return true;
    return false;
}

// Whether all of a tree lies inside the border.
bool lies_inside(const AxisTree& tree, const PartOutline& outline) {
    for (int a = 0; a < std::ssize(tree.joints); ++a) {
        if (!holds(outline, tree.joints[a].place)) return false;
        for (const int b : tree.neighbours[a])
            if (a < b && leaves(outline, tree.joints[a].place, tree.joints[b].place)) return false;
    }
    return true;
}

// Whether a joint that takes the place of another one keeps the bones to the other's neighbours inside.
bool can_take_over(const AxisTree& tree, const PartOutline& outline, int kept, int gone) {
    return std::none_of(tree.neighbours[gone].begin(), tree.neighbours[gone].end(), [&](int n) {
        return n != kept && leaves(outline, tree.joints[kept].place, tree.joints[n].place);
    });
}

// Whether every corner hangs together with the others. Where many corners meet in one instant, as in an exact
// cross, the straight skeleton can fall apart.
bool is_whole(const StraightSkeleton& skeleton) {
    DisjointSets sets(skeleton.nodes.size());
    for (const StraightSkeleton::Arc& arc : skeleton.arcs) sets.unite(arc.from, arc.to);
    for (int c = 1; c < std::ssize(skeleton.corners); ++c)
        if (sets.find(c) != sets.find(0)) return false;
    return true;
}

std::vector<std::vector<Point2d>> loops_of(const PartOutline& polygon) {
    std::vector<std::vector<Point2d>> loops = {polygon.corners};
    loops.insert(loops.end(), polygon.holes.begin(), polygon.holes.end());
    return loops;
}

// Of the polygon, or of one whose corners lie a little beside its own, so that few meet in one instant.
StraightSkeleton whole_skeleton(const PartOutline& polygon) {
    constexpr double aside = 1e-6; // of the diagonal
    constexpr int tries = 3, places = 7;
    const std::vector<std::vector<Point2d>> loops = loops_of(polygon);
    StraightSkeleton skeleton = straight_skeleton(loops);
    const double step = aside * diagonal_of(polygon.corners) / places;
    for (int round = 1; round <= tries && !is_whole(skeleton); ++round) {
        std::vector<std::vector<Point2d>> shaken = loops;
        int i = 0;
        for (std::vector<Point2d>& loop : shaken)
            for (Point2d& p : loop) {
                p = p + step * Point2d{(i * 3 + round) % places - 3.0, (i * 5 + round) % places - 3.0};
                ++i;
            }
        skeleton = straight_skeleton(shaken);
    }
    return polygon.holes.empty() ? skeleton : without_cycles(std::move(skeleton));
}

// The coarser one's holes may meet its border.
std::optional<PartOutline> coarser(const PartOutline& outline, double tolerance) {
    PartOutline polygon;
    polygon.corners = coarser_polygon(outline.corners, tolerance);
    for (const std::vector<Point2d>& hole : outline.holes) {
        polygon.holes.push_back(coarser_polygon(hole, std::min(tolerance, coarse_hole * diagonal_of(hole))));
        if (!is_apart(polygon, polygon.holes.size() - 1)) return {};
    }
    return polygon;
}

// On a coarser outline, the coarsest whose axis stays inside the outline itself. `nodes`: of that straight
// skeleton.
AxisTree axis_inside(const PartOutline& outline, const SubSkeletonOptions& options,
                     std::vector<Point2d>& nodes) {
    constexpr int tries = 6;
    const auto axis = [&](const PartOutline& polygon) {
        const StraightSkeleton skeleton = whole_skeleton(polygon);
        nodes.clear();
        for (std::size_t n = skeleton.corners.size(); n < skeleton.nodes.size(); ++n)
            nodes.push_back(skeleton.nodes[n].place);
        return options.printed_axis ? printed_axis(skeleton) : contributing_axis(skeleton);
    };
    double tolerance = options.coarsest * diagonal_of(outline.corners);
    for (int k = 0; k < tries; ++k, tolerance *= 0.5)
        if (const std::optional<PartOutline> polygon = coarser(outline, tolerance)) {
            AxisTree tree = axis(*polygon);
            if (lies_inside(tree, outline)) return tree;
        }
    return axis(outline);
}

struct Edge {
    double length;
    int a, b;
};

// Those shorter than the limit and those without length, shortest first.
std::vector<Edge> short_edges(const AxisTree& tree, double share, double least) {
    std::vector<Edge> edges;
    double sum = 0;
    for (int a = 0; a < std::ssize(tree.joints); ++a)
        for (const int b : tree.neighbours[a])
            if (a < b) {
                edges.push_back({distance(tree.joints[a].place, tree.joints[b].place), a, b});
                sum += edges.back().length;
            }
    const double limit = edges.empty() ? 0 : std::max(least, share * sum / static_cast<double>(edges.size()));
    std::erase_if(edges, [limit](const Edge& e) { return e.length >= limit && e.length > 0; });
    std::stable_sort(edges.begin(), edges.end(),
                     [](const Edge& e, const Edge& f) { return e.length < f.length; });
    return edges;
}

// Collapses the edges shorter than the share of the mean edge, shortest first. Of two joints the wider one
// stays where it is, but an end before a joint between two edges; a branch of one edge longer than `least`
// that ends stays. False when there was none.
bool collapse_short_edges(AxisTree& tree, const PartOutline& outline, double share, double least) {
    std::vector<char> touched(tree.joints.size());
    bool any = false;
    for (const Edge& e : short_edges(tree, share, least)) {
        if (touched[e.a] || touched[e.b]) continue;
        const std::size_t at_a = tree.neighbours[e.a].size(), at_b = tree.neighbours[e.b].size();
        bool first = tree.joints[e.a].radius >= tree.joints[e.b].radius;
        if ((at_a == 1) != (at_b == 1)) {
            if (std::max(at_a, at_b) > 2 && e.length >= least) continue;
            if (std::max(at_a, at_b) == 2) first = at_a == 1;
        }
        if (!can_take_over(tree, outline, first ? e.a : e.b, first ? e.b : e.a)) {
            first = !first;
            if (!can_take_over(tree, outline, first ? e.a : e.b, first ? e.b : e.a)) continue;
        }
        touched[e.a] = touched[e.b] = 1;
        tree.merge(e.a, e.b, tree.joints[first ? e.a : e.b]);
        any = true;
    }
    return any;
}

// Catmull–Rom through the points, ends included.
std::vector<Point2d> spline(const std::vector<Point2d>& points) {
    const auto at = [&](std::ptrdiff_t i) {
        return points[std::clamp<std::ptrdiff_t>(i, 0, std::ssize(points) - 1)];
    };
    std::vector<Point2d> line;
    for (std::ptrdiff_t i = 0; i + 1 < std::ssize(points); ++i)
        for (int k = 0; k < spline_steps; ++k) {
            const double t = static_cast<double>(k) / spline_steps, t2 = t * t, t3 = t2 * t;
            line.push_back(0.5 * ((-t3 + 2 * t2 - t) * at(i - 1) + (3 * t3 - 5 * t2 + 2) * at(i) +
                                  (-3 * t3 + 4 * t2 + t) * at(i + 1) + (t3 - t2) * at(i + 2)));
        }
    line.push_back(points.back());
    return line;
}

Cylinder cylinder_of(const PartOutline& outline, const std::vector<Point2d>& branch, double diagonal) {
    std::vector<Point2d> line = spline(branch);
    if (leaves(outline, line)) line = branch;
    int count =
        std::max(3, 1 + static_cast<int>(std::ceil(slices_a_diagonal * polyline_length(line) / diagonal)));
    constexpr int most_slices = 2000;
    Cylinder cylinder{resample(line, count), {}, {}};
    while (count < most_slices && leaves(outline, cylinder.axis)) { // cut a corner of the axis
        count *= 2;
        cylinder.axis = resample(line, count);
    }
    for (int i = 0; i < count; ++i) {
        const Point2d way = cylinder.axis[std::min(i + 1, count - 1)] - cylinder.axis[std::max(i - 1, 0)];
        const double size = length(way);
        const Point2d across = size > 0 ? (1 / size) * Point2d{-way.y, way.x} : Point2d{0, 1};
        const double farthest = widest_slice * radius_at(outline, cylinder.axis[i]);
        cylinder.left.push_back(reach(outline, cylinder.axis[i], across, farthest));
        cylinder.right.push_back(reach(outline, cylinder.axis[i], -1 * across, farthest));
    }
    return cylinder;
}

// Slices in a junction's disc belong to the junction: there the sides go on as they do beyond it.
void leave_out(Cylinder& cylinder, const SubSkeleton::Joint& junction) {
    const int count = static_cast<int>(cylinder.axis.size());
    const bool at_front = cylinder.axis.front() == junction.place;
    const auto slice = [&](int i) { return at_front ? i : count - 1 - i; };
    int first = 0;
    while (first + 1 < count && distance(cylinder.axis[slice(first)], junction.place) < junction.radius)
        ++first;
    const int next = std::min(2 * first, count - 1); // as far beyond
    for (std::vector<double>* side : {&cylinder.left, &cylinder.right}) {
        const double width = (*side)[slice(first)];
        const double slope = next > first ? ((*side)[slice(next)] - width) / (next - first) : 0;
        for (int i = 0; i < first; ++i)
            (*side)[slice(i)] = std::clamp(width - slope * (first - i), 0.5 * width, 2 * width);
    }
}

// The thresholds that are tried are those of one ladder, options.threshold times powers of the factor,
// whatever threshold is asked for: so that a larger one never keeps more joints. Nothing wanted, or too
// little: one at which all slices are kept.
double first_threshold(double wanted, const SubSkeletonOptions& options) {
    double threshold = options.threshold;
    while (threshold > wanted && threshold > options.least_threshold) threshold *= options.threshold_factor;
    double above = threshold / options.threshold_factor;
    for (int step = 1; above <= wanted && above < 10; ++step) {
        threshold = above;
        above = options.threshold;
        for (int k = 0; k <= step; ++k) above /= options.threshold_factor;
    }
    return threshold;
}

double threshold_of(int branch, const SubSkeletonOptions& options) {
    for (const int key : {branch, -1})
        if (const auto own = options.branch_thresholds.find(key); own != options.branch_thresholds.end())
            return own->second;
    return options.threshold;
}

// Algorithm 2: the threshold is lowered while a bone leaves the shape.
std::vector<int> simplified(const Cylinder& cylinder, const PartOutline& outline, double unit, double wanted,
                            const SubSkeletonOptions& options) {
    std::vector<int> kept(cylinder.axis.size());
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = static_cast<int>(i); // inside, whatever comes
    for (double threshold = first_threshold(wanted, options); threshold > options.least_threshold;
         threshold *= options.threshold_factor) {
        const std::vector<int> fewer = bounded_dp(cylinder, threshold * unit, options.shape_weight);
        std::vector<Point2d> line;
        for (const int i : fewer) line.push_back(cylinder.axis[i]);
        if (!leaves(outline, line)) return fewer;
    }
    return kept;
}

} // namespace

PartAxis part_axis(const PartOutline& polygon, const SubSkeletonOptions& options) {
    PartAxis axis;
    axis.outline = polygon;
    const PartOutline& outline = axis.outline;
    const double diagonal = diagonal_of(outline.corners);
    std::vector<Point2d> places;
    AxisTree tree = axis_inside(outline, options, places);
    for (const Point2d p : places)
        if (holds(outline, p)) axis.discs.push_back({p, radius_at(outline, p)});
    const double least = options.printed_axis ? 0 : least_edge * diagonal;
    for (int round = 0;
         round < options.collapse_rounds && collapse_short_edges(tree, outline, options.collapse, least);
         ++round) {
    }
    while (collapse_short_edges(tree, outline, 0, least)) {
    }
    std::vector<int> number(tree.joints.size(), -1);
    const auto joint = [&](int j) {
        if (number[j] < 0) {
            number[j] = static_cast<int>(axis.joints.size());
            axis.joints.push_back({tree.joints[j].place, radius_at(outline, tree.joints[j].place)});
        }
        return number[j];
    };
    for (const std::vector<int>& chain : chains_of(tree.neighbours)) {
        std::vector<Point2d> points;
        for (const int j : chain) points.push_back(tree.joints[j].place);
        PartAxis::Branch branch{joint(chain.front()), joint(chain.back()),
                                cylinder_of(outline, points, diagonal)};
        for (const int end : {chain.front(), chain.back()})
            if (!options.printed_axis && tree.neighbours[end].size() > 2)
                leave_out(branch.cylinder, axis.joints[number[end]]);
        axis.branches.push_back(std::move(branch));
    }
    if (axis.joints.empty() && !tree.joints.empty()) { // a disc: one joint
        const auto widest =
            std::max_element(tree.joints.begin(), tree.joints.end(),
                             [](const auto& a, const auto& b) { return a.radius < b.radius; });
        axis.joints.push_back({widest->place, radius_at(outline, widest->place)});
    }
    return axis;
}

SubSkeleton sub_skeleton(const PartAxis& axis, double unit, const SubSkeletonOptions& options) {
    SubSkeleton result;
    result.outline = axis.outline;
    const PartOutline& outline = result.outline;
    std::vector<int> number(axis.joints.size(), -1);
    const auto joint = [&](int j) {
        if (number[j] < 0) {
            number[j] = static_cast<int>(result.joints.size());
            result.joints.push_back(axis.joints[j]);
        }
        return number[j];
    };
    for (const PartAxis::Branch& branch : axis.branches) {
        const double threshold = threshold_of(static_cast<int>(result.branches.size()), options);
        const std::vector<int> kept = simplified(branch.cylinder, outline, unit, threshold, options);
        int before = joint(branch.from);
        result.branches.push_back({before});
        for (std::size_t i = 1; i + 1 < kept.size(); ++i) {
            const Point2d place = branch.cylinder.axis[kept[i]];
            result.joints.push_back({place, radius_at(outline, place)});
            result.bones.emplace_back(before, static_cast<int>(result.joints.size()) - 1);
            before = static_cast<int>(result.joints.size()) - 1;
            result.branches.back().push_back(before);
        }
        result.bones.emplace_back(before, joint(branch.to));
        result.branches.back().push_back(result.bones.back().second);
    }
    if (axis.branches.empty()) result.joints = axis.joints;
    return result;
}

SubSkeleton sub_skeleton(const std::vector<Point2d>& stroke, const SubSkeletonOptions& options) {
    const PartAxis axis = part_axis(simple_polygon(stroke, options.polygon), options);
    return sub_skeleton(axis, diagonal_of(axis.outline.corners), options);
}

} // namespace pantin
