// SPDX-License-Identifier: MIT
// The test program. Ends with the line `N passed, N failed` (test cases), which CI reads.
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>

#include <cstdio>

namespace {
std::size_t passed = 0, failed = 0;

struct Totals : Catch::TestEventListenerBase {
    using TestEventListenerBase::TestEventListenerBase;
    void testRunEnded(const Catch::TestRunStats& stats) override {
        passed = stats.totals.testCases.passed;
        failed = stats.totals.testCases.failed;
    }
};
CATCH_REGISTER_LISTENER(Totals)
} // namespace

int main(int argc, char** argv) {
    const int status = Catch::Session().run(argc, argv);
    std::printf("%zu passed, %zu failed\n", passed, failed);
    return status != 0 || passed == 0 ? 1 : 0;
}
