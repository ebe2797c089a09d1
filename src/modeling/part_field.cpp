// SPDX-License-Identifier: MIT
// An inflated part in, a function out that is negative inside of it and grows with the distance (own; for
// unite()).
#include "modeling/part_field.hpp"

#include <algorithm>
#include <cmath>

namespace pantin {
namespace {

constexpr double outside_band = 3; // steps of the table around the outline in which the distance to it counts

struct Extent {
    Point2d low, high;
};
Extent extent_of(const std::vector<Point2d>& points) {
    Extent e{points.front(), points.front()};
    for (const Point2d& p : points) {
        e.low = {std::min(e.low.x, p.x), std::min(e.low.y, p.y)};
        e.high = {std::max(e.high.x, p.x), std::max(e.high.y, p.y)};
    }
    return e;
}

} // namespace

PartField::PartField(const InflatedPart& part, double spacing, double least)
    : frame_(part.frame), size_(length(part.frame.right)), height_(part.height), spacing_(spacing / size_) {
    const Inflation& inflation = *part.inflation;
    const Extent extent = extent_of(inflation.points);
    const double margin = (outside_band + 1) * spacing_;
    corner_ = {extent.low.x - margin, extent.low.y - margin};
    squared_ = Grid<double>(
        static_cast<int>(std::ceil((extent.high.x - extent.low.x + 2 * margin) / spacing_)) + 2,
        static_cast<int>(std::ceil((extent.high.y - extent.low.y + 2 * margin) / spacing_)) + 2, 0);
    slope_ = 2 * inflation.half_width;
    tabulate(inflation);
    continue_outside(inflation, least / size_);
    const double thickest =
        std::max(height_ * std::sqrt(*std::max_element(inflation.squared.begin(), inflation.squared.end())),
                 least / size_);
    const double beyond = outside_band * spacing_;
    bool first = true;
    for (const double x : {extent.low.x - beyond, extent.high.x + beyond})
        for (const double y : {extent.low.y - beyond, extent.high.y + beyond})
            for (const double z : {-thickest - beyond, thickest + beyond}) {
                const Vec3 p = to_model(frame_, {x, y}, z);
                if (first) box_ = {p, p};
                first = false;
                box_.include(p);
            }
}

void PartField::tabulate(const Inflation& inflation) {
    for (const auto& [a, b, c] : inflation.triangles) {
        const Point2d p = inflation.points[a], u = inflation.points[b] - p, v = inflation.points[c] - p;
        const double twice = cross(u, v);
        const Extent e = extent_of({p, p + u, p + v});
        const int x0 = static_cast<int>(std::ceil((e.low.x - corner_.x) / spacing_)),
                  x1 = static_cast<int>((e.high.x - corner_.x) / spacing_);
        const int y0 = static_cast<int>(std::ceil((e.low.y - corner_.y) / spacing_)),
                  y1 = static_cast<int>((e.high.y - corner_.y) / spacing_);
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) {
                const Point2d d =
                    corner_ + spacing_ * Point2d{static_cast<double>(x), static_cast<double>(y)} - p;
                const double s = cross(d, v) / twice, t = cross(u, d) / twice;
                if (s < 0 || t < 0 || s + t > 1) continue;
                squared_(x, y) =
                    std::max(squared_(x, y), (1 - s - t) * inflation.squared[a] + s * inflation.squared[b] +
                                                 t * inflation.squared[c]);
            }
    }
}

// Beyond the outline the squared thickness falls on with one slope. Inside, a part that is too flat gets the
// least half thickness R, and a round rim: at a distance r from the outline R² − (R − r)².
void PartField::continue_outside(const Inflation& inflation, double least) {
    Grid<double> away(squared_.width(), squared_.height(), outside_band * spacing_);
    for (const auto& corners : inflation.triangles)
        for (int k = 0; k < 3; ++k) {
            const int i = corners[k], j = corners[(k + 1) % 3];
            if (!inflation.border[i] || !inflation.border[j]) continue;
            const Point2d a = inflation.points[i], v = inflation.points[j] - a;
            const double square = dot(v, v);
            const Extent e = extent_of({a, a + v});
            const auto column = [&](double x) { return static_cast<int>((x - corner_.x) / spacing_); };
            const auto row = [&](double y) { return static_cast<int>((y - corner_.y) / spacing_); };
            const double band = outside_band * spacing_;
            for (int y = std::max(0, row(e.low.y - band));
                 y <= std::min(away.height() - 1, row(e.high.y + band) + 1); ++y)
                for (int x = std::max(0, column(e.low.x - band));
                     x <= std::min(away.width() - 1, column(e.high.x + band) + 1); ++x) {
                    const Point2d p =
                        corner_ + spacing_ * Point2d{static_cast<double>(x), static_cast<double>(y)};
                    const double t = std::clamp(square > 0 ? dot(p - a, v) / square : 0, 0.0, 1.0);
                    away(x, y) = std::min(away(x, y), distance(p, a + t * v));
                }
        }
    for (std::size_t i = 0; i < squared_.size(); ++i) {
        double& squared = squared_.data()[i];
        const double r = std::min(away.data()[i], least);
        if (squared <= 0)
            squared = -slope_ * away.data()[i];
        else if (least > 0)
            squared = std::max(squared, r * (2 * least - r) / (height_ * height_));
    }
}

double PartField::operator()(Vec3 p) const {
    const Vec3 d = (1 / (size_ * size_)) * (p - frame_.origin);
    const double x = (dot(d, frame_.right) - corner_.x) / spacing_,
                 y = (dot(d, frame_.down) - corner_.y) / spacing_;
    const double z = dot(d, frame_.out) / height_;
    const double xc = std::clamp(x, 0.0, squared_.width() - 1.001),
                 yc = std::clamp(y, 0.0, squared_.height() - 1.001);
    const int i = static_cast<int>(xc), j = static_cast<int>(yc);
    const double s = xc - i, t = yc - j;
    const double *top = squared_.row(j) + i, *bottom = squared_.row(j + 1) + i;
    const double value =
        (1 - t) * ((1 - s) * top[0] + s * top[1]) + t * ((1 - s) * bottom[0] + s * bottom[1]);
    const double gx = ((1 - t) * (top[1] - top[0]) + t * (bottom[1] - bottom[0])) / spacing_;
    const double gy = ((1 - s) * (bottom[0] - top[0]) + s * (bottom[1] - top[1])) / spacing_;
    const double gz = 2 * z / height_;
    // z² − squared, divided by its gradient; where that vanishes, deep inside, by a share of the slope.
    return size_ * (z * z - value) / std::sqrt(gx * gx + gy * gy + gz * gz + 0.0625 * slope_ * slope_);
}

} // namespace pantin
