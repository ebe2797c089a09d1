// SPDX-License-Identifier: MIT
// Distance transforms in linear time. Based on:
// - P. Felzenszwalb, D. Huttenlocher: Distance Transforms of Sampled Functions. Theory of Computing 8, 2012
//   (lower envelope of parabolas, one dimension after the other);
// - A. Meijster, J. Roerdink, W. Hesselink: A General Algorithm for Computing Distance Transforms in Linear
// Time.
//   ISMM 2000 (the same envelope on integers: intersections rounded down, no floating point).
#include "image/distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "core/math.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace {

// Lower envelope of the parabolas f_i(x) = scale·(x − i)² + height_i, i = first … last, on the same integers.
// owner(x) = the i with the smallest f_i(x), the smallest such i among equals.
class LowerEnvelope {
public:
    explicit LowerEnvelope(int n)
        : parabolas_(static_cast<std::size_t>(n)), starts_(static_cast<std::size_t>(n)) {}

    // Calls visit(x, i) for x = last … first.
    template <class Visit>
    void run(const std::vector<std::int64_t>& height, std::int64_t scale, int first, int last, Visit visit) {
        const auto value = [&](std::int64_t x, int i) { return scale * (x - i) * (x - i) + height[i]; };
        int top = 0;
        parabolas_[0] = first;
        starts_[0] = first;
        for (int i = first + 1; i <= last; ++i) {
            while (top >= 0 && value(starts_[top], parabolas_[top]) > value(starts_[top], i)) --top;
            if (top < 0) {
                top = 0;
                parabolas_[0] = i;
                continue; // starts_[0] stays
            }
            const std::int64_t u = parabolas_[top], j = i;
            // Last x at which u is at most as high as i.
            const std::int64_t until = math::floor_divide(
                scale * (j * j - u * u) + height[i] - height[parabolas_[top]], 2 * scale * (j - u));
            if (until < last) {
                ++top;
                parabolas_[top] = i;
                starts_[top] = static_cast<int>(until + 1);
            }
        }
        for (int x = last; x >= first; --x) {
            visit(x, parabolas_[top]);
            if (x == starts_[top]) --top;
        }
    }

private:
    std::vector<int> parabolas_, starts_;
};

// Calls run(first, last) for the stretches of 0 … n−1 that end at the zeros and hold none inside. What lies
// beyond a zero is farther than the zero, so each stretch has its own envelope.
template <class Zero, class Run> void between_zeros(int n, Zero zero, Run run) {
    for (int first = 0; first < n;) {
        int last = first + 1;
        if (last < n && zero(first) && zero(last)) { // no stretch between neighbours
            run(first, first);
            first = last;
            continue;
        }
        while (last < n && !zero(last)) ++last;
        run(first, std::min(last, n - 1));
        first = last;
    }
}

// Distance along the column to the nearest pixel with that value; `far` where there is none or none nearer.
template <class T> Grid<T> column_distance(const Mask& mask, std::uint8_t value, bool outside, int far) {
    const int w = mask.width(), h = mask.height();
    const T most = static_cast<T>(far), least_outside = static_cast<T>(outside ? 0 : far);
    const std::vector<T> beyond(static_cast<std::size_t>(w), least_outside);
    Grid<T> distance(w, h);
    const T* before = beyond.data();
    for (int y = 0; y < h; before = distance.row(y++)) {
        const std::uint8_t* in = mask.row(y);
        T* out = distance.row(y);
        for (int x = 0; x < w; ++x) {
            const T further = before[x] < most ? static_cast<T>(before[x] + 1) : most;
            out[x] = in[x] == value ? T{0} : further;
        }
    }
    before = beyond.data();
    for (int y = h - 1; y >= 0; before = distance.row(y--)) {
        T* out = distance.row(y);
        for (int x = 0; x < w; ++x) {
            const T further = before[x] < most ? static_cast<T>(before[x] + 1) : most;
            out[x] = std::min(out[x], further);
        }
    }
    return distance;
}

// How far to both sides the disc around a pixel still covers the row d away; −1 from the first row that it
// does not reach.
std::vector<int> reach_of_disc(double radius, int farthest) {
    std::vector<int> reach;
    double k = std::min(std::floor(radius), static_cast<double>(farthest));
    for (int d = 0; k >= 0 && d < farthest; ++d) {
        while (k >= 0 && d * static_cast<double>(d) + k * k > radius * radius) --k;
        if (k >= 0) reach.push_back(static_cast<int>(k));
    }
    reach.push_back(-1);
    return reach;
}

// Sets the pixels from `first` to before `end` that lie in the row, and keeps the stretch that was set last,
// so that a stretch that goes on from it costs its new pixels only.
class Painter {
public:
    Painter(std::uint8_t* row, int width) : row_(row), width_(width) {}
    void paint(int first, int end) {
        first = std::max(first, 0), end = std::min(end, width_);
        if (first > end_ || first < first_) first_ = end_ = first;
        for (; end_ < end; ++end_) row_[end_] = 1;
    }

private:
    std::uint8_t* row_;
    int width_, first_ = 0, end_ = 0;
};

// Mostly a row's distances are 0 or out of reach for long: eight at a time.
template <class T>
Mask covered(const Mask& mask, std::uint8_t value, bool outside, const std::vector<int>& reach) {
    const int w = mask.width(), far = static_cast<int>(reach.size()) - 1;
    const Grid<T> column = column_distance<T>(mask, value, outside, far);
    std::array<T, 8> all_near{}, all_far;
    all_far.fill(static_cast<T>(far));
    Mask near(w, mask.height());
    for (int y = 0; y < mask.height(); ++y) {
        const T* in = column.row(y);
        Painter painter(near.row(y), w);
        if (outside) painter.paint(0, reach[0]);
        for (int x = 0; x < w;) {
            const bool eight = x + 8 <= w;
            if (eight && std::memcmp(in + x, all_far.data(), sizeof all_far) == 0) {
                x += 8;
            } else if (eight && std::memcmp(in + x, all_near.data(), sizeof all_near) == 0) {
                painter.paint(x - reach[0], x + 8 + reach[0]);
                x += 8;
            } else {
                if (const int k = reach[in[x]]; k >= 0) painter.paint(x - k, x + k + 1);
                ++x;
            }
        }
        if (outside) painter.paint(w - reach[0], w);
    }
    return near;
}

} // namespace

Grid<int> squared_distance_to(const Mask& mask, std::uint8_t value, bool outside) {
    const int w = mask.width(), h = mask.height();
    if (mask.empty()) return Grid<int>(w, h);
    const int far = w + h; // (2·16384)² + 16384² < 2³¹
    Grid<int> result = column_distance<int>(mask, value, outside, far);
    // Two more parabolas stand for the columns left and right of the image.
    const int shift = outside ? 1 : 0;
    std::vector<std::int64_t> height(static_cast<std::size_t>(w + 2 * shift), 0);
    LowerEnvelope envelope(w + 2 * shift);
    for (int y = 0; y < h; ++y) {
        int* out = result.row(y);
        for (int x = 0; x < w; ++x) height[x + shift] = static_cast<std::int64_t>(out[x]) * out[x];
        const auto visit = [&](int x, int i) {
            if (x >= shift && x < w + shift) out[x - shift] = static_cast<int>(height[i] + (x - i) * (x - i));
        };
        between_zeros(
            w + 2 * shift, [&](int x) { return height[x] == 0; },
            [&](int first, int last) { envelope.run(height, 1, first, last, visit); });
    }
    return result;
}

Mask within_disc(const Mask& mask, std::uint8_t value, bool outside, double radius) {
    if (mask.empty()) return Mask(mask.width(), mask.height());
    const std::vector<int> reach = reach_of_disc(radius, mask.width() + mask.height());
    return reach.size() <= 256 ? covered<std::uint8_t>(mask, value, outside, reach)
                               : covered<int>(mask, value, outside, reach);
}

Grid<int> squared_distance_transform(const Mask& mask) { return squared_distance_to(mask, 0, true); }

Grid<float> distance_transform(const Mask& mask) {
    const Grid<int> squared = squared_distance_transform(mask);
    Grid<float> distance(mask.width(), mask.height());
    for (std::size_t i = 0; i < distance.size(); ++i)
        distance.data()[i] = std::sqrt(static_cast<float>(squared.data()[i]));
    return distance;
}

Grid<int> nearest_seed(const Mask& seeds) {
    const int w = seeds.width(), h = seeds.height();
    // At first the row of the nearest seed of the column, the upper one among equals; −1 when it has none.
    Grid<int> nearest(w, h, -1);
    const std::vector<int> none(static_cast<std::size_t>(w), -1);
    for (int y = 0; y < h; ++y) {
        const std::uint8_t* seed = seeds.row(y);
        const int* above = y > 0 ? nearest.row(y - 1) : none.data();
        int* row = nearest.row(y);
        for (int x = 0; x < w; ++x) row[x] = seed[x] ? y : above[x];
    }
    std::vector<int> below = none;
    bool any = false;
    for (int y = h - 1; y >= 0; --y) {
        int* row = nearest.row(y);
        for (int x = 0; x < w; ++x) {
            if (row[x] == y) below[x] = y, any = true;
            if (below[x] >= 0 && (row[x] < 0 || below[x] - y < y - row[x])) row[x] = below[x];
        }
    }
    if (!any) return nearest;
    // Minimises (squared distance, row, column) in this order: the row goes into the lowest digits of the
    // height.
    const std::int64_t scale = h, far = static_cast<std::int64_t>(w + h) * (w + h) * scale;
    std::vector<std::int64_t> height(static_cast<std::size_t>(w), 0);
    std::vector<int> row(static_cast<std::size_t>(w));
    LowerEnvelope envelope(w);
    for (int y = 0; y < h; ++y) {
        int* out = nearest.row(y);
        std::copy(out, out + w, row.begin());
        for (int x = 0; x < w; ++x) {
            const std::int64_t dy = row[x] - y;
            height[x] = row[x] < 0 ? far : dy * dy * scale + row[x];
        }
        between_zeros(
            w, [&](int x) { return row[x] == y; },
            [&](int first, int last) {
                envelope.run(height, scale, first, last, [&](int x, int i) { out[x] = row[i] * w + i; });
            });
    }
    return nearest;
}

} // namespace pantin
