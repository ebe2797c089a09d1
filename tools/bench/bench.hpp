// Times of whole calls, as medians. Machines are noisy: what is compared is measured in turns within one run.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace pantin::bench {

struct Contender {
    std::string name;
    std::function<void()> work;
};

// Runs the contenders in turns, `rounds` times each, and prints the median of each in milliseconds and its
// ratio to the first one.
void compare(const std::string& title, const std::vector<Contender>& contenders, int rounds);

// Median time of a call in milliseconds.
double median_time(const std::function<void()>& work, int rounds);

void bench_steps(const std::string& page, int rounds);
void bench_kernel(int rounds);
void bench_graph_distance(int rounds);

} // namespace pantin::bench
