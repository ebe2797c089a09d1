// SPDX-License-Identifier: MIT
// The exhibits of failures show what docs/figures/README.md says of them; other weights could change that.
#include <catch2/catch.hpp>

#include <algorithm>
#include <regex>

#include "figures/figures.hpp"
#include "figures/preset_rows.hpp"

using namespace pantin;
using namespace pantin::figures;

namespace {

bool shows(const std::vector<pantin::figures::Figure>& all, const std::string& name,
           const std::string& pattern) {
    for (const pantin::figures::Figure& figure : all)
        if (figure.name == name) return std::regex_search(figure.svg, std::regex(pattern));
    return false;
}

} // namespace

TEST_CASE("Fish and stick figure end as the index says", "[figures]") {
    Gallery gallery("testdata");
    const auto all = failure_figures(gallery);
    CHECK(shows(all, "fig-6.7-fish.svg",
                "preset thesis: quadruped, side fin → tail, tail fin → leg [a-z ]*, leg"));
    CHECK(
        shows(all, "fig-6.7-fish.svg", "preset default: quadruped, side fin → leg [a-z ]*, tail fin → tail"));
    CHECK(shows(all, "fig-6.8-stick-figure.svg",
                "preset thesis: humanoid, limbs → hand [a-z]*, hand [a-z]*; "));
    CHECK(shows(all, "fig-6.8-stick-figure.svg",
                "preset default: humanoid, [a-z ]*→ hand [a-z]*, hand [a-z]*, foot [a-z]*, foot"));
}

TEST_CASE("Of two symmetric figures the thesis maps one wrongly", "[figures]") {
    Gallery gallery("testdata");
    const std::regex right("hand [a-z]*, hand [a-z]*, foot [a-z]*, foot [a-z]*"),
        changed("foot [a-z]*, foot [a-z]*, hand [a-z]*, hand [a-z]*");
    const auto run = [&](std::uint64_t seed, const char* preset) {
        return gallery.whole_run(doodled("humanoid:teddy", seed), preset);
    };
    // Left is left in the picture.
    const auto sides_kept = [](const Run& run) {
        return std::all_of(run.rig.mapping.pairs.begin(), run.rig.mapping.pairs.end(), [&](const EndPair& p) {
            const std::string& name = run.reference->nodes[p.reference_end].name;
            const bool left = run.skeleton.graph.vertices[p.end].x < run.labels().width() / 2.0;
            return name == "head" || (name.find("left") != std::string::npos) == left;
        });
    };
    CHECK(std::regex_match(partners_of(run(5, "thesis"), Label::limb), changed));
    for (const auto& [seed, preset] :
         {std::pair(5, "default"), std::pair(16, "thesis"), std::pair(16, "default")}) {
        const Run mapped = run(seed, preset);
        CHECK(std::regex_match(partners_of(mapped, Label::limb), right));
        CHECK(sides_kept(mapped));
    }
}

TEST_CASE("Legs are joined and a tail decides as the index says", "[figures]") {
    Gallery gallery("testdata");
    const auto all = dog_figures(gallery);
    std::vector<double> stretches;
    std::size_t edges = 0;
    for (const pantin::figures::Figure& figure : all) {
        const std::regex stretch(R"((\d+) edges between legs, stretched to ([\d.]+))");
        for (std::sregex_iterator i(figure.svg.begin(), figure.svg.end(), stretch), end; i != end; ++i) {
            stretches.push_back(std::stod((*i)[2]));
            if (stretches.size() == 1) edges = std::stoul((*i)[1]);
            if (stretches.size() == 2) CHECK(std::stoul((*i)[1]) < edges);
        }
    }
    REQUIRE(stretches.size() == 2);
    CHECK(1.5 * stretches[1] < stretches[0]);
    const std::string number = R"( (−)?[\d.]+)", dog = "table-6.1-dog.svg";
    CHECK(shows(all, dog, ">humanoid" + number + ", quadruped" + number + "<"));
    CHECK(shows(all, dog, ">quadruped" + number + ", humanoid" + number + "<"));
    CHECK(shows(all, dog, ">insect" + number + ", quadruped" + number + "<"));
}
