// SPDX-License-Identifier: MIT
// Distance transforms in linear time. Based on:
// - P. Felzenszwalb, D. Huttenlocher: Distance Transforms of Sampled Functions. Theory of Computing 8, 2012
//   (lower envelope of parabolas, one dimension after the other);
// - A. Meijster, J. Roerdink, W. Hesselink: A General Algorithm for Computing Distance Transforms in Linear
// Time.
//   ISMM 2000 (the same envelope on integers: intersections rounded down, no floating point).
#include "image/distance.hpp"

#include <cmath>

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

// Distance along the column to the nearest pixel with that value; `far` where there is none.
Grid<int> column_distance(const Mask& mask, std::uint8_t value, bool outside, int far) {
    const int w = mask.width(), h = mask.height();
    Grid<int> distance(w, h);
    std::vector<int> run(static_cast<std::size_t>(w), outside ? 0 : far);
    for (int y = 0; y < h; ++y) {
        const std::uint8_t* in = mask.row(y);
        int* out = distance.row(y);
        for (int x = 0; x < w; ++x) out[x] = run[x] = in[x] == value ? 0 : std::min(run[x] + 1, far);
    }
    run.assign(run.size(), outside ? 0 : far);
    for (int y = h - 1; y >= 0; --y) {
        const std::uint8_t* in = mask.row(y);
        int* out = distance.row(y);
        for (int x = 0; x < w; ++x) {
            run[x] = in[x] == value ? 0 : std::min(run[x] + 1, far);
            out[x] = std::min(out[x], run[x]);
        }
    }
    return distance;
}

} // namespace

Grid<int> squared_distance_to(const Mask& mask, std::uint8_t value, bool outside) {
    const int w = mask.width(), h = mask.height();
    Grid<int> result(w, h);
    if (mask.empty()) return result;
    const int far = w + h; // (2·16384)² + 16384² < 2³¹
    const Grid<int> column = column_distance(mask, value, outside, far);
    // Two more parabolas stand for the columns left and right of the image.
    const int shift = outside ? 1 : 0;
    std::vector<std::int64_t> height(static_cast<std::size_t>(w + 2 * shift), 0);
    LowerEnvelope envelope(w + 2 * shift);
    for (int y = 0; y < h; ++y) {
        const int* in = column.row(y);
        int* out = result.row(y);
        for (int x = 0; x < w; ++x) height[x + shift] = static_cast<std::int64_t>(in[x]) * in[x];
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
    const int w = mask.width(), h = mask.height(), far = w + h;
    Mask near(w, h);
    if (mask.empty()) return near;
    const Grid<int> column = column_distance(mask, value, outside, far);
    // reach[d]: how far to both sides the disc around a pixel with that value still covers the row d away;
    // −1: no more.
    std::vector<int> reach(static_cast<std::size_t>(far) + 1, -1);
    double k = std::min(std::floor(radius), static_cast<double>(far));
    for (int d = 0; d < far; ++d) {
        while (k >= 0 && d * static_cast<double>(d) + k * k > radius * radius) --k;
        reach[d] = static_cast<int>(k);
    }
    const int beyond = outside ? reach[0] : -1;
    for (int y = 0; y < h; ++y) {
        const int* in = column.row(y);
        std::uint8_t* out = near.row(y);
        for (int x = 0, left = beyond; x < w; ++x) {
            left = std::max(left - 1, reach[in[x]]);
            out[x] = left >= 0;
        }
        for (int x = w - 1, right = beyond; x >= 0; --x) {
            right = std::max(right - 1, reach[in[x]]);
            out[x] |= right >= 0;
        }
    }
    return near;
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
    Grid<int> nearest(w, h, -1);
    // Row of the nearest seed of the column, the upper one among equals; −1 when the column has none.
    Grid<int> row(w, h, -1);
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) row(x, y) = seeds(x, y) ? y : y > 0 ? row(x, y - 1) : -1;
    std::vector<int> below(static_cast<std::size_t>(w), -1);
    bool any = false;
    for (int y = h - 1; y >= 0; --y) {
        for (int x = 0; x < w; ++x) {
            if (seeds(x, y)) below[x] = y, any = true;
            const int above = row(x, y);
            if (below[x] >= 0 && (above < 0 || below[x] - y < y - above)) row(x, y) = below[x];
        }
    }
    if (!any) return nearest;
    // Minimises (squared distance, row, column) in this order: the row goes into the lowest digits of the
    // height.
    const std::int64_t scale = h, far = static_cast<std::int64_t>(w + h) * (w + h) * scale;
    std::vector<std::int64_t> height(static_cast<std::size_t>(w), 0);
    LowerEnvelope envelope(w);
    for (int y = 0; y < h; ++y) {
        for (int x = 0; x < w; ++x) {
            const std::int64_t dy = row(x, y) - y;
            height[x] = row(x, y) < 0 ? far : dy * dy * scale + row(x, y);
        }
        between_zeros(
            w, [&](int x) { return row(x, y) == y; },
            [&](int first, int last) {
                envelope.run(height, scale, first, last,
                             [&](int x, int i) { nearest(x, y) = row(i, y) * w + i; });
            });
    }
    return nearest;
}

} // namespace pantin
