// SPDX-License-Identifier: MIT
// The file of judgements by eye.
#include <catch2/catch.hpp>

#include "figures/verdicts.hpp"
#include "pantin/error.hpp"
#include "support/folders.hpp"

using namespace pantin;
using namespace pantin::test;

TEST_CASE("the last verdict on a drawing's step counts, and a remark may have commas", "[figures]") {
    const TemporaryFolder folder;
    write(folder / "verdicts.csv", "date,preset,drawing,step,verdict,remark\n"
                                   "2026-01-02,default,a.png#1,rigging,bad,\n"
                                   "2026-03-04,default,a.png#1,rigging,good,legs, arms and head\n"
                                   "2026-02-01,thesis,000001,rigging,bad,stands still\n");
    const figures::Verdicts verdicts((folder / "verdicts.csv").string());
    REQUIRE(verdicts.find("default", "a.png#1", "rigging"));
    CHECK(verdicts.find("default", "a.png#1", "rigging")->good);
    CHECK(verdicts.find("default", "a.png#1", "rigging")->remark == "legs, arms and head");
    REQUIRE(verdicts.find("thesis", "000001", "rigging"));
    CHECK_FALSE(verdicts.find("thesis", "000001", "rigging")->good);
    CHECK(verdicts.find("default", "000001", "rigging") == nullptr);
    CHECK(verdicts.find("default", "a.png#1", "detection") == nullptr);
    CHECK(verdicts.drawings() == std::vector<std::string>{"a.png#1"});
    CHECK(verdicts.newest() == "2026-03-04");
}

TEST_CASE("a malformed verdict is an error that names file and line", "[figures]") {
    const TemporaryFolder folder;
    for (const char* line : {"2026-01-02,default,a.png#1,rigging,perhaps,",
                             "2026-01-02,thesis,,rigging,good,", "2026-01-02,b,rigging,good,", "nothing"}) {
        write(folder / "verdicts.csv",
              std::string("date,preset,drawing,step,verdict,remark\n2026-01-02,default,b,rigging,good,\n") +
                  line + "\n");
        CHECK_THROWS_WITH(figures::Verdicts((folder / "verdicts.csv").string()),
                          Catch::Contains("verdicts.csv: line 3"));
    }
}

TEST_CASE(
    "docs/verdicts.csv judges both presets' rigging of the generated drawings and every step of testdata",
    "[figures]") {
    const figures::Verdicts verdicts("docs/verdicts.csv");
    for (int i = 0; i < 30; ++i)
        for (const char* preset : {"default", "thesis"})
            CHECK(verdicts.find(preset, "0000" + std::string(i < 10 ? "0" : "") + std::to_string(i),
                                "rigging"));
    for (const char* drawing : {"demo.png#1", "demo.png#4", "dog.png#1", "flying.png#1", "humanoid.png#1",
                                "lined.png#1", "person.png#1", "photo.jpg#1", "quadruped.png#1"})
        for (const char* step : {"detection", "segmentation", "skeletonization", "identification", "rigging"})
            CHECK(verdicts.find("default", drawing, step));
}
