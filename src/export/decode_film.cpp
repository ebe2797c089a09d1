// SPDX-License-Identifier: MIT
// Bytes of a WebP or GIF in, frames and their times out, by libwebp and giflib.
#include "export/decode_film.hpp"

#include <algorithm>
#include <cstring>
#include <memory>

#include "pantin/error.hpp"
#include "pantin/image.hpp"

#ifdef PANTIN_WEBP
#include <webp/demux.h>
#endif
#ifdef PANTIN_GIF
#include <gif_lib.h>
#endif

namespace pantin {

namespace {

[[maybe_unused]] bool is_too_large(long width, long height) { return width * height > max_image_pixels; }

[[noreturn, maybe_unused]] void damaged(const std::string& source, const char* kind) {
    throw Error(ErrorKind::input, source + ": is damaged or no " + kind);
}

} // namespace

#ifdef PANTIN_WEBP
DecodedFilm decode_webp(std::span<const unsigned char> bytes, const std::string& source) {
    WebPAnimDecoderOptions options;
    WebPAnimDecoderOptionsInit(&options);
    options.color_mode = MODE_RGBA;
    const WebPData data{bytes.data(), bytes.size()};
    const std::unique_ptr<WebPAnimDecoder, decltype(&WebPAnimDecoderDelete)> decoder(
        WebPAnimDecoderNew(&data, &options), WebPAnimDecoderDelete);
    if (!decoder) damaged(source, "animated WebP");
    WebPAnimInfo info;
    WebPAnimDecoderGetInfo(decoder.get(), &info);
    if (is_too_large(info.canvas_width, info.canvas_height)) damaged(source, "film of ours: it is too large");
    DecodedFilm film;
    film.loops_for_ever = info.loop_count == 0;
    int last = 0;
    while (WebPAnimDecoderHasMoreFrames(decoder.get())) {
        std::uint8_t* pixels = nullptr;
        int time = 0;
        if (!WebPAnimDecoderGetNext(decoder.get(), &pixels, &time)) damaged(source, "animated WebP");
        RgbaImage frame(static_cast<int>(info.canvas_width), static_cast<int>(info.canvas_height));
        std::memcpy(frame.data(), pixels, frame.size() * 4);
        film.frames.push_back(frame);
        film.delays.push_back(time - last);
        last = time;
    }
    return film;
}
#endif

#ifdef PANTIN_GIF
namespace {

struct Source {
    std::span<const unsigned char> bytes;
    std::size_t at = 0;
};
int read_bytes(GifFileType* file, GifByteType* to, int count) {
    Source& source = *static_cast<Source*>(file->UserData);
    const std::size_t given = std::min(static_cast<std::size_t>(count), source.bytes.size() - source.at);
    std::memcpy(to, source.bytes.data() + source.at, given);
    source.at += given;
    return static_cast<int>(given);
}

struct CloseGif {
    void operator()(GifFileType* gif) const {
        int ignored = 0;
        DGifCloseFile(gif, &ignored);
    }
};

bool loops_for_ever(const SavedImage& image) {
    for (int e = 0; e + 1 < image.ExtensionBlockCount; ++e) {
        const ExtensionBlock &block = image.ExtensionBlocks[e], &next = image.ExtensionBlocks[e + 1];
        if (block.Function != APPLICATION_EXT_FUNC_CODE || block.ByteCount != 11 || next.ByteCount != 3)
            continue;
        if (std::memcmp(block.Bytes, "NETSCAPE2.0", 11) == 0)
            return next.Bytes[0] == 1 && next.Bytes[1] == 0 && next.Bytes[2] == 0;
    }
    return false;
}

RgbaImage shown(const GifFileType& gif, const SavedImage& image, int transparent) {
    RgbaImage frame(gif.SWidth, gif.SHeight, Rgba8{0, 0, 0, 0});
    const ColorMapObject* map = image.ImageDesc.ColorMap ? image.ImageDesc.ColorMap : gif.SColorMap;
    const GifImageDesc& box = image.ImageDesc;
    for (int y = 0; y < box.Height; ++y)
        for (int x = 0; x < box.Width; ++x) {
            const int index = image.RasterBits[y * box.Width + x];
            if (index == transparent || !map || index >= map->ColorCount ||
                !frame.contains(box.Left + x, box.Top + y))
                continue;
            const GifColorType c = map->Colors[index];
            frame(box.Left + x, box.Top + y) = {c.Red, c.Green, c.Blue, 255};
        }
    return frame;
}

} // namespace

DecodedFilm decode_gif(std::span<const unsigned char> bytes, const std::string& source_name) {
    Source source{bytes};
    int error = 0;
    const std::unique_ptr<GifFileType, CloseGif> gif(DGifOpen(&source, read_bytes, &error));
    if (!gif || DGifSlurp(gif.get()) != GIF_OK) damaged(source_name, "GIF");
    if (is_too_large(gif->SWidth, gif->SHeight)) damaged(source_name, "film of ours: it is too large");
    DecodedFilm film;
    for (int i = 0; i < gif->ImageCount; ++i) {
        const SavedImage& image = gif->SavedImages[i];
        film.loops_for_ever = film.loops_for_ever || loops_for_ever(image);
        GraphicsControlBlock control{};
        control.TransparentColor = NO_TRANSPARENT_COLOR;
        DGifSavedExtensionToGCB(gif.get(), i, &control);
        film.disposes_to_background =
            film.disposes_to_background && control.DisposalMode == DISPOSE_BACKGROUND;
        film.delays.push_back(control.DelayTime);
        film.frames.push_back(shown(*gif, image, control.TransparentColor));
    }
    return film;
}
#endif

} // namespace pantin
