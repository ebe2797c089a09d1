// SPDX-License-Identifier: MIT
// pantin model: drawings whose names do not tell their parts.
#include <catch2/catch.hpp>

#include <algorithm>
#include <map>

#include <nlohmann/json.hpp>

#include "cli/demo.hpp"
#include "pantin/image.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Made {
    TemporaryFolder folder;
    Outcome outcome;
    fs::path out() const { return folder / "out"; }
    // "body head limb limb", in alphabetical order.
    std::string labels() const {
        std::vector<std::string> all;
        const Json model = Json::parse(read(out() / "model.json"));
        for (const Json& part : model["parts"]) all.push_back(part["label"]);
        std::sort(all.begin(), all.end());
        std::string text;
        for (const std::string& label : all) text += (text.empty() ? "" : " ") + label;
        return text;
    }
    std::string reference() const { return Json::parse(read(out() / "identification.json"))["reference"]; }
};

// `pantin model`, then identify.
std::unique_ptr<Made> make(const std::string& text, const std::string& name = "drawing.svg",
                           const std::string& reference = "") {
    auto made = std::make_unique<Made>();
    const fs::path file = made->folder / name;
    write(file, text);
    made->outcome = run_pantin({"model", file.string(), "-o", made->out().string()});
    CAPTURE(made->outcome.err);
    REQUIRE(made->outcome.code == 0);
    std::vector<std::string> identify = {"identify", made->out().string()};
    if (!reference.empty()) identify.insert(identify.end(), {"--reference", reference});
    REQUIRE(run_pantin(identify).code == 0);
    return made;
}

std::string svg(const std::string& inside, const std::string& attributes = "viewBox='0 0 200 200'") {
    return "<svg xmlns='http://www.w3.org/2000/svg' " + attributes + ">" + inside + "</svg>";
}

// A pony of own making: body, neck and head, ears, four legs, tail; `%` before each shape for its attributes.
const std::string pony =
    "<path % d='M55 85C80 72 140 74 160 86C168 100 162 118 150 122L70 122C52 116 48 98 55 85Z'/>"
    "<path % d='M78 92L52 100L38 58L52 40L62 48Z'/><path % d='M56 38L62 54L46 66L20 76L14 66L40 42Z'/>"
    "<path % d='M50 42L48 26L60 38Z'/><rect % x='60' y='112' width='11' height='56'/>"
    "<rect % x='80' y='112' width='11' height='56'/><rect % x='126' y='112' width='11' height='56'/>"
    "<rect % x='146' y='108' width='11' height='60'/><path % d='M152 84C176 84 184 104 180 142L172 142C174 "
    "112 168 98 154 98Z'/>";

std::string with(std::string shapes, const std::vector<std::string>& attributes) {
    std::size_t next = 0;
    for (std::size_t at; (at = shapes.find('%')) != std::string::npos; ++next)
        shapes.replace(at, 1, attributes[next % attributes.size()]);
    return shapes;
}

// One outline of a long-legged animal with a neck.
const std::string silhouette = "<path d='M36 42L60 30L72 40L96 84L160 84C172 88 182 104 182 140L176 140C174 "
                               "116 170 106 162 104L160 172L150 172L"
                               "146 118L134 118L132 172L122 172L118 120L100 120L98 172L88 172L84 118L78 "
                               "116L76 172L66 172L62 108C58 96 60 76 56 "
                               "58L30 66L20 56Z'/>";

} // namespace

TEST_CASE("Shapes without names are the parts that the part network sees", "[cli][model][needs-pugixml]") {
    const auto made =
        make(svg(with(pony, {"fill='#b57a45'", "fill='#8a5a2b'"}) + "<circle cx='44' cy='52' r='3'/>"));
    CHECK(made->reference() == "quadruped");
    const std::string labels = made->labels();
    CHECK(labels.find("limb limb limb limb tail") != std::string::npos);
    CHECK(labels.starts_with("body"));
    CHECK(labels.find("head") != std::string::npos);
    // The shapes themselves, with their colours; the eye is seen though it is no part.
    const Json strokes = Json::parse(read(made->out() / "strokes.json"));
    CHECK(strokes["parts"].size() == 9);
    CHECK(strokes["parts"][0]["colour"] == "#b57a45");
    CHECK(made->outcome.out.find("'part-10': lies on another one, which it decorates") != std::string::npos);
    CHECK(Json::parse(read(made->out() / "model.json"))["texture"] == "drawing");
    const RgbImage drawing = load_image(made->out() / "drawing.png");
    CHECK(std::count(drawing.begin(), drawing.end(), Rgb8{0, 0, 0}) > 20);
    CHECK(std::count(drawing.begin(), drawing.end(), Rgb8{0xb5, 0x7a, 0x45}) > 1000);
}

TEST_CASE("One outline of a whole animal is cut into its parts", "[cli][model][needs-pugixml]") {
    for (const std::string& drawing :
         {svg(silhouette),
          svg("<g transform='translate(0,200) scale(.1,-.1)'><g transform='scale(10,-10) "
              "translate(0,-200)'>" +
              silhouette + "</g></g>"),
          svg("<path d='M0 0h200v200H0z'/><g fill='#fff'>" + silhouette + "</g>"),
          svg("<g fill='none' stroke='#000' stroke-width='3'>" + silhouette + "</g>")}) {
        CAPTURE(drawing);
        const auto made = make(drawing);
        CHECK(made->reference() == "quadruped");
        CHECK(made->labels().find("limb limb") != std::string::npos);
        CHECK(made->outcome.out.find("cut out of the whole by the part network") != std::string::npos);
    }
    CHECK(make(svg(silhouette), "drawing.svg", "humanoid")->reference() == "humanoid");
    // A name that is the same for everything tells nothing.
    CHECK(make(svg("<g id='body'>" + silhouette + "</g>"))->reference() == "quadruped");
    std::string named = silhouette;
    CHECK(make(svg(named.replace(0, 5, "<path id='dog-body'")))->reference() == "quadruped");
}

TEST_CASE("Names and labels overrule the part network", "[cli][model][needs-pugixml]") {
    // Whatever it sees, the tail is called a wing.
    const auto made =
        make(svg(with(pony, {"id='path1'", "id='path2'", "id='path3'", "id='path4'", "id='path5'",
                             "id='path6'", "id='path7'", "id='path8'", "id='left_wing'"})));
    CHECK(made->labels().ends_with("wing"));
    const auto data = make(svg(with(pony, {"", "", "", "", "", "", "", "", "data-label='wing'"})));
    CHECK(data->labels().ends_with("wing"));
    // All named: the network is not asked, and the strokes stay as they are.
    const std::vector<std::string> names = {"id='body'", "id='neck'", "id='head'", "id='ear'", "id='leg1'",
                                            "id='leg2'", "id='leg3'", "id='leg4'", "id='tail'"};
    const auto all = make(svg(with(pony, names)));
    CHECK(all->labels() == "body body head head limb limb limb limb tail");
    CHECK(Json::parse(read(all->out() / "model.json"))["texture"] == "parts");
    CHECK(all->outcome.out.find("network") == std::string::npos);
}

TEST_CASE("JSON without telling names is looked at, too", "[cli][model]") {
    const std::string strokes = R"({"parts": [
      {"name": "a", "stroke": [[55, 85], [80, 76], [140, 76], [160, 86], [164, 110], [150, 122], [70, 122], [52, 108]]},
      {"name": "b", "stroke": [[78, 92], [52, 100], [38, 58], [52, 40], [62, 48]]},
      {"name": "c", "stroke": [[56, 38], [62, 54], [46, 66], [20, 76], [14, 66], [40, 42]]},
      {"name": "d", "stroke": [[60, 112], [71, 112], [71, 168], [60, 168]]},
      {"name": "e", "stroke": [[80, 112], [91, 112], [91, 168], [80, 168]]},
      {"name": "f", "stroke": [[126, 112], [137, 112], [137, 168], [126, 168]]},
      {"name": "g", "stroke": [[146, 108], [157, 108], [157, 168], [146, 168]]},
      {"name": "h", "stroke": [[152, 84], [172, 88], [182, 106], [180, 142], [172, 142], [170, 110], [154, 98]]}]})";
    CHECK(make(strokes, "strokes.json")->reference() == "quadruped");
    // In space: only what is said of the labels differs.
    std::string deep = strokes;
    for (std::size_t at = 0; (at = deep.find("168]]}", at)) != std::string::npos; ++at)
        deep.replace(at, 6, "168]], \"depth\": 12, \"symmetric\": \"z\"}");
    const auto made = make(deep, "strokes.json");
    CHECK(made->labels().find("limb limb limb limb") != std::string::npos);
    CHECK(Json::parse(read(made->out() / "strokes.json"))["parts"].size() == 8);
}

TEST_CASE("Looking at a drawing gives the same bytes with any number of threads",
          "[cli][model][needs-pugixml]") {
    const TemporaryFolder folder;
    const fs::path file = folder / "drawing.svg";
    write(file, svg(silhouette));
    for (const char* threads : {"1", "3"})
        REQUIRE(run_pantin({"model", file.string(), "-o", (folder / threads).string(), "--threads", threads})
                    .code == 0);
    CHECK((read_all(folder / "1") == read_all(folder / "3")));
}

TEST_CASE("Details that are cut out of an outline stay visible, and a head beside its body is joined to it",
          "[cli][model][needs-pugixml]") {
    const std::string eye = "M44 40a4 4 0 1 0 8 0a4 4 0 1 0 -8 0Z";
    std::string with_eye = silhouette;
    with_eye.replace(with_eye.find("Z'/>"), 4, "Z" + eye + "' fill-rule='evenodd'/>");
    const auto made = make(svg(with_eye));
    const Mask mask = load_grey(made->out() / "mask.png");
    const RgbImage drawing = load_image(made->out() / "drawing.png");
    long white = 0;
    for (int y = 0; y < drawing.height(); ++y)
        for (int x = 0; x < drawing.width(); ++x)
            white += drawing(x, y) == Rgb8{255, 255, 255} &&
                     mask(x * mask.width() / drawing.width(), y * mask.height() / drawing.height()) != 0;
    CHECK(white > 200);

    const auto apart =
        make(svg("<circle cx='100' cy='30' r='20'/><path d='M80 56H120L160 100L150 110L122 84V130L132 190H"
                 "112L100 140L88 190H68L78 130V84L50 110L40 100Z'/>"));
    Mask whole = load_grey(apart->out() / "mask.png");
    for (std::uint8_t& pixel : whole) pixel = pixel != 0;
    CHECK(connected_components(whole).list.size() == 1);
    CHECK(apart->labels().find("head") != std::string::npos);
    CHECK(apart->reference() == "humanoid");
}

TEST_CASE("Eyes on a named head are drawn on it, whatever they are called", "[cli][svg][needs-pugixml]") {
    const TemporaryFolder folder;
    const fs::path file = folder / "dog.svg", out = folder / "out";
    write(file,
          "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'><g fill='#c84'>"
          "<ellipse id='body' cx='55' cy='45' rx='25' ry='12'/><circle id='head' cx='22' cy='32' r='12'/>"
          "<rect id='leg1' x='35' y='50' width='6' height='30'/><rect id='leg2' x='70' y='50' width='6' "
          "height='30'/></g><circle id='eye' cx='18' cy='30' r='3' fill='#0000ff'/></svg>");
    const Outcome outcome = run_pantin({"model", file.string(), "-o", out.string()});
    REQUIRE(outcome.code == 0);
    CHECK(outcome.out.find("part 'eye': lies on another one, which it decorates") != std::string::npos);
    CHECK(read(out / "model.json").find("\"eye\"") == std::string::npos);
    const RgbImage drawing = load_image(out / "drawing.png");
    CHECK(std::count(drawing.begin(), drawing.end(), Rgb8{0, 0, 255}) > 50);
}
