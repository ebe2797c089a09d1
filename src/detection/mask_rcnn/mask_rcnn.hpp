// SPDX-License-Identifier: MIT
// Mask R-CNN (He et al. 2017) with a ResNet and a feature pyramid (Lin et al. 2017), as torchvision 0.14's
// `maskrcnn_resnet50_fpn` computes it; thesis 4.2 and ch. 5 use that network with two classes. One struct per
// module; widths, depths and arithmetic are those of the weight file, so a compact network is the same code.
//
// Shapes in comments are [channels, height, width] for the full-size network; the batch is the page, or the
// regions of a page.
#pragma once

#include <vector>

#include "network/regions.hpp"
#include "network/residual.hpp"
#include "pantin/grid.hpp"
#include "pantin/network.hpp"

namespace pantin::mask_rcnn {

using network::Region;
using network::Runtime;
using network::Tensor;
using network::WeightFile;

// --- backbone --------------------------------------------------------------------------------------------

// Blocks are 1×1, 3×3, 1×1 (bottleneck) or 3×3, 3×3 (basic block); the first of each layer but one halves.
template <class Arithmetic> struct ResNet {
    using Map = typename Arithmetic::Map;
    typename Arithmetic::Convolution stem; // 7×7, stride 2; then max pooling 3×3, stride 2
    std::vector<std::vector<network::BasicResidualBlock<Arithmetic>>> layers;
    // The outputs of the layers: strides 4, 8, 16, 32.
    std::vector<Map> forward(const Map& image, const Runtime& runtime) const;
};

// Top-down pathway with lateral connections; one more level by taking every second pixel of the last.
template <class Arithmetic> struct FeaturePyramid {
    using Map = typename Arithmetic::Map;
    std::vector<typename Arithmetic::Convolution> inner, layer;
    std::vector<Map> forward(std::vector<Map> stages, const Runtime& runtime) const;
};

// --- region proposals ------------------------------------------------------------------------------------

struct ProposalOptions {
    std::vector<float> sizes = {32, 64, 128, 256, 512}; // of the anchors, one per level
    std::vector<float> ratios = {0.5, 1, 2};            // height / width
    int per_level = 1000, total = 1000;                 // most proposals before and after suppression
    float overlap = 0.7f;
    float least_side = 1e-3f;
};

// What the head sees at one level; anchor a of pixel (x, y) has objectness (a, y, x) and the four
// displacements (4a … 4a + 3, y, x).
struct Objectness {
    Tensor logits;        // [anchors, height, width]
    Tensor displacements; // [4·anchors, height, width]
};

// Anchors of a level in the order (y, x, anchor): boxes of equal area around the corners of the grid.
std::vector<Region> make_anchors(float size, const std::vector<float>& ratios, int grid_width,
                                 int grid_height, int stride_x, int stride_y);

// The most probable boxes of each level, suppressed per level, by descending objectness. width, height: of
// the network's input (padded), clip_width, clip_height: of the image in it.
struct InputSize {
    int width = 0, height = 0, clip_width = 0, clip_height = 0;
};
std::vector<Region> propose(const std::vector<Objectness>& levels, const InputSize& size,
                            const ProposalOptions& options);

template <class Arithmetic> struct ProposalHead {
    typename Arithmetic::Convolution conv, logits, displacements; // 3×3 and two 1×1
    Objectness forward(const typename Arithmetic::Map& features, const Runtime& runtime) const;
};

// --- heads on regions ------------------------------------------------------------------------------------

struct DetectionOptions {
    float score = 0.05f;  // least score
    float overlap = 0.5f; // of two boxes of one class that both stay
    int most = 100;       // per image
    float least_side = 1e-2f;
    int box_pool = 7, mask_pool = 14, sampling = 2;
    float canonical_size = 224; // a region of this size is read from level 4
    int canonical_level = 4;
};

struct Found {
    Region box;
    float score = 0;
    int label = 0; // 1 … classes − 1
};

// Features of each region from the level that fits its size (Lin et al. 2017, Eq. 1): [regions][channels]
// [size][size]. zero: the byte of integer features that stands for 0.
Tensor pool_regions(const std::vector<Tensor>& pyramid, const std::vector<Region>& regions, int size,
                    const InputSize& image, const DetectionOptions& options, const Runtime& runtime);
network::integer::ByteTensor pool_regions(const std::vector<network::integer::ByteTensor>& pyramid,
                                          const std::vector<Region>& regions, int size, std::uint8_t zero,
                                          const InputSize& image, const DetectionOptions& options,
                                          const Runtime& runtime);

struct BoxScores {
    Tensor scores;        // [regions][classes] logits
    Tensor displacements; // [regions][4·classes]
};
template <class Arithmetic> struct BoxHead {
    typename Arithmetic::Linear fc6, fc7, scores, displacements;
    BoxScores forward(const typename Arithmetic::Map& pooled, const Runtime& runtime) const;
};

// Boxes of the classes (but for class 0, background) over the least score, suppressed per class, by
// descending score.
std::vector<Found> find_boxes(const BoxScores& seen, const std::vector<Region>& proposals,
                              const InputSize& image, const DetectionOptions& options,
                              const Runtime& runtime);

template <class Arithmetic> struct MaskHead {
    std::vector<typename Arithmetic::Convolution> convs;
    typename Arithmetic::TransposedConvolution up;
    typename Arithmetic::Convolution logits;
    // Logits [regions][classes, 28, 28].
    Tensor forward(const typename Arithmetic::Map& pooled, const Runtime& runtime) const;
};

// --- the network -----------------------------------------------------------------------------------------

// (x − mean) / deviation per channel, then resized so that the shorter side is `shorter`, or, when the longer
// one would exceed `longer`, so that it is `longer`; zeros to the right and below up to a multiple of 32.
struct TransformOptions {
    int shorter = 800, longer = 1333;
    std::vector<float> mean = {0.485f, 0.456f, 0.406f}, deviation = {0.229f, 0.224f, 0.225f};
    int divisor = 32;
};
struct Transformed {
    Tensor image; // [3, height, width]
    InputSize size;
};
// image: [channels of `mean`, height, width], values in [0, 1].
Transformed transform(const Tensor& image, const TransformOptions& options, const Runtime& runtime);

struct Detection {
    Region box; // pixels of the page
    float score = 0;
    int label = 0;
    Tensor mask; // [1, 28, 28] probabilities inside the box
};

struct Options {
    TransformOptions transform;
    ProposalOptions proposals;
    DetectionOptions detection;
};

template <class Arithmetic> struct BasicNetwork {
    Options options;
    ResNet<Arithmetic> backbone;
    FeaturePyramid<Arithmetic> pyramid;
    ProposalHead<Arithmetic> proposal_head;
    BoxHead<Arithmetic> box_head;
    MaskHead<Arithmetic> mask_head;

    // image: [channels, height, width] in [0, 1]. By descending score.
    std::vector<Detection> forward(const Tensor& image, const Runtime& runtime) const;
};
using Network = BasicNetwork<network::RealArithmetic>;

// Throws Error(weights) naming the file and the fact, also when the file is for another arithmetic. The
// options come from the metadata; what it does not say is as in torchvision.
template <class Arithmetic = network::RealArithmetic>
BasicNetwork<Arithmetic> load_network(const WeightFile& file);

// The mask's probabilities at the resolution of the page inside the box, 0 outside (torchvision's pasting:
// a border of zeros around the mask, the box enlarged accordingly and cut to whole pixels).
Grid<float> paste_mask(const Detection& detection, int page_width, int page_height);

// Displacements (dx, dy, dw, dh) of a box relative to another, divided by their weights (Girshick et al.
// 2014).
Region displaced(const Region& box, const float displacement[4], const float weights[4]);
Region clipped(const Region& box, int width, int height);

} // namespace pantin::mask_rcnn
