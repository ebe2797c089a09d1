// SPDX-License-Identifier: MIT
// The geometric graph distance of a drawing-like graph (11 vertices) to the quadruped: the integer program as
// printed in the thesis, its tightened form, and the branch and bound.
#include "bench.hpp"
#include "core/random.hpp"
#include "pantin/identification.hpp"

namespace pantin::bench {

namespace {

// The quadruped with three vertices more, shaken.
LabelledGraph shaken(const LabelledGraph& model, Random& random) {
    LabelledGraph graph = model;
    for (const int parent : {1, 2, 4}) {
        graph.positions.push_back(model.positions[static_cast<std::size_t>(parent)]);
        graph.labels.push_back(Label::limb);
        graph.edges.emplace_back(parent, static_cast<int>(graph.positions.size()) - 1);
    }
    for (Point2d& p : graph.positions) p = p + Point2d{0.1 * random.normal(), 0.1 * random.normal()};
    return normalised(graph);
}

} // namespace

void bench_graph_distance(int rounds) {
    Random random(2);
    for (const ReferenceSkeleton& reference : load_references()) {
        if (reference.name != "quadruped") continue;
        const LabelledGraph model = normalised(to_labelled_graph(reference)), graph = shaken(model, random);
        std::vector<Contender> contenders;
        if (ilp_available()) {
            contenders.push_back({"integer program as printed (GLPK)", [&] {
                                      geometric_graph_distance_ilp(graph, model, {}, IlpFormulation::literal);
                                  }});
            contenders.push_back(
                {"integer program tightened (GLPK)",
                 [&] { geometric_graph_distance_ilp(graph, model, {}, IlpFormulation::tightened); }});
        }
        contenders.push_back({"branch and bound", [&] { geometric_graph_distance(graph, model); }});
        compare("geometric graph distance, 11 x 8 vertices", contenders, rounds);
    }
}

} // namespace pantin::bench
