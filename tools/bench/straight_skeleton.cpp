// SPDX-License-Identifier: MIT
// Straight skeletons of star-shaped polygons, about half of whose corners are reflex: how the time grows.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench.hpp"
#include "core/math.hpp"
#include "core/random.hpp"
#include "pantin/straight_skeleton.hpp"

namespace pantin::bench {

void bench_straight_skeleton(int rounds) {
    std::printf("\nstraight skeleton\n  corners          ms   us / (n log2 n)\n");
    for (const int n : {42, 200, 400, 600, 1000, 2000, 5000, 10000}) {
        Random random(static_cast<std::uint64_t>(n));
        std::vector<double> angles(n);
        for (double& a : angles) a = random.uniform(0, 2 * math::pi);
        std::sort(angles.begin(), angles.end());
        std::vector<Point2d> loop;
        for (const double a : angles) {
            const double r = random.uniform(0.7, 1);
            loop.push_back({r * math::cos(a), r * math::sin(a)});
        }
        const double time = median_time([&] { straight_skeleton({loop}); }, rounds);
        std::printf("  %7d  %10.3f  %14.3f\n", n, time, 1000 * time / (n * std::log2(n)));
    }
}

} // namespace pantin::bench
