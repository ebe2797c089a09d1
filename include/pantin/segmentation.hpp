// Step 2 (thesis 4.3): part labels and the view direction of one character.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/label.hpp"

namespace pantin {

inline constexpr std::array<const char*, 8> pose_names = {"E", "NE", "N", "NW", "W", "SW", "S", "SE"};

struct SegmentationOptions {
    int threads = 1; // results do not depend on it
    // Rules of the silhouette are added here, each with its source.
};

struct Segmentation {
    std::string expert;                                       // the expert that the router chose
    std::vector<std::pair<std::string, double>> router;       // expert → probability
    std::array<double, 8> pose{};                             // probability per pose_names
    std::vector<Grid<float>> probabilities;                   // [label_count], network size (kept for explain)
    LabelMap labels;                                          // working size; the silhouette is labels ≠ 0
};

// SketchParse (Sarvadevabhatla et al. 2017): shared stem, router, one expert per category group, pose head.
class Segmenter {
public:
    // Reads the weights (safetensors). Throws Error(weights) naming `source`.
    Segmenter(std::span<const unsigned char> weights, const std::string& source);
    ~Segmenter();
    Segmenter(Segmenter&&) noexcept;

    // drawing: the crop at page resolution; mask: the detected silhouette at working size.
    Segmentation segment(const RgbImage& drawing, const Mask& mask, const SegmentationOptions& options = {}) const;

private:
    struct Model;
    std::unique_ptr<Model> model_;
};

} // namespace pantin
