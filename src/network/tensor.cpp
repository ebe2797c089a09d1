#include <limits>

#include "pantin/error.hpp"
#include "pantin/network.hpp"

namespace pantin::network {

Tensor::Tensor(int batch, int channels, int height, int width, float value)
    : batch_(batch), channels_(channels), height_(height), width_(width) {
    if (batch < 0 || channels < 0 || height < 0 || width < 0)
        throw Error(ErrorKind::weights, "a network layer's result would have a negative extent");
    std::size_t count = 1;
    for (const int extent : {batch, channels, height, width}) {
        if (extent != 0 &&
            count > std::numeric_limits<std::size_t>::max() / 16 / static_cast<std::size_t>(extent))
            throw Error(ErrorKind::weights, "a network layer's result would be too large");
        count *= static_cast<std::size_t>(extent);
    }
    data_.assign(count, value);
}

bool Tensor::same_shape(const Tensor& other) const {
    return batch_ == other.batch_ && channels_ == other.channels_ && height_ == other.height_ &&
           width_ == other.width_;
}

} // namespace pantin::network
