// SPDX-License-Identifier: MIT
// char_cfg.yaml: what is read, and what is said of what cannot be.
#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "formats/animated_drawings.hpp"
#include "formats/figure_joints.hpp"
#include "support/folders.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

FigureJoints read_text_of(const std::string& config, const std::string& name = "char_cfg.yaml") {
    const TemporaryFolder folder;
    write(folder / name, config);
    return read_joints(folder / ".", 100, 100);
}

std::string joint(const std::string& name, const std::string& parent, const std::string& place = "[10, 20]") {
    return "- {name: " + name + ", parent: " + parent + ", loc: " + place + "}\n";
}

} // namespace

TEST_CASE("Joints may be written in any way that is a number", "[animated-drawings][needs-yaml]") {
    const auto place = [&](const std::string& x) {
        const FigureJoints figure = read_text_of("skeleton:\n" + joint("neck", "null", "[" + x + ", 7.5]"));
        return figure.joints.empty() ? Point2d{-1, -1} : figure.joints[0].place;
    };
    for (const char* same : {"12", "12.0", "012", "'12'", "\"12\"", "+12", "1.2e1", "120e-1"}) {
        CAPTURE(same);
        CHECK(place(same) == Point2d{12, 7.5});
    }
    for (const char* none : {"twelve", "12px", "''", "0x0c", "[12]", "~", "{}"}) {
        CAPTURE(none);
        CHECK(place(none) == Point2d{-1, -1});
    }
}

TEST_CASE("Joints of any body are read in any order, from files of any editor",
          "[animated-drawings][needs-yaml]") {
    const std::string config = "width: 100\nskeleton:\n" + joint("tail_tip", "tail", "[3, 4]") +
                               joint("tail", "root") + joint("root", "null") + "height: 100\n";
    const std::vector<FigureJoint> wanted = {
        {"tail_tip", {3, 4}, 1}, {"tail", {10, 20}, 2}, {"root", {10, 20}, -1}};
    std::string lines = config;
    for (std::size_t at = 0; (at = lines.find('\n', at)) != std::string::npos; at += 2)
        lines.replace(at, 1, "\r\n");
    for (const std::string& text : {config, "\xEF\xBB\xBF" + config, lines, "---\n" + config}) {
        const FigureJoints figure = read_text_of(text);
        CHECK(figure.joints == wanted);
        CHECK(figure.remark.empty());
    }
    CHECK(read_text_of(config, "char_cfg.yml").joints == wanted);
    const FigureJoints alone = read_text_of("skeleton:\n- {name: a, loc: [1, 2]}\n" + joint("b", "None"));
    CHECK(alone.joints == std::vector<FigureJoint>{{"a", {1, 2}, -1}, {"b", {10, 20}, -1}});
    CHECK(alone.remark.empty());
}

TEST_CASE("A file of joints that cannot be used says why", "[animated-drawings][needs-yaml]") {
    std::string many = "skeleton:\n";
    for (int i = 0; i < 300; ++i) many += joint("j" + std::to_string(i), "null");
    const std::vector<std::pair<std::string, std::string>> bad = {
        {"", "has no list \"skeleton\""},
        {"hello", "has no list \"skeleton\""},
        {"- 3\n", "has no list \"skeleton\""},
        {"skeleton: {a: 1}\n", "has no list \"skeleton\""},
        {"skeleton: []\n", "its list \"skeleton\" is empty"},
        {"skeleton: [", "is not valid YAML: "},
        {"skeleton:\n- 3\n", "skeleton[0]: must be an object"},
        {"skeleton:\n- {loc: [1, 2]}\n", "skeleton[0]: misses \"name\""},
        {"skeleton:\n- name: hip\n", "joint 'hip' has no place of two numbers"},
        {"skeleton:\n" + joint("hip", "null", "[1, 2, 3]"), "joint 'hip' has no place of two numbers"},
        {"skeleton:\n" + joint("hip", "null", "5"), "joint 'hip' has no place of two numbers"},
        {"skeleton:\n" + joint("hip", "null", "[250, 3]"), "joint 'hip' lies far outside of texture.png"},
        {"skeleton:\n" + joint("hip", "null", "[nan, 3]"), "joint 'hip' lies far outside of texture.png"},
        {many, "skeleton: has more than 256 elements"}};
    for (const auto& [config, what] : bad) {
        const FigureJoints figure = read_text_of(config);
        CAPTURE(config.substr(0, 60), figure.remark);
        CHECK(figure.joints.empty());
        CHECK(figure.remark.find("char_cfg.yaml: " + what) != std::string::npos);
        CHECK(figure.remark.find('\n') == std::string::npos);
    }
    const TemporaryFolder empty;
    CHECK(read_joints(empty / ".", 100, 100).remark.find("char_cfg.yaml: ") != std::string::npos);
}

TEST_CASE("Parents that make no tree are left out, with a remark", "[animated-drawings][needs-yaml]") {
    const auto parents = [](const FigureJoints& figure) {
        std::vector<int> all;
        for (const FigureJoint& joint : figure.joints) all.push_back(joint.parent);
        return all;
    };
    const FigureJoints unknown = read_text_of("skeleton:\n" + joint("a", "null") + joint("b", "z"));
    CHECK(parents(unknown) == std::vector<int>{-1, -1});
    CHECK(unknown.remark.find("joint 'b' hangs on 'z', which is not there") != std::string::npos);
    const FigureJoints ring =
        read_text_of("skeleton:\n" + joint("a", "c") + joint("b", "a") + joint("c", "b") + joint("d", "d"));
    CHECK(parents(ring) == std::vector<int>{-1, 0, 1, -1});
    CHECK(ring.remark.find("joint 'a' hangs on itself or on its own child") != std::string::npos);
    const FigureJoints twice =
        read_text_of("skeleton:\n" + joint("a", "null") + joint("a", "null") + joint("b", "a"));
    CHECK(parents(twice) == std::vector<int>{-1, -1, 0});
    CHECK(twice.remark.find("joint 'a' is given twice") != std::string::npos);
}

TEST_CASE("A human figure is known by its sixteen joints", "[animated-drawings][needs-yaml]") {
    const TemporaryFolder folder;
    std::string config = "skeleton:\n";
    for (const AnimatedDrawingsJoint& j : animated_drawings_joints) config += joint(j.name, "null");
    write(folder / "char_cfg.yaml", config);
    CHECK(names_humanoid(folder / "."));
    write(folder / "char_cfg.yaml", config + joint("tail", "hip"));
    CHECK(names_humanoid(folder / "."));
    config.replace(config.find("left_knee"), 9, "left_nose");
    write(folder / "char_cfg.yaml", config);
    CHECK_FALSE(names_humanoid(folder / "."));
    write(folder / "char_cfg.yaml", "skeleton: [");
    CHECK_FALSE(names_humanoid(folder / "."));
}
