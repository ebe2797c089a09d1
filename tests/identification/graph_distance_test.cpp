// SPDX-License-Identifier: MIT
// The labelled geometric graph distance: hand-worked cases, enumeration, three solvers, invariances.
#include <catch2/catch.hpp>

#include <algorithm>
#include <optional>

#include "pantin/identification.hpp"

using namespace pantin;

namespace {

// A small linear congruential generator, so that the problems are the same everywhere.
struct Numbers {
    std::uint64_t state;
    double uniform() {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state >> 33) / 2147483648.0;
    }
    int below(int n) { return std::min(n - 1, static_cast<int>(uniform() * n)); }
};

LabelledGraph random_graph(Numbers& numbers, int vertices, double edge_share) {
    LabelledGraph graph;
    for (int i = 0; i < vertices; ++i) {
        graph.positions.push_back({numbers.uniform(), numbers.uniform()});
        graph.labels.push_back(static_cast<Label>(1 + numbers.below(5)));
    }
    for (int i = 0; i < vertices; ++i)
        for (int j = i + 1; j < vertices; ++j)
            if (numbers.uniform() < edge_share) graph.edges.emplace_back(i, j);
    return graph;
}

GgdOptions random_options(Numbers& numbers) {
    GgdOptions options;
    options.k_v = 0.2 + numbers.uniform();
    options.k_e = 0.2 + numbers.uniform();
    options.k_l = numbers.below(2) ? 5 : 0.05 * numbers.uniform();
    return options;
}

// Every partial matching, and the canonical one among those within 1e-9 of the smallest cost.
class Enumeration {
public:
    Enumeration(const LabelledGraph& a, const LabelledGraph& b, const GgdOptions& options)
        : a_(a), b_(b), options_(options), used_(b.positions.size()) {
        descend(0);
        for (const auto& [cost, pairs] : all_)
            if (cost <= best_ + 1e-9 && (!canonical_ || pairs < *canonical_)) canonical_ = pairs;
    }
    double cost() const { return best_; }
    const std::vector<std::pair<int, int>>& pairs() const { return *canonical_; }

private:
    void descend(int u) {
        if (u == std::ssize(a_.positions)) {
            const double cost = matching_cost(a_, b_, pairs_, options_);
            best_ = std::min(best_, cost);
            all_.emplace_back(cost, pairs_);
            return;
        }
        descend(u + 1);
        for (int v = 0; v < std::ssize(b_.positions); ++v) {
            if (used_[v]) continue;
            used_[v] = true;
            pairs_.emplace_back(u, v);
            descend(u + 1);
            pairs_.pop_back();
            used_[v] = false;
        }
    }
    const LabelledGraph& a_;
    const LabelledGraph& b_;
    GgdOptions options_;
    std::vector<bool> used_;
    std::vector<std::pair<int, int>> pairs_;
    std::vector<std::pair<double, std::vector<std::pair<int, int>>>> all_;
    double best_ = 1e300;
    std::optional<std::vector<std::pair<int, int>>> canonical_;
};

LabelledGraph segment(Point2d p, Point2d q, Label l, Label m) { return {{p, q}, {l, m}, {{0, 1}}}; }

} // namespace

TEST_CASE("the distance of two single edges is what the definition gives by hand") {
    const auto a = segment({0, 0}, {1, 0}, Label::body, Label::limb);
    // Moved by 0.1 and longer by 0.5: K_v (0.1 + 0.6) + K_e 0.5.
    const auto b = segment({0.1, 0}, {1.6, 0}, Label::body, Label::limb);
    const GgdResult result = geometric_graph_distance(a, b);
    CHECK(result.distance == Approx(0.7 + 0.5).epsilon(1e-12));
    CHECK(result.base == Approx(2.5));
    CHECK(result.pairs == std::vector<std::pair<int, int>>{{0, 0}, {1, 1}});
    // With other labels a match costs K_l · 5 and more than it saves: delete one edge, insert the other.
    const auto c = segment({0.1, 0}, {1.6, 0}, Label::limb, Label::wing);
    CHECK(geometric_graph_distance(a, c).distance == Approx(2.5));
    CHECK(geometric_graph_distance(a, c).pairs.empty());
}

TEST_CASE("branch and bound finds the canonical optimum of an enumeration of all matchings") {
    Numbers numbers{1};
    for (int round = 0; round < 120; ++round) {
        const auto a = random_graph(numbers, numbers.below(6), 0.5),
                   b = random_graph(numbers, numbers.below(6), 0.5);
        const GgdOptions options = random_options(numbers);
        const Enumeration expected(a, b, options);
        const GgdResult result = geometric_graph_distance(a, b, options);
        REQUIRE(result.optimal);
        REQUIRE(result.distance == Approx(expected.cost()).margin(1e-9));
        REQUIRE(result.pairs == expected.pairs());
    }
}

TEST_CASE("the terms of a matching add up to its cost") {
    Numbers numbers{11};
    for (int round = 0; round < 60; ++round) {
        const auto a = random_graph(numbers, 1 + numbers.below(6), 0.5),
                   b = random_graph(numbers, 1 + numbers.below(6), 0.5);
        GgdOptions options = random_options(numbers);
        options.k_l = 0.1; // so that labels mix
        const auto pairs = geometric_graph_distance(a, b, options).pairs;
        const GgdTerms t = matching_terms(a, b, pairs, options);
        REQUIRE(t.places + t.labels + t.lengths + t.edges_a + t.edges_b ==
                Approx(matching_cost(a, b, pairs, options)).margin(1e-9));
        REQUIRE(std::min({t.places, t.labels, t.lengths, t.edges_a, t.edges_b}) >= -1e-12);
    }
    const auto a = segment({0, 0}, {1, 0}, Label::body, Label::limb),
               b = segment({0.1, 0}, {1.6, 0}, Label::body, Label::wing);
    const GgdTerms t = matching_terms(a, b, {{0, 0}, {1, 1}});
    CHECK(t.places == Approx(0.7));
    CHECK(t.labels == Approx(15));
    CHECK(t.lengths == Approx(0.5));
    CHECK(matching_terms(a, b, {{0, 0}}).edges_b == Approx(1.5));
}

TEST_CASE("ties are broken by the lexicographically smallest matching") {
    // Two equal limbs on either side, and points on a lattice, where many matchings cost the same.
    Numbers numbers{7};
    for (int round = 0; round < 60; ++round) {
        auto a = random_graph(numbers, 4, 0.5), b = random_graph(numbers, 5, 0.5);
        for (LabelledGraph* graph : {&a, &b}) {
            for (Point2d& p : graph->positions) p = {numbers.below(2) * 1.0, numbers.below(2) * 1.0};
            for (Label& label : graph->labels) label = Label::limb;
        }
        const Enumeration expected(a, b, {});
        const GgdResult result = geometric_graph_distance(a, b);
        REQUIRE(result.distance == Approx(expected.cost()).margin(1e-9));
        REQUIRE(result.pairs == expected.pairs());
    }
}

TEST_CASE("the literal program, the tightened program and branch and bound agree", "[needs-glpk]") {
    Numbers numbers{2};
    for (int round = 0; round < 25; ++round) {
        const auto a = random_graph(numbers, 3 + numbers.below(3), 0.4),
                   b = random_graph(numbers, 3 + numbers.below(3), 0.4);
        const GgdOptions options = random_options(numbers);
        const double expected = geometric_graph_distance(a, b, options).distance;
        REQUIRE(geometric_graph_distance_ilp(a, b, options, IlpFormulation::literal).distance ==
                Approx(expected).margin(1e-9));
        REQUIRE(geometric_graph_distance_ilp(a, b, options, IlpFormulation::tightened).distance ==
                Approx(expected).margin(1e-9));
    }
    const auto references = load_references();
    for (const auto& a : references)
        for (const auto& b : references) {
            const LabelledGraph x = to_labelled_graph(a), y = to_labelled_graph(b);
            const double expected = geometric_graph_distance(x, y).distance;
            CHECK(geometric_graph_distance_ilp(x, y, {}, IlpFormulation::tightened).distance ==
                  Approx(expected).margin(1e-9));
        }
}

TEST_CASE("GLPK stops within the gap, or after so many subproblems with what it has", "[needs-glpk]") {
    Numbers numbers{21};
    int stopped = 0, improved = 0;
    for (int round = 0; round < 12; ++round) {
        const auto a = random_graph(numbers, 8, 0.3), b = random_graph(numbers, 6, 0.4);
        GgdOptions options;
        options.k_l = 0.05; // so that the relaxation is far from an integer solution
        const double best = geometric_graph_distance(a, b, options).distance;
        for (const IlpFormulation formulation : {IlpFormulation::literal, IlpFormulation::tightened}) {
            const GgdResult near = geometric_graph_distance_ilp(a, b, options, formulation, {0.05, 0});
            REQUIRE(near.optimal);
            REQUIRE(near.distance >= best - 1e-9);
            // The gap is relative to what the program minimises: the distance without the constant edges.
            REQUIRE(near.distance - best <= 0.05 * (near.base - near.distance) + 1e-9);
        }
        const GgdResult cut = geometric_graph_distance_ilp(a, b, options, IlpFormulation::literal, {0, 1});
        REQUIRE(cut.distance == Approx(matching_cost(a, b, cut.pairs, options)));
        REQUIRE(cut.distance >= best - 1e-9);
        stopped += !cut.optimal;
        const GgdResult later = geometric_graph_distance_ilp(a, b, options, IlpFormulation::literal, {0, 0});
        REQUIRE(later.optimal);
        REQUIRE(later.distance == Approx(best).margin(1e-9));
        improved += later.distance < cut.distance - 1e-9;
    }
    CHECK(stopped >= 10);
    CHECK(improved >= 1);
}

TEST_CASE("GLPK proves the optimum of graphs with more than 40 vertices", "[needs-glpk]") {
    Numbers numbers{5};
    const LabelledGraph large = random_graph(numbers, 45, 0.03),
                        model = to_labelled_graph(load_references()[0]);
    const GgdResult search = geometric_graph_distance(large, model);
    CHECK_FALSE(search.optimal);
    for (const IlpFormulation formulation : {IlpFormulation::literal, IlpFormulation::tightened}) {
        const GgdResult found = geometric_graph_distance_ilp(large, model, {}, formulation);
        CHECK(found.optimal);
        CHECK(found.distance <= search.distance + 1e-9);
    }
}

TEST_CASE("the distance is symmetric, zero on itself, and blind to the order of vertices") {
    Numbers numbers{3};
    for (int round = 0; round < 40; ++round) {
        const auto a = random_graph(numbers, 7, 0.3), b = random_graph(numbers, 4 + numbers.below(4), 0.3);
        const double distance = geometric_graph_distance(a, b).distance;
        REQUIRE(geometric_graph_distance(b, a).distance == Approx(distance).margin(1e-9));
        REQUIRE(geometric_graph_distance(a, a).distance == Approx(0).margin(1e-9));
        LabelledGraph reversed = a;
        std::reverse(reversed.positions.begin(), reversed.positions.end());
        std::reverse(reversed.labels.begin(), reversed.labels.end());
        for (auto& [u, v] : reversed.edges) std::tie(u, v) = std::pair{6 - v, 6 - u};
        REQUIRE(geometric_graph_distance(reversed, b).distance == Approx(distance).margin(1e-9));
        REQUIRE(geometric_graph_distance(mirrored(a), mirrored(b)).distance == Approx(distance).margin(1e-9));
    }
}

TEST_CASE("normalised graphs do not depend on position, size or aspect of the drawing") {
    Numbers numbers{4};
    const auto a = random_graph(numbers, 6, 0.4);
    LabelledGraph moved = a;
    for (Point2d& p : moved.positions) p = {20 + 300 * p.x, 7 + 150 * p.y};
    const LabelledGraph x = normalised(a), y = normalised(moved);
    double low = 1, high = 0;
    for (std::size_t i = 0; i < x.positions.size(); ++i) {
        CHECK(x.positions[i].x == Approx(y.positions[i].x));
        CHECK(x.positions[i].y == Approx(y.positions[i].y));
        low = std::min(low, x.positions[i].y);
        high = std::max(high, x.positions[i].y);
    }
    CHECK(low == 0);
    CHECK(high == 1);
    // One column of vertices has no width: it stands in the middle.
    const auto column = normalised(segment({5, 1}, {5, 9}, Label::head, Label::body));
    CHECK(column.positions[0] == Point2d{0.5, 0});
}

TEST_CASE("a matching that is no matching is refused") {
    const auto a = segment({0, 0}, {1, 0}, Label::body, Label::limb);
    CHECK_THROWS(matching_cost(a, a, {{0, 0}, {0, 1}}));
    CHECK_THROWS(matching_cost(a, a, {{0, 1}, {1, 1}}));
    CHECK_THROWS(matching_cost(a, a, {{2, 0}}));
    CHECK(matching_cost(a, a, {}) == Approx(2));
}

TEST_CASE(
    "beyond the node limit and beyond 40 vertices the best matching found is returned, not called optimal") {
    Numbers numbers{5};
    const auto a = random_graph(numbers, 14, 0.3), b = random_graph(numbers, 10, 0.3);
    GgdOptions options;
    options.k_l = 0.01;
    options.max_nodes = 200;
    const GgdResult limited = geometric_graph_distance(a, b, options);
    CHECK_FALSE(limited.optimal);
    CHECK(limited.distance < limited.base);
    CHECK(limited.distance == Approx(matching_cost(a, b, limited.pairs, options)));

    const auto large = random_graph(numbers, 41, 0.05);
    const GgdResult result = geometric_graph_distance(large, to_labelled_graph(load_references()[0]));
    CHECK_FALSE(result.optimal);
    CHECK(result.distance < result.base);
}

TEST_CASE("each reference is nearest to itself, and its mirror image to its mirrored self") {
    const auto references = load_references();
    for (const auto& a : references)
        for (const auto& b : references) {
            const double distance =
                geometric_graph_distance(mirrored(to_labelled_graph(a)), mirrored(to_labelled_graph(b)))
                    .distance;
            if (a.name == b.name)
                CHECK(distance == Approx(0).margin(1e-12));
            else
                CHECK(distance > 1);
        }
}
