// SPDX-License-Identifier: MIT
// A square of ink to what SketchParse was trained on, and its parts and directions to our labels and poses.
//
// As its authors evaluate it (exp-src/eval_r5.py of their code): black on white, grey values 0 … 255 in three
// channels without a mean subtracted, scores interpolated to the input with the corners in place. The
// softmax, which they take in training, gives the probabilities that the views need; parts of one label add
// up.
#include "segmentation/sketch_parse/sketch_parse_network.hpp"

#include <algorithm>

#include "network/layer_reader.hpp"
#include "network/metadata.hpp"
#include "pantin/label.hpp"
#include "pantin/segmentation.hpp"
#include "segmentation/sketch_parse/sketch_parse.hpp"

namespace pantin::sketch_parse {
namespace {

constexpr int authors_input = 321, max_input = 2048;
constexpr const char* authors_poses = "N,W,NW,NE,S,E,SE,SW"; // exp-src/data/lists/README.md of their code

class PipelineNetwork : public segmentation::SegmentationNetwork {
public:
    Network network;
    std::vector<std::vector<int>> labels; // of each expert's channels
    std::vector<int> poses;               // place in pose_names of each value of the pose heads
    int only_expert = 0;                  // the one that is always taken, without a router

    std::unique_ptr<segmentation::EncodedInput> encode(const Tensor& ink,
                                                       const Runtime& runtime) const override;
    Tensor parts_of(const Tensor& scores, int expert, const Runtime& runtime) const;
    Tensor pose_of(const Tensor& logits, const Runtime& runtime) const;
};

struct Encoded : segmentation::EncodedInput {
    const PipelineNetwork& owner;
    Shared shared;

    Encoded(const PipelineNetwork& network, Shared seen) : owner(network), shared(std::move(seen)) {
        if (owner.network.router) {
            router = shared.router;
            return;
        }
        router = Tensor(1, static_cast<int>(owner.expert_names.size()), 1, 1);
        router.begin()[owner.only_expert] = 1;
    }
    segmentation::Answer decode(int expert, const Runtime& runtime) const override {
        const Result result = owner.network.decode(shared, expert, runtime);
        return {owner.pose_of(result.pose, runtime), owner.parts_of(result.scores, expert, runtime)};
    }
};

Tensor image_of(const Tensor& ink) {
    Tensor image = Tensor::uninitialised(1, 3, ink.height(), ink.width());
    for (int c = 0; c < 3; ++c)
        std::transform(ink.begin(), ink.end(), image.plane(0, c),
                       [](float darkness) { return 255 * (1 - darkness); });
    return image;
}

std::unique_ptr<segmentation::EncodedInput> PipelineNetwork::encode(const Tensor& ink,
                                                                    const Runtime& runtime) const {
    return std::make_unique<Encoded>(*this, network.encode(image_of(ink), runtime));
}

Tensor PipelineNetwork::parts_of(const Tensor& scores, int expert, const Runtime& runtime) const {
    const Tensor probabilities = network::softmax(network::resize_corners(scores, input, input), runtime);
    const std::vector<int>& label = labels[static_cast<std::size_t>(expert)];
    Tensor parts(1, label_count, input, input);
    for (int c = 0; c < probabilities.channels(); ++c) {
        const float* from = probabilities.plane(0, c);
        float* to = parts.plane(0, label[static_cast<std::size_t>(c)]);
        for (std::size_t i = 0; i < parts.plane_size(); ++i) to[i] = std::min(1.0f, to[i] + from[i]);
    }
    return parts;
}

// Without a pose head every direction is as probable as another.
Tensor PipelineNetwork::pose_of(const Tensor& logits, const Runtime& runtime) const {
    const auto count = static_cast<int>(pose_names.size());
    if (logits.size() == 0) return Tensor(1, count, 1, 1, 1.0f / static_cast<float>(count));
    const Tensor probabilities = network::softmax(logits, runtime);
    Tensor pose(1, count, 1, 1);
    for (std::size_t i = 0; i < poses.size(); ++i) pose.begin()[poses[i]] = probabilities.begin()[i];
    return pose;
}

// --- metadata --------------------------------------------------------------------------------------------

template <class Names>
int place_of(const WeightFile& file, const std::string& key, const std::string& name, const Names& names) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) file.fail("metadata '" + key + "' has the unknown name '" + name + "'");
    return static_cast<int>(found - names.begin());
}

// "background,head,body;background,wing" to the labels of each expert's channels.
std::vector<std::vector<int>> read_labels(const WeightFile& file, const std::vector<Expert>& experts) {
    const std::vector<std::string> groups = network::split(file.metadata("parts"), ';');
    if (groups.size() != experts.size())
        file.fail("metadata 'parts' needs " + std::to_string(experts.size()) +
                  " lists, one for each expert, separated by semicolons");
    std::vector<std::vector<int>> labels;
    for (std::size_t e = 0; e < groups.size(); ++e) {
        std::vector<int> channels;
        for (const std::string& name : network::split(groups[e], ','))
            channels.push_back(place_of(file, "parts", name, label_names));
        const int count = experts[e].classifiers[0].out_channels();
        if (static_cast<int>(channels.size()) != count ||
            std::count(channels.begin(), channels.end(), 0) == 0)
            file.fail("metadata 'parts' needs " + std::to_string(count) +
                      " labels, background among them, for expert " + std::to_string(e));
        labels.push_back(std::move(channels));
    }
    return labels;
}

std::vector<int> read_poses(const WeightFile& file) {
    const std::string text = file.has_metadata("poses") ? file.metadata("poses") : authors_poses;
    std::vector<int> poses;
    for (const std::string& name : network::split(text, ',')) {
        poses.push_back(place_of(file, "poses", name, pose_names));
        if (std::count(poses.begin(), poses.end(), poses.back()) > 1)
            file.fail("metadata 'poses' has '" + name + "' twice");
    }
    if (poses.size() != pose_names.size()) file.fail("metadata 'poses' needs all eight directions");
    return poses;
}

void check_pose_heads(const WeightFile& file, const Network& network) {
    const network::LayerReader reader{file};
    for (std::size_t e = 0; e < network.pose.size(); ++e) {
        const std::string name = "pose_r" + std::to_string(e) + ".PoseC2.0.weight";
        if (reader.extent(name, 2, 0) != static_cast<int>(pose_names.size()))
            file.fail("tensor '" + name + "' needs eight rows, one for each direction");
    }
}

} // namespace

std::unique_ptr<segmentation::SegmentationNetwork> load_segmentation_network(const WeightFile& file) {
    auto loaded = std::make_unique<PipelineNetwork>();
    loaded->network = load_network(file);
    check_pose_heads(file, loaded->network);
    const std::vector<Expert>& experts = loaded->network.scales[0].experts;
    loaded->expert_names = network::split(file.metadata("experts"), ',');
    if (loaded->expert_names.size() != experts.size())
        file.fail("metadata 'experts' needs " + std::to_string(experts.size()) + " names");
    if (file.has_metadata("expert"))
        loaded->only_expert = place_of(file, "expert", file.metadata("expert"), loaded->expert_names);
    else if (!loaded->network.router && experts.size() > 1)
        file.fail("neither tensor 'router.weight' nor metadata 'expert' chooses between the experts");
    loaded->labels = read_labels(file, experts);
    loaded->poses = read_poses(file);
    loaded->input = authors_input;
    if (file.has_metadata("input"))
        loaded->input = network::parse_number(file, "input", file.metadata("input"), 1, max_input);
    return loaded;
}

} // namespace pantin::sketch_parse
