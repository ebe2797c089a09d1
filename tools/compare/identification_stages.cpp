// SPDX-License-Identifier: MIT
// Graph distances: the random problems with all three solvers, the figures' skeletons against the references.
#include <cmath>

#include "compare.hpp"
#include "mapping_stages.hpp"
#include "pantin/identification.hpp"
#include "settings.hpp"

namespace pantin::compare {
namespace {

constexpr double margin = 1e-9;

LabelledGraph labelled_graph(const nlohmann::json& json) {
    return to_labelled_graph(graph_from_json(json, 0, 0));
}

void compare_value(Report& report, const std::string& stage, double ours, double stored,
                   const std::string& where) {
    report.add(stage, std::abs(ours - stored) <= margin, ours - stored, where);
}

void random_problems(const std::filesystem::path& reference, Report& report) {
    int number = 0;
    for (const auto& problem : read_json(reference / "ggd_random.json")) {
        const std::string where = "problem " + std::to_string(number++);
        const LabelledGraph a = labelled_graph(problem["A"]), b = labelled_graph(problem["B"]);
        GgdOptions options = distance_settings("K115");
        options.k_v = problem["Kv"];
        options.k_e = problem["Ke"];
        options.k_l = problem["Kl"];
        const double stored = problem["ggd"];
        compare_value(report, "ggd random: branch and bound",
                      geometric_graph_distance(a, b, options).distance, stored, where);
        if (!ilp_available()) continue;
        for (const auto& [name, formulation] :
             {std::pair{"ggd random: literal program", IlpFormulation::literal},
              {"ggd random: tightened program", IlpFormulation::tightened}})
            compare_value(report, name, geometric_graph_distance_ilp(a, b, options, formulation).distance,
                          stored, where);
    }
}

void figure_distances(const Figure& figure, const std::vector<ReferenceSkeleton>& references,
                      Report& report) {
    for (const char* residual : {"arc", "chord"})
        for (const ReferenceSkeleton& reference : references) {
            const auto& stored = figure.stored.at("residual").at(residual);
            const LabelledGraph a = normalised(labelled_graph(stored["g2"])),
                                b = normalised(to_labelled_graph(reference));
            for (const auto& [key, value] : stored.at("ggd").at(reference.name).items()) {
                const std::string where = figure.name + " " + residual + " " + reference.name + " " + key;
                const GgdOptions options = distance_settings(key);
                const GgdResult result = geometric_graph_distance(a, b, options);
                compare_value(report, "ggd of figures", result.distance, value["ggd"], where);
                compare_value(report, "ggd of figures: empty matching", result.base, value["base"], where);
                if (key != "K1_1_0.1" && ilp_available()) // GLPK takes long where labels hardly matter
                    compare_value(
                        report, "ggd of figures: tightened program",
                        geometric_graph_distance_ilp(a, b, options, IlpFormulation::tightened).distance,
                        value["ggd"], where);
            }
        }
}

} // namespace

void identification_stages(const std::filesystem::path& reference, const std::vector<Figure>& figures,
                           Report& report) {
    random_problems(reference, report);
    std::vector<ReferenceSkeleton> references;
    for (const char* name : {"humanoid", "quadruped", "flying"})
        references.push_back(load_reference(reference, name));
    for (const Figure& figure : figures) figure_distances(figure, references, report);
    mapping_stages(reference, figures, report);
}

} // namespace pantin::compare
