// SPDX-License-Identifier: MIT
// Ma et al. 2021, section 3.1: straight skeleton of a part, cleaned and simplified.
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/extent.hpp"
#include "modeling/chains.hpp"
#include "pantin/geometry.hpp"
#include "pantin/modeling.hpp"
#include "pantin/straight_skeleton.hpp"

namespace pantin {
namespace {

constexpr int slices_a_diagonal = 100; // samples along a branch as long as the stroke's diagonal
constexpr double widest_slice = 2; // of the distance to the border: beyond, a slice runs into another branch
constexpr int spline_steps = 8;    // points of the spline between two nodes, before it is sliced evenly

// A tree of joints, some of which may be gone.
struct Tree {
    std::vector<SubSkeleton::Joint> joints;
    std::vector<std::vector<int>> neighbours;

    void join(int a, int b) {
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
    }
    // `gone` becomes `kept`, which moves to `place`.
    void merge(int kept, int gone, const SubSkeleton::Joint& joint) {
        std::erase(neighbours[kept], gone);
        for (const int n : neighbours[gone]) {
            if (n == kept) continue;
            std::replace(neighbours[n].begin(), neighbours[n].end(), gone, kept);
            neighbours[kept].push_back(n);
        }
        neighbours[gone].clear();
        joints[kept] = joint;
    }
};

// What is left of the straight skeleton without the arcs that begin at the outline.
Tree inner_tree(const StraightSkeleton& skeleton) {
    const int border = static_cast<int>(skeleton.corners.size());
    Tree tree;
    for (std::size_t n = border; n < skeleton.nodes.size(); ++n)
        tree.joints.push_back({skeleton.nodes[n].place, skeleton.nodes[n].time});
    tree.neighbours.resize(tree.joints.size());
    for (const StraightSkeleton::Arc& arc : skeleton.arcs)
        if (arc.from >= border && arc.to >= border) tree.join(arc.from - border, arc.to - border);
    return tree;
}

// From p along the unit vector to the border, at most `farthest`.
double reach(const std::vector<Point2d>& outline, Point2d p, Point2d direction, double farthest) {
    double nearest = farthest;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point2d a = outline[i], v = outline[(i + 1) % outline.size()] - a;
        const double sine = cross(direction, v);
        if (sine == 0) continue;
        const double s = cross(a - p, v) / sine, t = cross(a - p, direction) / sine;
        if (s >= 0 && t >= 0 && t <= 1) nearest = std::min(nearest, s);
    }
    return nearest;
}

bool holds(const std::vector<Point2d>& outline, Point2d p) {
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point2d a = outline[i], b = outline[(i + 1) % outline.size()];
        if ((a.y > p.y) != (b.y > p.y) && (cross(b - a, p - a) > 0) == (b.y > a.y)) inside = !inside;
    }
    return inside;
}

// Whether the way from a to b, a inside, touches the border.
bool leaves(const std::vector<Point2d>& outline, Point2d a, Point2d b) {
    const double span = distance(a, b);
    return span > 0 && reach(outline, a, (1 / span) * (b - a), 2 * span) <= span;
}
bool leaves(const std::vector<Point2d>& outline, const std::vector<Point2d>& line) {
    for (std::size_t i = 1; i < line.size(); ++i)
        if (leaves(outline, line[i - 1], line[i])) return true;
    return false;
}

// Whether all of a tree lies inside the border.
bool lies_inside(const Tree& tree, const std::vector<Point2d>& outline) {
    for (int a = 0; a < std::ssize(tree.joints); ++a) {
        if (!holds(outline, tree.joints[a].place)) return false;
        for (const int b : tree.neighbours[a])
            if (a < b && leaves(outline, tree.joints[a].place, tree.joints[b].place)) return false;
    }
    return true;
}

// Whether a joint that takes the place of another one keeps the bones to the other's neighbours inside.
bool can_take_over(const Tree& tree, const std::vector<Point2d>& outline, int kept, int gone) {
    return std::none_of(tree.neighbours[gone].begin(), tree.neighbours[gone].end(), [&](int n) {
        return n != kept && leaves(outline, tree.joints[kept].place, tree.joints[n].place);
    });
}

// That of a coarser outline, the coarsest whose skeleton stays inside the outline itself.
Tree inner_tree_inside(const std::vector<Point2d>& outline, double tolerance) {
    constexpr int tries = 4;
    for (int k = 0; k < tries; ++k, tolerance *= 0.25) {
        Tree tree = inner_tree(straight_skeleton({coarser_polygon(outline, tolerance)}));
        if (lies_inside(tree, outline)) return tree;
    }
    return inner_tree(straight_skeleton({outline}));
}

// Collapses the edges shorter than the share of the mean edge, shortest first. Of two joints the wider one
// stays where it is. False when there was none.
bool collapse_short_edges(Tree& tree, const std::vector<Point2d>& outline, double share) {
    struct Edge {
        double length;
        int a, b;
    };
    std::vector<Edge> edges;
    double sum = 0;
    for (int a = 0; a < std::ssize(tree.joints); ++a)
        for (const int b : tree.neighbours[a])
            if (a < b) {
                edges.push_back({distance(tree.joints[a].place, tree.joints[b].place), a, b});
                sum += edges.back().length;
            }
    const double limit = edges.empty() ? 0 : share * sum / static_cast<double>(edges.size());
    std::erase_if(edges, [limit](const Edge& e) { return e.length >= limit && e.length > 0; });
    std::stable_sort(edges.begin(), edges.end(),
                     [](const Edge& e, const Edge& f) { return e.length < f.length; });
    std::vector<char> touched(tree.joints.size());
    bool any = false;
    for (const Edge& e : edges) {
        if (touched[e.a] || touched[e.b]) continue;
        const bool first = tree.joints[e.a].radius >= tree.joints[e.b].radius;
        if (!can_take_over(tree, outline, first ? e.a : e.b, first ? e.b : e.a)) continue;
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

// The distance to the border, where a new joint comes to lie.
double radius_at(const std::vector<Point2d>& outline, Point2d p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point2d a = outline[i], v = outline[(i + 1) % outline.size()] - a;
        const double t = std::clamp(dot(p - a, v) / std::max(dot(v, v), 1e-300), 0.0, 1.0);
        nearest = std::min(nearest, distance(p, a + t * v));
    }
    return nearest;
}

Cylinder cylinder_of(const std::vector<Point2d>& outline, const std::vector<Point2d>& branch,
                     double diagonal) {
    std::vector<Point2d> line = spline(branch);
    if (leaves(outline, line)) line = branch;
    const int count =
        std::max(3, 1 + static_cast<int>(std::ceil(slices_a_diagonal * polyline_length(line) / diagonal)));
    Cylinder cylinder{resample(line, count), {}, {}};
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
std::vector<int> simplified(const Cylinder& cylinder, const std::vector<Point2d>& outline, double diagonal,
                            double wanted, const SubSkeletonOptions& options) {
    std::vector<int> kept(cylinder.axis.size());
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = static_cast<int>(i); // inside, whatever comes
    for (double threshold = first_threshold(wanted, options); threshold > options.least_threshold;
         threshold *= options.threshold_factor) {
        const std::vector<int> fewer = bounded_dp(cylinder, threshold * diagonal, options.shape_weight);
        std::vector<Point2d> line;
        for (const int i : fewer) line.push_back(cylinder.axis[i]);
        if (!leaves(outline, line)) return fewer;
    }
    return kept;
}

} // namespace

SubSkeleton sub_skeleton(const std::vector<Point2d>& stroke, const SubSkeletonOptions& options) {
    return sub_skeleton(simple_polygon(stroke, options.polygon), options);
}

SubSkeleton sub_skeleton(const SimplePolygon& polygon, const SubSkeletonOptions& options) {
    SubSkeleton result;
    result.outline = polygon;
    const std::vector<Point2d>& outline = result.outline.corners;
    const double diagonal = diagonal_of(outline);
    Tree tree = inner_tree_inside(outline, options.polygon.tolerance * diagonal);
    for (int round = 0;
         round < options.collapse_rounds && collapse_short_edges(tree, outline, options.collapse); ++round) {
    }
    std::vector<int> number(tree.joints.size(), -1); // of junctions and ends, in the result
    const auto joint = [&](int j) {
        if (number[j] < 0) {
            number[j] = static_cast<int>(result.joints.size());
            result.joints.push_back({tree.joints[j].place, radius_at(outline, tree.joints[j].place)});
        }
        return number[j];
    };
    for (const std::vector<int>& branch : chains_of(tree.neighbours)) {
        std::vector<Point2d> points;
        for (const int j : branch) points.push_back(tree.joints[j].place);
        const Cylinder cylinder = cylinder_of(outline, points, diagonal);
        const double threshold = threshold_of(static_cast<int>(result.branches.size()), options);
        const std::vector<int> kept = simplified(cylinder, outline, diagonal, threshold, options);
        int before = joint(branch.front());
        result.branches.push_back({before});
        for (std::size_t i = 1; i + 1 < kept.size(); ++i) {
            const Point2d place = cylinder.axis[kept[i]];
            result.joints.push_back({place, radius_at(outline, place)});
            result.bones.emplace_back(before, static_cast<int>(result.joints.size()) - 1);
            before = static_cast<int>(result.joints.size()) - 1;
            result.branches.back().push_back(before);
        }
        result.bones.emplace_back(before, joint(branch.back()));
        result.branches.back().push_back(result.bones.back().second);
    }
    if (result.joints.empty() && !tree.joints.empty()) { // a triangle, a disc: one joint
        const auto widest =
            std::max_element(tree.joints.begin(), tree.joints.end(),
                             [](const auto& a, const auto& b) { return a.radius < b.radius; });
        result.joints.push_back(*widest);
    }
    return result;
}

} // namespace pantin
