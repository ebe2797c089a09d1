// SPDX-License-Identifier: MIT
// The walkthrough of small drawings: whole, self-contained, and true to the files of the run. Browsers look
// at it in `make test-web`.
#include <catch2/catch.hpp>

#include <algorithm>
#include <regex>
#include <set>

#include <nlohmann/json.hpp>

#include "cli/demo.hpp"
#include "explain/markup.hpp"
#include "explain/picture_size.hpp"
#include "pantin/export.hpp"
#include "pantin/image.hpp"
#include "pipeline/character.hpp"

using namespace pantin::test;
using Json = nlohmann::json;

namespace {

const std::vector<std::string> chapter_names = {"silhouette", "segment",  "contour", "voronoi",    "thinning",
                                                "graph",      "identify", "paths",   "assignment", "mesh",
                                                "weights",    "motion",   "solid"};

struct Explained {
    TemporaryFolder folder;
    std::filesystem::path out;
    Outcome outcome;
    std::string page;
};

void explain(Explained& e, const std::string& image, const std::vector<std::string>& more = {}) {
    e.out = e.folder / "out";
    e.outcome = run_pantin(
        std::vector<std::string>{"explain", image, "-o", e.out.string(), "--trace", "--clip", "idle"} +
        small_films + more);
    if (std::filesystem::exists(e.out / "index.html")) e.page = read(e.out / "index.html");
}

const Explained& explained_humanoid() {
    static const std::unique_ptr<Explained> result = [] {
        auto e = std::make_unique<Explained>();
        explain(*e, small_page, {"--threads", "1"});
        return e;
    }();
    REQUIRE(result->outcome.err == "");
    REQUIRE(result->outcome.code == 0);
    return *result;
}

// Everything but the contents of <script> and <style>.
std::string markup_of(std::string page) {
    for (const char* name : {"script", "style"}) {
        const std::string open = std::string("<") + name, close = std::string("</") + name + ">";
        for (std::size_t at = page.find(open); at != std::string::npos;
             at = page.find(open, at + open.size())) {
            const std::size_t begin = page.find('>', at) + 1, end = page.find(close, begin);
            REQUIRE(end != std::string::npos);
            page.erase(begin, end - begin);
        }
    }
    return page;
}

std::string chapter_of(const std::string& page, const std::string& id) {
    const std::size_t begin = page.find("<article class=\"chapter\" id=\"" + id + "\""),
                      end = page.find("</article>", begin);
    REQUIRE(begin != std::string::npos);
    return page.substr(begin, end - begin);
}

Json data_of(const std::string& chapter) {
    const std::string open = "<script type=\"application/json\" class=\"data\">";
    const std::size_t begin = chapter.find(open) + open.size();
    return Json::parse(chapter.substr(begin, chapter.find("</script>", begin) - begin));
}

std::vector<std::string> values_of(const std::string& markup, const std::string& attribute) {
    std::vector<std::string> values;
    const std::string open = " " + attribute + "=\"";
    for (std::size_t at = markup.find(open); at != std::string::npos; at = markup.find(open, at + 1)) {
        const std::size_t begin = at + open.size();
        values.push_back(markup.substr(begin, std::min<std::size_t>(200, markup.find('"', begin) - begin)));
    }
    return values;
}

int count_of(const std::string& text, const std::string& what) {
    int count = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + what.size()))
        ++count;
    return count;
}

} // namespace

TEST_CASE("explain writes a page with every chapter, in the order of the steps", "[explain][end-to-end]") {
    const std::string& page = explained_humanoid().page;
    std::size_t last = 0;
    for (const std::string& name : chapter_names) {
        CAPTURE(name);
        const std::size_t at = page.find("id=\"character-1-" + name + "\"");
        REQUIRE(at != std::string::npos);
        CHECK(at > last);
        last = at;
        const std::string chapter = chapter_of(page, "character-1-" + name);
        CHECK(chapter.find("class=\"flow\"") != std::string::npos); // what goes in, what comes out
        CHECK(chapter.find("<math") != std::string::npos);          // the equation
        CHECK(chapter.find("class=\"settings\"") !=
              std::string::npos); // the parameters, and the file to edit
        const bool shows = chapter.find("<svg class=\"picture") != std::string::npos ||
                           chapter.find("<img") != std::string::npos ||
                           chapter.find("class=\"matrix\"") != std::string::npos;
        CHECK(shows); // also without a script
    }
    CHECK(page.size() < 15'000'000);
}

TEST_CASE("the page is self-contained: no address outside of it, every reference inside of it",
          "[explain][end-to-end]") {
    const std::string markup = markup_of(explained_humanoid().page);
    for (const char* attribute : {"src", "href"})
        for (const std::string& value : values_of(markup, attribute)) {
            CAPTURE(attribute, value);
            CHECK((value.starts_with("#") || value.starts_with("data:")));
        }
    const std::vector<std::string> ids = values_of(markup, "id");
    const std::set<std::string> known(ids.begin(), ids.end());
    CHECK(known.size() == ids.size()); // each once
    for (const std::string& value : values_of(markup, "href"))
        if (value.starts_with("#")) CHECK(known.count(value.substr(1)) == 1);
    for (const std::string& value : values_of(markup, "aria-labelledby")) CHECK(known.count(value) == 1);
    CHECK(count_of(markup, "{{") == 0);
    CHECK(count_of(markup, "<svg class=\"picture") == count_of(markup, "role=\"img\" aria-label="));
    CHECK(count_of(markup, "<img") == count_of(markup, "<img class=\"film\" alt="));
}

TEST_CASE("every element of the page that is opened is closed, in order", "[explain][end-to-end]") {
    const std::string markup = markup_of(explained_humanoid().page);
    const std::set<std::string> empty = {"!doctype", "meta", "img", "input", "br"};
    std::vector<std::string> open;
    for (std::size_t at = markup.find('<'); at != std::string::npos; at = markup.find('<', at + 1)) {
        const std::size_t end = markup.find('>', at);
        REQUIRE(end != std::string::npos);
        const bool closes = markup[at + 1] == '/';
        std::size_t stop = at + 1 + closes;
        while (stop < end && markup[stop] != ' ' && markup[stop] != '/') ++stop;
        const std::string name = markup.substr(at + 1 + closes, stop - at - 1 - closes);
        if (closes) {
            CAPTURE(name, markup.substr(at > 200 ? at - 200 : 0, 220));
            REQUIRE(!open.empty());
            REQUIRE(open.back() == name);
            open.pop_back();
        } else if (!empty.count(name) && markup[end - 1] != '/') {
            open.push_back(name);
        }
    }
    CHECK(open.empty());
}

TEST_CASE("the page shows what the files of the run hold", "[explain][end-to-end]") {
    const Explained& e = explained_humanoid();
    const auto file = [&](const std::string& name) {
        return Json::parse(read(e.out / "character-1" / name));
    };

    const Json voronoi = data_of(chapter_of(e.page, "character-1-voronoi")),
               edges = file("trace/voronoi.json")["edges"];
    REQUIRE(voronoi["edges"].size() == 5 * edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i)
        REQUIRE(voronoi["edges"][5 * i].get<double>() ==
                Approx(10 * edges[i]["from"][0].get<double>()).margin(0.51));

    const Json skeleton = file("skeleton.json"), mapping = file("mapping.json");
    const std::string graph = chapter_of(e.page, "character-1-graph");
    CHECK(graph.find("After H2: " + std::to_string(skeleton["vertices"].size()) + " vertices") !=
          std::string::npos);
    CHECK(graph.find(std::to_string(skeleton["edges"].size()) + " edges") != std::string::npos);

    const Json identification = file("identification.json");
    const std::string identify = chapter_of(e.page, "character-1-identify");
    CHECK(count_of(identify, "class=\"candidate") ==
          int(identification["candidates"].size()) + 1); // and the list of them
    CHECK(identify.find("<h4>" + identification["reference"].get<std::string>()) != std::string::npos);

    const Json paths = data_of(chapter_of(e.page, "character-1-paths"));
    CHECK(paths["comparisons"].size() == mapping["costs"].size());
    CHECK(count_of(chapter_of(e.page, "character-1-assignment"), "<td class=\"chosen\"") ==
          int(mapping["pairs"].size()));

    const Json weights = data_of(chapter_of(e.page, "character-1-weights"));
    const std::string obj = read(e.out / "character-1" / "mesh.obj"),
                      text = read(e.out / "character-1" / "weights.txt");
    CHECK(int(weights["weights"].size()) == count_of(obj, "\nv "));
    CHECK(int(weights["faces"].size()) == count_of(obj, "\nf "));
    for (const Json& vertex : weights["weights"]) {
        int sum = 0;
        for (std::size_t k = 1; k < vertex.size(); k += 2) sum += vertex[k].get<int>();
        REQUIRE(std::abs(sum - 1000) <= 2);
    }
    CHECK(count_of(chapter_of(e.page, "character-1-weights"), "<option value=") ==
          count_of(text, "bone ") + 1);
    CHECK(data_of(chapter_of(e.page, "character-1-motion"))["glb"].get<std::string>().starts_with(
        "data:model/gltf-binary;base64,Z2xURg"));
}

TEST_CASE("the solid's clips are made for its own bones", "[explain][end-to-end]") {
    using namespace pantin;
    Explained e;
    explain(e, "testdata/flying.png", {"--threads", "1"});
    REQUIRE(e.outcome.code == 0);
    const Settings settings;
    Context context(settings);
    const Character c = load_character(e.out / "character-1", Step::render, context);
    Model model(strokes_from_labels(c.segmentation.labels), settings.options.modeling);
    const SolidMesh mesh = model.united();
    ModelView view;
    view.width = c.mask.width();
    view.height = c.mask.height();
    const Rig rig = lifted(c.rig, model, mesh, view);
    const std::vector<BoneAnimation> clips = make_animations(rig, c.reference, context);
    const RgbaImage texture = make_solid_texture(small_drawing(c), c.segmentation.labels);
    const std::vector<unsigned char> glb = to_glb(rig, texture, clips);
    CHECK(data_of(chapter_of(e.page, "character-1-solid"))["glb"] == data_uri("model/gltf-binary", glb));
    CHECK(to_glb(rig, texture, c.animations) != glb); // the flat figure's are others
}

TEST_CASE("the page does not depend on the number of threads", "[explain][end-to-end]") {
    Explained two;
    explain(two, small_page, {"--threads", "2"});
    CHECK(two.page == explained_humanoid().page);
}

TEST_CASE("explain writes the same files as animate, and the page", "[explain][end-to-end]") {
    const Explained& e = explained_humanoid();
    const TemporaryFolder folder;
    const Outcome outcome =
        run_pantin(std::vector<std::string>{"animate", small_page, "-o", (folder / "out").string(), "--trace",
                                            "--clip", "idle", "--threads", "1"} +
                   small_films);
    REQUIRE(outcome.code == 0);
    auto files = read_all(e.out);
    CHECK(files.erase("index.html") == 1);
    CHECK(files == read_all(folder / "out"));
}

TEST_CASE("characters that cannot go on have the chapters up to there, and why", "[explain][end-to-end]") {
    Explained e;
    explain(e, "testdata/rejects.png");
    CHECK(e.outcome.code == 0);
    int stopped = 0;
    const Json page = Json::parse(read(e.out / "page.json"));
    for (const Json& character : page["characters"]) {
        const std::string id = character["folder"], status = character["status"];
        CAPTURE(id, status);
        CHECK(e.page.find("id=\"" + id + "-silhouette\"") != std::string::npos);
        CHECK((e.page.find("id=\"" + id + "-motion\"") != std::string::npos) == (status == "ok"));
        if (status == "ok") continue;
        ++stopped;
        CHECK(e.page.find("This character could not go on. " + status) != std::string::npos);
    }
    CHECK(stopped == 3);
}

TEST_CASE("what explain cannot read is one line, and no page", "[explain][end-to-end]") {
    Explained e;
    explain(e, "testdata/no-such.png");
    CHECK(e.outcome.code == 3);
    CHECK(e.outcome.err.find("testdata/no-such.png") != std::string::npos);
    CHECK(count_of(e.outcome.err, "\n") == 1);
    CHECK(!std::filesystem::exists(e.out / "index.html"));
    CHECK(run_pantin({"explain", small_page}).code == 2);
}

TEST_CASE("explain with labels and method of the user's", "[explain][end-to-end]") {
    const Explained& own = explained_humanoid();
    const Json found = Json::parse(read(own.out / "page.json"))["characters"][0]["box"];
    const pantin::Box box{found[0], found[1], found[2], found[3]};
    const pantin::RgbImage page = pantin::load_image(small_page);
    const pantin::LabelMap part =
        pantin::resize_nearest(pantin::load_grey(own.out / "character-1/labels.png"), box.width, box.height);
    pantin::LabelMap labels(page.width(), page.height());
    for (int y = 0; y < box.height; ++y)
        for (int x = 0; x < box.width; ++x) labels(box.x + x, box.y + y) = part(x, y);

    Explained e;
    pantin::save_png(e.folder / "labels.png", labels);
    write(e.folder / "options.json", R"({"skeletonization.method": "thinning"})");
    explain(
        e, small_page,
        {"--labels", (e.folder / "labels.png").string(), "--config", (e.folder / "options.json").string()});
    REQUIRE(e.outcome.code == 0);
    CHECK(e.page.find("id=\"character-1-voronoi\"") == std::string::npos); // no diagram, no chapter
    CHECK(chapter_of(e.page, "character-1-segment").find("were given") != std::string::npos);
}
