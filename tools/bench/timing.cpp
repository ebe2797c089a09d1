// SPDX-License-Identifier: MIT
// Functions in, times in milliseconds out: medians and ratios of alternating rounds.
#include <algorithm>
#include <chrono>
#include <cstdio>

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
