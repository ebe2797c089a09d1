// SPDX-License-Identifier: MIT
// Which instruction set a forward pass takes, and its threads and working memory.
#include <cstdlib>

#include "core/thread_pool.hpp"
#include "network/variant.hpp"
#include "pantin/error.hpp"
#include "pantin/network.hpp"

namespace pantin::network {

std::string_view name_of(Simd simd) {
    switch (simd) {
    case Simd::avx2:
        return "avx2";
    case Simd::avx512:
        return "avx512";
    case Simd::neon:
        return "neon";
    default:
        return "baseline";
    }
}

const Kernel& kernel_of(Simd simd) {
    switch (simd) {
    case Simd::avx2:
        return kernel_avx2;
    case Simd::avx512:
        return kernel_avx512;
    case Simd::neon:
        return kernel_neon;
    default:
        return kernel_baseline;
    }
}

bool simd_supported(Simd simd) {
    if (kernel_of(simd).width == 0) return false;
#if defined(__x86_64__)
    if (simd == Simd::avx512) return __builtin_cpu_supports("avx512f");
    if (simd == Simd::avx2) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#endif
    return true;
}

Simd best_simd() {
    if (const char* forced = std::getenv("PANTIN_SIMD"); forced && *forced) {
        for (const Simd simd : all_simd)
            if (name_of(simd) == forced && simd_supported(simd)) return simd;
        throw Error(ErrorKind::usage, std::string("PANTIN_SIMD: this processor has no '") + forced + "'");
    }
    for (const Simd simd : {Simd::avx512, Simd::avx2, Simd::neon})
        if (simd_supported(simd)) return simd;
    return Simd::baseline;
}

Runtime::Runtime(int threads, Simd simd) : simd_(simd) {
    if (!simd_supported(simd))
        throw Error(ErrorKind::usage, "this processor has no " + std::string(name_of(simd)));
    pool_ = std::make_unique<ThreadPool>(threads);
}

Runtime::~Runtime() = default;

int Runtime::threads() const { return pool_->threads(); }

float* Runtime::scratch(std::size_t count) const {
    if (scratch_.size() < count) scratch_.resize(count);
    return scratch_.data();
}

void Runtime::parallel_for(int count, const std::function<void(int)>& task) const {
    pool_->parallel_for(count, task);
}

} // namespace pantin::network
