// SPDX-License-Identifier: MIT
// Comparison with stored reference results, stage by stage: each stage is fed with the stored output of the
// stage before it, so that a pixel that differs upstream does not spread. What is stored, and how exactly it
// should be met, is in the README.md of the reference folder.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pantin/grid.hpp"
#include "pantin/reference.hpp"
#include "pantin/skeletonization.hpp"

namespace pantin::compare {

// The table that is printed: one row per stage, in the order in which the stages were first named.
class Report {
public:
    // One comparison. `difference` is 0 when equal, in the stage's own unit; `where` names the case.
    void add(const std::string& stage, bool matched, double difference, const std::string& where);
    // So many misses of a stage are known and have this reason; more are a failure, and so are fewer, so
    // that the number stays true.
    void expect_misses(const std::string& stage, int misses, const std::string& reason);
    // Prints `stage  matched/of  worst difference (case)`, then how many stages matched everywhere; true when
    // everything matched but for what is known.
    bool print() const;

private:
    struct Row {
        std::string stage;
        int matched = 0, of = 0;
        double worst = 0;
        std::string worst_case, first_miss;
        int expected = 0; // misses
        std::string reason;
    };
    Row& row_of(const std::string& stage);
    static void print_row(const Row& row);
    std::vector<Row> rows_;
};

// One figure with all its stored stages.
struct Figure {
    std::string name;      // synth0, real_cat_3900, …
    nlohmann::json stored; // the JSON file
    LabelMap labels;       // the label map as it lies on disk
    Mask mask;             // label > 0, closed with a 5×5 square, largest component, holes filled
    LabelMap near;         // every pixel of the mask with the nearest label, 0 elsewhere
    LabelMap everywhere; // every pixel of the image with the nearest label (what near_crc32_u8 is taken over)
};
// Reads synth*.json and real_*.json; the label maps of the latter lie in `data`/label_maps.
std::vector<Figure> load_figures(const std::filesystem::path& reference, const std::filesystem::path& data);

// {"xy": […], "label": […], "edges": […]} to a graph without pixel chains; `end` follows from the degrees.
SkeletonGraph graph_from_json(const nlohmann::json& json, int width, int height);
nlohmann::json read_json(const std::filesystem::path& file);
// The reference skeleton that the stored results were computed with: edges by index, nodes without names.
ReferenceSkeleton load_reference(const std::filesystem::path& reference, const std::string& name);

void skeleton_stages(const std::vector<Figure>& figures, Report& report);
// Figures' ggd values and bases, ggd_random.json.
void identification_stages(const std::filesystem::path& reference, const std::vector<Figure>& figures,
                           Report& report);
// Meshes, seeds, reach and σ of the weights.
void mesh_stages(const std::filesystem::path& reference, const std::vector<Figure>& figures, Report& report);

} // namespace pantin::compare
