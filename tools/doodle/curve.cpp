// SPDX-License-Identifier: MIT
// Few points in, curves out: Catmull-Rom splines, superellipses, ribbons, resampling.
#include "doodle/curve.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"

namespace pantin::doodle {

Point2d direction(double angle) { return {math::cos(angle), math::sin(angle)}; }

Point2d rotated(Point2d v, double angle) {
    const Point2d d = direction(angle);
    return {v.x * d.x - v.y * d.y, v.x * d.y + v.y * d.x};
}

Point2d unit(Point2d v) {
    const double norm = length(v);
    return norm > 0.0 ? (1.0 / norm) * v : Point2d{1.0, 0.0};
}

double path_length(const Path& path, bool closed) {
    double sum = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) sum += distance(path[i - 1], path[i]);
    if (closed && path.size() > 1) sum += distance(path.back(), path.front());
    return sum;
}

Path spline(const Path& points, bool closed, int steps) {
    const int n = static_cast<int>(points.size());
    if (n < 3) return points;
    const auto at = [&](int i) {
        if (closed) return points[static_cast<std::size_t>((i + n) % n)];
        return points[static_cast<std::size_t>(std::clamp(i, 0, n - 1))];
    };
    Path out;
    const int spans = closed ? n : n - 1;
    for (int i = 0; i < spans; ++i) {
        const Point2d p0 = at(i - 1), p1 = at(i), p2 = at(i + 1), p3 = at(i + 2);
        for (int k = 0; k < steps; ++k) {
            const double t = static_cast<double>(k) / steps, t2 = t * t, t3 = t2 * t;
            out.push_back((0.5 * (-t3 + 2 * t2 - t)) * p0 + (0.5 * (3 * t3 - 5 * t2 + 2)) * p1 +
                          (0.5 * (-3 * t3 + 4 * t2 + t)) * p2 + (0.5 * (t3 - t2)) * p3);
        }
    }
    if (!closed) out.push_back(points.back());
    return out;
}

Path ellipse(Point2d centre, double rx, double ry, double angle, double exponent) {
    const int n = 48;
    Path out;
    for (int i = 0; i < n; ++i) {
        Point2d d = direction(2.0 * math::pi * i / n);
        if (exponent != 2.0) {
            d.x = (d.x < 0 ? -1 : 1) * math::pow(std::abs(d.x), 2.0 / exponent);
            d.y = (d.y < 0 ? -1 : 1) * math::pow(std::abs(d.y), 2.0 / exponent);
        }
        out.push_back(centre + rotated({rx * d.x, ry * d.y}, angle));
    }
    return out;
}

Outline resample(const Outline& outline, double step) {
    const Path& path = outline.points;
    Outline out;
    out.closed = outline.closed;
    const double total = path_length(path, outline.closed);
    if (path.size() < 2 || total <= 0.0) return outline;
    const int count = std::max(2, static_cast<int>(std::ceil(total / step)));
    const double pitch = total / (outline.closed ? count : count - 1);
    std::size_t i = 0;
    double start = 0.0; // arc length at path[i]
    const std::size_t n = path.size();
    const auto span = [&](std::size_t k) { return distance(path[k], path[(k + 1) % n]); };
    const std::size_t last_span = outline.closed ? n - 1 : n - 2;
    for (int k = 0; k < count; ++k) {
        const double s = pitch * k;
        while (i < last_span && start + span(i) < s) start += span(i++);
        const double d = span(i);
        const double t = d > 0.0 ? std::clamp((s - start) / d, 0.0, 1.0) : 0.0;
        out.points.push_back(mix(path[i], path[(i + 1) % n], t));
        out.undrawn.push_back(outline.undrawn.empty() ? 0 : outline.undrawn[i]);
    }
    return out;
}

Path resample(const Path& path, double step, bool closed) {
    return resample(Outline{path, {}, closed}, step).points;
}

namespace {

void simplify_range(const Path& path, std::size_t a, std::size_t b, double tolerance,
                    std::vector<char>& keep) {
    if (b <= a + 1) return;
    const Point2d base = path[b] - path[a];
    const double base_length = length(base);
    double farthest = -1.0;
    std::size_t index = a;
    for (std::size_t i = a + 1; i < b; ++i) {
        const double d = base_length > 0.0 ? std::abs(cross(base, path[i] - path[a])) / base_length
                                           : distance(path[i], path[a]);
        if (d > farthest) farthest = d, index = i;
    }
    if (farthest <= tolerance) return;
    keep[index] = 1;
    simplify_range(path, a, index, tolerance, keep);
    simplify_range(path, index, b, tolerance, keep);
}

} // namespace

Path simplify(const Path& path, double tolerance) {
    if (path.size() < 3) return path;
    std::vector<char> keep(path.size(), 0);
    keep.front() = keep.back() = 1;
    simplify_range(path, 0, path.size() - 1, tolerance, keep);
    Path out;
    for (std::size_t i = 0; i < path.size(); ++i)
        if (keep[i]) out.push_back(path[i]);
    return out;
}

namespace {

struct Band {
    Path middle, normal;
    std::vector<double> radius;
};

Band sample_band(const Path& midline, const std::vector<double>& radii) {
    Band band;
    const Path smooth = midline.size() > 2 ? spline(midline, false, 6) : midline;
    const double total = path_length(smooth);
    band.middle = resample(smooth, std::max(total / 24.0, 1e-6));
    const int n = static_cast<int>(band.middle.size());
    for (int i = 0; i < n; ++i) {
        const std::size_t k = static_cast<std::size_t>(i);
        const Point2d before = band.middle[k == 0 ? 0 : k - 1];
        const Point2d after = band.middle[std::min(k + 1, band.middle.size() - 1)];
        const Point2d tangent = unit(after - before);
        band.normal.push_back({-tangent.y, tangent.x});
        const double t = static_cast<double>(i) / (n - 1) * (static_cast<double>(radii.size()) - 1.0);
        const std::size_t j = std::min(static_cast<std::size_t>(t), radii.size() - 1);
        const double next = radii[std::min(j + 1, radii.size() - 1)];
        band.radius.push_back(radii[j] + (t - static_cast<double>(j)) * (next - radii[j]));
    }
    return band;
}

// The line at the inner side of an elbow would run inside the band: it has no ink.
bool inside_band(const Band& band, Point2d p) {
    for (std::size_t i = 0; i < band.middle.size(); ++i)
        if (distance(p, band.middle[i]) < 0.9 * band.radius[i]) return true;
    return false;
}

void add_cap(Outline& out, Point2d centre, Point2d outward, double radius, Cap cap, bool open) {
    const Point2d normal = {-outward.y, outward.x};
    out.undrawn.back() = open;
    if (cap == Cap::pointed) {
        out.points.push_back(centre + radius * outward);
        out.undrawn.push_back(open);
    } else if (cap == Cap::round) {
        for (int i = 1; i < 8; ++i) {
            const Point2d d = direction(math::pi * (0.5 - i / 8.0));
            out.points.push_back(centre + (radius * d.x) * outward + (radius * d.y) * normal);
            out.undrawn.push_back(open);
        }
    }
}

} // namespace

Outline ribbon(const Path& midline, const std::vector<double>& radii, RibbonEnds ends) {
    const Band band = sample_band(midline, radii);
    const std::size_t n = band.middle.size();
    Outline out;
    const auto add = [&](std::size_t i, double side) {
        const Point2d p = band.middle[i] + (side * band.radius[i]) * band.normal[i];
        out.points.push_back(p);
        out.undrawn.push_back(inside_band(band, p));
    };
    for (std::size_t i = 0; i < n; ++i) add(i, 1.0);
    const Point2d forward = unit(band.middle[n - 1] - band.middle[n - 2]);
    add_cap(out, band.middle[n - 1], forward, band.radius[n - 1], ends.end, ends.open_end);
    for (std::size_t i = n; i-- > 0;) add(i, -1.0);
    const Point2d backward = unit(band.middle[0] - band.middle[1]);
    add_cap(out, band.middle[0], backward, band.radius[0], ends.start, ends.open_start);
    return out;
}

Waver::Waver(Random& random, int harmonics, double falloff) {
    double sum = 0.0;
    for (int k = 1; k <= harmonics; ++k) {
        const double amplitude = 1.0 / math::pow(k, falloff);
        const double a = amplitude * random.normal();
        const double b = amplitude * random.normal();
        waves_.push_back({a, b});
        sum += amplitude * amplitude;
    }
    for (Point2d& wave : waves_) wave = (0.6 / std::sqrt(sum)) * wave;
}

double Waver::operator()(double t) const {
    // cos kx and sin kx by the addition theorem: one evaluation of each per point.
    const Point2d first = direction(2.0 * math::pi * t);
    Point2d turn = first;
    double sum = 0.0;
    for (const Point2d& wave : waves_) {
        sum += wave.x * turn.x + wave.y * turn.y;
        turn = {turn.x * first.x - turn.y * first.y, turn.x * first.y + turn.y * first.x};
    }
    return sum;
}

} // namespace pantin::doodle
