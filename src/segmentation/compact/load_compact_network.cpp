// SPDX-License-Identifier: MIT
// From the weight file (docs/formats.md) to the compact network's modules.
#include <set>

#include "network/layer_reader.hpp"
#include "network/metadata.hpp"
#include "pantin/label.hpp"
#include "pantin/segmentation.hpp"
#include "segmentation/compact/compact_network.hpp"

namespace pantin::compact {
namespace {

using network::parse_number;
using network::read_numbers;
using network::split;

constexpr std::size_t stages = 4;
constexpr int max_width = 4096; // channels of a layer
constexpr int max_input = 2048; // side of the input
constexpr int max_blocks = 64;  // of a stage, and their dilations
constexpr int halvings = 1 << stages;
constexpr std::size_t quarter_turns = std::tuple_size_v<TurnProbabilities::value_type>;

template <class Names> std::string joined(const Names& names) {
    std::string text;
    for (const auto& name : names) text += (text.empty() ? "" : ",") + std::string(name);
    return text;
}

void expect(const WeightFile& file, const std::string& key, const std::string& value) {
    if (file.metadata(key) != value)
        file.fail("metadata '" + key + "' is '" + file.metadata(key) + "', not '" + value + "'");
}

struct Shape {
    int in = 0, out = 0, kernel = 3, stride = 1, dilation = 1;
    bool adds = false; // a residual block's shortcut comes after it, then the activation
};

// A convolution without bias, its normalisation folded in.
template <class A>
typename A::Convolution read_convolution(const WeightFile& file, const std::string& name,
                                         const Shape& shape) {
    network::ConvolutionOptions options;
    options.stride = shape.stride;
    options.dilation = shape.dilation;
    options.padding = shape.kernel / 2 * shape.dilation;
    options.relu = !shape.adds;
    const std::string conv = name + ".conv";
    if (file.shape(conv + ".weight") !=
        std::vector<std::int64_t>{shape.out, shape.in, shape.kernel, shape.kernel})
        file.fail("tensor '" + conv + ".weight' has another shape than the metadata says");
    const typename A::Reader reader{file};
    return shape.adds ? reader.adding_convolution(conv, name + ".norm", shape.in, options)
                      : reader.convolution(conv, name + ".norm", shape.in, options);
}

template <class A>
network::BasicResidualBlock<A> read_residual(const WeightFile& file, const std::string& name, int width,
                                             int dilation = 1) {
    const Shape shape{.in = width, .out = width, .dilation = dilation};
    Shape last = shape;
    last.adds = true;
    network::BasicResidualBlock<A> block;
    block.branch.push_back(read_convolution<A>(file, name + ".a", shape));
    block.branch.push_back(read_convolution<A>(file, name + ".b", last));
    return block;
}

network::Linear read_linear(const WeightFile& file, const std::string& name, int in, int out) {
    const network::LayerReader reader{file};
    if (reader.extent(name + ".weight", 2, 0) != out)
        file.fail("tensor '" + name + ".weight' needs " + std::to_string(out) + " rows");
    return reader.linear(name, in);
}

// What the metadata says of the network's layers; the names are their keys.
struct Layout {
    std::vector<int> widths;   // channels of the stem's stages
    std::vector<int> decoder;  // channels of the decoder's stages
    std::vector<int> contexts; // dilations of the experts' blocks on the coarsest stage
    std::vector<int> refine;   // number of blocks after each decoder stage
};

template <class A>
PooledHead<A> read_pooled_head(const WeightFile& file, const std::string& name, const Layout& layout,
                               std::size_t outputs) {
    const int in = layout.widths.back(), width = layout.decoder[0];
    return {{read_convolution<A>(file, name + ".conv", {.in = in, .out = width, .stride = 2})},
            read_linear(file, name + ".linear", 2 * width, static_cast<int>(outputs))};
}

template <class A>
Expert<A> read_expert(const WeightFile& file, const std::string& name, const Layout& layout) {
    network::ConvolutionOptions doubling;
    doubling.stride = 2;
    const typename A::Reader reader{file};
    if (reader.extent(name + ".logits.weight", 4, 1) != label_count ||
        reader.extent(name + ".logits.weight", 4, 2) != 2 ||
        reader.extent(name + ".logits.weight", 4, 3) != 2)
        file.fail("tensor '" + name + ".logits.weight' does not make " + std::to_string(label_count) +
                  " labels at twice the size");
    Expert<A> expert{
        {}, {}, reader.transposed_convolution(name + ".logits", layout.decoder.back(), doubling)};
    int width = layout.widths.back();
    for (std::size_t i = 0; i < layout.contexts.size(); ++i)
        expert.context.push_back(
            read_residual<A>(file, name + ".context." + std::to_string(i), width, layout.contexts[i]));
    for (std::size_t i = 0; i < layout.decoder.size(); ++i) {
        const int skip = layout.widths[stages - 2 - i], out = layout.decoder[i];
        const std::string number = std::to_string(stages - 1 - i);
        typename Expert<A>::Stage stage{
            {read_convolution<A>(file, name + ".up" + number, {.in = width + skip, .out = out})}, {}};
        for (int k = 0; k < layout.refine[i]; ++k)
            stage.refine.push_back(
                read_residual<A>(file, name + ".refine" + number + "." + std::to_string(k), out));
        expert.decoder.push_back(std::move(stage));
        width = out;
    }
    return expert;
}

template <class A> std::unique_ptr<segmentation::SegmentationNetwork> load(const WeightFile& file) {
    expect(file, "version", "2");
    expect(file, "labels", joined(label_names));
    expect(file, "poses", joined(pose_names));
    const Layout layout{read_numbers(file, "widths", 1, max_width, stages),
                        read_numbers(file, "decoder", 1, max_width, stages - 1),
                        read_numbers(file, "contexts", 1, max_blocks, 0),
                        read_numbers(file, "refine", 0, max_blocks, stages - 1)};

    auto loaded = std::make_unique<Network<A>>();
    Network<A>& net = *loaded;
    net.input = parse_number(file, "input", file.metadata("input"), 1, max_input);
    if (net.input % halvings != 0)
        file.fail("metadata 'input' is no multiple of " + std::to_string(halvings));
    net.expert_names = split(file.metadata("experts"), ',');
    if (std::set<std::string>(net.expert_names.begin(), net.expert_names.end()).size() !=
        net.expert_names.size())
        file.fail("metadata 'experts' names one twice");
    int in = 1;
    for (std::size_t i = 0; i < stages; ++i) {
        const int out = layout.widths[i];
        const std::string number = std::to_string(i + 1);
        net.stem.down.push_back({read_convolution<A>(
            file, "stem.down" + number, {.in = in, .out = out, .kernel = i == 0 ? 5 : 3, .stride = 2})});
        net.stem.res.push_back(read_residual<A>(file, "stem.res" + number, out));
        in = out;
    }
    const int experts = static_cast<int>(net.expert_names.size());
    net.router.emplace(Router<A>{read_linear(file, "router.linear", 2 * in, experts)});
    net.pose.emplace(PoseHead<A>{
        {read_convolution<A>(file, "pose.conv", {.in = in, .out = layout.decoder[0], .stride = 2})},
        read_linear(file, "pose.linear", layout.decoder[0], static_cast<int>(pose_names.size()))});
    if (file.has_metadata("types")) {
        expect(file, "types", joined(type_names));
        net.type = read_pooled_head<A>(file, "kind", layout, type_names.size());
    }
    if (file.has_metadata("turns")) {
        expect(file, "turns", "0,90,180,270");
        net.turn = read_pooled_head<A>(file, "turn", layout, quarter_turns);
    }
    for (const std::string& name : net.expert_names)
        net.experts.push_back(read_expert<A>(file, "experts." + name, layout));
    return loaded;
}

} // namespace

std::unique_ptr<segmentation::SegmentationNetwork> load_network(const WeightFile& file) {
    return network::holds_integers(file) ? load<network::IntegerArithmetic>(file)
                                         : load<network::RealArithmetic>(file);
}

} // namespace pantin::compact
