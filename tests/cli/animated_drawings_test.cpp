// SPDX-License-Identifier: MIT
// AnimatedDrawings character folders, written and read.
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "cli/demo.hpp"
#include "pantin/image.hpp"
#include "pantin/point.hpp"
#include "support/schemas.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

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

TEST_CASE("A folder whose joints cannot be used gets the network's parts, and a line that says why",
          "[cli][animated-drawings][needs-yaml]") {
    const TemporaryFolder folder;
    const fs::path copy = folder / "copy", character = folder / "out/character-1";
    fs::copy(written(), copy);
    const std::string config = read(copy / "char_cfg.yaml");
    const auto remarked = [&](const std::string& what) {
        const Outcome outcome = run_pantin(animate(copy.string(), folder / "out"));
        CAPTURE(what, outcome.out, outcome.err);
        CHECK(outcome.code == 0);
        CHECK(outcome.out.find("char_cfg.yaml: " + what) != std::string::npos);
        CHECK(outcome.out.find("; the network's parts are taken\n") != std::string::npos);
        CHECK(fs::exists(character / "segmentation.json"));
        const Json page = Json::parse(read(folder / "out/page.json"));
        CHECK(page["remarks"].size() == 1);
        CHECK(page["characters"][0]["exact_mask"] == true);
    };
    write(copy / "char_cfg.yaml", "skeleton: [");
    remarked("is not valid YAML: ");
    write(copy / "char_cfg.yaml", std::string(config).replace(config.find("  - "), 4, "  - 99999"));
    remarked("joint 'root' lies far outside of texture.png");
    write(copy / "char_cfg.yaml", "skeleton:\n- {name: a, loc: [1, 2]}\n");
    remarked("its joints do not say what is trunk, head, limb, tail or wing");
    fs::remove(copy / "char_cfg.yaml");
    remarked("no such file");
}

TEST_CASE("A folder without its texture or its mask is one line and exit code 3",
          "[cli][animated-drawings]") {
    const TemporaryFolder folder;
    const fs::path copy = folder / "copy";
    fs::copy(written(), copy);
    const auto refused = [&](const std::string& what) {
        const Outcome outcome = run_pantin(animate(copy.string(), folder / "out"));
        CAPTURE(what, outcome.err);
        CHECK(outcome.code == 3);
        CHECK(outcome.err.find(what) != std::string::npos);
        CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
        CHECK_FALSE(fs::exists(folder / "out"));
    };
    const GreyImage mask = load_grey(copy / "mask.png");
    save_png(copy / "mask.png", GreyImage(mask.width() + 1, mask.height(), 255));
    refused("mask.png: is ");
    save_png(copy / "mask.png", GreyImage(mask.width(), mask.height(), 0));
    refused("mask.png: has no pixel of the character");
    write(copy / "mask.png", "no picture");
    refused("mask.png: ");
    fs::remove(copy / "mask.png");
    refused("mask.png: no such file");
    save_png(copy / "mask.png", mask);
    write(copy / "texture.png", "no picture");
    refused("texture.png: ");
    fs::remove(copy / "texture.png");
    refused("texture.png: no such file");
}

// --- other bodies ------------------------------------------------------------------------------------------

namespace {

// A folder with a figure of ellipses and bars, and its joints.
class Figure {
public:
    // Its joints lie `shift` to the right of where they are said to be.
    explicit Figure(int width, int height, int shift = 0) : mask_(width, height, 0), shift_(shift) {}
    void ellipse(int x, int y, int rx, int ry) {
        fill([&](double px, double py) {
            return (px - x) * (px - x) / rx / rx + (py - y) * (py - y) / ry / ry <= 1;
        });
    }
    // With the joints of its ends and its middle, `parent` and what they are called.
    void bar(Point2d a, Point2d b, double half, const std::string& parent,
             const std::array<std::string, 3>& names) {
        const Point2d v = b - a;
        fill([&](double x, double y) {
            const Point2d p{x, y};
            const double t = std::clamp(dot(p - a, v) / dot(v, v), 0.0, 1.0);
            return distance(p, a + t * v) <= half;
        });
        joint(names[0], a, parent);
        joint(names[1], a + 0.5 * v, names[0]);
        joint(names[2], b, names[1]);
    }
    void joint(const std::string& name, Point2d p, const std::string& parent) {
        config_ += "- {name: " + name + ", parent: " + parent + ", loc: [" + std::to_string(p.x + shift_) +
                   ", " + std::to_string(p.y) + "]}\n";
    }
    const GreyImage& mask() const { return mask_; }
    void save(const fs::path& folder) const {
        fs::create_directories(folder);
        RgbImage texture(mask_.width(), mask_.height(), {255, 255, 255});
        for (std::size_t i = 0; i < mask_.size(); ++i)
            if (mask_.data()[i]) texture.data()[i] = {150, 90, 70};
        save_png(folder / "texture.png", texture);
        save_png(folder / "mask.png", mask_);
        write(folder / "char_cfg.yaml", config_);
    }

private:
    template <class Inside> void fill(const Inside& inside) {
        for (int y = 0; y < mask_.height(); ++y)
            for (int x = 0; x < mask_.width(); ++x)
                if (inside(x, y)) mask_(x, y) = 255;
    }
    GreyImage mask_;
    int shift_;
    std::string config_ = "skeleton:\n";
};

Figure horse(int shift = 0) {
    Figure figure(360, 300, shift);
    figure.ellipse(190, 130, 110, 50);
    figure.ellipse(55, 90, 42, 38);
    figure.joint("root", {190, 130}, "null");
    figure.joint("hip", {270, 130}, "root");
    figure.joint("torso", {110, 125}, "root");
    figure.joint("neck", {58, 92}, "torso");
    for (const auto& [name, x] : std::vector<std::pair<std::string, double>>{{"l", 120}, {"r", 160}})
        figure.bar({x, 165}, {x - 4, 275}, 11, "torso",
                   {name + "_shoulder_front", name + "_knee_front", name + "_hoof_front"});
    for (const auto& [name, x] : std::vector<std::pair<std::string, double>>{{"l", 225}, {"r", 265}})
        figure.bar({x, 165}, {x + 4, 275}, 11, "hip",
                   {name + "_hip_back", name + "_knee_back", name + "_hoof_back"});
    figure.bar({295, 120}, {345, 70}, 8, "hip", {"tail_base", "tail_middle", "tail_tip"});
    return figure;
}

Figure many_arms() {
    Figure figure(340, 440);
    figure.ellipse(170, 210, 45, 110);
    figure.ellipse(170, 60, 40, 40);
    figure.joint("root", {170, 300}, "null");
    figure.joint("torso", {170, 140}, "root");
    figure.joint("neck", {170, 75}, "torso");
    for (int i = 0; i < 3; ++i)
        for (const int side : {-1, 1}) {
            const std::string end = (side < 0 ? "_right" : "_left") + std::to_string(i);
            const double y = 150 + 50 * i;
            figure.bar({170.0 + side * 40, y}, {170.0 + side * 145, y - 30}, 9, "torso",
                       {"shoulder" + end, "elbow" + end, "hand" + end});
        }
    for (const int side : {-1, 1}) {
        const std::string end = side < 0 ? "_right" : "_left";
        figure.bar({170.0 + side * 18, 310}, {170.0 + side * 35, 425}, 11, "root",
                   {"hip" + end, "knee" + end, "foot" + end});
    }
    return figure;
}

std::array<long, 6> areas(const GreyImage& labels) {
    std::array<long, 6> count{};
    for (const std::uint8_t v : labels) ++count[std::min<std::size_t>(v, 5)];
    return count;
}

} // namespace

TEST_CASE("An AnimatedDrawings folder with four legs and a tail moves as a quadruped",
          "[cli][animated-drawings][needs-yaml]") {
    const TemporaryFolder folder;
    const fs::path character = folder / "out/character-1";
    horse().save(folder / "horse");
    const Outcome outcome = run_pantin(animate((folder / "horse").string(), folder / "out"));
    CAPTURE(outcome.out, outcome.err);
    REQUIRE(outcome.code == 0);
    CHECK_FALSE(Json::parse(read(folder / "out/page.json")).contains("remarks"));
    CHECK(Json::parse(read(character / "identification.json"))["reference"] == "quadruped");
    const std::array<long, 6> area = areas(load_grey(character / "labels.png"));
    for (const int part : {1, 2, 3, 4}) CHECK(area[static_cast<std::size_t>(part)] > 500);
    CHECK(area[5] == 0);
    // Each leg has an end of its own that drives a leg.
    CHECK(Json::parse(read(character / "mapping.json"))["pairs"].size() >= 6);
    // --reference overrules.
    REQUIRE(run_pantin(animate((folder / "horse").string(), folder / "out") +
                       std::vector<std::string>{"--reference", "humanoid"})
                .code == 0);
    CHECK(Json::parse(read(character / "identification.json"))["reference"] == "humanoid");
}

TEST_CASE("An AnimatedDrawings folder with six arms moves them", "[cli][animated-drawings][needs-yaml]") {
    const TemporaryFolder folder;
    const fs::path character = folder / "out/character-1";
    many_arms().save(folder / "arms");
    const Outcome outcome = run_pantin(animate((folder / "arms").string(), folder / "out"));
    CAPTURE(outcome.out, outcome.err);
    REQUIRE(outcome.code == 0);
    CHECK(Json::parse(read(character / "identification.json"))["reference"] == "humanoid");
    long limbs = 0;
    const Json skeleton = Json::parse(read(character / "skeleton.json"));
    for (const Json& vertex : skeleton["vertices"])
        limbs += vertex["kind"] == "end" && vertex["label"] == "limb";
    CHECK(limbs == 8);
}

TEST_CASE("Masks of AnimatedDrawings folders say in several ways what the figure is",
          "[cli][animated-drawings][needs-yaml]") {
    const TemporaryFolder folder;
    const Figure figure = horse();
    figure.save(folder / "horse");
    const auto run = [&] {
        const Outcome outcome =
            run_pantin({"detect", (folder / "horse").string(), "-o", (folder / "out").string()});
        CAPTURE(outcome.err);
        REQUIRE(outcome.code == 0);
        return areas(load_grey(folder / "out/character-1/mask.png"))[5];
    };
    const long area = run();
    GreyImage inverted = figure.mask(), soft = figure.mask();
    RgbaImage cut(inverted.width(), inverted.height());
    for (std::size_t i = 0; i < inverted.size(); ++i) {
        const bool inside = figure.mask().data()[i] != 0;
        inverted.data()[i] = inside ? 0 : 255;
        soft.data()[i] = inside ? 200 : 90;
        cut.data()[i] = {0, 0, 0, static_cast<std::uint8_t>(inside ? 255 : 0)};
    }
    save_png(folder / "horse/mask.png", soft);
    CHECK(run() == area);
    CHECK_FALSE(Json::parse(read(folder / "out/page.json")).contains("remarks"));
    save_png(folder / "horse/mask.png", cut); // black on a transparent ground
    CHECK(run() == area);
    save_png(folder / "horse/mask.png", inverted);
    CHECK(run() == area);
    const Json remarks = Json::parse(read(folder / "out/page.json"))["remarks"];
    REQUIRE(remarks.size() == 1);
    CHECK(remarks[0].get<std::string>().find("mask.png: is white around a black figure") !=
          std::string::npos);
    // Written as 0 and 1, and that inverted.
    const auto has_remark = [&](const std::string& what) {
        const Json page = Json::parse(read(folder / "out/page.json"));
        return page.value("remarks", Json::array()).size() == 1 &&
               page["remarks"][0].get<std::string>().find("mask.png: " + what) != std::string::npos;
    };
    GreyImage ones = figure.mask();
    for (const bool turned_round : {false, true}) {
        for (std::size_t i = 0; i < ones.size(); ++i)
            ones.data()[i] = (figure.mask().data()[i] != 0) != turned_round;
        save_png(folder / "horse/mask.png", ones);
        CHECK(run() == area);
        CHECK(has_remark(turned_round
                             ? "has no value above 1; 1 is taken for white; it is white around a black"
                             : "has no value above 1; 1 is taken for white"));
    }
    for (std::uint8_t& value : ones) value = static_cast<std::uint8_t>(value ? 2 : 1); // says nothing
    save_png(folder / "horse/mask.png", ones);
    const Outcome refused =
        run_pantin({"detect", (folder / "horse").string(), "-o", (folder / "none").string()});
    CHECK(refused.code == 3);
    CHECK(refused.err.find("mask.png: has no pixel of the character") != std::string::npos);
    CHECK_FALSE(fs::exists(folder / "none"));
    // A mask that is white everywhere is no inverted one.
    save_png(folder / "horse/mask.png", GreyImage(inverted.width(), inverted.height(), 255));
    CHECK(run() > 2 * area);
}

TEST_CASE("A mask of 0 and 1 beside a page is taken, with a line", "[cli][animated-drawings]") {
    const TemporaryFolder folder;
    const Figure figure = horse();
    figure.save(folder / "horse");
    GreyImage ones = figure.mask();
    for (std::uint8_t& value : ones) value = value != 0;
    save_png(folder / "ones.png", ones);
    const auto run = [&](const fs::path& mask) {
        const Outcome outcome = run_pantin(animate((folder / "horse/texture.png").string(), folder / "out") +
                                           std::vector<std::string>{"--mask", mask.string()});
        CAPTURE(outcome.err);
        REQUIRE(outcome.code == 0);
        return read(folder / "out/character-1/mask.png");
    };
    CHECK(run(folder / "ones.png") == run(folder / "horse/mask.png"));
    run(folder / "ones.png");
    const Json remarks = Json::parse(read(folder / "out/page.json"))["remarks"];
    REQUIRE(remarks.size() == 1);
    CHECK(remarks[0].get<std::string>().find("ones.png: has no value above 1") != std::string::npos);
}

TEST_CASE("Joints that lie outside of the mask are not followed", "[cli][animated-drawings][needs-yaml]") {
    const TemporaryFolder folder;
    for (const int shift : {0, 8, 250}) {
        Figure figure = horse(shift);
        figure.save(folder / "horse");
        const Outcome outcome = run_pantin(animate((folder / "horse").string(), folder / "out"));
        CAPTURE(shift, outcome.out, outcome.err);
        REQUIRE(outcome.code == 0);
        const bool said = outcome.out.find("char_cfg.yaml: 18 of its 19 joints lie outside of the mask; the "
                                           "network's parts are taken\n") != std::string::npos;
        CHECK(said == (shift == 250));
        CHECK(Json::parse(read(folder / "out/page.json")).contains("remarks") == (shift == 250));
        CHECK(fs::exists(folder / "out/character-1/segmentation.json") == (shift == 250));
    }
}

TEST_CASE("batch takes folders of any body, and says in the line what was wrong with one",
          "[cli][animated-drawings][needs-yaml]") {
    const TemporaryFolder folder;
    horse().save(folder / "horse");
    many_arms().save(folder / "arms");
    write(folder / "arms/char_cfg.yaml", "skeleton: []\n");
    const std::string lines = (folder / "horse").string() + "\n" + (folder / "arms").string() + "/\n";
    const Outcome outcome = run_pantin(
        std::vector<std::string>{"batch", "-o", (folder / "out").string()} + small_films, {}, "", lines);
    CAPTURE(outcome.out, outcome.err);
    REQUIRE(outcome.code == 0);
    const std::size_t end = outcome.out.find('\n');
    const Json first = Json::parse(outcome.out.substr(0, end)),
               second = Json::parse(outcome.out.substr(end + 1));
    CHECK(first["characters"][0]["type"] == "quadruped");
    CHECK_FALSE(first.contains("remarks"));
    REQUIRE(second["remarks"].size() == 1);
    CHECK(second["remarks"][0].get<std::string>().find("char_cfg.yaml: its list \"skeleton\" is empty") !=
          std::string::npos);
    CHECK(schema_violation("batch-output", second) == "");
    CHECK(schema_violation("page", Json::parse(read(folder / "out/arms/page.json"))) == "");
}
