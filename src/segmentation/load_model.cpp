// From the weight file to the network's modules.
#include <charconv>

#include "network/layer_reader.hpp"
#include "pantin/label.hpp"
#include "pantin/segmentation.hpp"
#include "segmentation/model.hpp"

namespace pantin::segmentation {
namespace {

constexpr int stages = 4;
constexpr int max_width = 4096; // channels of a layer
constexpr int max_input = 2048; // side of the input
constexpr int halvings = 1 << stages;

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> items;
    std::size_t begin = 0;
    for (std::size_t comma = text.find(','); comma != std::string::npos; comma = text.find(',', begin)) {
        items.push_back(text.substr(begin, comma - begin));
        begin = comma + 1;
    }
    items.push_back(text.substr(begin));
    return items;
}

int read_number(const WeightFile& file, const std::string& key, const std::string& text, int max) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < 1 || value > max)
        file.fail("metadata '" + key + "' has the impossible value '" + text + "'");
    return value;
}

std::vector<int> read_numbers(const WeightFile& file, const std::string& key, std::size_t count) {
    const std::vector<std::string> items = split(file.metadata(key));
    if (items.size() != count)
        file.fail("metadata '" + key + "' needs " + std::to_string(count) + " numbers");
    std::vector<int> values;
    for (const std::string& item : items) values.push_back(read_number(file, key, item, max_width));
    return values;
}

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
    bool relu = true;
};

// A convolution without bias, its normalisation folded in.
network::Convolution read_convolution(const WeightFile& file, const std::string& name, const Shape& shape) {
    network::ConvolutionOptions options;
    options.stride = shape.stride;
    options.dilation = shape.dilation;
    options.padding = shape.kernel / 2 * shape.dilation;
    options.relu = shape.relu;
    const std::string conv = name + ".conv";
    if (file.shape(conv + ".weight") != std::vector<std::int64_t>{shape.out, shape.in, shape.kernel, shape.kernel})
        file.fail("tensor '" + conv + ".weight' has another shape than the metadata says");
    return network::LayerReader{file}.convolution(conv, name + ".norm", shape.in, options);
}

Residual read_residual(const WeightFile& file, const std::string& name, int width, int dilation = 1) {
    const Shape shape{.in = width, .out = width, .dilation = dilation};
    Shape last = shape;
    last.relu = false; // comes after the sum
    return {read_convolution(file, name + ".a", shape), read_convolution(file, name + ".b", last)};
}

network::Linear read_linear(const WeightFile& file, const std::string& name, int in, int out) {
    const network::LayerReader reader{file};
    if (reader.extent(name + ".weight", 2, 0) != out)
        file.fail("tensor '" + name + ".weight' needs " + std::to_string(out) + " rows");
    return reader.linear(name, in);
}

Expert read_expert(const WeightFile& file, const std::string& name, const std::vector<int>& widths,
                   const std::vector<int>& decoder) {
    network::ConvolutionOptions doubling;
    doubling.stride = 2;
    const network::LayerReader reader{file};
    if (reader.extent(name + ".logits.weight", 4, 1) != label_count || reader.extent(name + ".logits.weight", 4, 2) != 2 ||
        reader.extent(name + ".logits.weight", 4, 3) != 2)
        file.fail("tensor '" + name + ".logits.weight' does not make six labels at twice the size");
    Expert expert{read_residual(file, name + ".context", widths.back(), 2),
                  {},
                  reader.transposed_convolution(name + ".logits", decoder.back(), doubling)};
    int width = widths.back();
    for (int i = 0; i < stages - 1; ++i) {
        const int skip = widths[static_cast<std::size_t>(stages - 2 - i)],
                  out = decoder[static_cast<std::size_t>(i)];
        const std::string up = name + ".up" + std::to_string(stages - 1 - i);
        expert.up.push_back({read_convolution(file, up, {.in = width + skip, .out = out})});
        width = out;
    }
    return expert;
}

} // namespace

Network load_network(const WeightFile& file) {
    expect(file, "model", "pantin.segmenter");
    expect(file, "version", "1");
    expect(file, "labels", joined(label_names));
    expect(file, "poses", joined(pose_names));
    const std::vector<int> widths = read_numbers(file, "widths", stages);
    const std::vector<int> decoder = read_numbers(file, "decoder", stages - 1);

    Network net;
    net.input = read_number(file, "input", file.metadata("input"), max_input);
    if (net.input % halvings != 0)
        file.fail("metadata 'input' is no multiple of " + std::to_string(halvings));
    net.expert_names = split(file.metadata("experts"));
    int in = 1;
    for (int i = 0; i < stages; ++i) {
        const int out = widths[static_cast<std::size_t>(i)];
        const std::string number = std::to_string(i + 1);
        net.stem.down.push_back({read_convolution(
            file, "stem.down" + number, {.in = in, .out = out, .kernel = i == 0 ? 5 : 3, .stride = 2})});
        net.stem.res.push_back(read_residual(file, "stem.res" + number, out));
        in = out;
    }
    const int experts = static_cast<int>(net.expert_names.size());
    net.router = std::make_unique<Router>(Router{read_linear(file, "router.linear", 2 * in, experts)});
    net.pose = std::make_unique<PoseHead>(
        PoseHead{{read_convolution(file, "pose.conv", {.in = in, .out = decoder[0], .stride = 2})},
                 read_linear(file, "pose.linear", decoder[0], static_cast<int>(pose_names.size()))});
    for (const std::string& name : net.expert_names)
        net.experts.push_back(read_expert(file, "experts." + name, widths, decoder));
    return net;
}

} // namespace pantin::segmentation
