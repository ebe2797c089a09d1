// SPDX-License-Identifier: MIT
// End-effector mapping of painted figures and of the references onto themselves.
#include <catch2/catch.hpp>

#include <algorithm>
#include <map>

#include "../identification/figures.hpp"
#include "rigging/path_distance.hpp"
#include "rigging/reference_shape.hpp"

using namespace pantin;

namespace {

Mask mask_of(const Figure& figure) {
    Mask mask(figure.squared_distance.width(), figure.squared_distance.height());
    for (std::size_t i = 0; i < mask.size(); ++i) mask.data()[i] = figure.squared_distance.data()[i] > 0;
    return mask;
}

const ReferenceSkeleton& find(const std::vector<ReferenceSkeleton>& references, const std::string& name) {
    return *std::find_if(references.begin(), references.end(),
                         [&](const ReferenceSkeleton& r) { return r.name == name; });
}

struct Mapped {
    Skeletonization skeleton;
    Mapping mapping;
    std::map<std::string, Point2d> places; // of the ends, by the name of the reference node
};
Mapped map_figure(const LabelMap& labels, const std::string& expected, const MappingOptions& options = {}) {
    static const std::vector<ReferenceSkeleton> references = load_references();
    Mapped result;
    result.skeleton = skeletonize(labels);
    const Identification found = identify(result.skeleton.graph, labels, references);
    REQUIRE(found.reference == expected);
    const ReferenceSkeleton& reference = find(references, expected);
    result.mapping =
        map_end_effectors(result.skeleton.graph, labels, reference, found.candidates[0], options);
    for (const EndPair& p : result.mapping.pairs) {
        const SkeletonVertex& v = result.skeleton.graph.vertices[p.end];
        result.places[reference.nodes[p.reference_end].name] = {v.x, v.y};
        CHECK(v.label == reference.nodes[p.reference_end].label);
    }
    return result;
}

} // namespace

TEST_CASE("a mapping tells how its costs came about") {
    const ReferenceSkeleton reference = load_references().front();
    const Figure figure = draw_reference(reference, false);
    MappingOptions options;
    options.label_aware = false;
    const Mapping mapping = map_end_effectors(figure.graph, mask_of(figure), reference, {}, options);
    const std::size_t n = mapping.ends.size(), m = mapping.reference_ends.size();
    REQUIRE(mapping.paths.size() == n);
    REQUIRE(mapping.comparisons.size() == n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < m; ++j) {
            const EndComparison& c = mapping.comparisons[i][j];
            REQUIRE(c.osb.cost == mapping.costs[i][j]);
            REQUIRE(c.distances.size() == n - 1);
            for (std::size_t k = 0; k + 1 < n; ++k)
                for (std::size_t l = 0; l + 1 < m; ++l)
                    REQUIRE(c.distances[k][l] ==
                            path_distance(mapping.paths[i][k], mapping.reference_paths[j][l], options.alpha));
        }
}

TEST_CASE("each reference maps onto itself, mirrored or not, with and without labels") {
    for (const ReferenceSkeleton& reference : load_references())
        for (const bool mirrored : {false, true}) {
            const Figure figure = draw_reference(reference, mirrored);
            Candidate match;
            match.mirrored = mirrored;
            for (const bool aware : {true, false}) {
                MappingOptions options;
                options.label_aware = aware;
                const Mapping mapping =
                    map_end_effectors(figure.graph, mask_of(figure), reference, match, options);
                REQUIRE(mapping.pairs.size() == mapping.ends.size());
                CHECK(mapping.ends == mapping.reference_ends);
                if (aware)
                    for (const EndPair& p : mapping.pairs) CHECK(p.end == p.reference_end);
                else // equal limbs may be exchanged, but nothing costs more than itself
                    for (const EndPair& p : mapping.pairs) CHECK(p.cost <= 1e-9);
            }
        }
}

TEST_CASE("the ends are ordered clockwise, starting on the left") {
    const ReferenceSkeleton humanoid = load_references()[0];
    const Figure figure = draw_reference(humanoid, false);
    const Mapping mapping = map_end_effectors(figure.graph, mask_of(figure), humanoid, {});
    std::vector<std::string> names;
    for (const int e : mapping.ends) names.push_back(humanoid.nodes[e].name);
    CHECK(names == std::vector<std::string>{"hand_left", "head", "hand_right", "foot_right", "foot_left"});
}

TEST_CASE("hands go to hands, feet to feet, left to left") {
    const auto at = map_figure(figures::paint(200, 250, figures::humanoid()), "humanoid").places;
    REQUIRE(at.size() == 5);
    CHECK(at.at("head").y < 80);
    CHECK(at.at("hand_left").x < 60);
    CHECK(at.at("hand_right").x > 140);
    CHECK(at.at("foot_left").x < 90);
    CHECK(at.at("foot_right").x > 110);
}

TEST_CASE("front legs go to front legs and the tail to the tail, whichever way the animal faces") {
    const LabelMap left = figures::paint(250, 200, figures::quadruped());
    const auto a = map_figure(left, "quadruped").places,
               b = map_figure(figures::mirrored(left), "quadruped").places;
    REQUIRE(a.size() == 6);
    REQUIRE(b.size() == 6);
    CHECK(a.at("leg_front_left").x < a.at("leg_front_right").x);
    CHECK(a.at("leg_front_right").x < a.at("leg_hind_left").x);
    CHECK(a.at("leg_hind_left").x < a.at("leg_hind_right").x);
    CHECK(a.at("tail").x > 200);
    for (const auto& [name, place] : a) {
        CHECK(b.at(name).x == Approx(249 - place.x).margin(4));
        CHECK(b.at(name).y == Approx(place.y).margin(4));
    }
}

TEST_CASE("wings go to wings, and the feet of a flyer to its feet") {
    const auto at = map_figure(figures::paint(240, 230, figures::flyer()), "flying").places;
    REQUIRE(at.size() == 6);
    CHECK(at.at("wing_left").x < 60);
    CHECK(at.at("wing_right").x > 180);
    CHECK(at.at("foot_left").x < at.at("foot_right").x);
    CHECK(at.at("tail").y > 190);
}

TEST_CASE("a missing leg leaves its reference free and the others in order") {
    std::vector<figures::Stroke> strokes = figures::quadruped();
    strokes.erase(strokes.begin()); // the outer front leg
    const Mapped mapped = map_figure(figures::paint(250, 200, strokes), "quadruped");
    REQUIRE(mapped.places.size() == 5);
    CHECK(mapped.mapping.unmatched_ends.empty());
    CHECK((mapped.places.count("leg_front_left") + mapped.places.count("leg_front_right")) == 1);
    CHECK(mapped.places.at("leg_hind_left").x < mapped.places.at("leg_hind_right").x);
}

TEST_CASE("a tail that the reference lacks stays unmatched and is listed") {
    std::vector<figures::Stroke> strokes = figures::humanoid();
    strokes.insert(strokes.begin(), {Label::tail, {110, 140}, {180, 175}, 5});
    const Mapped mapped = map_figure(figures::paint(200, 250, strokes), "humanoid");
    CHECK(mapped.places.size() == 5);
    REQUIRE(mapped.mapping.unmatched_ends.size() == 1);
    CHECK(mapped.skeleton.graph.vertices[mapped.mapping.unmatched_ends[0]].label == Label::tail);
}

TEST_CASE("a fifth leg-like end in the place of the tail is taken for the tail") {
    std::vector<figures::Stroke> strokes = figures::quadruped();
    for (figures::Stroke& s : strokes)
        if (s.label == Label::tail) s.label = Label::limb;
    const LabelMap labels = figures::paint(250, 200, strokes);
    const Skeletonization skeleton = skeletonize(labels);
    const ReferenceSkeleton quadruped = load_references()[1];
    const Mapping mapping = map_end_effectors(skeleton.graph, labels, quadruped, {});
    for (const EndPair& p : mapping.pairs)
        if (quadruped.nodes[p.reference_end].name == "tail") {
            CHECK(skeleton.graph.vertices[p.end].x > 200);
            return;
        }
    FAIL("nothing was mapped to the tail");
}

TEST_CASE("equal path samples are at distance zero and lengths count as the constant says") {
    const PathSamples a{{1, 2, 3}, 10}, b{{1, 2, 5}, 30};
    CHECK(path_distance(a, a, 0.1) == 0);
    CHECK(path_distance(a, b, 0) == Approx(4.0 / 8));
    CHECK(path_distance(a, b, 0.1) == Approx(0.5 + 0.1 * 400.0 / 40));
    CHECK(path_distance(a, b, 0.1) == path_distance(b, a, 0.1));
    CHECK(path_distance({{0}, 0}, {{0}, 0}, 1) == 0); // no division by zero
}

TEST_CASE("samples lie at equal arc length along the pixels and read the radius there") {
    Mask bar(41, 11);
    for (int y = 3; y < 8; ++y)
        for (int x = 3; x < 38; ++x) bar(x, y) = 1;
    SkeletonGraph graph;
    graph.width = 41;
    graph.height = 11;
    graph.vertices = {{5, 5, Label::limb, true}, {35, 5, Label::body, true}};
    SkeletonEdge edge{0, 1, 30, {}};
    for (int x = 5; x <= 35; ++x) edge.pixels.push_back({x, 5});
    graph.edges.push_back(edge);
    const Figure figure = make_figure(graph, bar);
    const auto path = shortest_path(figure.graph, 0, 1);
    REQUIRE(path.size() == 31);
    CHECK(path.front() == Point2d{5, 5});
    CHECK(path.back() == Point2d{35, 5});
    const PathSamples samples = sample_path(figure, path, 4, true);
    CHECK(samples.length == 30);
    REQUIRE(samples.radii.size() == 4);
    for (const double r : samples.radii) CHECK(r == Approx(3 / figure.mean_distance));
    CHECK(sample_path(figure, path, 4, false).length == Approx(30 / figure.mean_distance));
    const auto back = shortest_path(figure.graph, 1, 0);
    CHECK(std::equal(path.rbegin(), path.rend(), back.begin(), back.end()));
    CHECK(shortest_path(figure.graph, 0, 0).empty());
}

TEST_CASE("the shortest of two ways through the skeleton is taken") {
    SkeletonGraph graph;
    graph.vertices = {{0, 0}, {10, 0}, {5, 5}, {20, 0}};
    const auto add = [&graph](int u, int v, double length) { graph.edges.push_back({u, v, length, {}}); };
    add(0, 1, 10);
    add(0, 2, 4);
    add(1, 2, 4);
    add(1, 3, 10);
    const auto path = shortest_path(graph, 0, 3);
    CHECK(path == std::vector<Point2d>{{0, 0}, {5, 5}, {10, 0}, {20, 0}});
    graph.vertices.push_back({50, 50});
    CHECK(shortest_path(graph, 0, 4).empty());
}
