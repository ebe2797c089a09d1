// SPDX-License-Identifier: MIT
// Step 2 (thesis 4.3): part labels and the view direction of one character.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/label.hpp"
#include "pantin/type_probabilities.hpp"

namespace pantin {

// The direction in which the character faces, as in the annotations of SketchParse: E to the right of the
// picture, W to the left, S towards the viewer, N away.
inline constexpr std::array<const char*, 8> pose_names = {"E", "NE", "N", "NW", "W", "SW", "S", "SE"};

// The final silhouette. p(x, y) is the network's foreground probability, 1 − p(background), at working
// size; lengths are shares of the working crop's longer side, areas shares of the silhouette's area.
//
// 1. Cut: a region of the mask without ink where p < keep_probability is removed, when it is thicker than
//    2·tolerance and at least open_share of its border lies along the outside (what the detector's closing
//    bridged: the space between two legs), or when it is more closed, at most hole_cut_share of the mask and
//    its mean p below hole_probability (the space between arm and body). A narrower region without ink is
//    removed when it lies between strokes (region_ink_share of its border is ink), has region_share of the
//    mask, and its mean p is below region_probability (the space between two legs). Inked pixels stay.
// 2. Fill: a region outside the mask where p ≥ fill_probability is added, when it is thicker than 2·tolerance
//    (else it is a rim along the outline, or closes a gap between two strokes, which is taken) and at least
//    enclosed_share of its border lies along the mask: open outlines that the detector left hollow. Were the
//    result still hollow, less than hollow_share of what mask and network see together, half that enclosure,
//    and then any, is enough.
// 3. One piece: parts that are not connected are joined to the largest by a bridge as wide as 2·tolerance
//    when they are large and near enough, else dropped. Small holes are filled, jagged pixels of the outline
//    smoothed by a 3×3 majority that spares whatever is thin.
// 4. Rim: the detector's mask ends at the outer edge of the pen, a character in its middle. Pixels within
//    `rim` of the outside where p < rim_probability are removed, but nothing that is thin.
struct SilhouetteOptions {
    double fill_probability = 0.5;
    double keep_probability = 0.3;
    double open_share = 0.08;
    double hole_probability = 0.1;
    double hole_cut_share = 0.1;
    double region_probability = 0.4;
    double region_share = 0.002;
    double region_ink_share = 0.7;
    double enclosed_share = 0.6;
    double hollow_share = 0.6;
    double ink_darkness = 0.35; // of an inked pixel, at working size
    double tolerance = 0.01;    // length
    double piece_share = 0.01;  // least area of a piece that is joined
    double bridge_length = 0.15;
    double hole_share = 0.01; // largest area of a hole that is filled
    double rim = 0.008;       // length
    double rim_probability = 0.5;
    // Labels of the silhouette's pixels: the most probable of the five parts, the first among equals. Where
    // the five together have less than part_probability: the label of the nearest pixel where they have more.
    // Pieces of a label smaller than speck_share are given to the labels around them.
    double part_probability = 0.2;
    double speck_share = 0.004;
};

// Which drawings get grey erosion: none; photographs, as is_photograph() (pantin/image.hpp) says of the crop
// (by the pipeline: a Segmenter sees no colours and takes this for `never`); all.
enum class GreyErosion { never, photographs, always };

struct SegmentationOptions {
    int threads = 1; // results do not depend on it
    // Thesis ch. 5: grey erosion of photographs, so that strokes are as thick and sharp as in the training
    // data: the darkest value of the 3×3 neighbourhood at the network's resolution.
    // `thesis`: photographs.
    GreyErosion grey_erosion = GreyErosion::never;
    // Whether the detector's mask is an estimate that the network corrects (SilhouetteOptions). `thesis`:
    // false, the silhouette is the mask, and every pixel of it gets a part.
    bool refine_silhouette = true;
    // Test-time augmentation: probabilities are means over several views of the drawing, with its mirror
    // image and tilted by so many degrees to either side (0: not). A view counts exp(inverse_temperature ·
    // its confidence). `thesis`: one view.
    bool mirror = true;
    double tilt = 20, inverse_temperature = 30;
    // When the first view, the drawing as it is, has this confidence it is the only one.
    double sufficient_confidence = 0.96;
    // A scribble, and no character: its strokes are longer than its outline by scribble_ratio; every view has
    // less confidence than least_confidence, or one part, not the head, is scribble_part of the figure; and a
    // type head, if there is one, says `other` with scribble_other. (An outline with gaps lowers the
    // confidence, too, a bird with many feathers has long strokes, and a fish is none of the types.) Without
    // a type head the confidence alone decides. `thesis`: nothing is a scribble.
    double least_confidence = 0.895, scribble_ratio = 1.2, scribble_other = 0.7, scribble_part = 0.9;
    SilhouetteOptions silhouette;
};

struct Segmentation {
    std::string expert; // the expert that the router chose
    // Length of the strokes over that of the silhouette's border: 1 for a plain outline.
    double stroke_ratio = 0;
    // Mean probability of the most probable part over the foreground, of the view where it is largest; in [0,
    // 1]. segmentation.json calls it "sureness".
    double confidence = 0;
    std::vector<std::pair<std::string, double>>
        router;                             // expert → probability, in the order of the weight file
    std::array<double, 8> pose{};           // probability per pose_names
    TypeProbabilities type;                 // of a network with a type head
    std::vector<Grid<float>> probabilities; // [label_count], the crop at network size (for explain)
    LabelMap labels;                        // working size; the silhouette is labels ≠ 0
};

// Whether it looks like a scribble, and no character (SegmentationOptions says how); false where no network
// has seen the picture. No error. Own.
bool is_scribble(const Segmentation& segmentation, const SegmentationOptions& options);

// Probability of each number of quarter turns clockwise, 0 to 3, after which a character stands as it was
// drawn; they add up to 1. Nothing of a network without such a head.
using TurnProbabilities = std::optional<std::array<double, 4>>;

// A two-level network in the manner of SketchParse (Sarvadevabhatla et al. 2017; thesis 4.3): shared layers,
// a router, one expert for each group of categories, a pose head. The weight file's metadata chooses between
// the compact one and SketchParse itself (docs/formats.md).
class Segmenter {
public:
    // weights: the bytes of a safetensors file, which are not needed afterwards; source: its name in
    // messages. Error(weights) when the file is damaged, incomplete or for a network that is not known. Own
    // format on top of safetensors.
    Segmenter(std::span<const unsigned char> weights, const std::string& source);
    ~Segmenter();
    Segmenter(Segmenter&&) noexcept;

    // ink: of the crop at page resolution (DetectedCharacter); mask: the silhouette at working size, the same
    // crop: the detector's estimate, or exact, then the labels fill it to the pixel. Labels at working size,
    // probabilities at the network's. Error(weights) when the layers do not fit together, Error(internal)
    // when ink or mask is empty. The bits do not depend on the threads. Thesis 4.3; views and the final
    // silhouette are own.
    Segmentation segment(const GreyImage& ink, const Mask& mask, const SegmentationOptions& options = {},
                         bool exact_mask = false) const;

    // How a character on a page that may lie on its side was meant. ink as above. Error(weights) and the
    // bits as above. Own.
    TurnProbabilities find_turn(const GreyImage& ink, const SegmentationOptions& options = {}) const;

private:
    struct Model;
    std::unique_ptr<Model> model_;
};

} // namespace pantin
