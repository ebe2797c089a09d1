// SPDX-License-Identifier: MIT
// How many limbs a drawing has, which its label map does not tell.
#include <map>

#include <catch2/catch.hpp>

#include "doodle/doodle.hpp"
#include "pantin/image.hpp"
#include "pantin/label.hpp"
#include "plain.hpp"

using namespace pantin;
using namespace pantin::doodle;

namespace {

// Number of limbs → number of drawings.
std::map<int, int> counts(const std::string& what, int drawings) {
    std::map<int, int> counts;
    for (int seed = 0; seed < drawings; ++seed)
        ++counts[draw_character(what, static_cast<std::uint64_t>(seed), plain(160)).limbs];
    return counts;
}

int pieces(const LabelMap& labels) {
    Mask limbs(labels.width(), labels.height());
    for (std::size_t i = 0; i < limbs.size(); ++i)
        limbs.data()[i] = labels.data()[i] == static_cast<int>(Label::limb);
    int large = 0;
    for (const Component& piece : connected_components(limbs).list) large += piece.area >= 12;
    return large;
}

} // namespace

TEST_CASE("people and animals have four limbs, penguins two, whatever hands and feet they have") {
    // Some hide one behind another; an animal in six is drawn with two.
    const std::vector<std::pair<std::string, int>> wanted = {{"humanoid:person", 34},
                                                             {"humanoid:stick person", 34},
                                                             {"quadruped:horse", 26},
                                                             {"quadruped:cow", 26}};
    for (const auto& [what, four] : wanted) {
        const std::map<int, int> found = counts(what, 40);
        INFO(what);
        CHECK(found.at(4) >= four);
        CHECK((found.begin()->first >= 2 && found.rbegin()->first == 4)); // none has more
    }
    CHECK(counts("humanoid:penguin", 10) == std::map<int, int>{{2, 10}});
    CHECK(counts("scribble", 3) == std::map<int, int>{{0, 3}});
}

TEST_CASE("legs that have grown together are counted one by one") {
    int joined = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const Doodle d = draw_character("quadruped:horse", seed, plain(160));
        joined += d.limbs == 4 && pieces(d.labels) < 4;
    }
    CHECK(joined >= 3);
}

TEST_CASE("a page says of each character how many limbs it has") {
    const Page page = draw_page({"humanoid:penguin", "quadruped:horse"}, 3, plain(200));
    REQUIRE(page.characters.size() == 2);
    CHECK(page.characters[0].limbs == 2);
    CHECK((page.characters[1].limbs >= 3 && page.characters[1].limbs <= 4));
    const Page scene = draw_scene("family", 1, plain(300));
    for (const Character& c : scene.characters) CHECK(c.limbs >= 0);
    for (const Character& c : scene.things) CHECK(c.limbs == -1);
}
