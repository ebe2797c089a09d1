// SPDX-License-Identifier: MIT
// Animated WebP back to frames (libwebp's WebPAnimDecoder).
#include "export/decode_film.hpp"

#include <cstring>
#include <memory>

#include <webp/demux.h>

namespace pantin {

DecodedFilm decode_webp(std::span<const unsigned char> bytes, const std::string& source) {
    WebPAnimDecoderOptions options;
    WebPAnimDecoderOptionsInit(&options);
    options.color_mode = MODE_RGBA;
    const WebPData data{bytes.data(), bytes.size()};
    const std::unique_ptr<WebPAnimDecoder, decltype(&WebPAnimDecoderDelete)> decoder(
        WebPAnimDecoderNew(&data, &options), WebPAnimDecoderDelete);
    if (!decoder) damaged_film(source, "animated WebP");
    WebPAnimInfo info;
    WebPAnimDecoderGetInfo(decoder.get(), &info);
    check_film_size(info.canvas_width, info.canvas_height, source);
    DecodedFilm film;
    film.loops_for_ever = info.loop_count == 0;
    int last = 0;
    while (WebPAnimDecoderHasMoreFrames(decoder.get())) {
        std::uint8_t* pixels = nullptr;
        int time = 0;
        if (!WebPAnimDecoderGetNext(decoder.get(), &pixels, &time)) damaged_film(source, "animated WebP");
        RgbaImage frame(static_cast<int>(info.canvas_width), static_cast<int>(info.canvas_height));
        std::memcpy(frame.data(), pixels, frame.size() * 4);
        film.frames.push_back(frame);
        film.delays.push_back(time - last);
        last = time;
    }
    return film;
}

} // namespace pantin
