// SPDX-License-Identifier: MIT
// OBJ, MTL and weights.txt.
#include <catch2/catch.hpp>

#include <sstream>

#include "core/decimal.hpp"
#include "core/random.hpp"
#include "export/rigs.hpp"
#include "pantin/export.hpp"

using namespace pantin;
using namespace pantin::test;

TEST_CASE("Decimals are the shortest that read back to the same bits", "[export]") {
    CHECK(to_decimal(0.1) == "0.1");
    CHECK(to_decimal(3.0) == "3");
    CHECK(to_decimal(-0.0) == "-0.0");
    CHECK(to_decimal(1.0 / 3) == "0.3333333333333333");
    CHECK(to_decimal(1e-7) == "1e-07");
    Random random(7);
    for (int i = 0; i < 2000; ++i) {
        const double value = random.normal() * (i % 2 ? 1e9 : 1e-9);
        CHECK(std::stod(to_decimal(value)) == value);
    }
}

TEST_CASE("The OBJ of a square has its vertices upright, v up, and faces counter-clockwise", "[export]") {
    std::istringstream lines(to_obj(square_rig(), "mesh.mtl"));
    std::vector<std::string> v, vt, f, others;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("v "))
            v.push_back(line);
        else if (line.starts_with("vt "))
            vt.push_back(line);
        else if (line.starts_with("f "))
            f.push_back(line);
        else
            others.push_back(line);
    }
    REQUIRE(v.size() == 9);
    REQUIRE(vt.size() == 9);
    REQUIRE(f.size() == 4);
    CHECK(v[0] == "v -0.5 1 0");
    CHECK(v[8] == "v 0.5 0 0");
    CHECK(v[4] == "v 0 0.5 0.001");
    CHECK(vt[0] == "vt 0 1");
    CHECK(vt[8] == "vt 1 0");
    CHECK(f[0] == "f 4/4 5/5 2/2 1/1");
    CHECK(others ==
          std::vector<std::string>{"# pantin mesh 1", "mtllib mesh.mtl", "o character", "usemtl drawing"});
}

TEST_CASE("The MTL names the texture", "[export]") {
    CHECK(to_mtl("drawing.png").find("\nmap_Kd drawing.png\n") != std::string::npos);
}

TEST_CASE("weights.txt lists bones by index and vertices from 1, weights that are 0 left out", "[export]") {
    const std::string text = to_weights_text(square_rig());
    CHECK(text.starts_with("# pantin weights 1\nbone 0 hips\nbone 1 leg\nbone 2 leg.1\nv 1 0 1\n"));
    CHECK(text.find("\nv 5 1 0.1 0 0.2 2 0.7\n") != std::string::npos);
    CHECK(text.find("\nv 9 2 0.3333333333333333 1 0.3333333333333333 0 0.33333333333333337\n") !=
          std::string::npos);
}
