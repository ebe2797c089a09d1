// SPDX-License-Identifier: MIT
// Which edges of a straight skeleton are the axis of a shape (own; Ma et al. 2021, section 3.1, drop those at
// the outline). How far a shape reaches beyond an inscribed disc as a measure of a branch, after: D. Shaked,
// A. M. Bruckstein, Pruning medial axes, Computer Vision and Image Understanding 69(2), 1998.
#include "modeling/axis_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/disjoint_sets.hpp"
#include "geometry/extent.hpp"

namespace pantin {
namespace {

// The tip of a wedge reaches beyond a disc in it, of radius 1, by 0.41 for 90°, 0.7 for 72°, 1 for 60°.
constexpr double arm = 0.8;        // what reaches so far beyond a disc along it is an arm …
constexpr double least_arm = 0.02; // … and no tremor, of a corner either: share of the diagonal
constexpr double cap = 0.6;        // an arm ends at the disc beyond which its tip reaches so far, …
constexpr double least_cap = 0.25; // … or, sharp, so far: share of least_arm
constexpr double elongated = 1.8;  // a shape so much longer than wide, from corner to corner, has an axis

// The polygon that a skeleton is of; which loop is a hole makes no difference here.
PartOutline polygon_of(const StraightSkeleton& skeleton) {
    PartOutline polygon;
    for (int first = 0; first < std::ssize(skeleton.corners);) {
        std::vector<Point2d>& loop = first == 0 ? polygon.corners : polygon.holes.emplace_back();
        int last = first, corner = first;
        do {
            loop.push_back(skeleton.corners[corner]);
            last = std::max(last, corner);
            corner = skeleton.next[corner];
        } while (corner != first);
        first = last + 1;
    }
    return polygon;
}

template <class Do> void for_sides(const PartOutline& outline, const Do& act) {
    const auto around = [&](const std::vector<Point2d>& loop) {
        for (std::size_t i = 0; i < loop.size(); ++i) act(loop[i], loop[(i + 1) % loop.size()]);
    };
    around(outline.corners);
    for (const std::vector<Point2d>& hole : outline.holes) around(hole);
}

class Axis {
public:
    explicit Axis(const StraightSkeleton& skeleton)
        : skeleton_(skeleton), polygon_(polygon_of(skeleton)),
          border_(static_cast<int>(skeleton.corners.size())),
          small_(least_arm * diagonal_of(skeleton.corners)), neighbours_(skeleton.nodes.size()),
          parent_(skeleton.nodes.size(), -1), first_leaf_(skeleton.nodes.size()),
          end_leaf_(skeleton.nodes.size()), before_(skeleton.corners.size()), kept_(skeleton.nodes.size()) {
        for (int c = 0; c < border_; ++c) before_[skeleton.next[c]] = c;
        for (const StraightSkeleton::Arc& arc : skeleton.arcs) {
            neighbours_[arc.from].push_back(arc.to);
            neighbours_[arc.to].push_back(arc.from);
        }
        for (int n = 0; n < std::ssize(skeleton.nodes); ++n)
            radius_.push_back(n < border_ ? 0 : radius_at(polygon_, skeleton.nodes[n].place));
    }

    AxisTree run() {
        const int root = static_cast<int>(std::max_element(radius_.begin(), radius_.end()) - radius_.begin());
        visit(root);
        for (auto n = order_.rbegin(); n != order_.rend(); ++n) kept_[*n] = *n != root && is_arm(*n);
        for (const int n : order_) // what the disc of a node nearer to the root covers is no arm
            if (n != root && parent_[n] != root && !kept_[parent_[n]]) kept_[n] = 0;
        number_.assign(radius_.size(), -1);
        number_[root] = tree_.add({place(root), radius_[root]});
        for (const int n : order_)
            if (kept_[n]) add_arm(n);
        if (tree_.neighbours[number_[root]].size() < 2) extend_root(root);
        return std::move(tree_);
    }

private:
    Point2d place(int node) const { return skeleton_.nodes[node].place; }

    // Depth first from the widest node; the tips behind a node are consecutive in leaves_.
    void visit(int root) {
        std::vector<std::pair<int, std::size_t>> path = {{root, 0}};
        order_.push_back(root);
        while (!path.empty()) {
            auto& [node, next] = path.back();
            if (next == 0) {
                first_leaf_[node] = static_cast<int>(leaves_.size());
                if (is_tip(node)) leaves_.push_back(node);
            }
            while (next < neighbours_[node].size() && neighbours_[node][next] == parent_[node]) ++next;
            if (next == neighbours_[node].size()) {
                end_leaf_[node] = static_cast<int>(leaves_.size());
                path.pop_back();
                continue;
            }
            const int child = neighbours_[node][next++];
            parent_[child] = node;
            order_.push_back(child);
            path.emplace_back(child, 0);
        }
    }

    // An arm leads to a corner, or to where a cycle was cut.
    bool is_tip(int node) const { return node < border_ ? is_convex(node) : neighbours_[node].size() == 1; }
    // What a corner that points inward leads to is between arms, never one.
    bool is_convex(int corner) const {
        const int next = skeleton_.next[corner], before = before_[corner];
        return cross(place(corner) - place(before), place(next) - place(corner)) > 0;
    }

    // The tip behind a node that is farthest from p.
    int farthest(int node, Point2d p) const {
        int best = leaves_[first_leaf_[node]];
        for (int k = first_leaf_[node] + 1; k < end_leaf_[node]; ++k)
            if (distance(place(leaves_[k]), p) > distance(place(best), p)) best = leaves_[k];
        return best;
    }
    // How far what is behind a node reaches beyond the disc of another one.
    double beyond(int node, int disc) const {
        return distance(place(farthest(node, place(disc))), place(disc)) - radius_[disc];
    }

    // Whether the edge from a node to its parent belongs to an arm; its children are judged.
    bool is_arm(int node) const {
        const int parent = parent_[node];
        if (first_leaf_[node] == end_leaf_[node]) return false;
        const double out = beyond(node, parent);
        if (out < small_) return false;
        for (const int child : neighbours_[node])
            if (child != parent && kept_[child]) return true;
        return out >= arm * radius_[parent] || (node >= border_ && beyond(node, node) >= arm * radius_[node]);
    }

    bool ends(int node) const {
        for (const int child : neighbours_[node])
            if (child != parent_[node] && kept_[child]) return false;
        return true;
    }

    // From the root: what comes before is added.
    void add_arm(int node) {
        const int parent = parent_[node];
        if (!ends(node)) {
            number_[node] = tree_.add({place(node), radius_[node]});
            return tree_.join(number_[parent], number_[node]);
        }
        const int tip = farthest(node, place(parent));
        std::vector<int> way; // from the root to the tip
        for (int n = tip; n >= 0; n = parent_[n]) way.push_back(n);
        std::reverse(way.begin(), way.end());
        const std::size_t at = std::find(way.begin(), way.end(), parent) - way.begin();
        const bool begins_later = node >= border_ && is_within(place(parent), radius_[parent], tip);
        add_end(way, at, begins_later ? at + 1 : at, {});
    }

    // Whether a disc reaches the tip, all but a cap.
    bool is_within(Point2d p, double radius, int tip) const {
        const double out = distance(p, place(tip)) - radius;
        return out <= cap * radius || out <= least_cap * small_;
    }

    // The end of an arm: on the way to the tip the first disc that reaches it, searched from way[from] on,
    // and from there as far as the same disc fits in. way[at] is in the tree; `behind`: before the way.
    void add_end(const std::vector<int>& way, std::size_t at, std::size_t from,
                 const std::vector<Point2d>& behind) {
        const int tip = way.back();
        std::size_t k = from;
        while (k + 1 < way.size() && !is_within(place(way[k]), radius_[way[k]], tip)) ++k;
        Point2d end = place(way[k]);
        if (k > from) {
            Point2d inner = place(way[k - 1]);
            for (int step = 0; step < 20; ++step) {
                const Point2d middle = 0.5 * (inner + end);
                (is_within(middle, radius_at(polygon_, middle), tip) ? end : inner) = middle;
            }
        }
        std::vector<Point2d> line = behind;
        for (std::size_t i = 0; i < std::max(k, std::size_t{1}) && i < way.size(); ++i)
            line.push_back(place(way[i]));
        end = pushed_out(line, end);
        int before = number_[way[at]];
        for (std::size_t i = at + 1; i < k; ++i) {
            number_[way[i]] = tree_.add({place(way[i]), radius_[way[i]]});
            tree_.join(before, number_[way[i]]);
            before = number_[way[i]];
        }
        const double radius = radius_at(polygon_, end);
        if (k <= at) { // the tree's own node moves
            tree_.joints[before] = {end, radius};
        } else {
            tree_.join(before, tree_.add({end, radius}));
        }
    }

    // As far on from the end of a line as its disc fits in.
    Point2d pushed_out(const std::vector<Point2d>& line, Point2d end) const {
        const double radius = radius_at(polygon_, end);
        Point2d back = end;
        for (std::size_t i = line.size(); i-- > 0;) {
            const double step = distance(line[i], back), left = radius - distance(back, end);
            if (step > 0 && distance(line[i], end) >= radius) {
                back = back + std::min(1.0, std::max(left, 0.0) / step) * (line[i] - back);
                break;
            }
            back = line[i];
        }
        const double span = distance(back, end);
        if (!(span > 0)) return end;
        const Point2d out = (1 / span) * (end - back);
        const double free = reach(polygon_, end, out, 2 * radius) - radius;
        return end + std::max(0.0, free) * out;
    }

    // Without arms, or with one: to the other side of the widest node as well, where the shape is long.
    void extend_root(int root) {
        if (tree_.neighbours[number_[root]].empty()) return extend_both(root);
        int side = -1;
        for (const int child : neighbours_[root])
            if (!kept_[child] && first_leaf_[child] < end_leaf_[child] &&
                (side < 0 || beyond(child, root) > beyond(side, root)))
                side = child;
        if (side < 0) return;
        const int kept = tree_.neighbours[number_[root]].front();
        add_end(way_to(farthest(side, place(root)), root), 0, 0, {tree_.joints[kept].place});
    }
    void extend_both(int root) {
        int a = leaves_.front(), b = a;
        for (const int p : leaves_)
            for (const int q : leaves_)
                if (distance(place(p), place(q)) > distance(place(a), place(b))) a = p, b = q;
        if (distance(place(a), place(b)) < 2 * elongated * radius_[root]) return;
        const std::vector<int> one = way_to(a, root), other = way_to(b, root);
        if (one[1] == other[1]) return;
        add_end(one, 0, 0, {place(other[1])});
        add_end(other, 0, 0, {place(one[1])});
    }
    std::vector<int> way_to(int tip, int root) const {
        std::vector<int> way;
        for (int n = tip; n != root; n = parent_[n]) way.push_back(n);
        way.push_back(root);
        std::reverse(way.begin(), way.end());
        return way;
    }

    const StraightSkeleton& skeleton_;
    PartOutline polygon_;
    int border_; // nodes before it are corners
    double small_;
    std::vector<std::vector<int>> neighbours_;
    std::vector<int> parent_, first_leaf_, end_leaf_, before_;
    std::vector<char> kept_; // the edge to the parent
    std::vector<double> radius_;
    std::vector<int> order_, leaves_;
    std::vector<int> number_; // in the tree
    AxisTree tree_;
};

} // namespace

void AxisTree::merge(int kept, int gone, const SubSkeleton::Joint& joint) {
    std::erase(neighbours[kept], gone);
    for (const int n : neighbours[gone]) {
        if (n == kept) continue;
        std::replace(neighbours[n].begin(), neighbours[n].end(), gone, kept);
        neighbours[kept].push_back(n);
    }
    neighbours[gone].clear();
    joints[kept] = joint;
}

StraightSkeleton without_cycles(StraightSkeleton skeleton) {
    std::vector<int> order(skeleton.arcs.size());
    std::iota(order.begin(), order.end(), 0);
    const auto width = [&](int a) {
        return skeleton.nodes[skeleton.arcs[a].from].time + skeleton.nodes[skeleton.arcs[a].to].time;
    };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return width(a) > width(b); });
    DisjointSets trees(skeleton.nodes.size());
    for (const int a : order) {
        const StraightSkeleton::Arc arc = skeleton.arcs[a];
        if (trees.find(arc.from) != trees.find(arc.to)) {
            trees.unite(arc.from, arc.to);
            continue;
        }
        const StraightSkeleton::Node from = skeleton.nodes[arc.from], to = skeleton.nodes[arc.to];
        const int first = static_cast<int>(skeleton.nodes.size());
        for (const double t : {0.375, 0.625})
            skeleton.nodes.push_back(
                {from.place + t * (to.place - from.place), from.time + t * (to.time - from.time)});
        skeleton.arcs[a].to = first;
        skeleton.arcs.push_back({first + 1, arc.to, arc.left, arc.right});
    }
    return skeleton;
}

double reach(const PartOutline& outline, Point2d p, Point2d direction, double farthest) {
    double nearest = farthest;
    for_sides(outline, [&](Point2d a, Point2d b) {
        const Point2d v = b - a;
        const double sine = cross(direction, v);
        if (sine == 0) return;
        const double s = cross(a - p, v) / sine, t = cross(a - p, direction) / sine;
        if (s >= 0 && t >= 0 && t <= 1) nearest = std::min(nearest, s);
    });
    return nearest;
}

double radius_at(const PartOutline& outline, Point2d p) {
    double nearest = std::numeric_limits<double>::infinity();
    for_sides(outline, [&](Point2d a, Point2d b) {
        const Point2d v = b - a;
        const double t = std::clamp(dot(p - a, v) / std::max(dot(v, v), 1e-300), 0.0, 1.0);
        nearest = std::min(nearest, distance(p, a + t * v));
    });
    return nearest;
}

bool holds(const PartOutline& outline, Point2d p) {
    bool inside = false;
    for_sides(outline, [&](Point2d a, Point2d b) {
        if ((a.y > p.y) != (b.y > p.y) && (cross(b - a, p - a) > 0) == (b.y > a.y)) inside = !inside;
    });
    return inside;
}

bool leaves(const PartOutline& outline, Point2d a, Point2d b) {
    const double span = distance(a, b);
    return span > 0 && reach(outline, a, (1 / span) * (b - a), 2 * span) <= span;
}

AxisTree printed_axis(const StraightSkeleton& skeleton) {
    const int border = static_cast<int>(skeleton.corners.size());
    AxisTree tree;
    for (std::size_t n = border; n < skeleton.nodes.size(); ++n)
        tree.add({skeleton.nodes[n].place, skeleton.nodes[n].time});
    for (const StraightSkeleton::Arc& arc : skeleton.arcs)
        if (arc.from >= border && arc.to >= border) tree.join(arc.from - border, arc.to - border);
    return tree;
}

AxisTree contributing_axis(const StraightSkeleton& skeleton) { return Axis(skeleton).run(); }

} // namespace pantin
