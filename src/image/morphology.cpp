// SPDX-License-Identifier: MIT
// Binary morphology. Squares are separable and use running counts, so the cost does not depend on the radius;
// discs threshold the exact squared distance transform (Serra 1982: dilation by a disc = parallel set).
#include <algorithm>
#include <cmath>

#include "image/distance.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace {

// out(x, y) = 1 where at least `needed` of the 2·radius+1 pixels of the window along the row are set; pixels
// outside the image are not set.
Mask count_rows(const Mask& mask, int radius, int needed) {
    const int w = mask.width();
    Mask out(w, mask.height());
    for (int y = 0; y < mask.height(); ++y) {
        const std::uint8_t* in = mask.row(y);
        std::uint8_t* to = out.row(y);
        int count = 0;
        for (int x = 0; x < std::min(radius, w); ++x) count += in[x];
        for (int x = 0; x < w; ++x) {
            if (x + radius < w) count += in[x + radius];
            if (x - radius - 1 >= 0) count -= in[x - radius - 1];
            to[x] = count >= needed;
        }
    }
    return out;
}

// The same along the columns, row by row.
Mask count_columns(const Mask& mask, int radius, int needed) {
    const int w = mask.width(), h = mask.height();
    Mask out(w, h);
    std::vector<int> count(static_cast<std::size_t>(w), 0);
    const auto add_row = [&](int y, int sign) {
        const std::uint8_t* in = mask.row(y);
        for (int x = 0; x < w; ++x) count[x] += sign * in[x];
    };
    for (int y = 0; y < std::min(radius, h); ++y) add_row(y, 1);
    for (int y = 0; y < h; ++y) {
        if (y + radius < h) add_row(y + radius, 1);
        if (y - radius - 1 >= 0) add_row(y - radius - 1, -1);
        std::uint8_t* to = out.row(y);
        for (int x = 0; x < w; ++x) to[x] = count[x] >= needed;
    }
    return out;
}

} // namespace

Mask opaque_pixels(const RgbaImage& image) {
    Mask opaque(image.width(), image.height());
    std::transform(image.begin(), image.end(), opaque.begin(),
                   [](Rgba8 p) -> std::uint8_t { return is_opaque(p); });
    return opaque;
}

double share_of_frame(const Mask& mask) {
    long all = 0, own = 0;
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) {
            if (x > 0 && y > 0 && x + 1 < mask.width() && y + 1 < mask.height()) continue;
            ++all;
            own += mask(x, y);
        }
    return all == 0 ? 0 : static_cast<double>(own) / static_cast<double>(all);
}

Mask pad(const Mask& mask, int margin) {
    Mask out(mask.width() + 2 * margin, mask.height() + 2 * margin);
    for (int y = 0; y < mask.height(); ++y)
        std::copy(mask.row(y), mask.row(y) + mask.width(), out.row(y + margin) + margin);
    return out;
}
Mask unpad(const Mask& mask, int margin) {
    return crop(mask, {margin, margin, mask.width() - 2 * margin, mask.height() - 2 * margin});
}

Mask dilate_square(const Mask& mask, int radius) {
    return count_columns(count_rows(mask, radius, 1), radius, 1);
}
Mask erode_square(const Mask& mask, int radius) {
    return count_columns(count_rows(mask, radius, 2 * radius + 1), radius, 2 * radius + 1);
}
// Padded, so that a closing never loses a pixel at the image's border.
Mask close_square(const Mask& mask, int radius) {
    return unpad(erode_square(dilate_square(pad(mask, radius), radius), radius), radius);
}

Mask dilate_disc(const Mask& mask, double radius) { return within_disc(mask, 1, false, radius); }
Mask erode_disc(const Mask& mask, double radius) {
    Mask out = within_disc(mask, 0, true, radius);
    for (std::uint8_t& pixel : out) pixel = !pixel;
    return out;
}
Mask close_disc(const Mask& mask, double radius) {
    const int margin = static_cast<int>(std::ceil(radius));
    return unpad(erode_disc(dilate_disc(pad(mask, margin), radius), radius), margin);
}
Mask open_disc(const Mask& mask, double radius) { return dilate_disc(erode_disc(mask, radius), radius); }

} // namespace pantin
