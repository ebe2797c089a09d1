// SPDX-License-Identifier: MIT
// Times of whole calls, as medians. Machines are noisy: what is compared is measured in turns within one run.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pantin/network.hpp"

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

// The fastest of the calls: for what is compared with a ceiling, and not with a contender in turns.
double least_time(const std::function<void()>& work, int rounds);

// Most fused multiply-adds of one thread, in GFLOP/s; 0 where it is not known how to ask.
double fma_peak(network::Simd simd);
// Most products of bytes, in billions a second; likewise.
double dot_product_peak(network::Simd simd);

void bench_steps(const std::string& page, int rounds);
void bench_kernel(int rounds);
void bench_integer_kernel(int rounds);
void bench_segmenter(int rounds);
void bench_rasteriser(const std::string& folder, int rounds); // for enlarged frames; none: no pictures
void bench_graph_distance(int rounds);
void bench_straight_skeleton(int rounds);
void bench_skeletons(int rounds);                           // of testdata/labels_*.png
void bench_modeling(const std::string& folder, int rounds); // label maps (*.png); none: drawings of our own

} // namespace pantin::bench
