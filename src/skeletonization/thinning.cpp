// SPDX-License-Identifier: MIT
// Thinning to one pixel: Zhang & Suen, "A fast parallel algorithm for thinning digital patterns", 1984, as
// Algorithm 4.1 of the thesis, with its misprints mended (B(P_1) for B(P_0), M cleared before each
// sub-iteration, the second one with C_c' and C_d'); then the staircase pixels that it leaves are removed,
// because each would count as a junction. Pixels outside the image are 0.
#include "pantin/skeletonization.hpp"

#include <array>

#include "skeletonization/neighbourhood.hpp"

namespace pantin {
namespace {

// Conditions C_a to C_d (C_c' and C_d' in the second sub-iteration) as a bit table over the 256
// neighbourhoods; bit k stands for P_{k+2}, as in `neighbourhood`.
std::array<bool, 256> deletable(bool second) {
    std::array<bool, 256> table{};
    for (int n = 0; n < 256; ++n) {
        const auto p = [n](int i) { return (n >> (i - 2)) & 1; }; // P_2 … P_9
        int b = 0, a = 0;                                         // B(P_1) and A(P_1)
        for (int i = 2; i <= 9; ++i) {
            b += p(i);
            a += p(i) == 0 && p(i == 9 ? 2 : i + 1) == 1;
        }
        const bool c = second ? p(2) * p(4) * p(8) == 0 : p(2) * p(4) * p(6) == 0;
        const bool d = second ? p(2) * p(6) * p(8) == 0 : p(4) * p(6) * p(8) == 0;
        table[n] = 2 <= b && b <= 6 && a == 1 && c && d;
    }
    return table;
}

} // namespace

Thinning zhang_suen_steps(const Mask& mask, ThinningStop stop) {
    static const std::array<std::array<bool, 256>, 2> tables = {deletable(false), deletable(true)};
    Thinning result{mask, Grid<std::uint16_t>(mask.width(), mask.height())};
    Mask& image = result.thinned;
    std::vector<Point2i> foreground = foreground_pixels(image), marked; // `marked` is M
    std::uint16_t step = 0;
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto& table : tables) {
            ++step;
            marked.clear();
            std::size_t kept = 0;
            for (const Point2i p : foreground) {
                if (table[neighbourhood(image, p.x, p.y)])
                    marked.push_back(p);
                else
                    foreground[kept++] = p;
            }
            foreground.resize(kept);
            for (const Point2i p : marked) {
                image(p.x, p.y) = 0;
                result.removed_in(p.x, p.y) = step;
            }
            if (stop == ThinningStop::either && marked.empty()) return result; // lines 11 and 21
            changed |= !marked.empty();
        }
    }
    return result;
}

Mask zhang_suen(const Mask& mask, ThinningStop stop) { return zhang_suen_steps(mask, stop).thinned; }

Mask remove_redundant_pixels(const Mask& skeleton) {
    Mask image = skeleton;
    std::vector<Point2i> foreground = foreground_pixels(image);
    const auto redundant = [&image](Point2i p) {
        const unsigned n = neighbourhood(image, p.x, p.y);
        if (is_line_end(n) || connectivity_number(n) != 1) return false;
        image(p.x, p.y) = 0;
        return true;
    };
    while (std::erase_if(foreground, redundant) > 0) {
    }
    return image;
}

} // namespace pantin
