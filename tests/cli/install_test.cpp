// SPDX-License-Identifier: MIT
// make install, and a program that uses the library through pkg-config.
#include <catch2/catch.hpp>

#include <cstdlib>

#include "cli/demo.hpp"
#include "pantin/version.hpp"

using namespace pantin::test;

namespace {

namespace fs = std::filesystem;

int shell(const std::string& line) { return std::system((line + " >/dev/null 2>&1").c_str()); }

} // namespace

TEST_CASE("make install and uninstall: program, library, headers, man pages, completion; nothing is left",
          "[cli][install]") {
    const TemporaryFolder folder;
    const std::string program = std::getenv("PANTIN"), build = fs::path(program).parent_path().string();
    const std::string where = " BUILD=" + build + " PREFIX=/usr DESTDIR=" + folder.path().string();
    REQUIRE(shell("env -u MAKEFLAGS -u MAKELEVEL make install-files" + where) == 0);
    for (const char* file :
         {"bin/pantin", "lib/libpantin.a", "lib/pkgconfig/pantin.pc", "include/pantin/skeletonization.hpp",
          "share/man/man1/pantin.1", "share/man/man1/pantin-animate.1",
          "share/bash-completion/completions/pantin", "share/zsh/site-functions/_pantin",
          "share/fish/vendor_completions.d/pantin.fish"})
        CHECK(fs::exists(folder / "usr" / file));
    CHECK(read(folder / "usr/lib/pkgconfig/pantin.pc").find("\nVersion: " PANTIN_VERSION "\n") !=
          std::string::npos);
    REQUIRE(shell("env -u MAKEFLAGS -u MAKELEVEL make uninstall" + where) == 0);
    for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
        CAPTURE(entry.path().string());
        CHECK(entry.is_directory());
    }
}

#ifndef __SANITIZE_ADDRESS__ // the library would need the sanitizers' own, which pkg-config does not know
TEST_CASE("docs/examples/skeleton.cpp uses the installed library through pkg-config", "[cli][install]") {
    const TemporaryFolder folder;
    const std::string build = fs::path(std::getenv("PANTIN")).parent_path().string(),
                      prefix = (folder / "prefix").string();
    REQUIRE(shell("env -u MAKEFLAGS -u MAKELEVEL make install-files BUILD=" + build + " PREFIX=" + prefix) ==
            0);
    const char* compiler = std::getenv("CXX");
    REQUIRE(shell("PKG_CONFIG_PATH=" + prefix + "/lib/pkgconfig sh -c '" + (compiler ? compiler : "g++") +
                  " -std=c++20 docs/examples/skeleton.cpp $(pkg-config --cflags --libs pantin) -o " +
                  (folder / "skeleton").string() + "'") == 0);
    const std::string program = (folder / "skeleton").string();
    CHECK(shell(program + " testdata/labels_humanoid.png") == 0);
    CHECK(shell(program + " testdata/none.png") != 0);
    CHECK(shell(program) != 0);
}
#endif

TEST_CASE("Completion scripts are valid where the shell is there, and know every command", "[cli][install]") {
    const Outcome bash = run_pantin({"completion", "bash"});
    REQUIRE(bash.code == 0);
    for (const char* name : {"animate", "model", "skeletonize", "--skeleton", "--calls"})
        CHECK(bash.out.find(name) != std::string::npos);
    const TemporaryFolder folder;
    const std::string script = (folder / "pantin").string();
    write(script, bash.out);
    const auto completes = [&](const std::string& words, int last, const std::string& wanted) {
        CAPTURE(words);
        CHECK(shell("bash -c '. " + script + "; COMP_WORDS=(" + words + ") COMP_CWORD=" +
                    std::to_string(last) + "; _pantin; test \"${COMPREPLY[*]}\" = \"" + wanted + "\"'") == 0);
    };
    completes("pantin skel", 1, "skeletonize");
    completes("pantin model --anim", 2, "--animate");
    completes("pantin model te", 2, ""); // a file's name: the shell's own
    const Outcome zsh = run_pantin({"completion", "zsh"}), fish = run_pantin({"completion", "fish"});
    CHECK(zsh.out.starts_with("#compdef pantin"));
    CHECK(fish.out.find("-a animate") != std::string::npos);
    if (shell("command -v zsh") == 0) {
        write(script, zsh.out);
        CHECK(shell("zsh -n " + script) == 0);
    }
    if (shell("command -v fish") == 0) {
        write(script, fish.out);
        for (const char* line : {"pantin model --anim", "pantin skel", "pantin --vers"})
            CHECK(shell("HOME=" + folder.path().string() + " fish --no-config -c '. " + script +
                        "; test (count (complete -C \"" + line + "\")) = 1'") == 0);
    }
    CHECK(run_pantin({"completion", "tcsh"}).code == 2);
}

TEST_CASE("Every command has a man page with its options", "[cli][install]") {
    const TemporaryFolder folder;
    REQUIRE(run_pantin({"manual", "-o", (folder / "man").string()}).code == 0);
    const auto pages = read_all(folder / "man");
    CHECK(pages.at("pantin.1").find(".SH COMMANDS") != std::string::npos);
    CHECK(pages.at("pantin-model.1").find("\\-\\-calls") != std::string::npos);
    const std::string& animate = pages.at("pantin-animate.1");
    CHECK(animate.find(".SH EXIT STATUS") != std::string::npos);
    for (const char* fact : {"INT in [16 \\- 4096]; default: 512", "environment: PANTIN_WEIGHTS"})
        CHECK(animate.find(fact) != std::string::npos);
    // Every command and every option of --help.
    for (const auto& [file, text] : pages) {
        CAPTURE(file);
        const std::string command = file == "pantin.1" ? "" : file.substr(7, file.size() - 9);
        const std::string help = run_pantin(command.empty() ? std::vector<std::string>{"--help"}
                                                            : std::vector<std::string>{command, "--help"})
                                     .out;
        int options = 0;
        for (std::size_t at = help.find("--"); at != std::string::npos; at = help.find("--", at + 2)) {
            const std::size_t end = help.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", at);
            std::string name;
            for (const char c : help.substr(at, end - at)) name += c == '-' ? "\\-" : std::string(1, c);
            CHECK(text.find(name) != std::string::npos);
            ++options;
        }
        CHECK(options > 0);
        if (shell("command -v man") == 0)
            CHECK(shell("test -z \"$(LC_ALL=C.UTF-8 MANROFFSEQ= man --warnings -E UTF-8 -l -Tutf8 -Z '" +
                        (folder / "man" / file).string() + "' 2>&1 >/dev/null)\"") == 0);
    }
}
