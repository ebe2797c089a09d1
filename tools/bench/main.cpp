// make bench: the time of each step on a page, and of the kernels beside their baselines.
// Usage: bench [PAGE [ROUNDS]]
//        bench modeling [FOLDER]       strokes to models alone; label maps whose silhouettes are taken
//        bench skeletons [ROUNDS]      the 2D skeletons alone
//        bench segmenter [ROUNDS]      the segmentation network alone (against_torch.py calls it in turns with PyTorch)
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

#include "bench.hpp"

namespace pantin::bench {

namespace {

double milliseconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> times) {
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
}

} // namespace

double median_time(const std::function<void()>& work, int rounds) {
    std::vector<double> times;
    for (int i = 0; i < rounds; ++i) times.push_back(milliseconds(work));
    return median(times);
}

double least_time(const std::function<void()>& work, int rounds) {
    double least = milliseconds(work);
    for (int i = 1; i < rounds; ++i) least = std::min(least, milliseconds(work));
    return least;
}

void compare(const std::string& title, const std::vector<Contender>& contenders, int rounds) {
    std::vector<std::vector<double>> times(contenders.size());
    for (int i = 0; i < rounds; ++i)
        for (std::size_t c = 0; c < contenders.size(); ++c)
            times[c].push_back(milliseconds(contenders[c].work));
    std::printf("\n%s\n", title.c_str());
    const double baseline = median(times[0]);
    for (std::size_t c = 0; c < contenders.size(); ++c) {
        const double time = median(times[c]);
        std::printf("  %-36s %10.3f ms   x %.1f\n", contenders[c].name.c_str(), time, baseline / time);
    }
}

} // namespace pantin::bench

int main(int argc, char** argv) {
    try {
        const int rounds = argc > 2 ? std::max(1, std::atoi(argv[2])) : 5;
        if (argc > 1 && std::strcmp(argv[1], "segmenter") == 0) {
            pantin::bench::bench_segmenter(rounds);
            return 0;
        }
        if (argc > 1 && std::strcmp(argv[1], "modeling") == 0) {
            pantin::bench::bench_straight_skeleton(5);
            pantin::bench::bench_modeling(argc > 2 ? argv[2] : "", 5);
            return 0;
        }
        if (argc > 1 && std::strcmp(argv[1], "skeletons") == 0) {
            pantin::bench::bench_skeletons(rounds);
            return 0;
        }
        pantin::bench::bench_steps(argc > 1 ? argv[1] : "testdata/demo.png", rounds);
        pantin::bench::bench_kernel(rounds);
        pantin::bench::bench_segmenter(rounds);
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
