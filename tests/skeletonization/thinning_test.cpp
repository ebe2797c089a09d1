// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "shapes.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

// Algorithm 4.1 word for word, pixel by pixel, without tables. Its counter C as printed, or as Zhang and Suen
// have it: of both sub-iterations together.
Thinning literal_zhang_suen(Mask image, bool printed_stop = false) {
    Grid<std::uint16_t> removed_in(image.width(), image.height());
    std::uint16_t step = 0;
    for (bool changed = true; changed;) {
        changed = false;
        for (const bool second : {false, true}) {
            ++step;
            bool c_is_zero = true;
            Mask marked(image.width(), image.height());
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x) {
                    if (!image(x, y)) continue;
                    const int p2 = image.value_or(x, y - 1, 0), p3 = image.value_or(x + 1, y - 1, 0);
                    const int p4 = image.value_or(x + 1, y, 0), p5 = image.value_or(x + 1, y + 1, 0);
                    const int p6 = image.value_or(x, y + 1, 0), p7 = image.value_or(x - 1, y + 1, 0);
                    const int p8 = image.value_or(x - 1, y, 0), p9 = image.value_or(x - 1, y - 1, 0);
                    const int b = p2 + p3 + p4 + p5 + p6 + p7 + p8 + p9;
                    const int a = (p2 < p3) + (p3 < p4) + (p4 < p5) + (p5 < p6) + (p6 < p7) + (p7 < p8) +
                                  (p8 < p9) + (p9 < p2);
                    const int c = second ? p2 * p4 * p8 : p2 * p4 * p6;
                    const int d = second ? p2 * p6 * p8 : p4 * p6 * p8;
                    marked(x, y) = b >= 2 && b <= 6 && a == 1 && c == 0 && d == 0;
                    changed |= marked(x, y) != 0;
                    c_is_zero &= marked(x, y) == 0;
                    if (marked(x, y)) removed_in(x, y) = step;
                }
            for (std::size_t i = 0; i < image.size(); ++i) image.data()[i] -= marked.data()[i];
            if (printed_stop && c_is_zero) return {image, removed_in};
        }
    }
    return {image, removed_in};
}

} // namespace

TEST_CASE("Zhang-Suen by hand: a bar, a line, a square, the whole image") {
    // C_c and C_d: the eastern and southern sides and the upper left corner go. C_c' and C_d': the upper side
    // and both ends of the middle row, which still have neighbours in it.
    CHECK(rows_of(zhang_suen(picture({
              "........",
              ".######.",
              ".######.",
              ".######.",
              "........",
          }))) == std::vector<std::string>{
                      "........",
                      "........",
                      "..###...",
                      "........",
                      "........",
                  });
    const Mask line = picture({".....", ".###.", "....#"});
    CHECK(zhang_suen(line) == line);
    // Known flaw of the algorithm: a 2×2 square vanishes as a whole.
    CHECK(count(zhang_suen(picture({"....", ".##.", ".##.", "...."}))) == 0);
    // Nothing is outside the image: the border is thinned like any other.
    CHECK(rows_of(zhang_suen(picture({"###", "###", "###"}))) ==
          std::vector<std::string>{"...", ".#.", "..."});
}

TEST_CASE("Zhang-Suen equals the algorithm word for word") {
    Random random(11);
    for (int round = 0; round < 60; ++round) {
        Mask mask = random_blob(random, random.integer(8, 40));
        if (round % 3 == 0)
            for (auto& pixel : mask) pixel = random.chance(0.7);
        const Thinning expected = literal_zhang_suen(mask), found = zhang_suen_steps(mask);
        REQUIRE(found.thinned == expected.thinned);
        REQUIRE(found.removed_in == expected.removed_in);
    }
}

TEST_CASE("Algorithm 4.1 stops at the first idle sub-iteration, which differs in few masks") {
    Random random(13);
    int differ = 0;
    for (int round = 0; round < 20'000; ++round) {
        Mask mask(6, 6);
        for (auto& pixel : mask) pixel = random.chance(0.7);
        const Thinning expected = literal_zhang_suen(mask, true),
                       found = zhang_suen_steps(mask, ThinningStop::either);
        REQUIRE(found.thinned == expected.thinned);
        REQUIRE(found.removed_in == expected.removed_in);
        const Mask to_the_end = zhang_suen(mask);
        differ += found.thinned != to_the_end;
        // What stops early has deleted a part of what the other deletes.
        for (std::size_t i = 0; i < mask.size(); ++i)
            REQUIRE(to_the_end.data()[i] <= found.thinned.data()[i]);
    }
    CHECK(differ == 38);
}

TEST_CASE("where the two ends of the thinning differ: the first half is idle, the second one is not") {
    // No pixel fulfils C_c and C_d: line 11 stops. The one in the middle of the second row fulfils C_c' and
    // C_d'.
    const Mask mask = picture({
        "#...#",
        ".###.",
        ".###.",
        "#.#.#",
        "...#.",
    });
    CHECK(zhang_suen(mask, ThinningStop::either) == mask);
    CHECK(rows_of(zhang_suen(mask, ThinningStop::both)) == std::vector<std::string>{
                                                               "#...#",
                                                               ".#.#.",
                                                               ".###.",
                                                               "#.#.#",
                                                               "...#.",
                                                           });
}

TEST_CASE("redundant staircase pixels go, corners of a line, ends and crossings stay") {
    CHECK(rows_of(remove_redundant_pixels(picture({
              "##....",
              ".##...",
              "..##..",
              "...##.",
          }))) == std::vector<std::string>{
                      "#.....",
                      ".#....",
                      "..#...",
                      "...##.",
                  });
    for (const auto& kept : {picture({"#.#", ".#.", "#.#"}), picture({".#.", "#.#", ".#."}),
                             picture({"####"}), picture({"#"}), picture({"#..", ".#.", ".#."})})
        CHECK(remove_redundant_pixels(kept) == kept);
}

TEST_CASE("thinning and cleaning keep components and holes, and leave nothing redundant") {
    Random random(12);
    for (int round = 0; round < 150; ++round) {
        const Mask mask = random_blob(random, random.integer(16, 60));
        const Mask thinned = zhang_suen(mask);
        if (count(thinned) == 0) continue; // the 2×2 square
        REQUIRE(topology(thinned) == topology(mask));
        const Mask skeleton = remove_redundant_pixels(thinned);
        REQUIRE(topology(skeleton) == topology(mask));
        REQUIRE(remove_redundant_pixels(skeleton) == skeleton);
        for (std::size_t i = 0; i < mask.size(); ++i) REQUIRE(skeleton.data()[i] <= mask.data()[i]);
    }
}
