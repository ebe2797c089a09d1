// SPDX-License-Identifier: MIT
// Step 1 (thesis 4.2): a page to characters, each with its box and its filled silhouette.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/image.hpp"
#include "pantin/point.hpp"

namespace pantin {

// The classical alternative that thesis 4.2 describes; the network that the thesis uses.
enum class Detector { contour, mask_rcnn };
inline constexpr const char* detector_names[] = {"contour", "mask-rcnn"};

// What the silhouette is: the ink of a character and what it encloses, or the network's mask, one half and
// more.
enum class MaskSource { ink, network };

struct DetectionOptions {
    Detector detector = Detector::mask_rcnn; // 4.2; how much better on crowded pages: weights/README.md
    int working_size =
        512; // longer side of the working crop at most; `thesis`: 321 (its network's input, ch. 5)
    int max_characters = 64; // a page with more keeps the ones with the largest boxes

    // A sheet on a photograph of a desk is found and flattened first (pantin/sheet.hpp). `thesis`: never.
    bool flatten_sheet = true;

    // A page that lies on its side or upside down is turned by itself when a quarter turn has this
    // probability (own, src/pipeline/upright.hpp). `thesis`: never (2).
    double turn_probability = 0.98;

    // Ink. Shares of the darkness of the darkest strokes (ink_darkness).
    double ink_contrast = 0.15;    // a stroke is darker than the local mean by this
    double lightest_stroke = 0.38; // and at least this dark itself
    double filled_darkness = 0.5;  // a filled area is at least this dark
    int threshold_windows = 40;    // half a window of the local mean = longer side / this

    // Grouping of ink pieces (src/detection/grouping.cpp), measured on pages composed of real drawings
    // (tools/evaluate_detection.py). Gaps relative to the diagonal of a box.
    int grouping_size = 1024; // longer side of the page on which pieces are grouped, at most
    double mark_size = 0.35;  // a mark is at most this share of its character …
    double mark_gap = 0.12;   // … and this far from it (share of the character)
    double touching_gap =
        0.02; // pieces of like size this close are one (here and below: share of the smaller one)
    double closed_share = 0.03; // what encloses this share of its squared diagonal could stand alone
    double deepest_pen = 0.02;  // ink deeper than this share of its diagonal is colour, not a stroke
    double contact_share =
        0.05;               // an open line has this share of the border of a region that it helps to enclose
    double head_size = 0.5; // a closed shape beside another is its head up to this share of it,
    double stacked_head_size = 0.7; // or this one when one is above the other,
    double head_gap = 0.1;          // and this gap; all other closed shapes stay apart
    double open_gap = 0.15;         // an open line and anything of like size
    double stacked_gap = 0.2;       // the same, one above the other
    double enclosed_gain = 0.2;     // side by side only if this share of what they enclose needs both
    double min_share = 0.15;        // groups smaller than this share of the largest are dropped
    int min_side = 16;              // page pixels; smaller characters are dropped

    // `thesis`: network (4.4: "the mask computed in the detection step"). A character that no network found
    // (the contour-based detector; a network that finds nothing) has that of the ink.
    MaskSource mask = MaskSource::ink;

    // Grouping by Mask R-CNN (src/detection/network_grouping.hpp).
    double network_score = 0.5; // least score of a detection
    // A detection with so much of its mask inside the mask of a larger one whose score is no lower is a part
    // of that character.
    double contained_share = 0.6;
    // A detection whose ink touches that of a larger one, with a lower score than part_score and part_overlap
    // of its box inside the other's (a halo, a tail, the second half of an animal), is a part of that one.
    // `thesis`: 0.
    double part_score = 0.8, part_overlap = 0.35;
    // A character of which so much lies inside the silhouette of a larger one (an eye, a button) is none.
    double inside_share = 0.8;
    double shared_claim = 0.2;   // a piece of ink of which others claim this share is divided
    double claimed_reach = 0.05; // connected ink farther than this (of its diagonal) from what is claimed …
    double claimed_extent = 0.35; // … is no character's if it goes on farther than this
    double unclaimed_reach =
        0.06; // ink that nobody claims belongs to a character this near (of its diagonal) …
    double unclaimed_extent = 0.35; // … if it ends this near, too
    int threads = 1;                // of the network; results do not depend on it
};

// The network that finds characters on a page: Mask R-CNN (He et al. 2017; thesis 4.2, ch. 5), the compact
// one or any other size. The weight file's metadata chooses (docs/formats.md).
class CharacterFinder {
public:
    // weights: the bytes of a safetensors file, which are not needed afterwards; source: its name in
    // messages. Error(weights) when the file is damaged, incomplete or for a network that is not known. Own
    // format on top of safetensors.
    CharacterFinder(std::span<const unsigned char> weights, const std::string& source);
    ~CharacterFinder();
    CharacterFinder(CharacterFinder&&) noexcept;

    struct Found {
        double score = 0;                                // [0, 1]
        double left = 0, top = 0, right = 0, bottom = 0; // page pixels
        Grid<float> mask;                                // probabilities inside the box, 28×28
        // Of the mask at a place in page pixels, in [0, 1], bilinear; 0 outside the box. No errors. He et al.
        // 2017, 3.1, where the mask is resized to its box.
        double probability(double x, double y) const;
    };
    // page: at any size; ink: how dark its ink is (find_page_ink). A network sees the ink or, as the thesis
    // has it, the colours, dark on light. By descending score. Error(weights) when the layers do not fit
    // together. The bits do not depend on `threads`. Thesis 4.2.
    std::vector<Found> find(const RgbImage& page, const Grid<float>& ink, int threads = 1) const;
    // Number (1, 2, …) of the found character that claims each grid cell most, by mask times score where the
    // mask is at least one half; 0: none. width × height cells of `factor` page pixels a side. No errors.
    // Own.
    static Grid<int> claims(const std::vector<Found>& found, int width, int height, int factor);

private:
    struct Model;
    std::unique_ptr<Model> model_;
};

struct DetectedCharacter {
    Box box; // page pixels, margin of max(4, 2 % of the longer side) included, cut at the page's border
    double scale = 1; // working pixels per page pixel, ≤ 1
    double score = 0; // [0, 1]: share of the silhouette's outline that is inked; with a network its score
    RgbImage drawing; // the crop at the page's resolution
    GreyImage ink;    // the same: 0 paper, 255 the strongest strokes; of this character alone
    Mask mask;        // the filled silhouette at working size
    // The two between which DetectionOptions::mask chooses, for `--trace`; `network_mask` is empty without a
    // network.
    Mask ink_mask, network_mask;
    bool exact_mask = false; // it is the user's word (a mask, a cut-out), not an estimate
};

// Intermediate products are kept for `--trace` and `explain`.
struct Detection {
    int width = 0, height = 0; // of the page
    Mask ink;                  // after the adaptive threshold, page size; empty when nothing was detected
    std::vector<DetectedCharacter> characters; // left to right, then top to bottom, by box centre
};

// page: at any size; ink: of that page. With a finder its network groups the ink (when it finds anything),
// without one the contour-based detector does. Boxes in page pixels, masks at working size.
// Error(no_character) when the page holds none. Thesis 4.2, Fig. 4.3; contours: Suzuki & Abe 1985.
Detection detect(const RgbImage& page, const PageInk& ink, const DetectionOptions& options = {},
                 const CharacterFinder* finder = nullptr);
// The same with the ink of find_page_ink(page).
Detection detect(const RgbImage& page, const DetectionOptions& options = {},
                 const CharacterFinder* finder = nullptr);

// The character whose silhouette on the page is known: of the page's size, not 0 inside; its score is 1.
// Error(internal) when the silhouette is empty. Own.
DetectedCharacter character_of(const RgbImage& page, const PageInk& ink, const Mask& silhouette,
                               const DetectionOptions& options = {});

} // namespace pantin
