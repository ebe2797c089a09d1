// SPDX-License-Identifier: MIT
// Quick sketches: every species that `variety` adds has its parts, in one piece; without it nothing changes.
#include <algorithm>
#include <array>
#include <set>

#include <catch2/catch.hpp>

#include "doodle/doodle.hpp"
#include "pantin/error.hpp"
#include "pantin/image.hpp"
#include "pantin/label.hpp"
#include "plain.hpp"

using namespace pantin;
using namespace pantin::doodle;

namespace {

const std::vector<std::string> all_types = {"humanoid", "quadruped", "flying", "other"};

} // namespace

TEST_CASE("every sketched species has a head and a body, in one piece without holes") {
    for (const std::string& type : all_types)
        for (const std::string& species : varied_species(type)) {
            std::array<long, label_count> most{};
            for (std::uint64_t seed = 0; seed < 3; ++seed) {
                INFO(species << " " << seed);
                DoodleOptions options = plain(128);
                options.species = species;
                const Doodle d = draw_character(type, seed, options);
                CHECK(d.type == type);
                CHECK(d.species == species);
                std::array<long, label_count> count{};
                for (std::uint8_t label : d.labels) ++count.at(label);
                CHECK(count[1] > 8);
                CHECK(count[2] > 8);
                for (std::size_t k = 0; k < label_count; ++k) most[k] = std::max(most[k], count[k]);
                const Mask mask = foreground(d.labels);
                REQUIRE(connected_components(mask).list.size() == 1);
                CHECK(fill_holes(mask) == mask);
                CHECK(std::max(d.box.width, d.box.height) > 50);
            }
            INFO(species);
            if (type == "humanoid" || type == "quadruped") CHECK(most[3] > 8);
            const bool spread = species.find("front") == 0 || species == "raised bird" || species == "fairy";
            if (spread) CHECK(most[5] > 20);
            if (species == "mermaid" || species == "kangaroo" || species == "squirrel") CHECK(most[4] > 20);
        }
}

TEST_CASE("variety is the share of drawings that are quick sketches") {
    DoodleOptions options = plain(96);
    for (const std::string& type : character_types()) {
        const std::vector<std::string> more = varied_species(type), usual = species_of(type);
        int drawn[2] = {};
        for (int all = 0; all < 2; ++all)
            for (std::uint64_t seed = 0; seed < 12; ++seed) {
                options.variety = all;
                const Doodle d = draw_character(type, seed, options);
                drawn[all] += std::find(more.begin(), more.end(), d.species) != more.end();
                CHECK(d.type == type);
            }
        CHECK(drawn[0] == 0);
        CHECK(drawn[1] == 12);
        // One name, one way to draw it.
        std::set<std::string> names(usual.begin(), usual.end());
        for (const std::string& name : more) CHECK(names.insert(name).second);
    }
}

TEST_CASE("quick sketches follow from their seed, on pages too") {
    DoodleOptions options = plain(200);
    options.variety = 0.7, options.colour = 0.3;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        const Page a = draw_page({"humanoid", "other", "flying", "quadruped:hedgehog"}, seed, options),
                   b = draw_page({"humanoid", "other", "flying", "quadruped:hedgehog"}, seed, options);
        CHECK((a.picture == b.picture && a.labels == b.labels));
        CHECK(a.characters[1].type == "other");
        CHECK(a.characters[3].species == "hedgehog");
    }
}

TEST_CASE("sketched species belong to their type") {
    CHECK_THROWS_AS(draw_character("humanoid:songbird", 1), Error);
    CHECK_THROWS_AS(draw_character("other:dog", 1), Error);
}
