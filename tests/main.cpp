// SPDX-License-Identifier: MIT
// The test program. A test with the tag [needs-x] is left out of a build without the optional library x, and
// said to be. Ends with the line `N passed, N failed` (test cases), which CI reads, and `, N skipped` where
// there are any.
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdio>
#include <string>

#include "support/libraries.hpp"

namespace {
std::size_t passed = 0, failed = 0, skipped = 0;

struct Totals : Catch::TestEventListenerBase {
    using TestEventListenerBase::TestEventListenerBase;
    void testRunEnded(const Catch::TestRunStats& stats) override {
        passed = stats.totals.testCases.passed;
        failed = stats.totals.testCases.failed;
    }
};
CATCH_REGISTER_LISTENER(Totals)

// `exclusions` before each of the filters, which commas part. (Behind a name they would count as part of it.)
std::string with_each_filter(const std::string& exclusions, const std::string& spec) {
    std::string result = exclusions;
    bool quoted = false;
    for (const char c : spec) {
        quoted = quoted != (c == '"');
        result += c;
        if (c == ',' && !quoted) result += exclusions;
    }
    return result;
}

// Leaves out what this build cannot do, of all tests or of those that were asked for.
void skip_tests(Catch::Session& session) {
    std::string unless;
    for (const auto& [name, available] : pantin::test::optional_libraries())
        if (!available) unless += "~[needs-" + name + "]";
    if (unless.empty()) return;
    const std::vector<Catch::TestCase> wanted =
        filterTests(getAllTestCasesSorted(session.config()), session.config().testSpec(), session.config());
    for (const Catch::TestCase& test : wanted)
        for (const auto& [name, available] : pantin::test::optional_libraries())
            if (const auto& tags = test.lcaseTags;
                !available && std::find(tags.begin(), tags.end(), "needs-" + name) != tags.end()) {
                std::printf("skipped, built without %s: %s\n", name.c_str(), test.name.c_str());
                ++skipped;
                break;
            }
    std::vector<std::string>& specs = session.configData().testsOrTags;
    if (specs.empty()) specs.emplace_back("~[.]"); // an exclusion alone would take in the hidden tests
    for (std::string& spec : specs) spec = with_each_filter(unless, spec);
}
} // namespace

int main(int argc, char** argv) {
    Catch::Session session;
    if (const int status = session.applyCommandLine(argc, argv); status != 0) return status;
    skip_tests(session);
    session.useConfigData(session.configData()); // as changed
    const int status = session.run();
    std::printf("%zu passed, %zu failed", passed, failed);
    if (skipped > 0) std::printf(", %zu skipped", skipped);
    std::printf("\n");
    return status != 0 || passed == 0 ? 1 : 0;
}
