// SPDX-License-Identifier: MIT
// Brightness, and what is darker than its surroundings. P. D. Wellner, Adaptive Thresholding for the
// DigitalDesk, 1993 (darker than the local mean by a margin).
#include "pantin/image.hpp"

namespace pantin {

GreyImage greyscale(const RgbImage& image) {
    GreyImage grey(image.width(), image.height());
    for (std::size_t i = 0; i < image.size(); ++i) {
        const Rgb8 p = image.data()[i];
        grey.data()[i] = static_cast<std::uint8_t>((299u * p.r + 587u * p.g + 114u * p.b + 500u) / 1000u);
    }
    return grey;
}

Mask adaptive_threshold(const GreyImage& image, int radius, int offset) {
    const int w = image.width(), h = image.height();
    Mask ink(w, h);
    std::vector<int> column(static_cast<std::size_t>(w), 0); // sums over the rows of the window
    const auto add_row = [&](int y, int sign) {
        const std::uint8_t* in = image.row(y);
        for (int x = 0; x < w; ++x) column[x] += sign * in[x];
    };
    for (int y = 0; y < std::min(radius, h); ++y) add_row(y, 1);
    for (int y = 0; y < h; ++y) {
        if (y + radius < h) add_row(y + radius, 1);
        if (y - radius - 1 >= 0) add_row(y - radius - 1, -1);
        const std::int64_t window_rows = std::min(h - 1, y + radius) - std::max(0, y - radius) + 1;
        std::int64_t sum = 0;
        for (int x = 0; x < std::min(radius, w); ++x) sum += column[x];
        for (int x = 0; x < w; ++x) {
            if (x + radius < w) sum += column[x + radius];
            if (x - radius - 1 >= 0) sum -= column[x - radius - 1];
            const std::int64_t count =
                window_rows * (std::min(w - 1, x + radius) - std::max(0, x - radius) + 1);
            ink(x, y) = (image(x, y) + offset) * count < sum;
        }
    }
    return ink;
}

} // namespace pantin
