// SPDX-License-Identifier: MIT
// WebP bytes to pixels (libwebp's WebPAnimDecoder, which takes a single picture for an animation of one).
#include "image/webp.hpp"

#include <memory>

#include <webp/demux.h>

namespace pantin {

bool webp_pictures_available() { return true; }

RgbaImage decode_webp_picture(ByteView bytes) {
    WebPAnimDecoderOptions options;
    if (!WebPAnimDecoderOptionsInit(&options)) return {};
    options.color_mode = MODE_RGBA;
    const WebPData data{bytes.data(), bytes.size()};
    const std::unique_ptr<WebPAnimDecoder, decltype(&WebPAnimDecoderDelete)> decoder(
        WebPAnimDecoderNew(&data, &options), WebPAnimDecoderDelete);
    WebPAnimInfo info;
    std::uint8_t* pixels = nullptr;
    int time = 0;
    if (!decoder || !WebPAnimDecoderGetInfo(decoder.get(), &info) ||
        !WebPAnimDecoderGetNext(decoder.get(), &pixels, &time))
        return {};
    RgbaImage image(static_cast<int>(info.canvas_width), static_cast<int>(info.canvas_height));
    std::memcpy(image.data(), pixels, image.size() * sizeof(Rgba8));
    return image;
}

} // namespace pantin
