// SPDX-License-Identifier: MIT
// Delaunay triangulation by divide and conquer on quad-edges: Guibas & Stolfi, "Primitives for the
// manipulation of general subdivisions and the computation of Voronoi diagrams", 1985. Every sign is exact
// (integer predicates), so rows of collinear and cocircular pixels need no special case.
//
// Ties: points are sorted by x, then y, and split in the middle; while two halves are merged a candidate
// replaces another only when it lies strictly inside its circle. So the triangulation depends on the set of
// points alone.
#include "pantin/geometry.hpp"

#include <algorithm>
#include <numeric>

namespace pantin {
namespace {

// Directed edges are numbers: 4k and 4k + 2 are one edge in its two directions, 4k + 1 and 4k + 3 its dual.
int rotate(int e) { return (e & ~3) | ((e + 1) & 3); }
int rotate_back(int e) { return (e & ~3) | ((e + 3) & 3); }
int symmetric(int e) { return e ^ 2; }

// Guibas & Stolfi's quad-edge structure, as arrays.
class QuadEdges {
public:
    explicit QuadEdges(std::size_t points) {
        next_.reserve(points * 12 + 4);
        origin_.reserve(points * 12 + 4);
    }
    int size() const { return static_cast<int>(next_.size()); }
    int origin(int e) const { return origin_[e]; }
    int destination(int e) const { return origin_[symmetric(e)]; }
    bool deleted(int e) const { return origin_[e & ~3] < 0; }
    int onext(int e) const { return next_[e]; } // the next edge counterclockwise around the origin
    int oprev(int e) const { return rotate(next_[rotate(e)]); }
    int lnext(int e) const { return rotate(next_[rotate_back(e)]); } // … around the face to the left
    int rprev(int e) const { return next_[symmetric(e)]; }

    int make(int from, int to) {
        const int e = size();
        next_.insert(next_.end(), {e, e + 3, e + 2, e + 1});
        origin_.insert(origin_.end(), {from, -1, to, -1});
        return e;
    }
    void splice(int a, int b) {
        std::swap(next_[rotate(next_[a])], next_[rotate(next_[b])]);
        std::swap(next_[a], next_[b]);
    }
    // Connects the destination of a to the origin of b, all three with the same face to the left.
    int connect(int a, int b) {
        const int e = make(destination(a), origin(b));
        splice(e, lnext(a));
        splice(symmetric(e), b);
        return e;
    }
    void remove(int e) {
        splice(e, oprev(e));
        splice(symmetric(e), oprev(symmetric(e)));
        origin_[e & ~3] = -1;
    }

private:
    std::vector<int> next_, origin_;
};

class DivideAndConquer {
public:
    explicit DivideAndConquer(const std::vector<Point2i>& sorted) : points_(sorted), edges_(sorted.size()) {
        if (sorted.size() >= 2) triangulate(0, static_cast<int>(sorted.size()));
    }
    const QuadEdges& edges() const { return edges_; }

private:
    struct Hull {
        int left,
            right; // counterclockwise hull edge out of the leftmost point, clockwise one out of the rightmost
    };

    int turn(int a, int b, int c) const { return orientation(points_[a], points_[b], points_[c]); }
    bool right_of(int p, int e) const { return turn(p, edges_.destination(e), edges_.origin(e)) > 0; }
    bool left_of(int p, int e) const { return turn(p, edges_.origin(e), edges_.destination(e)) > 0; }

    Hull triangulate(int begin, int end) {
        if (end - begin == 2) {
            const int e = edges_.make(begin, begin + 1);
            return {e, symmetric(e)};
        }
        if (end - begin == 3) return triangle(begin);
        const int middle = begin + (end - begin) / 2;
        const Hull left = triangulate(begin, middle);
        const Hull right = triangulate(middle, end);
        return merge(left, right);
    }

    Hull triangle(int first) {
        const int a = edges_.make(first, first + 1), b = edges_.make(first + 1, first + 2);
        edges_.splice(symmetric(a), b);
        const int side = turn(first, first + 1, first + 2);
        if (side == 0) return {a, symmetric(b)};
        const int c = edges_.connect(b, a);
        if (side > 0) return {a, symmetric(b)};
        return {symmetric(c), c};
    }

    // Lower common tangent of the two halves; ldi and rdi end at it.
    void find_tangent(int& ldi, int& rdi) const {
        for (;;) {
            if (left_of(edges_.origin(rdi), ldi))
                ldi = edges_.lnext(ldi);
            else if (right_of(edges_.origin(ldi), rdi))
                rdi = edges_.rprev(rdi);
            else
                return;
        }
    }

    // Deletes the edges of one half that the rising base kills and returns the half's candidate.
    template <class Step> int candidate(int e, int base, Step step) {
        while (true) {
            const int following = step(e);
            if (!right_of(edges_.destination(e), base) ||
                in_circle(points_[edges_.destination(base)], points_[edges_.origin(base)],
                          points_[edges_.destination(e)], points_[edges_.destination(following)]) <= 0)
                return e;
            edges_.remove(e);
            e = following;
        }
    }

    Hull merge(Hull left, Hull right) {
        int ldo = left.left, ldi = left.right, rdi = right.left, rdo = right.right;
        find_tangent(ldi, rdi);
        int base = edges_.connect(symmetric(rdi), ldi);
        if (edges_.origin(ldi) == edges_.origin(ldo)) ldo = symmetric(base);
        if (edges_.origin(rdi) == edges_.origin(rdo)) rdo = base;
        for (;;) { // the base rises from the lower to the upper common tangent
            const int l =
                candidate(edges_.onext(symmetric(base)), base, [this](int e) { return edges_.onext(e); });
            const int r = candidate(edges_.oprev(base), base, [this](int e) { return edges_.oprev(e); });
            const bool l_valid = right_of(edges_.destination(l), base);
            const bool r_valid = right_of(edges_.destination(r), base);
            if (!l_valid && !r_valid) return {ldo, rdo};
            if (!l_valid ||
                (r_valid && in_circle(points_[edges_.destination(l)], points_[edges_.origin(l)],
                                      points_[edges_.origin(r)], points_[edges_.destination(r)]) > 0))
                base = edges_.connect(r, symmetric(base));
            else
                base = edges_.connect(symmetric(base), symmetric(l));
        }
    }

    const std::vector<Point2i>& points_;
    QuadEdges edges_;
};

// Indices by x, then y, then index; of equal points only the first.
std::vector<int> sorted_order(const std::vector<Point2i>& points) {
    std::vector<int> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        const Point2i p = points[a], q = points[b];
        return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : a < b;
    });
    const auto equal = [&](int a, int b) { return points[a] == points[b]; };
    order.erase(std::unique(order.begin(), order.end(), equal), order.end());
    return order;
}

// The positively oriented faces of three edges, in the order in which their first edge was made.
Delaunay collect(const QuadEdges& edges, const std::vector<Point2i>& sorted, const std::vector<int>& order) {
    Delaunay result;
    std::vector<int> face(edges.size(), -1);
    std::vector<std::array<int, 3>> face_edges;
    for (int e = 0; e < edges.size(); e += 2) {
        if (edges.deleted(e) || face[e] >= 0) continue;
        const std::array<int, 3> loop = {e, edges.lnext(e), edges.lnext(edges.lnext(e))};
        if (edges.lnext(loop[2]) != e) continue;
        const int a = edges.origin(loop[0]), b = edges.origin(loop[1]), c = edges.origin(loop[2]);
        if (orientation(sorted[a], sorted[b], sorted[c]) <= 0) continue;
        for (const int side : loop) face[side] = static_cast<int>(face_edges.size());
        face_edges.push_back(loop);
        result.triangles.push_back({order[a], order[b], order[c]});
    }
    for (const auto& loop : face_edges) // the edge from corner i + 1 to corner i + 2 lies opposite corner i
        result.neighbours.push_back(
            {face[symmetric(loop[1])], face[symmetric(loop[2])], face[symmetric(loop[0])]});
    return result;
}

} // namespace

Delaunay delaunay(const std::vector<Point2i>& points) {
    const std::vector<int> order = sorted_order(points);
    std::vector<Point2i> sorted;
    for (const int i : order) sorted.push_back(points[i]);
    const DivideAndConquer triangulation(sorted);
    return collect(triangulation.edges(), sorted, order);
}

} // namespace pantin
