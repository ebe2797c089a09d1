// SPDX-License-Identifier: MIT
// The shipped segmentation network alone, one view and the six of the default, on one thread and two, beside
// the same network on real numbers.
#include "bench.hpp"
#include "core/file.hpp"
#include "core/resources.hpp"
#include "segmentation/views.hpp"

namespace pantin::bench {

void bench_segmenter(int rounds) {
    const auto loaded = segmentation::load_segmentation_network(
        network::WeightFile(find_resource("weights/segmenter.safetensors"), "weights/segmenter.safetensors"));
    const segmentation::SegmentationNetwork& net = *loaded;
    const std::vector<unsigned char> bytes = read_file("weights/float/segmenter.safetensors");
    const auto real =
        segmentation::load_segmentation_network(network::WeightFile(bytes, "weights/float/segmenter"));
    const network::Tensor ink(1, 1, net.input, net.input, 0.5f);
    const network::Runtime one(1), two(2);
    compare("segmentation network, forward",
            {{"real numbers, one thread", [&] { real->forward(ink, one); }},
             {"one thread", [&] { net.forward(ink, one); }},
             {"two threads", [&] { net.forward(ink, two); }},
             {"one thread, six views",
              [&] {
                  segmentation::segment_views(net, ink, {true, 20, 30}, one);
              }},
             {"two threads, six views",
              [&] {
                  segmentation::segment_views(net, ink, {true, 20, 30}, two);
              }}},
            5 * rounds);
}

} // namespace pantin::bench
