// SPDX-License-Identifier: MIT
// Which step succeeds on which drawing (thesis, tables 6.1 to 6.3).
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "core/file.hpp"
#include "figures/results.hpp"
#include "figures/svg.hpp"
#include "formats/identification_file.hpp"
#include "formats/skeleton_file.hpp"
#include "pantin/evaluation.hpp"
#include "pantin/image.hpp"

namespace pantin::figures {
namespace {

namespace fs = std::filesystem;

// What counts as success where the truth is known.
constexpr double least_silhouette = 0.5, least_parts = 0.6; // intersection over union; 0.5 as in AP50

struct Judged {
    CharacterResult result;
    std::size_t vertices = 0, edges = 0, raw_vertices = 0; // of the skeleton graph, and before the heuristics
    std::string type; // that was identified; "" when it did not get so far

    bool detected() const { return result.found && result.mask_overlap >= least_silhouette; }
    bool segmented() const { return result.found && result.mean_overlap() >= least_parts; }
    bool skeletonized() const { return result.ends.all(); }
    bool identified() const { return type == result.type; }
};

Judged judge(const CharacterResult& result, const fs::path& pages,
             const std::vector<ReferenceSkeleton>& references, const Options& options) {
    Judged judged;
    judged.result = result;
    if (!result.found) return judged;
    const fs::path folder = pages / result.page / result.folder;
    const fs::path skeleton = folder / "skeleton.json", identification = folder / "identification.json";
    if (!fs::exists(skeleton)) return judged;
    const SkeletonGraph graph = skeleton_from_json(read_text(skeleton), skeleton.string());
    judged.vertices = graph.vertices.size();
    judged.edges = graph.edges.size();
    judged.raw_vertices =
        skeletonize(load_grey(folder / "labels.png"), options.skeletonization).raw.vertices.size();
    if (fs::exists(identification))
        judged.type =
            identification_from_json(read_text(identification), identification.string(), graph, references)
                .type;
    return judged;
}

std::vector<Judged> judge_all(const fs::path& dataset, const fs::path& out, const std::string& preset) {
    Settings settings;
    settings.options = make_preset(preset);
    const Dataset drawings(dataset);
    const Evaluation evaluation = evaluate(drawings, out, settings);
    const std::vector<ReferenceSkeleton> references = load_references();
    std::vector<Judged> all;
    for (const CharacterResult& result : evaluation.characters)
        all.push_back(judge(result, out / "pages", references, settings.options));
    return all;
}

std::string mark(bool good) { return good ? "✓" : "✗"; }
std::string mark(const Verdict* verdict) { return verdict ? mark(verdict->good) : "–"; }
std::string share(double overlap) { return shown(overlap, 2, true); }

// How many of all hold.
std::string count(const std::vector<Judged>& all, const std::function<bool(const Judged&)>& holds) {
    return std::to_string(std::count_if(all.begin(), all.end(), holds)) + " of " + std::to_string(all.size());
}

std::string summary(const std::vector<Judged>& ours, const std::vector<Judged>& thesis,
                    const Verdicts& verdicts) {
    const auto line = [&](const std::string& step, const std::string& means,
                          const std::function<bool(const Judged&)>& holds, const std::string& paper) {
        return "| " + step + " | " + means + " | " + count(ours, holds) + " | " + count(thesis, holds) +
               " | " + paper + " |\n";
    };
    std::string text = "| step | success here means | `default` | `thesis` | the thesis: 21 drawings of its "
                       "tables |\n|---|---|---|---|---|\n";
    text += line(
        "detection", "silhouettes overlap by " + share(least_silhouette) + " (intersection over union)",
        [](const Judged& j) { return j.detected(); }, "21 (and all 50 of the set)");
    text += line(
        "segmentation", "parts overlap by " + share(least_parts) + " (mean over the parts that are there)",
        [](const Judged& j) { return j.segmented(); }, "21");
    text += line(
        "skeletonization",
        "every head, tail and wing (of 1 % of the figure or more) and every limb that is drawn has an "
        "end-effector",
        [](const Judged& j) { return j.skeletonized(); }, "21");
    text += line(
        "identification", "the right type", [](const Judged& j) { return j.identified(); },
        "16 (85 % of the set)");
    const auto looks_right = [&](const char* preset) {
        return [&verdicts, preset](const Judged& j) {
            const Verdict* v = verdicts.find(preset, j.result.page, "rigging");
            return v && v->good;
        };
    };
    return text + "| rigging | the clip looks right (by eye) | " + count(ours, looks_right("default")) +
           " | " + count(thesis, looks_right("thesis")) + " | 20 |\n";
}

// What chapter 5 says about the sizes of its graphs.
std::string graph_row(const std::string& name, const std::vector<Judged>& all) {
    double vertices = 0, edges = 0, removed = 0, skeletons = 0;
    std::size_t least = 1000, most = 0;
    for (const Judged& j : all) {
        if (j.vertices == 0) continue;
        ++skeletons;
        vertices += static_cast<double>(j.vertices);
        edges += static_cast<double>(j.edges);
        removed += static_cast<double>(j.raw_vertices) - static_cast<double>(j.vertices);
        least = std::min(least, j.vertices);
        most = std::max(most, j.vertices);
    }
    return "| " + name + " | " + shown(vertices / skeletons, 1) + " (" + std::to_string(least) + " to " +
           std::to_string(most) + ") | " + shown(edges / skeletons, 1) + " | " +
           shown(removed / skeletons, 1) + " |\n";
}

std::string drawing_table(const std::vector<Judged>& all, const std::string& preset, const std::string& type,
                          const Verdicts& verdicts) {
    std::string text = "With `" + preset +
                       "`:\n\n| ground truth | number | detection | segmentation | skeletonization | "
                       "identification | rigging | remark |\n|---|---|---|---|---|---|---|---|\n";
    for (const Judged& j : all) {
        if (j.result.type != type) continue;
        const Verdict* rigging = verdicts.find(preset, j.result.page, "rigging");
        text += "| " + type + ": " + j.result.species + " | " + j.result.page + " | " + mark(j.detected()) +
                " " + share(j.result.mask_overlap) + " | " + mark(j.segmented()) + " " +
                share(std::max(0.0, j.result.mean_overlap())) + " | " + mark(j.skeletonized()) + " " +
                std::to_string(j.result.ends.reached) + "/" + std::to_string(j.result.ends.parts) + " | " +
                mark(j.identified()) +
                (j.identified() ? "" : " " + (j.type.empty() ? j.result.status : j.type)) + " | " +
                mark(rigging) + " | " + (rigging ? rigging->remark : "") + " |\n";
    }
    return text + "\n";
}

std::string testdata_table(const Verdicts& verdicts) {
    std::string text = "| drawing | detection | segmentation | skeletonization | identification | rigging | "
                       "remark |\n|---|---|---|---|---|---|---|\n";
    for (const std::string& drawing : verdicts.drawings()) {
        std::string remarks;
        text += "| `" + drawing + "` |";
        for (const char* step :
             {"detection", "segmentation", "skeletonization", "identification", "rigging"}) {
            const Verdict* verdict = verdicts.find("default", drawing, step);
            text += " " + mark(verdict) + " |";
            if (verdict && !verdict->remark.empty())
                remarks += (remarks.empty() ? "" : "; ") + verdict->remark;
        }
        text += " " + remarks + " |\n";
    }
    return text;
}

} // namespace

std::string success_tables(const fs::path& dataset, const fs::path& work, const Verdicts& verdicts) {
    const std::vector<Judged> ours = judge_all(dataset, work / "default", "default"),
                              thesis = judge_all(dataset, work / "thesis", "thesis");
    const std::string graphs = "\nSizes of the skeleton graphs, means over the drawings:\n\n| | vertices "
                               "(range) | edges | vertices removed by H1 and H2 |\n|---|---|---|---|\n" +
                               graph_row("`default`", ours) + graph_row("`thesis`", thesis) +
                               "| the thesis, chapter 5 | 11 (7 to 15) | 12 | 3 |\n";
    std::string text = summary(ours, thesis, verdicts) + graphs + "\n";
    for (const auto& [title, type] :
         {std::pair{"Humanoids", "humanoid"}, {"Quadrupeds", "quadruped"}, {"Flyers", "flying"}})
        text += "### " + std::string(title) + "\n\n" + drawing_table(ours, "default", type, verdicts) +
                drawing_table(thesis, "thesis", type, verdicts);
    return text +
           "### The drawings of testdata, by eye\n\nWith `default`; the characters of a page are numbered as "
           "in its `page.json`.\n\n" +
           testdata_table(verdicts);
}

std::string results_page(const fs::path& dataset, const fs::path& work, const std::string& testdata,
                         const Verdicts& verdicts) {
    return "# Results on our own drawings\n\n"
           "The counterparts of the thesis's table 5.1 (times) and tables 6.1 to 6.3 (success of each step), "
           "written by `make results`. All drawings are\n"
           "our own: those of `testdata/`, and 30 of `tools/doodle` (seed 2026, 640×480, ten of each type, a "
           "third of them with the look of a\n"
           "photograph). They are easier than drawings by people: the same generator drew a part of the "
           "networks' training data, with other seeds.\n"
           "What the pipeline does on drawings by people is in [accuracy.md](accuracy.md).\n\n"
           "## Times\n\n" +
           time_table(testdata) +
           "\n## Success of each step\n\n"
           "Detection, segmentation, skeletonization and identification are computed from the generator's "
           "truth. Rigging is judged by eye, from frames of\n"
           "the first clip; these verdicts, with their dates, are in [verdicts.csv](verdicts.csv) (newest: " +
           verdicts.newest() +
           "). Numbers beside the marks: overlap of the\nsilhouettes, mean overlap of the parts, parts with "
           "an end-effector (limbs as drawn, not connected\npieces, so legs that have grown together need "
           "one each; a "
           "wing that is folded on the body has no end of its own and counts as missed).\n"
           "The thesis judged every step by eye. With `thesis` a humanoid's limbs swing towards the viewer "
           "(6.1), which "
           "frames hardly show: the parts that its\nbones move were looked at, too.\n\n" +
           success_tables(dataset, work, verdicts);
}

} // namespace pantin::figures
