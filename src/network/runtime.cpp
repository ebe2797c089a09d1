// SPDX-License-Identifier: MIT
// Which instruction set, and the threads of a forward pass.
#include <atomic>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

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

// Workers sleep until a loop starts; its indices are handed out one by one. The caller works too.
struct Runtime::Pool {
    std::mutex mutex;
    std::condition_variable start, finish;
    const std::function<void(int)>* task = nullptr;
    int count = 0, busy = 0;
    std::uint64_t loop = 0; // number of the current loop
    bool stop = false;
    std::atomic<int> next{0};
    std::exception_ptr error;
    std::vector<std::thread> workers;
    std::vector<float> scratch;

    void work() {
        for (int i = next++; i < count; i = next++) {
            try {
                (*task)(i);
            } catch (...) {
                const std::lock_guard lock(mutex);
                if (!error) error = std::current_exception();
            }
        }
    }
    void run_worker() {
        std::uint64_t seen = 0;
        std::unique_lock lock(mutex);
        while (true) {
            start.wait(lock, [&] { return stop || loop != seen; });
            if (stop) return;
            seen = loop;
            lock.unlock();
            work();
            lock.lock();
            if (--busy == 0) finish.notify_one();
        }
    }
    ~Pool() {
        {
            const std::lock_guard lock(mutex);
            stop = true;
        }
        start.notify_all();
        for (std::thread& worker : workers) worker.join();
    }
};

Runtime::Runtime(int threads, Simd simd) : simd_(simd), pool_(std::make_unique<Pool>()) {
    if (!simd_supported(simd))
        throw Error(ErrorKind::usage, "this processor has no " + std::string(name_of(simd)));
    for (int i = 1; i < threads; ++i)
        pool_->workers.emplace_back([pool = pool_.get()] { pool->run_worker(); });
}

Runtime::~Runtime() = default;

int Runtime::threads() const { return static_cast<int>(pool_->workers.size()) + 1; }

float* Runtime::scratch(std::size_t count) const {
    if (pool_->scratch.size() < count) pool_->scratch.resize(count);
    return pool_->scratch.data();
}

void Runtime::parallel_for(int count, const std::function<void(int)>& task) const {
    if (pool_->workers.empty() || count <= 1) {
        for (int i = 0; i < count; ++i) task(i);
        return;
    }
    {
        const std::lock_guard lock(pool_->mutex);
        pool_->task = &task;
        pool_->count = count;
        pool_->next = 0;
        pool_->busy = static_cast<int>(pool_->workers.size());
        ++pool_->loop;
    }
    pool_->start.notify_all();
    pool_->work();
    std::unique_lock lock(pool_->mutex);
    pool_->finish.wait(lock, [&] { return pool_->busy == 0; });
    if (pool_->error) std::rethrow_exception(std::exchange(pool_->error, nullptr));
}

} // namespace pantin::network
