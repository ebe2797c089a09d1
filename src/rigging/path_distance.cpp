// SPDX-License-Identifier: MIT
// Path distance between two skeleton paths (thesis 4.6, Eq. 4.8 and 4.9).
//
// X. Bai, L. J. Latecki: Path Similarity Skeleton Graph Matching, 2008. Eq. 4.8 is read as DT(p) / mean DT,
// as in that paper; M samples, i = 0 … M−1 (ERRATA 14, 15).
#include <algorithm>
#include <limits>

#include "pantin/image.hpp"
#include "rigging/skeleton_paths.hpp"

namespace pantin {
namespace {

// (a − b)² / (a + b) for non-negative a, b; 0 when both are 0.
double chi_square(double a, double b) { return a + b > 0 ? (a - b) * (a - b) / (a + b) : 0; }

double radius_at(const Figure& figure, Point2d p) {
    const Grid<int>& squared = figure.squared_distance;
    const int x = std::clamp(static_cast<int>(std::floor(p.x + 0.5)), 0, squared.width() - 1);
    const int y = std::clamp(static_cast<int>(std::floor(p.y + 0.5)), 0, squared.height() - 1);
    return std::sqrt(static_cast<double>(squared(x, y))) / figure.mean_distance;
}

struct Hop {
    double distance = std::numeric_limits<double>::infinity();
    int edge = -1; // through which the vertex was reached
    bool done = false;
};

std::vector<Hop> dijkstra(const SkeletonGraph& graph, int from) {
    std::vector<Hop> hops(graph.vertices.size());
    hops[from].distance = 0;
    for (;;) {
        int u = -1;
        for (int i = 0; i < std::ssize(hops); ++i)
            if (!hops[i].done && hops[i].distance < std::numeric_limits<double>::infinity() &&
                (u < 0 || hops[i].distance < hops[u].distance))
                u = i;
        if (u < 0) return hops;
        hops[u].done = true;
        for (int e = 0; e < std::ssize(graph.edges); ++e) {
            const SkeletonEdge& edge = graph.edges[e];
            if (edge.u != u && edge.v != u) continue;
            Hop& next = hops[edge.u == u ? edge.v : edge.u];
            if (hops[u].distance + edge.length < next.distance) {
                next.distance = hops[u].distance + edge.length;
                next.edge = e;
            }
        }
    }
}

} // namespace

std::vector<Point2d> shortest_path(const SkeletonGraph& graph, int from, int to) {
    // Searched backwards, so that following the hops from `from` yields the pixels in order.
    const std::vector<Hop> hops = dijkstra(graph, to);
    std::vector<Point2d> path;
    if (from == to || hops[from].edge < 0) return path;
    const auto append = [&path](Point2d p) {
        if (path.empty() || !(path.back() == p)) path.push_back(p);
    };
    append({graph.vertices[from].x, graph.vertices[from].y});
    for (int at = from; at != to;) {
        const SkeletonEdge& edge = graph.edges[hops[at].edge];
        const bool forward = edge.u == at;
        for (std::size_t k = 0; k < edge.pixels.size(); ++k)
            append(to_double(edge.pixels[forward ? k : edge.pixels.size() - 1 - k]));
        at = forward ? edge.v : edge.u;
        // A merged vertex may lie beside the chains that meet in it; only the ends of the path are kept
        // exactly.
        if (edge.pixels.empty() || at == to) append({graph.vertices[at].x, graph.vertices[at].y});
    }
    return path;
}

PathSamples sample_path(const Figure& figure, const std::vector<Point2d>& path, int samples,
                        bool length_in_pixels) {
    PathSamples out;
    if (path.empty()) { // no way from one end to the other: like nothing that has a radius
        out.radii.assign(samples, 0);
        return out;
    }
    std::vector<double> arc = {0};
    for (std::size_t k = 1; k < path.size(); ++k) arc.push_back(arc.back() + distance(path[k - 1], path[k]));
    out.length = length_in_pixels ? arc.back() : arc.back() / figure.mean_distance;
    std::size_t k = 0;
    for (int i = 0; i < samples; ++i) {
        const double s = samples > 1 ? arc.back() * i / (samples - 1) : 0;
        while (k + 2 < path.size() && arc[k + 1] < s) ++k;
        const double step = path.size() > 1 ? arc[k + 1] - arc[k] : 0;
        const double t = step > 0 ? std::min(1.0, (s - arc[k]) / step) : 0;
        out.radii.push_back(
            radius_at(figure, path.size() > 1 ? path[k] + t * (path[k + 1] - path[k]) : path[0]));
    }
    return out;
}

double path_distance(const PathSamples& a, const PathSamples& b, double alpha) {
    double sum = 0;
    for (std::size_t i = 0; i < std::min(a.radii.size(), b.radii.size()); ++i)
        sum += chi_square(a.radii[i], b.radii[i]);
    return sum + alpha * chi_square(a.length, b.length);
}

} // namespace pantin
