// SPDX-License-Identifier: MIT
// A row-major 2D array and the pixel types stored in it.
// Pixel (x, y) has its centre at integer coordinates, x to the right, y down, origin top left.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pantin {

// Sides and indices in elements; what is outside is a programming error, asserted, not thrown. Own.
template <class T> class Grid {
public:
    Grid() = default;
    // width × height elements, each `value`; sides ≥ 0.
    Grid(int width, int height, T value = T{})
        : width_(width), height_(height), data_(static_cast<std::size_t>(width) * height, value) {
        assert(width >= 0 && height >= 0);
    }

    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t size() const { return data_.size(); }
    bool empty() const { return data_.empty(); }
    bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

    // The element in column x of row y, which must be inside.
    T& operator()(int x, int y) {
        assert(contains(x, y));
        return data_[static_cast<std::size_t>(y) * width_ + x];
    }
    const T& operator()(int x, int y) const {
        assert(contains(x, y));
        return data_[static_cast<std::size_t>(y) * width_ + x];
    }
    // Value at (x, y), or `outside` beyond the border.
    T value_or(int x, int y, T outside) const { return contains(x, y) ? (*this)(x, y) : outside; }

    // `width` elements from column 0 of row y on; data(), begin(), end(): all rows, from the top.
    T* row(int y) { return data_.data() + static_cast<std::size_t>(y) * width_; }
    const T* row(int y) const { return data_.data() + static_cast<std::size_t>(y) * width_; }
    T* data() { return data_.data(); }
    const T* data() const { return data_.data(); }
    auto begin() { return data_.begin(); }
    auto end() { return data_.end(); }
    auto begin() const { return data_.begin(); }
    auto end() const { return data_.end(); }

    bool operator==(const Grid&) const = default;

private:
    int width_ = 0, height_ = 0;
    std::vector<T> data_;
};

struct Rgb8 {
    std::uint8_t r = 0, g = 0, b = 0;
    bool operator==(const Rgb8&) const = default;
};
struct Rgba8 {
    std::uint8_t r = 0, g = 0, b = 0, a = 0; // straight (not premultiplied) alpha
    bool operator==(const Rgba8&) const = default;
};

using GreyImage = Grid<std::uint8_t>; // 0 black, 255 white
using RgbImage = Grid<Rgb8>;
using RgbaImage = Grid<Rgba8>;
using Mask = Grid<std::uint8_t>;     // 0 or 1 in memory, 0 or 255 in files; 8-connected foreground
using LabelMap = Grid<std::uint8_t>; // value = part label, see label.hpp

} // namespace pantin
