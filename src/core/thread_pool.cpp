// SPDX-License-Identifier: MIT
// The indices of a loop are handed out one by one from a counter that all threads share.
#include "core/thread_pool.hpp"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace pantin {

struct ThreadPool::State {
    std::mutex mutex;
    std::condition_variable start, finish;
    const std::function<void(int)>* task = nullptr;
    int count = 0, busy = 0;
    std::uint64_t loop = 0; // number of the current loop
    bool stop = false;
    std::atomic<int> next{0};
    std::exception_ptr error;
    std::vector<std::thread> workers;

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
    ~State() {
        {
            const std::lock_guard lock(mutex);
            stop = true;
        }
        start.notify_all();
        for (std::thread& worker : workers) worker.join();
    }
};

ThreadPool::ThreadPool(int threads) : state_(std::make_unique<State>()) {
    for (int i = 1; i < threads; ++i)
        state_->workers.emplace_back([state = state_.get()] { state->run_worker(); });
}

ThreadPool::~ThreadPool() = default;

int ThreadPool::threads() const { return static_cast<int>(state_->workers.size()) + 1; }

void ThreadPool::parallel_for(int count, const std::function<void(int)>& task) const {
    if (state_->workers.empty() || count <= 1) {
        for (int i = 0; i < count; ++i) task(i);
        return;
    }
    {
        const std::lock_guard lock(state_->mutex);
        state_->task = &task;
        state_->count = count;
        state_->next = 0;
        state_->busy = static_cast<int>(state_->workers.size());
        ++state_->loop;
    }
    state_->start.notify_all();
    state_->work();
    std::unique_lock lock(state_->mutex);
    state_->finish.wait(lock, [&] { return state_->busy == 0; });
    if (state_->error) std::rethrow_exception(std::exchange(state_->error, nullptr));
}

} // namespace pantin
