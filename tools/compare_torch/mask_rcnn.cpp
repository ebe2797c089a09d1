// SPDX-License-Identifier: MIT
// Mask R-CNN, each module fed with what PyTorch's module got.
#include <algorithm>
#include <cmath>

#include "compare_torch/trace.hpp"
#include "detection/mask_rcnn/mask_rcnn.hpp"

namespace pantin::compare {
namespace {

using network::Region;
using network::Tensor;

std::vector<Region> regions_of(const Tensor& boxes) {
    std::vector<Region> regions;
    for (int i = 0; i < boxes.batch(); ++i)
        regions.push_back({boxes(i, 0, 0, 0), boxes(i, 1, 0, 0), boxes(i, 2, 0, 0), boxes(i, 3, 0, 0)});
    return regions;
}

// The largest coordinate difference between a box and the nearest one on the other side, both ways: as sets,
// because nearly equal scores may change their order.
Difference compare_boxes(const std::string& what, const std::vector<Region>& ours,
                         const std::vector<Region>& theirs) {
    const auto distance = [](const Region& a, const Region& b) {
        return std::max({std::abs(a.left - b.left), std::abs(a.top - b.top), std::abs(a.right - b.right),
                         std::abs(a.bottom - b.bottom)});
    };
    const auto farthest = [&](const std::vector<Region>& from, const std::vector<Region>& to) {
        double largest = 0;
        for (const Region& a : from) {
            double nearest = std::numeric_limits<double>::infinity();
            for (const Region& b : to) nearest = std::min<double>(nearest, distance(a, b));
            largest = std::max(largest, nearest);
        }
        return largest;
    };
    Difference difference{.what = what, .shape = std::to_string(ours.size()) + " boxes"};
    difference.allowed = 1e-2; // pixels
    difference.by_absolute = true;
    difference.absolute = std::max(farthest(ours, theirs), farthest(theirs, ours));
    if (ours.size() != theirs.size()) {
        difference.shape += " instead of " + std::to_string(theirs.size());
        difference.absolute = std::numeric_limits<double>::infinity();
    }
    return difference;
}

class Comparison {
public:
    Comparison(const network::WeightFile& weights, const network::WeightFile& trace, int threads)
        : trace_(trace), network_(mask_rcnn::load_network(weights)), runtime_(threads),
          image_(tensor("image")) {}

    std::vector<Difference> run() {
        image();
        features();
        proposals();
        boxes();
        masks();
        whole();
        return std::move(differences_);
    }

private:
    Tensor tensor(const std::string& name) const { return read_tensor(trace_, name); }
    void add(const std::string& name, const Tensor& ours) {
        differences_.push_back(compare(trace_, name, ours));
    }
    std::vector<Tensor> tensors(const std::string& name, std::size_t count) const {
        std::vector<Tensor> list;
        for (std::size_t i = 0; i < count; ++i) list.push_back(tensor(name + std::to_string(i)));
        return list;
    }
    std::size_t levels() const { return network_.backbone.layers.size() + 1; }

    void image() {
        mask_rcnn::Transformed input = transform(image_, network_.options.transform, runtime_);
        size_ = input.size;
        add("transformed", input.image);
    }
    void features() {
        const std::vector<Tensor> stages = network_.backbone.forward(tensor("transformed"), runtime_);
        for (std::size_t i = 0; i < stages.size(); ++i) add("stage" + std::to_string(i), stages[i]);
        const std::vector<Tensor> pyramid =
            network_.pyramid.forward(tensors("stage", stages.size()), runtime_);
        for (std::size_t i = 0; i < pyramid.size(); ++i) add("level" + std::to_string(i), pyramid[i]);
    }
    void proposals() {
        std::vector<mask_rcnn::Objectness> theirs;
        for (std::size_t i = 0; i < levels(); ++i) {
            const std::string number = std::to_string(i);
            const mask_rcnn::Objectness ours =
                network_.proposal_head.forward(tensor("level" + number), runtime_);
            add("objectness" + number, ours.logits);
            add("displacements" + number, ours.displacements);
            theirs.push_back({tensor("objectness" + number), tensor("displacements" + number)});
        }
        differences_.push_back(compare_boxes("proposals", propose(theirs, size_, network_.options.proposals),
                                             regions_of(tensor("proposals"))));
    }
    void boxes() {
        const std::vector<Tensor> pyramid = tensors("level", levels());
        const std::vector<Region> regions = regions_of(tensor("proposals"));
        const mask_rcnn::DetectionOptions& options = network_.options.detection;
        add("box_pooled", pool_regions(pyramid, regions, options.box_pool, size_, options, runtime_));
        const mask_rcnn::BoxScores seen = network_.box_head.forward(tensor("box_pooled"), runtime_);
        add("class_logits", seen.scores);
        add("box_displacements", seen.displacements);
        std::vector<Region> found;
        for (const mask_rcnn::Found& f : find_boxes({tensor("class_logits"), tensor("box_displacements")},
                                                    regions, size_, options, runtime_))
            found.push_back(f.box);
        differences_.push_back(compare_boxes("found", found, regions_of(tensor("found"))));
    }
    void masks() {
        const mask_rcnn::DetectionOptions& options = network_.options.detection;
        add("mask_pooled", pool_regions(tensors("level", levels()), regions_of(tensor("found")),
                                        options.mask_pool, size_, options, runtime_));
        add("mask_logits", network_.mask_head.forward(tensor("mask_pooled"), runtime_));
    }
    // End to end: boxes as sets; of the boxes that belong together the share of different mask pixels.
    void whole() {
        const std::vector<Region> theirs = regions_of(tensor("boxes"));
        const Tensor masks = tensor("masks"); // [detections][1, height, width], 0 or 1
        std::vector<Region> ours;
        long different = 0, inside = 0;
        for (const mask_rcnn::Detection& detection : network_.forward(image_, runtime_)) {
            ours.push_back(detection.box);
            const auto partner = std::find_if(theirs.begin(), theirs.end(), [&](const Region& box) {
                return overlap(box, detection.box) > 0.999f;
            });
            if (partner == theirs.end()) continue;
            const Grid<float> mask = paste_mask(detection, image_.width(), image_.height());
            const float* expected = masks.plane(static_cast<int>(partner - theirs.begin()), 0);
            for (std::size_t i = 0; i < mask.size(); ++i) {
                inside += expected[i] > 0.5f;
                different += (mask.data()[i] > 0.5f) != (expected[i] > 0.5f);
            }
        }
        differences_.push_back(compare_boxes("boxes, end to end", ours, theirs));
        Difference share{.what = "masks, end to end (share of pixels)",
                         .shape = std::to_string(inside) + " pixels"};
        share.absolute = inside ? static_cast<double>(different) / static_cast<double>(inside) : 0;
        share.allowed = 1e-3;
        share.by_absolute = true;
        differences_.push_back(share);
    }

    const network::WeightFile& trace_;
    mask_rcnn::Network network_;
    network::Runtime runtime_;
    Tensor image_;
    mask_rcnn::InputSize size_;
    std::vector<Difference> differences_;
};

} // namespace

std::vector<Difference> compare_mask_rcnn(const network::WeightFile& weights,
                                          const network::WeightFile& trace, int threads) {
    return Comparison(weights, trace, threads).run();
}

} // namespace pantin::compare
