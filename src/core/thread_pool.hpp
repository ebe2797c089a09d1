// SPDX-License-Identifier: MIT
// Threads that run the indices of a loop; nothing that uses them may depend on which thread takes which.
#pragma once

#include <functional>
#include <memory>

namespace pantin {

// The caller of a loop works, too, so a pool of n has n − 1 threads of its own, which sleep between loops.
class ThreadPool {
public:
    // 1 and less: the caller alone.
    explicit ThreadPool(int threads);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    int threads() const;
    // Calls task(0) … task(count − 1), each once, in any order; returns when all are done. The first
    // exception of a task is rethrown; whether the indices after it ran is open. One loop at a time.
    void parallel_for(int count, const std::function<void(int)>& task) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

// One loop on a pool of its own.
inline void parallel_for(int threads, int count, const std::function<void(int)>& task) {
    ThreadPool(threads).parallel_for(count, task);
}

} // namespace pantin
