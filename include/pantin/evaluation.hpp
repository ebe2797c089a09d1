// SPDX-License-Identifier: MIT
// How good the pipeline is on drawings with truth: `pantin evaluate`.
//
// A dataset is a folder (docs/formats.md, "Datasets"; tools/doodle writes such folders):
//     image/<id>.png or .jpg      the page
//     label/<id>.png              part labels of the page, 8-bit, value = label (optional; a page without
//                                 counts in the table of types alone)
//     instance/<id>.png           value = number of the character, 1, 2, … (optional; else all are one)
//     index.ndjson                one object a line: id, and for one character type, species, pose, limbs, or
//                                 for several characters: [{type, species, pose, limbs}, …] in the order of
//                                 their numbers (all optional)
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/label.hpp"
#include "pantin/pipeline.hpp"

namespace pantin {

// --- truth -------------------------------------------------------------------------------------------------

struct TrueCharacter {
    Mask mask;                       // page size; empty when the dataset has no label maps
    std::string type, species, pose; // "" when not known
    int limbs = -1;                  // arms, legs and fins that are seen; −1: not known
};
struct TruePage {
    std::string id;
    std::filesystem::path image;
    LabelMap labels; // page size; empty when the dataset has none
    std::vector<TrueCharacter> characters;
    // Whether it is known where its characters are: it has a label map, or there are none. Another page
    // counts in the table of types alone.
    bool is_labelled() const { return !labels.empty() || characters.empty(); }
};
// The ids of a dataset in the order of its index, and the truth of one page. Error(input) when something is
// missing or malformed. Own.
class Dataset {
public:
    // Reads the index alone.
    explicit Dataset(const std::filesystem::path& folder);
    std::size_t size() const { return rows_.size(); }
    // index: 0 … size() − 1; pictures in pixels of the page.
    TruePage page(std::size_t index) const;

private:
    struct Row {
        std::string id;
        std::vector<TrueCharacter> characters; // without masks
    };
    std::filesystem::path folder_;
    std::vector<Row> rows_;
};

// --- results -----------------------------------------------------------------------------------------------

// A character that the detector found, whether there is one or not. Overlap: intersection over union with the
// true character that it overlaps most, of the detector's mask and of the silhouette after segmentation.
struct FoundCharacter {
    std::string page;
    double score = 0;
    int true_by_mask = -1, true_by_silhouette = -1; // number of that character on its page
    double mask_overlap = 0, silhouette_overlap = 0;
};

// How many of a character's heads, limbs, tails and wings (of 1 % of it or more) have an end of the skeleton.
struct EndCount {
    int parts = 0, reached = 0; // no parts: the truth has no label map
    bool limbs_known = false; // limbs are counted as drawn; else every connected piece of limb pixels is one,
                              // however many legs have grown together in it
    bool all() const { return parts > 0 && reached == parts; }
};

// A true character and what became of it.
struct CharacterResult {
    std::string page, type, species;
    bool labelled = true; // whether its page is
    bool found = false;   // its best detection overlaps it by one half or more
    std::string folder;   // of that detection, below pages/<page>/
    double mask_overlap = 0, silhouette_overlap = 0;
    std::array<double, label_count> part_overlap{}; // −1: the truth has no such part; [0] unused
    EndCount ends;
    double pixel_accuracy = 0;              // share of the true character's pixels with the right label
    int pose_right = -1, expert_right = -1; // −1: not known
    std::string identified;                 // reference; "" when the character did not get so far
    double confidence = 0;
    std::string status;              // "ok", "step: reason", "not found"
    std::vector<Warning> warnings{}; // of what was found
    double mean_overlap() const;     // over the parts that the truth has; −1 when it has none
};

// What evaluate() runs, in this order.
inline constexpr std::array<std::string_view, 5> evaluated_steps = {"detect", "segment", "skeletonize",
                                                                    "identify", "rig"};

// What the answers hold; what they do not is not measured. The pipeline's have everything.
struct Measured {
    bool masks = true, labels = true, types = true;
    bool steps = true; // skeletons, rigs, warnings and times
};

struct Evaluation {
    Measured measured;
    int pages = 0, unanswered_pages = 0;     // those of which another program says nothing
    std::vector<std::string> labelled_pages; // their ids; the others stay out of detection and stages
    std::vector<FoundCharacter> found;       // on labelled pages
    std::vector<CharacterResult> characters;
    // Wall-clock seconds of each step, reading and writing its files and its networks included: of the first
    // on every page, of the others on every character that got so far. Differ from run to run.
    std::array<std::vector<double>, evaluated_steps.size()> seconds;
};

// Steps 1 to 5 on every page; the folders are written to out/pages/<id>. Errors of a page other than "no
// character" end the evaluation and are those of animate(). Thesis 6.1 (tables 6.1 to 6.3) and 6.2.
Evaluation evaluate(const Dataset& dataset, const std::filesystem::path& out, const Settings& settings);

// Answers of another program in the layout of a dataset, judged in the same way:
// predictions/instance/<id>.png, label/<id>.png and index.ndjson with type, pose and score (0 to 1, 1 when it
// is missing) of each character, as much of it as there is. Without instance/ the labels are one character;
// without both, the index's characters are answers for the true ones in their order. A page with none of its
// files has no answer. Error(input): there is nothing of the kind, or a picture has another size than the
// truth. Own.
Evaluation evaluate_predictions(const Dataset& dataset, const std::filesystem::path& predictions);

// Average precision: found characters by descending score, a hit overlaps a true character that no better one
// took by `least_overlap` or more; area under the precision that is made monotone (every point counts).
// least_overlap: intersection over union, in (0, 1]; by_mask: the detector's masks, else the silhouettes. Of
// labelled pages alone: where nobody knows what is there, an answer is neither right nor wrong. In [0, 1];
// NaN without true characters. No error. After PASCAL VOC (Everingham et al. 2010).
double average_precision(const Evaluation& evaluation, double least_overlap, bool by_mask);

// --- 95 % intervals ----------------------------------------------------------------------------------------

struct Interval {
    double low = 0, high = 0; // both NaN where there is too little to tell
};
// Of a share, hits of count. No error. Wilson (1927), without correction.
Interval share_interval(int hits, int count);
// Of a mean of independent values: ± 1.96 standard errors; NaN for fewer than two. No error.
Interval mean_interval(const std::vector<double>& values);
// Of average_precision(): percentiles of 1000 draws of as many pages with replacement, the same ones every
// time (characters of one page have the same hand and paper, so pages are drawn, not characters). NaN for
// fewer than two labelled pages. No error. Efron (1979).
Interval average_precision_interval(const Evaluation& evaluation, double least_overlap, bool by_mask);

// --- reports -----------------------------------------------------------------------------------------------

// One value of a table.
struct Measurement {
    std::string
        table; // "detection", "segmentation", "identification", "stages", "ends", "warnings", "seconds"
    std::string group; // of what: "all", "all, humanoid", "all, humanoid, person"; of identification the true
                       // type; of ends how limbs are counted: "as drawn", "as pieces"; of seconds what they
                       // are of: "page", "character"
    std::string measure; // "mask AP50", "head", "rigged"; of identification what was answered
    double value = 0;    // a share, a mean or an average precision; NaN where nothing was counted
    Interval interval;
    int count = 0;           // what it was counted on: characters (of "false": answers; of "detect": pages)
    std::optional<int> hits; // of a share that was measured
};
// All tables, in the order of evaluation_to_text. No error. Own.
std::vector<Measurement> measurements_of(const Evaluation& evaluation);

// Tables for people. No error. Own.
std::string evaluation_to_text(const Evaluation& evaluation);
// evaluation.json (docs/schemas/evaluation.schema.json): shares in [0, 1], null where nothing was counted. No
// error. Own.
std::string evaluation_to_json(const Evaluation& evaluation);
// The measurements as CSV: table, group, measure, value, low, high, count, hits; a cell is empty where there
// is nothing to tell. No error. Own.
std::string measurements_to_csv(const std::vector<Measurement>& measurements);
// One line a true character, as CSV. No error. Own.
std::string characters_to_csv(const Evaluation& evaluation);
// One row per character with its drawing, labels and skeleton, as in tables 6.1 to 6.3 of the thesis;
// pictures are referred to below `pages/`. No error.
std::string evaluation_to_html(const Evaluation& evaluation);

} // namespace pantin
