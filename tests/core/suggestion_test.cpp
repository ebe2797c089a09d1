// SPDX-License-Identifier: MIT
// Nearly known words, numbers of things, words of a shell.
#include <catch2/catch.hpp>

#include "core/plural.hpp"
#include "core/shell_word.hpp"
#include "core/suggestion.hpp"

using namespace pantin;

TEST_CASE("The edit distance counts letters put in, taken out, changed and exchanged", "[core]") {
    CHECK(edit_distance("", "") == 0);
    CHECK(edit_distance("abc", "") == 3);
    CHECK(edit_distance("", "ab") == 2);
    CHECK(edit_distance("kitten", "sitting") == 3);
    CHECK(edit_distance("fromat", "format") == 1); // an exchange
    CHECK(edit_distance("ca", "abc") == 3);        // no letter is moved twice
}

TEST_CASE("The nearest known word is suggested, a far one is not", "[core]") {
    const std::vector<std::string> known{"walk", "wave", "jump", "a"};
    CHECK(did_you_mean("wlak", known) == "; did you mean 'walk'?");
    CHECK(did_you_mean("wale", known) == "; did you mean 'walk'?"); // the first of two
    CHECK(did_you_mean("jmup", known) == "; did you mean 'jump'?");
    CHECK(did_you_mean("dance", known).empty());
    CHECK(did_you_mean("x", known).empty()); // every letter would change
    CHECK(did_you_mean("walk", {}).empty());
    CHECK(did_you_mean("detection.colour", {"detection.detector"}).empty()); // alike in the group alone
    CHECK(did_you_mean("detection.wroking_siz", {"detection.working_size"}) ==
          "; did you mean 'detection.working_size'?");
}

TEST_CASE("One is singular", "[core]") {
    CHECK(count_of(0, "clip") == "0 clips");
    CHECK(count_of(1, "clip") == "1 clip");
    CHECK(count_of(2, "vertex", "vertices") == "2 vertices");
}

TEST_CASE("A file's name is one word of a command", "[core]") {
    CHECK(shell_word("out/page-1.png") == "out/page-1.png");
    CHECK(shell_word("my page.png") == "'my page.png'");
    CHECK(shell_word("it's") == "'it'\\''s'");
    CHECK(shell_word("$(rm)") == "'$(rm)'");
    CHECK(shell_word("").size() == 2);
}
