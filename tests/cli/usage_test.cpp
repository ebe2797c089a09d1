// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "pantin/export.hpp"
#include "pantin/identification.hpp"
#include "pantin/version.hpp"
#include "support/folders.hpp"
#include "support/program.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

const std::vector<std::string> commands = {"animate",  "detect", "segment", "skeletonize",
                                           "identify", "rig",    "render",  "batch"};

} // namespace

TEST_CASE("Help goes to standard output and is no error", "[cli]") {
    const Outcome outcome = run_pantin({"--help"});
    CHECK(outcome.code == 0);
    CHECK(outcome.err.empty());
    for (const std::string& command : commands) CHECK(outcome.out.find("  " + command) != std::string::npos);
    CHECK(outcome.out.find("Exit codes") != std::string::npos);
}

TEST_CASE("Every subcommand has its help", "[cli]") {
    for (const std::string& command : commands) {
        CAPTURE(command);
        const Outcome outcome = run_pantin({command, "--help"});
        CHECK(outcome.code == 0);
        CHECK(outcome.err.empty());
        for (const std::string option :
             {"--preset", "--config", "--weights", "--references", "--threads", "--trace", "--quiet"})
            CHECK(outcome.out.find(option) != std::string::npos);
    }
}

TEST_CASE("The version names the optional libraries", "[cli]") {
    const Outcome outcome = run_pantin({"--version"});
    CHECK(outcome.code == 0);
    CHECK(outcome.out.starts_with("pantin " PANTIN_VERSION "\nwith:"));
    const auto named = [&](const char* library) {
        return outcome.out.find(library) < outcome.out.find("without:");
    };
    CHECK(named("GLPK") == ilp_available());
    CHECK(named("GIF") == gif_available());
    CHECK(outcome.out.find("\nnetwork kernel: ") != std::string::npos);
    CHECK(outcome.out.find("\nweights (compiled in): detector.safetensors ") != std::string::npos);
    CHECK((outcome.out.find("licence: GPL-3.0-or-later") != std::string::npos) == ilp_available());
    CHECK(outcome.out.ends_with("weights CC BY 4.0\n"));
    const Outcome other = run_pantin({"--version"}, {{"PANTIN_WEIGHTS", "no such folder"}});
    CHECK(other.out.find("weights (no such folder): detector.safetensors missing") != std::string::npos);
    CHECK(outcome.err.empty());
}

TEST_CASE("A wrong command line is one line on standard error and exit code 2", "[cli]") {
    const TemporaryFolder folder;
    const std::string out = (folder / "out").string();
    const std::vector<std::string> line = GENERATE_COPY(values<std::vector<std::string>>({
        {},
        {"dance"},
        {"animate"},
        {"animate", "page.png"},
        {"detect", "page.png", "-o"},
        {"animate", "page.png", "-o", out, "--colour", "red"},
        {"animate", "page.png", "-o", out, "--threads", "0"},
        {"animate", "page.png", "-o", out, "--threads", "many"},
        {"animate", "page.png", "-o", out, "--preset", "best"},
        {"animate", "page.png", "-o", out, "--format", "avi"},
        {"animate", "page.png", "-o", out, "--fps", "0"},
        {"animate", "page.png", "-o", out, "--fps", "nan"},
        {"animate", "page.png", "-o", out, "--size", "1000000"},
        {"animate", "page.png", "-o", out, "--quality", "101"},
        {"animate", "page.png", "-o", out, "--quality", "8x"},
        {"animate", "page.png", "-o", out, "--background", "#12345"},
        {"animate", "page.png", "-o", out, "--background", "#12345g"},
        {"segment"},
        {"segment", "one", "two"},
    }));
    CAPTURE(line);
    const Outcome outcome = run_pantin(line);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.starts_with("pantin: "));
    CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
    CHECK_FALSE(std::filesystem::exists(out));
}

TEST_CASE("What is nearly a command, an option or a value is suggested", "[cli]") {
    const auto said = [](const std::vector<std::string>& line) { return run_pantin(line).err; };
    CHECK(said({"anmate", "page.png"}) ==
          "pantin: there is no command 'anmate'; did you mean 'animate'? (pantin --help)\n");
    CHECK(said({"dance"}) == "pantin: there is no command 'dance' (pantin --help)\n");
    CHECK(said({"animate", "page.png", "--fromat=gif", "-o", "out"}) ==
          "pantin: there is no option '--fromat'; did you mean '--format'? (pantin animate --help)\n");
    const std::vector<std::string> page{"animate", "page.png", "-o", "out"};
    const auto ends = [&](const std::string& option, const std::string& value, const std::string& end) {
        std::vector<std::string> line = page;
        line.insert(line.end(), {option, value});
        const std::string text = said(line);
        CAPTURE(text);
        CHECK(text.find("; did you mean '" + end + "'?") != std::string::npos);
    };
    ends("--format", "webpp", "webp");
    ends("--detector", "contuor", "contour");
    ends("--preset", "thesi", "thesis");
    ends("--quality", "losless", "lossless");
    ends("--reference", "humaniod", "humanoid");
}

TEST_CASE("Standard output that cannot be written is an output error", "[cli]") {
    if (!std::filesystem::exists("/dev/full")) return;
    const Outcome outcome = run_pantin({"--help"}, {}, "/dev/full");
    CHECK(outcome.code == 6);
    CHECK(outcome.err == "pantin: standard output: cannot be written\n");
}
