// SPDX-License-Identifier: MIT
// compare_reference REFERENCE DATA: compares every stage with stored reference results and prints a table.
#include "compare.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>

#include "pantin/image.hpp"

namespace pantin::compare {

Report::Row& Report::row_of(const std::string& stage) {
    auto row = std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) { return r.stage == stage; });
    if (row == rows_.end()) row = rows_.insert(rows_.end(), Row{stage, 0, 0, 0, "", "", 0, ""});
    return *row;
}

void Report::add(const std::string& stage, bool matched, double difference, const std::string& where) {
    Row& row = row_of(stage);
    ++row.of;
    row.matched += matched;
    if (!matched && row.first_miss.empty()) row.first_miss = where;
    if (std::abs(difference) > row.worst || std::isnan(difference)) {
        row.worst = std::abs(difference);
        row.worst_case = where;
    }
}

void Report::expect_misses(const std::string& stage, int misses, const std::string& reason) {
    Row& row = row_of(stage);
    row.expected = misses;
    row.reason = reason;
}

void Report::print_row(const Row& row) {
    std::printf("%-44s %4d/%4d  %.3g", row.stage.c_str(), row.matched, row.of, row.worst);
    if (!row.worst_case.empty()) std::printf(" (%s)", row.worst_case.c_str());
    if (!row.first_miss.empty()) std::printf(", first miss %s", row.first_miss.c_str());
    if (row.expected > 0) std::printf("; %d misses are known: %s", row.expected, row.reason.c_str());
    std::printf("\n");
}

bool Report::print() const {
    int stages = 0, explained = 0, comparisons = 0, matched = 0;
    std::printf("%-44s %9s  %s\n", "stage", "matched", "worst difference");
    for (const Row& row : rows_) {
        print_row(row);
        const bool as_expected = row.of > 0 && row.of - row.matched == row.expected;
        stages += as_expected && row.expected == 0;
        explained += as_expected && row.expected > 0;
        comparisons += row.of;
        matched += row.matched;
    }
    const int count = static_cast<int>(rows_.size());
    std::printf(
        "%d stages: %d equal everywhere, %d with known misses, %d differ; %d of %d comparisons equal\n",
        count, stages, explained, count - stages - explained, matched, comparisons);
    return stages + explained == count;
}

nlohmann::json read_json(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) throw Error(ErrorKind::input, file.string() + ": cannot be read");
    return nlohmann::json::parse(in);
}

ReferenceSkeleton load_reference(const std::filesystem::path& reference, const std::string& name) {
    const nlohmann::json json = read_json(reference / "references" / (name + ".json"));
    ReferenceSkeleton skeleton;
    skeleton.name = name;
    for (const auto& node : json.at("nodes"))
        skeleton.nodes.push_back({"", label_from_name(node.at("label").get<std::string>()), node.at("x"),
                                  node.at("y"), node.at("r")});
    for (const auto& edge : json.at("edges")) skeleton.edges.emplace_back(edge[0], edge[1]);
    return skeleton;
}

SkeletonGraph graph_from_json(const nlohmann::json& json, int width, int height) {
    SkeletonGraph graph;
    graph.width = width;
    graph.height = height;
    for (std::size_t i = 0; i < json.at("xy").size(); ++i) {
        const auto& xy = json["xy"][i];
        graph.vertices.push_back({xy[0], xy[1], static_cast<Label>(json.at("label")[i].get<int>()), false});
    }
    std::vector<int> degree(graph.vertices.size(), 0);
    for (const auto& e : json.at("edges")) {
        const int u = e[0], v = e[1];
        graph.edges.push_back({std::min(u, v), std::max(u, v), 0, {}});
        ++degree[u];
        ++degree[v];
    }
    for (std::size_t i = 0; i < degree.size(); ++i) graph.vertices[i].end = degree[i] == 1;
    return graph;
}

namespace {

Mask silhouette(const LabelMap& labels) {
    Mask mask(labels.width(), labels.height());
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) mask(x, y) = labels(x, y) != 0;
    return fill_holes(largest_component(close_square(mask, 2)));
}

template <class T> Grid<T> transposed(const Grid<T>& grid) {
    Grid<T> result(grid.height(), grid.width());
    for (int y = 0; y < grid.height(); ++y)
        for (int x = 0; x < grid.width(); ++x) result(y, x) = grid(x, y);
    return result;
}

// Every pixel with the label of the nearest labelled pixel of the mask. Of equally near ones the stored
// results take the leftmost, then the uppermost; `nearest_seed` the uppermost, then the leftmost: hence the
// transposition.
LabelMap nearest_labels(const LabelMap& labels, const Mask& mask) {
    const LabelMap columns = transposed(labels);
    Mask seeds = transposed(mask);
    for (std::size_t i = 0; i < seeds.size(); ++i) seeds.data()[i] = seeds.data()[i] && columns.data()[i];
    const Grid<int> nearest = nearest_seed(seeds);
    LabelMap near(columns.width(), columns.height());
    for (std::size_t i = 0; i < near.size(); ++i)
        if (nearest.data()[i] >= 0) near.data()[i] = columns.data()[nearest.data()[i]];
    return transposed(near);
}

} // namespace

std::vector<Figure> load_figures(const std::filesystem::path& reference, const std::filesystem::path& data) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(reference)) {
        const std::string name = entry.path().stem().string();
        if (entry.path().extension() == ".json" && (name.starts_with("synth") || name.starts_with("real_")))
            files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::vector<Figure> figures;
    for (const auto& file : files) {
        Figure figure;
        figure.name = file.stem().string();
        figure.stored = read_json(file);
        const bool real = figure.name.starts_with("real_");
        figure.labels = load_grey(real ? data / "label_maps" / (figure.name.substr(5) + ".png")
                                       : reference / (figure.name + ".png"));
        figure.mask = silhouette(figure.labels);
        figure.everywhere = nearest_labels(figure.labels, figure.mask);
        figure.near = figure.everywhere;
        for (std::size_t i = 0; i < figure.mask.size(); ++i)
            if (!figure.mask.data()[i]) figure.near.data()[i] = 0;
        figures.push_back(std::move(figure));
    }
    return figures;
}

} // namespace pantin::compare

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: compare_reference REFERENCE_DIR DATA_DIR\n");
        return 2;
    }
    try {
        using namespace pantin::compare;
        const std::filesystem::path reference = argv[1];
        const std::vector<Figure> figures = load_figures(reference, argv[2]);
        Report report;
        skeleton_stages(figures, report);
        identification_stages(reference, figures, report);
        mesh_stages(reference, figures, report);
        return report.print() ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "compare_reference: %s\n", error.what());
        return 1;
    }
}
