// SPDX-License-Identifier: MIT
#include "core/thread_pool.hpp"

#include <catch2/catch.hpp>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace pantin {

TEST_CASE("A parallel loop visits every index once and rethrows a task's exception") {
    for (const int threads : {1, 2, 5}) {
        const ThreadPool pool(threads);
        CHECK(pool.threads() == threads);
        for (int round = 0; round < 50; ++round) {
            std::vector<std::atomic<int>> visits(37);
            pool.parallel_for(37, [&](int i) { ++visits[i]; });
            for (const auto& count : visits) CHECK(count == 1);
        }
        CHECK_THROWS_AS(pool.parallel_for(10,
                                          [](int i) {
                                              if (i == 3) throw std::runtime_error("three");
                                          }),
                        std::runtime_error);
        std::atomic<int> after{0};
        pool.parallel_for(5, [&](int) { ++after; });
        CHECK(after == 5);
    }
}

TEST_CASE("A loop on a pool of its own visits every index once, and none of an empty one") {
    std::atomic<int> sum{0};
    parallel_for(3, 10, [&](int i) { sum += i; });
    CHECK(sum == 45);
    parallel_for(3, 0, [&](int) { sum = -1; });
    CHECK(sum == 45);
}

} // namespace pantin
