// SPDX-License-Identifier: MIT
// make bench: the time of each step on a page, and of the kernels beside their baselines.
// Usage: bench [PAGE [ROUNDS]]
//        bench modeling [FOLDER]       strokes to models alone; label maps whose silhouettes are taken
//        bench skeletons [ROUNDS]      the 2D skeletons alone
//        bench kernels [ROUNDS]        the kernels of the networks alone
//        bench rasteriser [FOLDER]     the frames of a film alone; enlarged ones side by side
//        bench segmenter [ROUNDS]      the segmentation network alone (against_torch.py calls it in turns
//        with PyTorch)
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

#include "bench.hpp"

int main(int argc, char** argv) {
    try {
        const int rounds = argc > 2 ? std::max(1, std::atoi(argv[2])) : 5;
        if (argc > 1 && std::strcmp(argv[1], "kernels") == 0) {
            pantin::bench::bench_kernel(rounds);
            pantin::bench::bench_integer_kernel(rounds);
            return 0;
        }
        if (argc > 1 && std::strcmp(argv[1], "segmenter") == 0) {
            pantin::bench::bench_segmenter(rounds);
            return 0;
        }
        if (argc > 1 && std::strcmp(argv[1], "modeling") == 0) {
            pantin::bench::bench_straight_skeleton(5);
            pantin::bench::bench_modeling(argc > 2 ? argv[2] : "", 5);
            return 0;
        }
        if (argc > 1 && std::strcmp(argv[1], "rasteriser") == 0) {
            pantin::bench::bench_rasteriser(argc > 2 ? argv[2] : "", 5);
            return 0;
        }
        if (argc > 1 && std::strcmp(argv[1], "skeletons") == 0) {
            pantin::bench::bench_skeletons(rounds);
            return 0;
        }
        pantin::bench::bench_steps(argc > 1 ? argv[1] : "testdata/demo.png", rounds);
        pantin::bench::bench_kernel(rounds);
        pantin::bench::bench_integer_kernel(rounds);
        pantin::bench::bench_segmenter(rounds);
        pantin::bench::bench_rasteriser("", rounds);
        pantin::bench::bench_graph_distance(rounds);
        pantin::bench::bench_straight_skeleton(rounds);
        pantin::bench::bench_skeletons(rounds);
        pantin::bench::bench_modeling("", rounds);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench: %s\n", error.what());
        return 1;
    }
}
