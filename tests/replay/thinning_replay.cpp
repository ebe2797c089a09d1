// SPDX-License-Identifier: MIT
// Algorithm 4.1 of the thesis (Zhang & Suen 1984, ERRATA 5) line by line, and the redundant pixels (ERRATA
// 6).
#include <array>

#include "replay/stored.hpp"

namespace pantin::test::replay {
namespace {

// P_2 … P_9 at 2 … 9 (Fig. 4.10); outside is background.
std::array<int, 10> neighbours_of(const Mask& image, int x, int y) {
    const auto at = [&](int dx, int dy) { return image.value_or(x + dx, y + dy, 0) != 0 ? 1 : 0; };
    return {0,        at(0, 0), at(0, -1), at(1, -1), at(1, 0),
            at(1, 1), at(0, 1), at(-1, 1), at(-1, 0), at(-1, -1)};
}

bool condition(const Mask& image, int x, int y, bool second) {
    const std::array<int, 10> p = neighbours_of(image, x, y);
    int b = 0, a = 0;
    for (int i = 2; i <= 9; ++i) {
        b += p[i];
        if (p[i] == 0 && p[i < 9 ? i + 1 : 2] == 1) ++a;
    }
    if (b < 2 || b > 6 || a != 1) return false;
    if (!second) return p[2] * p[4] * p[6] == 0 && p[4] * p[6] * p[8] == 0;
    return p[2] * p[4] * p[8] == 0 && p[2] * p[6] * p[8] == 0;
}

// One half of an iteration; the number of pixels that it deletes.
int half_iteration(Mask& image, bool second) {
    std::vector<Point2i> marked;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (image(x, y) && condition(image, x, y, second)) marked.push_back({x, y});
    for (const Point2i p : marked) image(p.x, p.y) = 0;
    return static_cast<int>(marked.size());
}

// `either`: lines 11 and 21 as printed, the end with the first half that deletes nothing; else with an
// iteration that does.
Mask thin(Mask image, bool either) {
    for (;;) {
        const int first = half_iteration(image, false);
        if (either && first == 0) return image;
        const int second = half_iteration(image, true);
        if (either ? second == 0 : first + second == 0) return image;
    }
}

// Whether the pixel's removal changes neither components nor holes in its neighbourhood: one region of
// background touches one of its sides there, and the neighbours hang together.
bool simple(const Mask& image, int x, int y) {
    Mask window(3, 3);
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            window(dx + 1, dy + 1) = (dx != 0 || dy != 0) && image.value_or(x + dx, y + dy, 0) != 0;
    if (regions_of(window, true, true).area.size() != 1) return false;
    return !window(1, 0) || !window(2, 1) || !window(1, 2) || !window(0, 1);
}

// At most one neighbour, or two side by side.
bool line_end(const Mask& image, int x, int y) {
    const std::array<int, 10> p = neighbours_of(image, x, y);
    int count = 0, beside = 0;
    for (int i = 2; i <= 9; ++i) {
        count += p[i];
        beside += p[i] * p[i < 9 ? i + 1 : 2];
    }
    return count < 2 || (count == 2 && beside == 1);
}

Mask without_redundant(Mask image) {
    for (bool changed = true; changed;) {
        changed = false;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (image(x, y) && !line_end(image, x, y) && simple(image, x, y))
                    image(x, y) = 0, changed = true;
    }
    return image;
}

} // namespace

void replay_thinning(const Stored& s, Tally& tally) {
    const Mask thinned = thin(s.voronoi, s.thesis);
    long pixels = 0;
    for (const auto pixel : thinned) pixels += pixel;
    if (pixels > 0)
        tally.add("Zhang-Suen", thinned == s.thinned); // a 2 × 2 square vanishes; ours keeps a pixel
    const Mask reduced = without_redundant(s.thinned);
    // Only the default cuts cycles afterwards.
    if (s.thesis || holes_of(reduced) == 0) tally.add("redundant pixels", reduced == s.skeleton);
}

} // namespace pantin::test::replay
