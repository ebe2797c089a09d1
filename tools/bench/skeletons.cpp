// SPDX-License-Identifier: MIT
// The four 2D skeletons of the same silhouettes, from labels to graph.
#include <string>

#include "bench.hpp"
#include "pantin/image.hpp"
#include "pantin/skeletonization.hpp"

namespace pantin::bench {

void bench_skeletons(int rounds) {
    constexpr std::pair<const char*, SkeletonMethod> methods[] = {{"voronoi", SkeletonMethod::voronoi},
                                                                  {"straight", SkeletonMethod::straight},
                                                                  {"thinning", SkeletonMethod::thinning},
                                                                  {"chordal", SkeletonMethod::chordal}};
    for (const std::string type : {"humanoid", "quadruped", "flying"}) {
        const LabelMap labels = load_grey("testdata/labels_" + type + ".png");
        std::vector<Contender> contenders;
        for (const auto& [name, method] : methods) {
            SkeletonizationOptions options;
            options.method = method;
            contenders.push_back({name, [&labels, options] { skeletonize(labels, options); }});
        }
        const std::string size = std::to_string(labels.width()) + "x" + std::to_string(labels.height());
        compare("skeleton, " + type + ", " + size, contenders, rounds);
    }
}

} // namespace pantin::bench
