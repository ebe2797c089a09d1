// SPDX-License-Identifier: MIT
// Meshes (marching squares with interpolated distance) and weights (Algorithm 4.4) against stored results.
#include <cmath>

#include "compare.hpp"
#include "image/label_map.hpp"
#include "pantin/rigging.hpp"
#include "rigging/mesh_topology.hpp"
#include "rigging/thesis_weights.hpp"
#include "settings.hpp"

namespace pantin::compare {
namespace {

double area_of(const Mesh& mesh) {
    double twice = 0;
    for (const std::vector<int>& face : mesh.faces)
        for (std::size_t i = 0; i < face.size(); ++i)
            twice += cross(mesh.vertices[face[i]], mesh.vertices[face[(i + 1) % face.size()]]);
    return twice / 2;
}

void compare_mesh(const Mesh& mesh, const nlohmann::json& stored, const std::string& where, Report& report) {
    std::vector<int> sizes(7, 0);
    Point2d sum{};
    for (const std::vector<int>& face : mesh.faces) ++sizes.at(face.size());
    for (const Point2d& p : mesh.vertices) sum = sum + p;
    const bool counts = static_cast<int>(mesh.vertices.size()) == stored.at("vertices") &&
                        static_cast<int>(mesh.faces.size()) == stored.at("faces") &&
                        static_cast<int>(edges_of(mesh).size()) == stored.at("edges") &&
                        sizes == stored.at("face_sizes").get<std::vector<int>>();
    report.add("mesh: vertices, edges, faces, face sizes", counts, 0, where);
    const double area = area_of(mesh) - stored.at("area").get<double>();
    report.add("mesh: area", std::abs(area) < 1e-6, area, where);
    const double x = sum.x - stored.at("sum_xy")[0].get<double>(),
                 y = sum.y - stored.at("sum_xy")[1].get<double>();
    report.add("mesh: sum of coordinates", std::abs(x) + std::abs(y) < 1e-6, std::abs(x) + std::abs(y),
               where);
}

void compare_weights(const Figure& figure, const Mesh& mesh, const ReferenceSkeleton& quadruped,
                     Report& report) {
    const nlohmann::json& stored = figure.stored.at("weights_cell8_quadruped");
    const nlohmann::json& effectors = figure.stored.at("effectors_vs_quadruped");
    const SkeletonGraph graph = graph_from_json(figure.stored.at("residual").at("chord").at("g2"),
                                                figure.labels.width(), figure.labels.height());
    std::vector<FloodInput> ends;
    for (int vertex : effectors.at("efA"))
        ends.push_back({{graph.vertices[vertex].x, graph.vertices[vertex].y}, graph.vertices[vertex].label});
    const std::vector<FloodResult> floods = flood_weights(mesh, nearest_labels(figure.labels), ends);
    bool seeds = true;
    int most = 0;
    for (std::size_t e = 0; e < floods.size(); ++e) {
        seeds &= floods[e].seed == stored.at("seeds")[e];
        most = std::max(
            most, std::abs(static_cast<int>(floods[e].reached.size()) - stored.at("reached")[e].get<int>()));
    }
    report.add("weights: seeds", seeds, 0, figure.name);
    // Outside the parts a vertex takes the nearest label; where two are equally near it is the distance
    // transform's choice, which may let a flood reach a few vertices more or less.
    report.add("weights: vertices reached (to 4)", most <= 4, most, figure.name);
    double worst = 0;
    const nlohmann::json& pairs = effectors.at("pairs");
    for (std::size_t k = 0; k < pairs.size(); ++k)
        worst = std::max(worst, std::abs(bone_ratio(graph, pairs[k][0], quadruped, pairs[k][1]) -
                                         stored.at("sigma")[k].get<double>()));
    report.add("weights: sigma", worst < 1e-12, worst, figure.name);
}

} // namespace

void mesh_stages(const std::filesystem::path& reference, const std::vector<Figure>& figures, Report& report) {
    const ReferenceSkeleton quadruped = load_reference(reference, "quadruped");
    for (const Figure& figure : figures)
        for (const int cell : {8, 16}) {
            const Mesh mesh = marching_squares(figure.mask, mesh_settings(cell));
            compare_mesh(mesh, figure.stored.at("mesh").at(std::to_string(cell)),
                         figure.name + " cell " + std::to_string(cell), report);
            if (cell == 8) compare_weights(figure, mesh, quadruped, report);
        }
}

} // namespace pantin::compare
