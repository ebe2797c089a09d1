// SPDX-License-Identifier: MIT
// This work is based on: Juan Pineda, A parallel algorithm for polygon rasterization, 1988 (edge functions).
// Vertices are snapped to 1/256 of a sample, edge functions are integers and edges follow the top-left rule:
// every sample of two abutting faces belongs to exactly one, on every machine.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "core/math.hpp"
#include "pantin/grid.hpp"

namespace pantin {

constexpr std::int64_t sample_units = 256; // fixed-point units per sample

// A vertex on the sample grid. `w` is 1/depth of the perspective camera, 1 in the orthographic one.
struct ScreenVertex {
    std::int64_t x = 0, y = 0;  // fixed point, y down
    double z = 0;               // a whole number; larger is nearer
    double w = 1, u = 0, v = 0; // u and v: texels, divided by depth
    double light = 1;           // brightness, 0 to 1
    Rgb8 colour;                // of solids without a texture
};

struct SampleSpan {
    int begin = 0, end = 0;
};

// The samples of a row or column from `low` to `high`, both fixed point.
inline SampleSpan samples_between(std::int64_t low, std::int64_t high) {
    return {static_cast<int>(math::floor_divide(low + sample_units / 2 - 1, sample_units)),
            static_cast<int>(math::floor_divide(high - sample_units / 2, sample_units) + 1)};
}

// Positive inside (y down, clockwise). A sample on the edge belongs to it if the edge is a top or a left one.
struct ScreenEdge {
    std::int32_t x = 0, y = 0, dx = 0, dy = 0; // coordinates stay below 2^28
    ScreenEdge() = default;
    ScreenEdge(const ScreenVertex& from, const ScreenVertex& to)
        : x(static_cast<std::int32_t>(from.x)), y(static_cast<std::int32_t>(from.y)),
          dx(static_cast<std::int32_t>(to.x - from.x)), dy(static_cast<std::int32_t>(to.y - from.y)) {}
    // At the first sample of the row; a sample is inside from 0 on.
    std::int64_t at_row(int row) const {
        const bool top_left = (dy == 0 && dx > 0) || dy < 0;
        return dx * (row * sample_units + sample_units / 2 - y) - dy * (sample_units / 2 - x) -
               (top_left ? 0 : 1);
    }
    // From one end to the other.
    SampleSpan rows() const { return samples_between(std::min(y, y + dy), std::max(y, y + dy)); }
};

// Where a row's samples inside an edge that is not level begin (a left edge) or end (a right one), row after
// row without a division.
class EdgeWalk {
public:
    EdgeWalk() = default;
    EdgeWalk(const ScreenEdge& edge, int row) : left_(edge.dy < 0) {
        const std::int64_t first = edge.at_row(row), down = sample_units * edge.dx;
        size_ = sample_units *
                std::abs(std::int64_t{edge.dy}); // what the function changes by from sample to sample
        whole_ = math::floor_divide(first, size_), rest_ = first - whole_ * size_;
        whole_step_ = math::floor_divide(down, size_), rest_step_ = down - whole_step_ * size_;
    }
    // The first sample inside, or the first one outside: first + x · size ≥ 0, or first - x · size < 0.
    std::int64_t sample() const { return left_ ? -whole_ : whole_ + 1; }
    void next_row() {
        whole_ += whole_step_, rest_ += rest_step_;
        if (rest_ >= size_) rest_ -= size_, ++whole_;
    }

private:
    bool left_ = false;
    std::int64_t size_ = 1, whole_ = 0, whole_step_ = 0, rest_ = 0, rest_step_ = 0;
};

// A value that changes evenly over a face.
struct ScreenPlane {
    double at = 0, dx = 0, dy = 0; // in the middle; per sample
};

// A triangle, or a convex quadrangle whose values change about evenly.
class ScreenFace {
public:
    // The corners clockwise, three or four of them; none is concave.
    explicit ScreenFace(std::span<const ScreenVertex* const> corners) : count_(corners.size()) {
        std::int64_t left = corners[0]->x, right = left, top = corners[0]->y, bottom = top;
        for (std::size_t i = 0; i < count_; ++i) {
            const ScreenVertex &from = *corners[i], &to = *corners[(i + 1) % count_];
            edges_[i] = ScreenEdge(from, to);
            left = std::min(left, from.x), right = std::max(right, from.x);
            top = std::min(top, from.y), bottom = std::max(bottom, from.y);
            x_ += static_cast<double>(from.x), y_ += static_cast<double>(from.y);
        }
        const double unit = static_cast<double>(count_) * sample_units;
        x_ = x_ / unit - 0.5, y_ = y_ / unit - 0.5;
        rows_ = samples_between(top, bottom - 1), columns_ = samples_between(left, right);
        // Two sides of the triangle, or the diagonals.
        const ScreenVertex &p = *corners[0], &q = *corners[count_ - 2], &r = *corners[1],
                           &s = *corners[count_ - 1];
        const std::int64_t qx = q.x - p.x, qy = q.y - p.y, sx = s.x - (count_ == 3 ? p.x : r.x),
                           sy = s.y - (count_ == 3 ? p.y : r.y);
        const double scale = static_cast<double>(sample_units) / static_cast<double>(qx * sy - qy * sx);
        qx_ = scale * static_cast<double>(qx), qy_ = scale * static_cast<double>(qy);
        sx_ = scale * static_cast<double>(sx), sy_ = scale * static_cast<double>(sy);
    }

    // The plane through three values at the corners, or next to four.
    ScreenPlane plane(const std::array<double, 4>& values) const {
        double sum = 0;
        for (std::size_t i = 0; i < count_; ++i) sum += values[i];
        const double q = values[count_ - 2] - values[0],
                     s = values[count_ - 1] - (count_ == 3 ? values[0] : values[1]);
        return {sum / static_cast<double>(count_), q * sy_ - s * qy_, s * qx_ - q * sx_};
    }
    // Its value at a place of the sample grid, where samples are whole numbers.
    double value(const ScreenPlane& plane, double x, double y) const {
        return plane.at + plane.dx * (x - x_) + plane.dy * (y - y_);
    }

    std::span<const ScreenEdge> edges() const { return {edges_.data(), count_}; }
    // All samples inside are in these rows and columns, which may lie outside of the frame; those on a level
    // lower edge are not inside.
    SampleSpan rows() const { return rows_; }
    SampleSpan columns() const { return columns_; }

private:
    std::size_t count_;
    std::array<ScreenEdge, 4> edges_;
    double x_ = 0, y_ = 0;     // the middle of the corners, on the sample grid
    double qx_, qy_, sx_, sy_; // two vectors between corners, over the area
    SampleSpan rows_, columns_;
};

// The samples of a face, row after row. A row crosses one left and one right edge of it; where it meets a
// corner, both edges of that side say the same.
class FaceWalk {
public:
    explicit FaceWalk(const ScreenFace& face) : face_(&face) {}

    // Of the next row, which is one of the face's, the samples inside among those of `columns`.
    SampleSpan next(int row, SampleSpan columns) {
        const auto left = left_.sample(*face_, row, true), right = right_.sample(*face_, row, false);
        const auto begin = std::max<std::int64_t>(left, columns.begin),
                   end = std::min<std::int64_t>(right, columns.end);
        return begin < end ? SampleSpan{static_cast<int>(begin), static_cast<int>(end)} : SampleSpan{};
    }

private:
    struct Side {
        EdgeWalk walk;
        SampleSpan rows; // of the edge
        std::int64_t sample(const ScreenFace& face, int row, bool left) {
            if (row < rows.end) {
                walk.next_row();
                return walk.sample();
            }
            for (const ScreenEdge& edge : face.edges()) {
                if (left ? edge.dy >= 0 : edge.dy <= 0) continue;
                rows = edge.rows();
                if (row < rows.begin || row >= rows.end) continue;
                walk = EdgeWalk(edge, row);
                break;
            }
            return walk.sample();
        }
    };
    const ScreenFace* face_;
    Side left_{{}, {0, -(1 << 30)}}, right_{{}, {0, -(1 << 30)}};
};

} // namespace pantin
