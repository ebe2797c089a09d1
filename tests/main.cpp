// SPDX-License-Identifier: MIT
// The test program. A test with the tag [needs-x] is left out of a build without the optional library x, and
// said to be. With --jobs N, N files of tests run at a time, each in a process of its own. Ends with the line
// `N passed, N failed` (test cases), which CI reads, and `, N skipped` where there are any.
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <set>
#include <string>

#include "support/jobs.hpp"
#include "support/libraries.hpp"

namespace {
pantin::test::Counts counts;
std::size_t skipped = 0;

struct Totals : Catch::TestEventListenerBase {
    using TestEventListenerBase::TestEventListenerBase;
    void testRunEnded(const Catch::TestRunStats& stats) override {
        counts.passed = stats.totals.testCases.passed;
        counts.failed = stats.totals.testCases.failed;
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

std::vector<Catch::TestCase> wanted_tests(Catch::Session& session) {
    const Catch::Config& config = session.config();
    return filterTests(getAllTestCasesSorted(config), config.testSpec(), config);
}

// Leaves out what this build cannot do, of all tests or of those that were asked for.
void skip_tests(Catch::Session& session) {
    std::string unless;
    for (const auto& [name, available] : pantin::test::optional_libraries())
        if (!available) unless += "~[needs-" + name + "]";
    if (unless.empty()) return;
    for (const Catch::TestCase& test : wanted_tests(session))
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
// Files of tests by name without extension, which is their tag (Catch2's --filenames-as-tags). Those of the
// program as a whole come first: they take longest.
std::vector<std::string> wanted_files(Catch::Session& session) {
    std::set<std::string> whole, modules;
    for (const Catch::TestCase& test : wanted_tests(session)) {
        const std::filesystem::path file = test.lineInfo.file;
        const std::string folder = file.parent_path().filename();
        (folder == "cli" || folder == "pipeline" || folder == "evaluation" ? whole : modules)
            .insert(file.stem());
    }
    std::vector<std::string> files(whole.begin(), whole.end());
    std::set_difference(modules.begin(), modules.end(), whole.begin(), whole.end(),
                        std::back_inserter(files));
    return files;
}

// Its exit code: 0 where all tests passed.
int run_tests(Catch::Session& session) {
    session.useConfigData(session.configData()); // as changed
    return session.run();
}

pantin::test::Counts run_file(Catch::Session& session, const std::string& file) {
    session.configData().filenamesAsTags = true;
    std::vector<std::string>& specs = session.configData().testsOrTags;
    if (specs.empty()) specs.emplace_back("~[.]");
    for (std::string& spec : specs) spec = with_each_filter("[#" + file + "]", spec);
    run_tests(session);
    return counts;
}
} // namespace

int main(int argc, char** argv) {
    Catch::Session session;
    int jobs = 1;
    session.cli(session.cli() | Catch::clara::Opt(jobs, "N")["--jobs"]("files of tests that run at a time"));
    if (const int status = session.applyCommandLine(argc, argv); status != 0) return status;
    skip_tests(session);
    const Catch::ConfigData& data = session.configData();
    const bool lists = data.listTests || data.listTags || data.listReporters || data.listTestNamesOnly ||
                       data.showHelp || data.libIdentify;
    int status = 0;
    if (jobs > 1 && !lists)
        counts = pantin::test::run_in_processes(
            wanted_files(session), jobs, [&](const std::string& file) { return run_file(session, file); });
    else
        status = run_tests(session);
    std::printf("%zu passed, %zu failed", counts.passed, counts.failed);
    if (skipped > 0) std::printf(", %zu skipped", skipped);
    std::printf("\n");
    return status != 0 || counts.passed == 0 || counts.failed != 0 ? 1 : 0;
}
