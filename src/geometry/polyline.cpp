// SPDX-License-Identifier: MIT
// Open polylines: length, sampling at equal arc length, simplification (Douglas & Peucker, "Algorithms for
// the reduction of the number of points required to represent a digitized line or its caricature", 1973).
#include "pantin/geometry.hpp"

#include <algorithm>
#include <utility>

namespace pantin {
namespace {

// Distance from p to the segment from a to b (to the point a when they coincide).
double segment_distance(Point2d p, Point2d a, Point2d b) {
    const Point2d ab = b - a;
    const double squared = dot(ab, ab);
    if (squared == 0) return distance(p, a);
    const double t = std::clamp(dot(p - a, ab) / squared, 0.0, 1.0);
    return distance(p, a + t * ab);
}

} // namespace

double polyline_length(const std::vector<Point2d>& line) {
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
    return sum;
}

std::vector<Point2d> resample(const std::vector<Point2d>& line, int count) {
    assert(!line.empty() && count >= 2);
    const double total = polyline_length(line);
    std::vector<Point2d> samples = {line.front()};
    std::size_t segment = 1; // the segment that ends at line[segment]
    double before = 0;       // arc length up to its start
    for (int i = 1; i < count - 1; ++i) {
        const double target = total * i / (count - 1);
        double size = 0;
        for (; segment < line.size(); ++segment) {
            size = distance(line[segment - 1], line[segment]);
            if (before + size >= target && size > 0) break;
            before += size;
        }
        if (segment == line.size()) {
            samples.push_back(line.back());
            continue;
        }
        const double t = std::clamp((target - before) / size, 0.0, 1.0);
        samples.push_back(line[segment - 1] + t * (line[segment] - line[segment - 1]));
    }
    samples.push_back(line.back());
    return samples;
}

std::vector<int> douglas_peucker(const std::vector<Point2d>& line, double tolerance) {
    const int count = static_cast<int>(line.size());
    if (count == 0) return {};
    if (count == 1) return {0};
    std::vector<bool> keep(count, false);
    keep[0] = keep[count - 1] = true;
    std::vector<std::pair<int, int>> pending = {{0, count - 1}};
    while (!pending.empty()) {
        const auto [first, last] = pending.back();
        pending.pop_back();
        int farthest = -1;
        double largest = tolerance;
        for (int i = first + 1; i < last; ++i) {
            const double d = segment_distance(line[i], line[first], line[last]);
            if (d > largest) { // ties: the first
                largest = d;
                farthest = i;
            }
        }
        if (farthest < 0) continue;
        keep[farthest] = true;
        pending.push_back({first, farthest});
        pending.push_back({farthest, last});
    }
    std::vector<int> kept;
    for (int i = 0; i < count; ++i)
        if (keep[i]) kept.push_back(i);
    return kept;
}

} // namespace pantin
