// SPDX-License-Identifier: MIT
// How good the pipeline is on drawings with truth: `pantin evaluate`.
//
// A dataset is a folder (docs/formats.md, "Datasets"; tools/doodle writes such folders):
//     image/<id>.png or .jpg      the page
//     label/<id>.png              part labels of the page, 8-bit, value = label (optional; a page without
//                                 counts in the table of types alone)
//     instance/<id>.png           value = number of the character, 1, 2, … (optional; else all are one)
//     index.ndjson                one object a line: id, and for one character type, species, pose, or for
//                                 several characters: [{type, species, pose}, …] in the order of their
//                                 numbers (all optional)
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/label.hpp"
#include "pantin/pipeline.hpp"

namespace pantin {

// --- truth -------------------------------------------------------------------------------------------------

struct TrueCharacter {
    Mask mask;                       // page size; empty when the dataset has no label maps
    std::string type, species, pose; // "" when not known
};
struct TruePage {
    std::string id;
    std::filesystem::path image;
    LabelMap labels; // page size; empty when the dataset has none
    std::vector<TrueCharacter> characters;
    // Whether it is known where its characters are: it has a label map, or there are none. Another page counts
    // in the table of types alone.
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

// A true character and what became of it.
struct CharacterResult {
    std::string page, type, species;
    bool labelled = true; // whether its page is
    bool found = false; // its best detection overlaps it by one half or more
    std::string folder; // of that detection, below pages/<page>/
    double mask_overlap = 0, silhouette_overlap = 0;
    std::array<double, label_count> part_overlap{}; // −1: the truth has no such part; [0] unused
    double pixel_accuracy = 0;              // share of the true character's pixels with the right label
    int pose_right = -1, expert_right = -1; // −1: not known
    std::string identified;                 // reference; "" when the character did not get so far
    double confidence = 0;
    std::string status;              // "ok", "step: reason", "not found"
    std::vector<Warning> warnings{}; // of what was found
    double mean_overlap() const;     // over the parts that the truth has; −1 when it has none
};

struct Evaluation {
    int pages = 0;
    std::vector<std::string> labelled_pages; // their ids; the others stay out of detection and stages
    std::vector<FoundCharacter> found;       // on labelled pages
    std::vector<CharacterResult> characters;
};

// Steps 1 to 5 on every page; the folders are written to out/pages/<id>. Errors of a page other than "no
// character" end the evaluation and are those of animate(). Thesis 6.1 (tables 6.1 to 6.3) and 6.2.
Evaluation evaluate(const Dataset& dataset, const std::filesystem::path& out, const Settings& settings);

// Average precision: found characters by descending score, a hit overlaps a true character that no better one
// took by `least_overlap` or more; area under the precision that is made monotone (every point counts).
// least_overlap: intersection over union, in (0, 1]; by_mask: the detector's masks, else the silhouettes. Of
// labelled pages alone: where nobody knows what is there, an answer is neither right nor wrong. In [0, 1]; NaN
// without true characters. No error. After PASCAL VOC (Everingham et al. 2010).
double average_precision(const Evaluation& evaluation, double least_overlap, bool by_mask);

// --- reports -----------------------------------------------------------------------------------------------

// Tables for people. No error. Own.
std::string evaluation_to_text(const Evaluation& evaluation);
// evaluation.json (docs/schemas/evaluation.schema.json): shares in [0, 1], null where nothing was counted. No
// error. Own.
std::string evaluation_to_json(const Evaluation& evaluation);
// One row per character with its drawing, labels and skeleton, as in tables 6.1 to 6.3 of the thesis;
// pictures are referred to below `pages/`. No error.
std::string evaluation_to_html(const Evaluation& evaluation);

} // namespace pantin
