// The shipped segmentation network alone, without and with the mirror image, on one thread and two.
#include "bench.hpp"
#include "core/resources.hpp"
#include "segmentation/model.hpp"

namespace pantin::bench {

void bench_segmenter(int rounds) {
    const segmentation::Network net = segmentation::load_network(
        network::WeightFile(find_resource("weights/segmenter.safetensors"), "weights/segmenter.safetensors"));
    const network::Tensor ink(1, 1, net.input, net.input, 0.5f);
    const network::Runtime one(1), two(2);
    compare("segmentation network, forward",
            {{"one thread", [&] { net.forward(ink, one); }},
             {"two threads", [&] { net.forward(ink, two); }},
             {"one thread, with the mirror image", [&] { net.forward(ink, one, -1, true); }},
             {"two threads, with the mirror image", [&] { net.forward(ink, two, -1, true); }}},
            5 * rounds);
}

} // namespace pantin::bench
