// SPDX-License-Identifier: MIT
// AnimatedDrawings character folders, written and read.
#include <catch2/catch.hpp>

#include <cmath>

#include <nlohmann/json.hpp>

#include "cli/demo.hpp"
#include "formats/animated_drawings.hpp"
#include "pantin/error.hpp"
#include "pantin/image.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

namespace fs = std::filesystem;

std::vector<std::string> animate(const std::string& what, const fs::path& out) {
    return std::vector<std::string>{"animate", what, "-o", out.string()} + small_films;
}

// The folder of the one character of the small page.
const fs::path& written() {
    static const TemporaryFolder folder;
    static const fs::path character = [] {
        const Outcome outcome =
            run_pantin(animate(small_page, folder / "out") + std::vector<std::string>{"--animated-drawings"});
        if (outcome.code != 0) throw std::runtime_error(outcome.err);
        return folder / "out/character-1/animated_drawings";
    }();
    return character;
}

} // namespace

TEST_CASE("A humanoid is written as AnimatedDrawings wants it", "[cli][animated-drawings]") {
    const std::string config = read(written() / "char_cfg.yaml");
    const GreyImage mask = load_grey(written() / "mask.png");
    const RgbImage texture = load_image(written() / "texture.png");
    CHECK(mask.width() == texture.width());
    CHECK(mask.height() == texture.height());
    CHECK(config.starts_with("height: " + std::to_string(mask.height()) + "\nskeleton:\n- loc:\n"));
    CHECK(config.ends_with("width: " + std::to_string(mask.width()) + "\n"));
    int inside = 0, joints = 0;
    for (std::size_t at = config.find("- loc:"); at != std::string::npos;
         at = config.find("- loc:", at + 1)) {
        int x = -1, y = -1;
        REQUIRE(std::sscanf(config.c_str() + at, "- loc:\n  - %d\n  - %d\n", &x, &y) == 2);
        ++joints;
        inside += mask(x, y) == 255;
    }
    CHECK(joints == 16);
    CHECK(inside >= 14); // of arms that are lines a joint may lie beside the ink
}

TEST_CASE("An AnimatedDrawings folder is animated with its mask and its joints",
          "[cli][animated-drawings][needs-yaml]") {
    const TemporaryFolder folder;
    const Outcome outcome = run_pantin(animate(written().string(), folder / "out"));
    CAPTURE(outcome.err);
    REQUIRE(outcome.code == 0);
    const fs::path character = folder / "out/character-1";
    CHECK(nlohmann::json::parse(read(character / "identification.json"))["reference"] == "humanoid");
    // The joints came from our own labels: parts lie where they lay.
    const GreyImage labels = load_grey(character / "labels.png"),
                    before = load_grey(written().parent_path() / "labels.png");
    REQUIRE(labels.width() == Approx(before.width()).margin(30));
    std::array<double, 4> now{}, then{};
    for (const std::uint8_t v : labels) now[std::min<std::size_t>(v, 3)] += 1.0 / labels.size();
    for (const std::uint8_t v : before) then[std::min<std::size_t>(v, 3)] += 1.0 / before.size();
    for (std::size_t i = 0; i < 4; ++i) CHECK(now[i] == Approx(then[i]).margin(0.08));
}

TEST_CASE("A damaged AnimatedDrawings folder is one line and exit code 3",
          "[cli][animated-drawings][needs-yaml]") {
    const TemporaryFolder folder;
    const fs::path copy = folder / "copy";
    const auto refused = [&](const std::string& config, const std::string& what) {
        write(copy / "char_cfg.yaml", config);
        const Outcome outcome = run_pantin(animate(copy.string(), folder / "out"));
        CAPTURE(outcome.err);
        CHECK(outcome.code == 3);
        CHECK(outcome.err.find("char_cfg.yaml: " + what) != std::string::npos);
        CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
        CHECK_FALSE(fs::exists(folder / "out"));
    };
    fs::copy(written(), copy);
    const std::string config = read(copy / "char_cfg.yaml");
    refused("", "has no list \"skeleton\"");
    refused("skeleton: [", "is not valid YAML: ");
    refused("skeleton:\n- name: hip\n", "joint 'hip' has no place");
    refused("skeleton:\n- 3\n", "skeleton[0]: must be an object");
    refused(std::string(config).replace(config.find("left_knee"), 9, "left_nose"),
            "misses the joint 'left_knee'");
    refused(std::string(config).replace(config.find("  - "), 4, "  - 99999"),
            "joint 'root' lies far outside");
    fs::remove(copy / "mask.png");
    const Outcome outcome = run_pantin(animate(copy.string(), folder / "out"));
    CHECK(outcome.code == 3);
}

TEST_CASE("Joints may be written in any way that is a number", "[cli][animated-drawings][needs-yaml]") {
    const TemporaryFolder folder;
    const auto joints_of = [&](const std::string& x) {
        std::string config = "skeleton:\n";
        for (const auto& [name, parent] : animated_drawings_joints)
            config += "- {name: " + std::string(name) + ", loc: [" + x + ", 7.5]}\n";
        write(folder / "char_cfg.yaml", config);
        return read_joints(folder / ".", 100, 100);
    };
    const auto plain = joints_of("12");
    CHECK(plain.at("neck") == Point2d{12, 7.5});
    for (const char* same : {"12.0", "012", "'12'", "\"12\"", "+12", "1.2e1", "120e-1"}) {
        CAPTURE(same);
        CHECK(joints_of(same).at("neck") == Point2d{12, 7.5});
    }
    for (const char* none : {"twelve", "12px", "''", "0x0c", "[12]", "~"}) {
        CAPTURE(none);
        CHECK_THROWS_AS(joints_of(none), Error);
    }
}
