// SPDX-License-Identifier: MIT
// The step: whole figures, what is rejected, what the evidence does, what the presets do.
#include <catch2/catch.hpp>

#include <cmath>
#include <set>
#include <tuple>

#include "core/random.hpp"
#include "figures.hpp"
#include "identification/evidence.hpp"
#include "pantin/error.hpp"

using namespace pantin;
using figures::paint;

namespace {

Identification identify_map(const LabelMap& labels, const IdentificationOptions& options = {}) {
    return identify(skeletonize(labels).graph, labels, load_references(), options);
}

std::string rejection(const LabelMap& labels) {
    try {
        identify_map(labels);
    } catch (const CharacterRejected& rejected) {
        return rejected.step() + ": " + rejected.what();
    }
    return "";
}

const Candidate& candidate(const Identification& found, const std::string& reference) {
    for (const Candidate& c : found.candidates)
        if (c.reference == reference) return c;
    FAIL("no candidate " << reference);
    throw 0;
}

// The same figure with every point moved a little and every radius changed a little.
std::vector<figures::Stroke> shaken(std::vector<figures::Stroke> strokes, Random& random) {
    for (figures::Stroke& s : strokes) {
        for (Point2d* p : {&s.from, &s.to}) *p = *p + Point2d{random.uniform(-5, 5), random.uniform(-5, 5)};
        s.radius *= random.uniform(0.85, 1.2);
    }
    return strokes;
}

} // namespace

TEST_CASE("plain figures are recognised, whichever way they face") {
    Random random(3);
    for (int round = 0; round < 4; ++round) {
        const LabelMap human = paint(200, 250, shaken(figures::humanoid(), random));
        const LabelMap animal = paint(250, 200, shaken(figures::quadruped(), random));
        const LabelMap bird = paint(240, 230, shaken(figures::flyer(), random));
        for (const auto& [name, map] :
             {std::pair{"humanoid", human}, {"quadruped", animal}, {"flying", bird}})
            for (const LabelMap& labels : {map, figures::mirrored(map)}) {
                const Identification found = identify_map(labels);
                CHECK(found.reference == name);
                CHECK(found.confidence > 0.5);
                CHECK(found.confidence <= 1);
            }
    }
}

TEST_CASE("a figure that faces the other way is found mirrored, with the same score") {
    const LabelMap left = paint(250, 200, figures::quadruped());
    const Identification a = identify_map(left), b = identify_map(figures::mirrored(left));
    CHECK_FALSE(a.candidates[0].mirrored);
    CHECK(b.candidates[0].mirrored);
    CHECK(b.candidates[0].distance ==
          Approx(a.candidates[0].distance).margin(0.25)); // thinning has a bias of a pixel
}

TEST_CASE("size does not change what a figure is") {
    std::vector<figures::Stroke> large = figures::quadruped();
    for (figures::Stroke& s : large) s = {s.label, 2 * s.from, 2 * s.to, 2 * s.radius};
    CHECK(identify_map(paint(500, 400, large)).reference == "quadruped");
}

TEST_CASE("candidates are sorted, complete and account for their score") {
    const Identification found = identify_map(paint(200, 250, figures::humanoid()));
    REQUIRE(found.candidates.size() >= 3);
    CHECK(found.reference == found.candidates[0].reference);
    double sum = 0;
    for (const Candidate& c : found.candidates) {
        CHECK(c.optimal);
        CHECK(c.score >= found.candidates[0].score);
        const bool special = !c.evidence.empty() && c.evidence.back().first == "special";
        REQUIRE(c.evidence.size() == (special ? 3u : 2u) + trait_count);
        CHECK(c.evidence[0].first == "graph");
        double score = 0;
        for (const auto& [name, contribution] : c.evidence) score += contribution;
        CHECK(score == Approx(c.score));
        if (!special) sum += std::exp(found.candidates[0].score - c.score);
    }
    CHECK(found.confidence == Approx(1 / sum));
}

TEST_CASE("what the type head has seen is a part of the evidence, and can be overruled") {
    const LabelMap labels = paint(250, 200, figures::quadruped());
    const SkeletonGraph graph = skeletonize(labels).graph;
    const auto with = [&](const std::array<double, 4>& seen, const IdentificationOptions& options = {}) {
        return identify(graph, labels, load_references(), options, TypeProbabilities(seen));
    };
    const Identification sure = with({0.01, 0.98, 0.01, 0}), doubtful = with({0.3, 0.4, 0.3, 0});
    CHECK(sure.type == "quadruped");
    CHECK(sure.confidence > doubtful.confidence);
    CHECK(sure.candidates[0].evidence.back().first == "seen");
    double sum = 0;
    for (const auto& [name, contribution] : sure.candidates[0].evidence) sum += contribution;
    CHECK(sum == Approx(sure.candidates[0].score));
    CHECK(with({0.3, 0.33, 0.37, 0}).type == "quadruped"); // the parts overrule a weak opinion …
    // … and what is none of the types has little confidence, whatever it is nearest to.
    CHECK(with({0.003, 0.294, 0.003, 0.7}).confidence < 0.31);
    IdentificationOptions thesis;
    thesis.thesis_score = true;
    CHECK(with({0.98, 0.01, 0.01, 0}, thesis).candidates[0].score ==
          identify(graph, labels, load_references(), thesis).candidates[0].score);
}

TEST_CASE("what cannot move is rejected with a reason") {
    using figures::Stroke;
    const Stroke head{Label::head, {60, 60}, {60, 90}, 30};
    CHECK_FALSE(rejection(paint(120, 150, {head})).empty()); // by whichever step sees it first
    // No head at an end of the body, nothing to nod.
    const std::vector<Stroke> cross = {{Label::body, {130, 30}, {130, 230}, 10},
                                       {Label::body, {30, 110}, {230, 110}, 10},
                                       {Label::head, {130, 110}, {130, 112}, 11}};
    CHECK(rejection(paint(260, 260, cross)) ==
          "identify: no limb, wing or tail, and no head on a body: nothing can move");
    IdentificationOptions all;
    all.reject_unmovable = false; // then it is like one of the references, as anything with an edge
    CHECK(identify_map(paint(260, 260, cross), all).candidates.size() >= 3);
    std::vector<Stroke> star = {{Label::body, {200, 200}, {200, 200}, 30}};
    for (int k = 0; k < 32; ++k) {
        const double angle = 2 * 3.14159265 * k / 32;
        star.push_back(
            {Label::limb, {200, 200}, {200 + 190 * std::cos(angle), 200 + 190 * std::sin(angle)}, 4});
    }
    CHECK(rejection(paint(400, 400, star)).find("scribble") != std::string::npos);
    all.ggd.max_nodes = 1000; // 32 legs are many for the search
    CHECK(identify_map(paint(400, 400, star), all).candidates.size() >= 3);
}

TEST_CASE("a graph without edges is a blob") {
    SkeletonGraph graph;
    graph.vertices.push_back({5, 5, Label::body, false});
    CHECK_THROWS_WITH(identify(graph, LabelMap(10, 10, 2), load_references()),
                      Catch::Matchers::Contains("a blob"));
    graph.vertices = {{2, 5, Label::head, true}, {8, 5, Label::head, true}};
    graph.edges = {{0, 1, 6, {}}};
    CHECK_THROWS_WITH(identify(graph, LabelMap(10, 10, 1), load_references()), "one part only: head");
    IdentificationOptions all;
    all.reject_unmovable = false;
    CHECK(identify(graph, LabelMap(10, 10, 1), load_references(), all).candidates.size() >= 3);
    graph.edges.clear();
    // Without an edge nothing is matched: the reference with the shortest edges is nearest.
    const Identification found = identify(graph, LabelMap(10, 10, 1), load_references(), all);
    CHECK(found.candidates.size() >= 3);
    CHECK_THROWS_AS(identify(graph, LabelMap(10, 10, 2), {}), Error);
}

TEST_CASE("more wing speaks for flying, a lower head against a human, two raised limbs for one") {
    Traits traits{};
    const auto score = [&traits](const std::string& type) {
        double sum = 0;
        for (const auto& [name, contribution] : evidence_terms(type, 1, traits, {})) sum += contribution;
        return sum;
    };
    const auto advantage = [&](Trait trait, double value, const std::string& type, const std::string& other) {
        const double before = score(other) - score(type);
        traits[static_cast<int>(trait)] = value;
        const double after = score(other) - score(type);
        traits[static_cast<int>(trait)] = 0;
        return after - before;
    };
    CHECK(advantage(Trait::wing_share, 0.5, "flying", "quadruped") > 0);
    CHECK(advantage(Trait::wing_share, 0.5, "flying", "humanoid") > 0);
    CHECK(advantage(Trait::wing_presence, 1, "flying", "quadruped") > 0);
    CHECK(advantage(Trait::head_above, 1, "humanoid", "quadruped") > 0);
    CHECK(advantage(Trait::upright, 0.5, "humanoid", "quadruped") > 0);
    CHECK(advantage(Trait::high_limb_pieces, 1, "humanoid", "flying") > 0);
    CHECK(advantage(Trait::low_limb_pieces, 1, "quadruped", "humanoid") > 0);
    CHECK(score("quadruped") < [&] { // a smaller distance is better for every type
        double sum = 0;
        for (const auto& [name, contribution] : evidence_terms("quadruped", 1.5, traits, {}))
            sum += contribution;
        return sum;
    }());
}

TEST_CASE("the thesis scores with the distance alone, K_v = 0.38 for the quadruped, and never mirrors") {
    IdentificationOptions thesis;
    thesis.thesis_score = true;
    thesis.k_n_replaces = KnReading::k_v;
    thesis.mirrored = Mirroring::none;
    const LabelMap labels = figures::mirrored(paint(250, 200, figures::quadruped()));
    const SkeletonGraph graph = skeletonize(labels).graph;
    const Identification found = identify(graph, labels, load_references(), thesis);
    CHECK(found.candidates.size() == 3);
    for (const ReferenceSkeleton& reference : load_references()) {
        if (!reference.like.empty()) continue;
        const Candidate& c = candidate(found, reference.name);
        GgdOptions ggd;
        if (reference.name == "quadruped") ggd.k_v = 0.38;
        const GgdResult expected = geometric_graph_distance(normalised(to_labelled_graph(graph)),
                                                            normalised(to_labelled_graph(reference)), ggd);
        CHECK(c.distance == expected.distance);
        CHECK(c.score == c.distance);
        CHECK_FALSE(c.mirrored);
        CHECK(c.evidence.empty());
    }
}

TEST_CASE("K_n takes the place of the constants that its reading names, for quadrupeds alone") {
    const LabelMap labels = paint(250, 200, figures::quadruped());
    const SkeletonGraph graph = skeletonize(labels).graph;
    const LabelledGraph drawn = normalised(to_labelled_graph(graph));
    std::vector<ReferenceSkeleton> references = load_references();
    references.push_back(references[1]); // one of one's own, which is nearest to the quadruped
    references.back().name = "fox";
    IdentificationOptions options;
    options.thesis_score = true;
    options.mirrored = Mirroring::none;
    options.k_n = 0.2;
    std::set<double> distances;
    for (const auto& [reading, k_v, k_e, k_l] :
         std::vector<std::tuple<KnReading, double, double, double>>{{KnReading::none, 1, 1, 5},
                                                                    {KnReading::k_v, 0.2, 1, 5},
                                                                    {KnReading::k_e, 1, 0.2, 5},
                                                                    {KnReading::k_l, 1, 1, 0.2},
                                                                    {KnReading::all, 0.2, 0.2, 0.2}}) {
        options.k_n_replaces = reading;
        const Identification found = identify(graph, labels, references, options);
        for (const ReferenceSkeleton& reference : references) {
            if (!reference.like.empty()) continue;
            GgdOptions ggd;
            if (reference.name == "quadruped" || reference.name == "fox")
                ggd.k_v = k_v, ggd.k_e = k_e, ggd.k_l = k_l;
            const double expected =
                geometric_graph_distance(drawn, normalised(to_labelled_graph(reference)), ggd).distance;
            CHECK(candidate(found, reference.name).distance == expected);
        }
        distances.insert(candidate(found, "quadruped").distance);
    }
    CHECK(distances.size() >= 4); // K_l may change nothing (ERRATA 10)
}

TEST_CASE("a reference is tried left for right never, where its distance is smaller, or with the head") {
    const LabelMap labels = figures::mirrored(paint(250, 200, figures::quadruped()));
    const SkeletonGraph graph = skeletonize(labels).graph;
    const LabelledGraph drawn = normalised(to_labelled_graph(graph));
    const LabelledGraph model = normalised(to_labelled_graph(load_references()[1]));
    const double as_drawn = geometric_graph_distance(drawn, model).distance,
                 turned = geometric_graph_distance(drawn, mirrored(model)).distance;
    REQUIRE(turned < as_drawn);
    IdentificationOptions options;
    options.thesis_score = true;
    for (const Mirroring mirroring : {Mirroring::none, Mirroring::distance, Mirroring::head}) {
        options.mirrored = mirroring;
        const Identification found = identify(graph, labels, load_references(), options);
        const Candidate& c = candidate(found, "quadruped");
        CHECK(c.mirrored == (mirroring != Mirroring::none));
        CHECK(c.distance == (mirroring == Mirroring::none ? as_drawn : turned));
    }
}

TEST_CASE("all solvers find the same distances, and what is cut off says so", "[needs-glpk]") {
    const LabelMap labels = paint(250, 200, figures::quadruped());
    const SkeletonGraph graph = skeletonize(labels).graph;
    IdentificationOptions options;
    options.thesis_score = true;
    const Identification expected = identify(graph, labels, load_references(), options);
    for (const GgdSolver solver : {GgdSolver::literal, GgdSolver::tightened}) {
        options.solver = solver;
        const Identification found = identify(graph, labels, load_references(), options);
        for (const Candidate& c : found.candidates) {
            CHECK(c.optimal);
            CHECK(c.distance == Approx(candidate(expected, c.reference).distance).epsilon(1e-3));
        }
        CHECK(found.reference == expected.reference);
    }
    options.solver = GgdSolver::literal;
    options.ilp.iterations = 1;
    const Identification cut = identify(graph, labels, load_references(), options);
    CHECK(std::any_of(cut.candidates.begin(), cut.candidates.end(),
                      [](const Candidate& c) { return !c.optimal; }));
}

TEST_CASE("without evidence the score is the distance divided by the cost of the reference's edges") {
    IdentificationOptions plain;
    plain.use_evidence = false;
    const Identification found = identify_map(paint(250, 200, figures::quadruped()), plain);
    const Candidate& c = candidate(found, "quadruped");
    double edges = 0;
    const ReferenceSkeleton reference = load_references()[1];
    const LabelledGraph graph = normalised(to_labelled_graph(reference));
    for (const auto& [u, v] : graph.edges) edges += distance(graph.positions[u], graph.positions[v]);
    CHECK(c.score == Approx(c.distance / edges));
    CHECK(found.reference == "quadruped");
}

TEST_CASE("a reference of one's own shares the evidence of the nearest compiled-in one") {
    std::vector<ReferenceSkeleton> references = load_references();
    ReferenceSkeleton fox = references[1];
    fox.name = "fox";
    fox.nodes[0].y = 0.2;
    references.push_back(fox);
    const LabelMap labels = paint(250, 200, figures::quadruped());
    const Identification found = identify(skeletonize(labels).graph, labels, references);
    const Candidate &a = candidate(found, "fox"), &b = candidate(found, "quadruped");
    REQUIRE(a.evidence.size() == b.evidence.size());
    for (std::size_t i = 1; i < a.evidence.size(); ++i) CHECK(a.evidence[i] == b.evidence[i]);
    CHECK((found.reference == "fox" || found.reference == "quadruped"));
}

namespace {

// The quadruped with one more condition.
std::vector<ReferenceSkeleton> with_special(const ReferenceNeed& need,
                                            const std::string& like = "quadruped") {
    std::vector<ReferenceSkeleton> references = load_references();
    references.resize(3);
    ReferenceSkeleton special = references[1];
    special.name = "special";
    special.like = like;
    special.needs = {need};
    references.push_back(special);
    return references;
}

} // namespace

TEST_CASE("a special reference is chosen where its needs are met, and changes neither type nor confidence") {
    const LabelMap labels = paint(250, 200, figures::quadruped());
    const SkeletonGraph graph = skeletonize(labels).graph;
    const Identification plain = identify(graph, labels, with_special({"wing_ends", 1, 9}));
    CHECK(plain.reference == "quadruped");
    CHECK(plain.type == "quadruped");
    CHECK(plain.candidates.size() == 3);
    const Identification found = identify(graph, labels, with_special({"limb_ends", 4, 4}));
    CHECK(found.reference == "special");
    CHECK(found.type == "quadruped");
    CHECK(found.confidence == plain.confidence);
    CHECK(found.candidates.size() == 4);
    double sum = 0;
    for (const auto& [name, value] : found.candidates[0].evidence) sum += value;
    CHECK(sum == Approx(found.candidates[0].score));
    // Met, but like another type: no better than that one.
    CHECK(identify(graph, labels, with_special({"limb_ends", 4, 4}, "flying")).reference == "quadruped");
    CHECK(identify(graph, labels, with_special({"limb_ends", 4, 4}, "any")).type == "special");
    CHECK(identify(graph, labels, with_special({"limb_ends", 4, 4}, "dragon")).reference == "quadruped");
    IdentificationOptions thesis;
    thesis.use_evidence = false;
    CHECK(identify(graph, labels, with_special({"limb_ends", 4, 4}), thesis).reference == "quadruped");
}

TEST_CASE("a head on a body nods, with or without a speck of limb") {
    using figures::Stroke;
    const Stroke head{Label::head, {60, 60}, {60, 90}, 30}, body{Label::body, {60, 120}, {60, 190}, 25};
    for (const LabelMap& labels : {paint(120, 250, {body, head}),
                                   paint(120, 250, {body, head, {Label::limb, {60, 150}, {62, 150}, 3}})}) {
        const Identification found = identify_map(labels);
        CHECK(found.reference == "bust");
        CHECK(found.type == "bust");
    }
}

TEST_CASE("the user's reference decides, its needs met or not") {
    const LabelMap labels = paint(250, 200, figures::quadruped());
    const SkeletonGraph graph = skeletonize(labels).graph;
    IdentificationOptions options;
    for (const std::string name : {"flying", "bird", "fish", "quadruped"}) {
        options.reference = name;
        const Identification found = identify(graph, labels, load_references(), options);
        CHECK(found.reference == name);
        CHECK_FALSE(candidate(found, name).pairs.empty());
        CHECK(found.confidence > 0);
        CHECK(found.confidence <= 1);
    }
    options.reference = "dragon";
    CHECK_THROWS_WITH(identify(graph, labels, load_references(), options), "there is no reference 'dragon'");
}

TEST_CASE("parts are measured without specks, in any place") {
    LabelMap labels(100, 100);
    for (int y = 10; y < 30; ++y)
        for (int x = 20; x < 60; ++x) labels(x, y) = 2;
    for (int y = 30; y < 50; ++y)
        for (int x = 20; x < 24; ++x) labels(x, y) = labels(x + 36, y) = 3;
    labels(80, 80) = 3; // a speck
    const PartRegion limbs = part_region(labels, {Label::limb});
    CHECK(limbs.area == 160);
    REQUIRE(limbs.centres.size() == 2);
    CHECK(limbs.centres[0] == Point2d{21.5, 39.5});
    CHECK(limbs.centre.x == Approx(39.5));
    CHECK(limbs.x0 == 20);
    CHECK(limbs.x1 == 59);
    CHECK(limbs.y1 == 49);
    const Traits traits = measure_traits({}, labels);
    const auto value = [&traits](Trait t) { return traits[static_cast<int>(t)]; };
    CHECK(value(Trait::low_limb_pieces) == 0.5);
    CHECK(value(Trait::high_limb_pieces) == 0);
    CHECK(value(Trait::leg_spread) == 1);
    CHECK(value(Trait::leg_length) == 1); // reaches 20 below, head and body are 20 high
    CHECK(value(Trait::upright) == Approx(-20.0 / 60));
    CHECK(value(Trait::wing_share) == 0);
    CHECK(value(Trait::limb_share) == Approx(std::sqrt(160.0 / 961)));
}
