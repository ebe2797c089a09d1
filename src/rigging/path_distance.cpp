// SPDX-License-Identifier: MIT
// Path distance between two skeleton paths (thesis 4.6, Eq. 4.8 and 4.9).
//
// X. Bai, L. J. Latecki: Path Similarity Skeleton Graph Matching, 2008. Eq. 4.8 is read as DT(p) / mean DT,
// as in that paper; M samples, i = 0 … M−1 (ERRATA 14, 15).
#include "rigging/path_distance.hpp"

#include <algorithm>
#include <cmath>

#include "image/nearest_pixel.hpp"
#include "rigging/shortest_paths.hpp"

namespace pantin {
namespace {

// (a − b)² / (a + b) for non-negative a, b; 0 when both are 0.
double chi_square(double a, double b) { return a + b > 0 ? (a - b) * (a - b) / (a + b) : 0; }

double radius_at(const Figure& figure, Point2d p) {
    const Grid<int>& squared = figure.squared_distance;
    const Point2i pixel = pixel_at_or_after(p);
    const int x = std::clamp(pixel.x, 0, squared.width() - 1),
              y = std::clamp(pixel.y, 0, squared.height() - 1);
    return std::sqrt(static_cast<double>(squared(x, y))) / figure.mean_distance;
}

} // namespace

std::vector<Point2d> shortest_path(const SkeletonGraph& graph, int from, int to) {
    // Searched backwards, so that following the edges from `from` yields the pixels in order.
    const ShortestPaths paths = shortest_paths(graph, to);
    std::vector<Point2d> path;
    if (from == to || paths.edge[from] < 0) return path;
    const auto append = [&path](Point2d p) {
        if (path.empty() || !(path.back() == p)) path.push_back(p);
    };
    append({graph.vertices[from].x, graph.vertices[from].y});
    for (int at = from; at != to;) {
        const SkeletonEdge& edge = graph.edges[paths.edge[at]];
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
