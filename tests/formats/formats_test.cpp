// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "core/random.hpp"
#include <algorithm>
#include <functional>

#include <nlohmann/json.hpp>

#include "formats/identification_file.hpp"
#include "formats/mapping_file.hpp"
#include "formats/page_file.hpp"
#include "formats/segmentation_file.hpp"
#include "formats/skeleton_file.hpp"
#include "formats/voronoi_file.hpp"
#include "formats/weights_file.hpp"
#include "pantin/error.hpp"

using namespace pantin;

namespace {

SkeletonGraph random_graph(Random& random) {
    SkeletonGraph graph;
    graph.width = random.integer(20, 400);
    graph.height = random.integer(20, 400);
    const int count = random.integer(2, 12);
    for (int i = 0; i < count; ++i) {
        SkeletonVertex vertex;
        vertex.x = random.uniform(0, graph.width - 1);
        vertex.y = random.uniform(0, graph.height - 1);
        vertex.label = static_cast<Label>(random.integer(1, 5));
        vertex.end = random.chance(0.5);
        graph.vertices.push_back(vertex);
    }
    for (int i = 1; i < count; ++i) {
        SkeletonEdge edge;
        edge.u = random.integer(0, i - 1);
        edge.v = i;
        edge.length = random.uniform(0, 300);
        for (int k = random.integer(0, 6); k > 0; --k)
            edge.pixels.push_back({random.integer(0, graph.width - 1), random.integer(0, graph.height - 1)});
        graph.edges.push_back(edge);
    }
    return graph;
}

std::string message_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::input);
        return error.what();
    }
    return "no error";
}

const char* small_skeleton = R"({
  "width": 10,
  "height": 20,
  "vertices": [
    {
      "id": 0,
      "x": 1.5,
      "y": 2,
      "label": "head",
      "kind": "end"
    },
    {
      "id": 1,
      "x": 0.1,
      "y": 7,
      "label": "body",
      "kind": "junction"
    }
  ],
  "edges": [
    {
      "u": 0,
      "v": 1,
      "length": 5.5,
      "pixels": [
        [1, 2],
        [0, 7]
      ]
    }
  ]
}
)";

} // namespace

TEST_CASE("A skeleton survives the way to JSON and back to the bit", "[pipeline]") {
    Random random(11);
    for (int i = 0; i < 50; ++i) {
        const SkeletonGraph graph = random_graph(random);
        const std::string text = skeleton_to_json(graph);
        const SkeletonGraph back = skeleton_from_json(text, "skeleton.json");
        CHECK(back == graph);
        CHECK(skeleton_to_json(back) == text);
    }
}

TEST_CASE("JSON files have two-space indent, keys in order and the shortest decimals", "[pipeline]") {
    CHECK(skeleton_to_json(skeleton_from_json(small_skeleton, "skeleton.json")) == small_skeleton);
}

TEST_CASE("A damaged skeleton.json is an error that names file, place and fact", "[pipeline]") {
    struct Damage {
        std::string from, to, message;
    };
    const Damage damage = GENERATE(
        Damage{"\"width\": 10", "\"width\": \"10\"", "skeleton.json: width: must be a number"},
        Damage{"\"width\": 10", "\"width\": 1e9", "skeleton.json: width: must lie between 1 and 16384"},
        Damage{"\"id\": 1,", "\"id\": 7,", "skeleton.json: vertices[1].id: ids count up from 0"},
        Damage{"\"x\": 1.5", "\"x\": 1000", "skeleton.json: vertices[0].x: must lie between -1 and 10"},
        Damage{"\"label\": \"head\"", "\"label\": \"nose\"",
               "skeleton.json: vertices[0].label: must be " + listed_parts()},
        Damage{"\"kind\": \"end\"", "\"kind\": 3", "skeleton.json: vertices[0].kind: must be a string"},
        Damage{"\"v\": 1", "\"v\": 2", "skeleton.json: edges[0].v: must lie between 0 and 1"},
        Damage{"\"u\": 0", "\"u\": 1", "skeleton.json: edges[0]: u must be smaller than v"},
        Damage{"\"u\": 0", "\"u\": 0.5", "skeleton.json: edges[0].u: must be a whole number"},
        Damage{"[0, 7]", "[0, 7, 1]", "skeleton.json: edges[0].pixels[1]: has more than 2 elements"},
        Damage{"[0, 7]", "[0, 20]", "skeleton.json: edges[0].pixels[1][1]: must lie between 0 and 19"},
        Damage{"\"length\": 5.5,", "", "skeleton.json: edges[0]: misses \"length\""},
        Damage{"\"edges\": [", "\"edges\": {", "skeleton.json: not valid JSON (line 21)"});
    std::string text = small_skeleton;
    const std::size_t at = text.find(damage.from);
    REQUIRE(at != std::string::npos);
    text.replace(at, damage.from.size(), damage.to);
    CHECK(message_of([&] { skeleton_from_json(text, "skeleton.json"); }) == damage.message);
}

TEST_CASE("Every truncation of a JSON file is an error, not a crash", "[pipeline]") {
    const std::string text = small_skeleton;
    for (std::size_t length = 0; length + 2 < text.size(); ++length)
        CHECK_THROWS_AS(skeleton_from_json(text.substr(0, length), "skeleton.json"), Error);
}

TEST_CASE("An identification survives the way to JSON and back", "[pipeline]") {
    Random random(5);
    const SkeletonGraph graph = random_graph(random);
    ReferenceSkeleton reference;
    reference.name = "quadruped";
    reference.nodes.resize(8);
    Identification identification;
    identification.reference = "quadruped";
    identification.confidence = 0.1 + 0.2;
    Candidate candidate;
    candidate.reference = "quadruped";
    candidate.mirrored = true;
    candidate.distance = 1.0 / 3;
    candidate.score = -2.5e-7;
    candidate.evidence = {{"zebra", 1.5}, {"apple", -1}};
    candidate.optimal = false;
    candidate.pairs = {{0, 7}, {1, 2}};
    identification.candidates = {candidate};

    const std::string text = identification_to_json(identification);
    const Identification back = identification_from_json(text, "identification.json", graph, {reference});
    CHECK(back.confidence == identification.confidence);
    REQUIRE(back.candidates.size() == 1);
    CHECK(back.candidates[0].evidence == candidate.evidence); // the order, too
    CHECK(back.candidates[0].pairs == candidate.pairs);
    CHECK(back.candidates[0].score == candidate.score);
    CHECK(back.candidates[0].mirrored);
    CHECK_FALSE(back.candidates[0].optimal);
    CHECK(identification_to_json(back) == text);

    const auto damaged = [&](const std::string& from, const std::string& to) {
        std::string broken = text;
        broken.replace(broken.find(from), from.size(), to);
        return message_of([&] { identification_from_json(broken, "i.json", graph, {reference}); });
    };
    CHECK(damaged("[0, 7]", "[0, 8]") == "i.json: candidates[0].pairs[0][1]: must lie between 0 and 7");
    CHECK(damaged("\"quadruped\"", "\"dragon\"") == "i.json: reference: is none of the candidates");
    CHECK(damaged("\"mirrored\": true", "\"mirrored\": 1") ==
          "i.json: candidates[0].mirrored: must be true or false");
}

TEST_CASE("What the type head has seen survives the way to JSON and back", "[pipeline]") {
    Segmentation segmentation;
    segmentation.router = {{"ground", 1.0}};
    CHECK_FALSE(type_probabilities_from_json(segmentation_to_json(segmentation), "s.json"));
    segmentation.type = {0.125, 0.5, 0.25, 0.125};
    const std::string text = segmentation_to_json(segmentation);
    CHECK(type_probabilities_from_json(text, "s.json") == segmentation.type);
    std::string damaged = text;
    damaged.replace(damaged.find("\"flying\""), 8, "\"floats\"");
    CHECK(message_of([&] { type_probabilities_from_json(damaged, "s.json"); }) ==
          "s.json: type: misses \"flying\"");
}

TEST_CASE("A page survives the way to JSON and back, and its folders lie below it", "[pipeline]") {
    Page page;
    page.source = "a \"page\".png";
    page.width = 640;
    page.height = 480;
    page.characters = {{"character-1", {1, 2, 30, 40}, 1, 0.75, "ok"},
                       {"character-2", {100, 2, 30, 40}, 0.3, 0.5, "identify: a head alone"}};
    CHECK(page_to_json(page).find("warnings") == std::string::npos);
    page.characters[0].warnings = {{WarningKind::lost_ink, 0.125, "12 % \"lost\""},
                                   {WarningKind::unsure_type, 1.0 / 3, "unsure"}};
    const std::string text = page_to_json(page);
    const Page back = page_from_json(text, "page.json");
    CHECK(page_to_json(back) == text);
    REQUIRE(back.characters[0].warnings.size() == 2);
    CHECK(back.characters[0].warnings[0].kind == WarningKind::lost_ink);
    CHECK(back.characters[0].warnings[1].value == 1.0 / 3);
    CHECK(back.characters[1].warnings.empty());
    CHECK(message_of([&] {
              std::string unknown = text;
              page_from_json(unknown.replace(unknown.find("lost_ink"), 8, "lost_fun"), "page.json");
          }) == "page.json: characters[0].warnings[0].kind: there is no warning 'lost_fun'");
    for (const std::string folder : {"../other", "..", "", "a/b"}) {
        page.characters[0].folder = folder;
        CHECK_THROWS_AS(page_from_json(page_to_json(page), "page.json"), Error);
    }
}

TEST_CASE("A mapping survives the way to JSON and back; an end is mapped once", "[pipeline]") {
    Random random(6);
    const SkeletonGraph graph = random_graph(random);
    ReferenceSkeleton reference;
    reference.nodes.resize(4);
    Mapping mapping;
    mapping.pairs = {{0, 3, 0.25}, {1, 2, 1.0 / 7}};
    mapping.costs = {{0.1, 0.2}, {0.3, 1.0 / 7}};
    const std::string text = mapping_to_json(mapping);
    CHECK(mapping_to_json(mapping_from_json(text, "mapping.json", graph, reference)) == text);
    mapping.pairs[1].end = 0;
    CHECK(message_of([&] {
              mapping_from_json(mapping_to_json(mapping), "mapping.json", graph, reference);
          }) == "mapping.json: pairs[1].end: is mapped twice");
}

TEST_CASE("A Voronoi edge between two borders has no residual", "[pipeline]") {
    LabelMap ring(40, 40, static_cast<std::uint8_t>(Label::body));
    for (int y = 15; y < 25; ++y)
        for (int x = 15; x < 25; ++x) ring(x, y) = 0;
    SkeletonizationOptions options;
    options.fill_holes_share = 0;
    options.cut_cycles = false;
    const Skeletonization skeleton = skeletonize(ring, options);
    REQUIRE(skeleton.contour.size() == 2);
    const auto json = nlohmann::json::parse(voronoi_to_json(skeleton.voronoi, skeleton.residuals));
    const auto is_between = [](const nlohmann::json& edge) { return edge["residual"].is_null(); };
    CHECK(std::any_of(json["edges"].begin(), json["edges"].end(), is_between));
    CHECK_FALSE(std::all_of(json["edges"].begin(), json["edges"].end(), is_between));
}

TEST_CASE("weights.txt reads back to the weights that it was written from", "[pipeline]") {
    Rig rig;
    rig.mesh.vertices.resize(2);
    rig.bones = {{"hips", -1, {}, {}, Label::body, 0, 0, false},
                 {"leg", 0, {}, {}, Label::limb, 1, 0, false}};
    const std::string head = "# pantin weights 1\nbone 0 hips\nbone 1 leg\n";
    const auto weights = weights_from_text(head + "v 2 1 1\nv 1 0 0.25 1 0.75\n", "w", rig);
    CHECK(weights[0].bones[0] == 1); // the heavier first
    CHECK(weights[0].weights[0] == 0.75);
    CHECK(weights[0].weights[1] == 0.25);
    CHECK(weights[1].weights[0] == 1);
    const auto message = [&](const std::string& text) {
        return message_of([&] { weights_from_text(text, "w", rig); });
    };
    CHECK(message(head + "v 1 0 1\n") == "w: line 4: misses the weights of vertex 2");
    CHECK(message(head + "v 1 0 1\nv 3 0 1\n") == "w: line 5: '3' is not a number in range");
    CHECK(message(head + "v 1 0 1\nv 1 0 1\n") == "w: line 5: the vertex occurs twice");
    CHECK(message(head + "v 1 0 nan\n") == "w: line 4: 'nan' is not a number in range");
    CHECK(message(head + "v 1 0 0.5\n") == "w: line 4: the weights of a vertex sum to 1");
    CHECK(message(head + "v 1 0\n") == "w: line 4: misses a weight");
    CHECK(message("bone 0 arm\n") == "w: line 1: the bones do not fit skeleton.json and identification.json");
    CHECK(message("\x01garbage\n") == "w: line 1: a line begins with bone or v");
    CHECK(message("") == "w: line 0: names 0 bones of 2");
}
