// SPDX-License-Identifier: MIT
// compare_torch mask-rcnn|sketch-parse WEIGHTS TRACE [THREADS]: the largest difference of each module's
// output. Exit code 0 when all agree.
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "compare_torch/trace.hpp"
#include "core/file.hpp"
#include "pantin/error.hpp"

namespace {

using namespace pantin;

int run(const std::string& kind, const char* weights_path, const char* trace_path, int threads) {
    constexpr std::size_t limit = std::size_t{4} << 30;
    const std::vector<unsigned char> weight_bytes = read_file(weights_path, limit),
                                     trace_bytes = read_file(trace_path, limit);
    const network::WeightFile weights(weight_bytes, weights_path), trace(trace_bytes, trace_path);
    const auto compare = kind == "mask-rcnn" ? compare::compare_mask_rcnn : compare::compare_sketch_parse;
    bool agree = true;
    std::printf("%-38s %-34s %10s %10s\n", "tensor", "shape", "absolute", "relative");
    for (const compare::Difference& d : compare(weights, trace, threads)) {
        std::printf("%-38s %-34s %10.2e %10.2e%s\n", d.what.c_str(), d.shape.c_str(), d.absolute, d.relative,
                    d.agrees() ? "" : "  DIFFERENT");
        agree = agree && d.agrees();
    }
    return agree ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::fprintf(stderr, "usage: compare_torch mask-rcnn|sketch-parse WEIGHTS TRACE [THREADS]\n");
        return 2;
    }
    try {
        return run(argv[1], argv[2], argv[3], argc > 4 ? std::atoi(argv[4]) : 1);
    } catch (const Error& error) {
        std::fprintf(stderr, "compare_torch: %s\n", error.what());
        return 1;
    }
}
