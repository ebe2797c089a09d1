// make install, and a program that uses the library through pkg-config.
#include <catch2/catch.hpp>

#include <cstdlib>

#include "cli/demo.hpp"

using namespace pantin::test;

namespace {

namespace fs = std::filesystem;

int shell(const std::string& line) { return std::system((line + " >/dev/null 2>&1").c_str()); }

} // namespace

TEST_CASE("make install and uninstall: program, library, headers, man pages, completion; nothing is left", "[cli][install]") {
    const TemporaryFolder folder;
    const std::string program = std::getenv("PANTIN"), build = fs::path(program).parent_path().string();
    const std::string where = " BUILD=" + build + " PREFIX=/usr DESTDIR=" + folder.path().string();
    REQUIRE(shell("env -u MAKEFLAGS -u MAKELEVEL make install-files" + where) == 0);
    for (const char* file : {"bin/pantin", "lib/libpantin.a", "lib/pkgconfig/pantin.pc", "include/pantin/skeletonization.hpp", "share/man/man1/pantin.1",
                             "share/man/man1/pantin-animate.1", "share/bash-completion/completions/pantin", "share/zsh/site-functions/_pantin",
                             "share/fish/vendor_completions.d/pantin.fish"})
        CHECK(fs::exists(folder / "usr" / file));
    REQUIRE(shell("env -u MAKEFLAGS -u MAKELEVEL make uninstall" + where) == 0);
    for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
        CAPTURE(entry.path().string());
        CHECK(entry.is_directory());
    }
}

#ifndef __SANITIZE_ADDRESS__ // the library would need the sanitizers' own, which pkg-config does not know
TEST_CASE("docs/examples/skeleton.cpp uses the installed library through pkg-config", "[cli][install]") {
    const TemporaryFolder folder;
    const std::string build = fs::path(std::getenv("PANTIN")).parent_path().string(), prefix = (folder / "prefix").string();
    REQUIRE(shell("env -u MAKEFLAGS -u MAKELEVEL make install-files BUILD=" + build + " PREFIX=" + prefix) == 0);
    const char* compiler = std::getenv("CXX");
    REQUIRE(shell("PKG_CONFIG_PATH=" + prefix + "/lib/pkgconfig sh -c '" + (compiler ? compiler : "g++") +
                  " -std=c++20 docs/examples/skeleton.cpp $(pkg-config --cflags --libs pantin) -o " + (folder / "skeleton").string() + "'") == 0);
    const std::string program = (folder / "skeleton").string();
    CHECK(shell(program + " testdata/labels_humanoid.png") == 0);
    CHECK(shell(program + " testdata/none.png") != 0);
    CHECK(shell(program) != 0);
}
#endif

TEST_CASE("Completion scripts are valid where the shell is there, and know every command", "[cli][install]") {
    const Outcome bash = run_pantin({"completion", "bash"});
    REQUIRE(bash.code == 0);
    for (const char* name : {"animate", "model", "skeletonize", "--skeleton", "--calls"}) CHECK(bash.out.find(name) != std::string::npos);
    const TemporaryFolder folder;
    write(folder / "pantin", bash.out);
    CHECK(shell("bash -n " + (folder / "pantin").string()) == 0);
    CHECK(run_pantin({"completion", "zsh"}).out.starts_with("#compdef pantin"));
    CHECK(run_pantin({"completion", "fish"}).out.find("-a animate") != std::string::npos);
    CHECK(run_pantin({"completion", "tcsh"}).code == 2);
}

TEST_CASE("Every command has a man page with its options", "[cli][install]") {
    const TemporaryFolder folder;
    REQUIRE(run_pantin({"manual", "-o", (folder / "man").string()}).code == 0);
    const auto pages = read_all(folder / "man");
    CHECK(pages.at("pantin.1").find(".SH COMMANDS") != std::string::npos);
    CHECK(pages.at("pantin-model.1").find("\\-\\-calls") != std::string::npos);
    CHECK(pages.at("pantin-animate.1").find(".SH EXIT STATUS") != std::string::npos);
}
