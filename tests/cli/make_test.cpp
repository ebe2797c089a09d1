// SPDX-License-Identifier: MIT
// The Makefile's own promises: what it says about optional libraries, and what a change of flags makes again.
#include <catch2/catch.hpp>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <tuple>

#include <sys/wait.h>

#include "support/folders.hpp"
#include "support/program.hpp"

using namespace pantin::test;

namespace {

namespace fs = std::filesystem;

// Not as a part of the make that may run these tests, nor with its switches. Both outputs in one.
Outcome make(const std::string& arguments) {
    FILE* pipe = ::popen(("env -u MAKEFLAGS -u MAKELEVEL -u MFLAGS -u GLPK -u WEBP -u GIF -u YAML -u PUGIXML "
                          "-u CGAL -u STATIC -u werror -u config "
                          "-u BUILD -u V -u CXXFLAGS make " +
                          arguments + " 2>&1")
                             .c_str(),
                         "r");
    REQUIRE(pipe);
    Outcome outcome;
    char buffer[4096];
    while (std::fgets(buffer, sizeof buffer, pipe)) outcome.out += buffer;
    outcome.code = WEXITSTATUS(::pclose(pipe));
    return outcome;
}

bool has_library(const std::string& name, const std::string& arguments) {
    const Outcome outcome = make("-s libraries " + arguments);
    CAPTURE(outcome.out);
    REQUIRE(outcome.code == 0);
    REQUIRE(outcome.out.starts_with("optional libraries: "));
    return outcome.out.find(name) < outcome.out.find("without");
}

} // namespace

TEST_CASE("A library whose header or archive does not exist is not found", "[cli][make]") {
    CHECK(has_library("GLPK", "GLPK_header=stdio.h GLPK_libs=-lm"));
    CHECK_FALSE(has_library("GLPK", "GLPK_header=no/such/header.h GLPK_libs=-lm"));
    CHECK_FALSE(has_library("GLPK", "GLPK_header=stdio.h GLPK_libs=-lno_such_library"));
    CHECK_FALSE(has_library("GLPK", "GLPK=0 GLPK_header=stdio.h GLPK_libs=-lm"));
}

TEST_CASE("A library that the user wants and that is not there is one line, before anything is compiled",
          "[cli][make]") {
    const TemporaryFolder folder;
    for (const std::string name : {"GLPK", "WEBP", "GIF", "YAML", "PUGIXML", "CGAL"}) {
        const Outcome outcome =
            make(name + "=1 " + name + "_header=no_such.h BUILD=" + (folder / "build").string());
        CAPTURE(outcome.out);
        CHECK(outcome.code == 2);
        CHECK(outcome.out.find(name + "=1, but <no_such.h>") != std::string::npos);
        CHECK(outcome.out.find('\n') == outcome.out.size() - 1);
    }
    CHECK_FALSE(fs::exists(folder / "build/src"));
    CHECK(make("libraries GLPK=yes").code == 2);
}

TEST_CASE("A small program has neither the commands that are left out nor their data", "[cli][make]") {
    const TemporaryFolder folder;
    const std::string program = (folder / "build").string() + "/pantin";
    const auto plan = [&](const std::string& switches) {
        return make("-n " + switches + " BUILD=" + (folder / "build").string() + " " + program);
    };
    const std::string whole = plan("").out;
    for (const auto& [name, folder_of_command, data] :
         {std::tuple<std::string, std::string, std::string>{"EXPLAIN", "src/cli/explain/", "page.html"},
          {"MODELING", "src/cli/model/", ""},
          {"VERIFY", "src/cli/verify/", "vectors.tar.gz"},
          {"WEIGHTS", "", "weights/segmenter.safetensors"}}) {
        const Outcome outcome = plan(name + "=0");
        CAPTURE(name);
        REQUIRE(outcome.code == 0);
        const auto has = [](const std::string& text, const std::string& word) {
            return text.find(word) != std::string::npos;
        };
        if (!data.empty()) {
            CHECK(has(whole, data));
            CHECK_FALSE(has(outcome.out, data));
        }
        if (folder_of_command.empty()) continue;
        CHECK(has(whole, folder_of_command + "command.o"));
        CHECK_FALSE(has(whole, folder_of_command + "absent.o"));
        CHECK_FALSE(has(outcome.out, folder_of_command + "command.o"));
        CHECK(has(outcome.out, folder_of_command + "absent.o"));
    }
    CHECK(make("EXPLAIN=no " + program).code == 2);
    // The tests are about the whole program.
    CHECK(make("test-run VERIFY=0 BUILD=" + (folder / "build").string()).code == 2);
}

TEST_CASE("A change of flags makes objects again, the same flags do not; flags are added to ours",
          "[cli][make]") {
    const TemporaryFolder folder;
    const std::string build = (folder / "build").string(), object = build + "/src/core/random.o";
    const auto compiles = [&](const std::string& flags) {
        const Outcome outcome = make("V=1 BUILD=" + build + " " + flags + " " + object);
        CAPTURE(outcome.out);
        REQUIRE(outcome.code == 0);
        const std::size_t command = outcome.out.find(" -c -o " + object);
        if (command != std::string::npos) {
            CHECK(outcome.out.find("-ffp-contract=off") < command);
            CHECK(outcome.out.find("-std=c++20") < command);
        }
        return command != std::string::npos;
    };
    CHECK(compiles(""));
    CHECK_FALSE(compiles(""));
    CHECK(compiles("CXXFLAGS='-O1 -ffast-math'"));
    CHECK_FALSE(compiles("CXXFLAGS='-O1 -ffast-math'"));
    CHECK(compiles("CPPFLAGS=-DSOMETHING werror=1"));
    CHECK(compiles(""));
    // A library's switch changes which files there are, not how they are compiled.
    CHECK_FALSE(compiles("GLPK=0 WEBP=0 GIF=0 YAML=0 PUGIXML=0 CGAL=0"));
}
