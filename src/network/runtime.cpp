// SPDX-License-Identifier: MIT
// Which instruction set a forward pass takes, and its threads and working memory.
#include <algorithm>
#include <cstdlib>
#include <iterator>

#if defined(__aarch64__) && defined(__linux__)
#include <asm/hwcap.h>
#include <sys/auxv.h>
#endif

#include "core/thread_pool.hpp"
#include "network/variant.hpp"
#include "pantin/error.hpp"
#include "pantin/network.hpp"

namespace pantin::network {

namespace {

#if defined(__x86_64__)
bool has_avx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
bool has_avx512() { return __builtin_cpu_supports("avx512f"); }
bool has_vnni() { return __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vnni"); }
bool has_sse41() { return __builtin_cpu_supports("sse4.1"); }
#endif

// The fastest first.
constexpr Simd by_speed[] = {Simd::vnni,     Simd::avx512, Simd::avx2,    Simd::sse41,
                             Simd::neon_dot, Simd::neon,   Simd::baseline};

} // namespace

std::string_view name_of(Simd simd) {
    switch (simd) {
    case Simd::sse41:
        return "sse4.1";
    case Simd::avx2:
        return "avx2";
    case Simd::avx512:
        return "avx512";
    case Simd::vnni:
        return "vnni";
    case Simd::neon:
        return "neon";
    case Simd::neon_dot:
        return "neon-dot";
    default:
        return "baseline";
    }
}

const Kernel& kernel_of(Simd simd) {
    switch (simd) {
    case Simd::avx2:
        return kernel_avx2;
    case Simd::avx512:
    case Simd::vnni:
        return kernel_avx512;
    case Simd::neon:
    case Simd::neon_dot:
        return kernel_neon;
    default:
        return kernel_baseline;
    }
}

const integer::Kernel& integer_kernel_of(Simd simd) {
    switch (simd) {
    case Simd::sse41:
        return integer::kernel_sse41;
    case Simd::avx2:
    case Simd::avx512: // has no instructions on bytes
        return integer::kernel_avx2;
    case Simd::vnni:
        return integer::kernel_vnni;
    case Simd::neon:
        return integer::kernel_neon;
    case Simd::neon_dot:
        return integer::kernel_neon_dot;
    default:
        return integer::kernel_baseline;
    }
}

bool simd_supported(Simd simd) {
    if (kernel_of(simd).width == 0 || integer_kernel_of(simd).width == 0) return false;
#if defined(__x86_64__)
    if (simd == Simd::vnni) return has_avx2() && has_avx512() && has_vnni();
    if (simd == Simd::avx512) return has_avx2() && has_avx512();
    if (simd == Simd::avx2) return has_avx2();
    if (simd == Simd::sse41) return has_sse41();
#elif defined(__aarch64__) && defined(__linux__)
    if (simd == Simd::neon_dot) return (getauxval(AT_HWCAP) & HWCAP_ASIMDDP) != 0;
#endif
    return true;
}

Simd best_simd() {
    if (const char* forced = std::getenv("PANTIN_SIMD"); forced && *forced) {
        std::string known;
        for (const Simd simd : all_simd) {
            if (!simd_supported(simd)) continue;
            if (name_of(simd) == forced) return simd;
            known += (known.empty() ? "" : ", ") + std::string(name_of(simd));
        }
        throw Error(ErrorKind::usage, std::string("PANTIN_SIMD: '") + forced +
                                          "' is none of this processor's instruction sets (" + known + ")");
    }
    return *std::find_if(std::begin(by_speed), std::end(by_speed), simd_supported);
}

Runtime::Runtime(int threads, Simd simd) : simd_(simd) {
    if (!simd_supported(simd))
        throw Error(ErrorKind::usage, "this processor has no " + std::string(name_of(simd)));
    pool_ = std::make_unique<ThreadPool>(threads);
}

Runtime::~Runtime() {
    if (scratch_.data) give_back(scratch_);
}

int Runtime::threads() const { return pool_->threads(); }

void* Runtime::scratch_memory(std::size_t count) const {
    if (scratch_.capacity < count) {
        if (scratch_.data) give_back(scratch_);
        scratch_ = {};
        scratch_ = take_block(count);
    }
    return scratch_.data;
}

void Runtime::parallel_for(int count, const std::function<void(int)>& task) const {
    pool_->parallel_for(count, task);
}

} // namespace pantin::network
