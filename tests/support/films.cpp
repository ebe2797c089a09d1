#include "support/films.hpp"

#include <cstring>
#include <stdexcept>

#ifdef PANTIN_WEBP
#include <webp/demux.h>
#endif
#ifdef PANTIN_GIF
#include <gif_lib.h>
#endif

namespace pantin::test {

#ifdef PANTIN_WEBP
Film read_webp(const std::vector<unsigned char>& bytes) {
    WebPAnimDecoderOptions options;
    WebPAnimDecoderOptionsInit(&options);
    options.color_mode = MODE_RGBA;
    const WebPData data{bytes.data(), bytes.size()};
    WebPAnimDecoder* decoder = WebPAnimDecoderNew(&data, &options);
    if (!decoder) throw std::runtime_error("no animated WebP");
    WebPAnimInfo info;
    WebPAnimDecoderGetInfo(decoder, &info);
    Film film;
    film.loops_for_ever = info.loop_count == 0;
    int last = 0;
    while (WebPAnimDecoderHasMoreFrames(decoder)) {
        std::uint8_t* pixels = nullptr;
        int time = 0;
        if (!WebPAnimDecoderGetNext(decoder, &pixels, &time)) throw std::runtime_error("broken WebP");
        RgbaImage frame(static_cast<int>(info.canvas_width), static_cast<int>(info.canvas_height));
        std::memcpy(frame.data(), pixels, frame.size() * 4);
        film.frames.push_back(frame);
        film.delays.push_back(time - last);
        last = time;
    }
    WebPAnimDecoderDelete(decoder);
    return film;
}
#endif

#ifdef PANTIN_GIF
namespace {
struct Source {
    const std::vector<unsigned char>& bytes;
    std::size_t at = 0;
};
int read_bytes(GifFileType* file, GifByteType* to, int count) {
    Source& source = *static_cast<Source*>(file->UserData);
    const std::size_t given = std::min(static_cast<std::size_t>(count), source.bytes.size() - source.at);
    std::memcpy(to, source.bytes.data() + source.at, given);
    source.at += given;
    return static_cast<int>(given);
}
} // namespace

Film read_gif(const std::vector<unsigned char>& bytes) {
    Source source{bytes};
    int error = 0;
    GifFileType* gif = DGifOpen(&source, read_bytes, &error);
    if (!gif || DGifSlurp(gif) != GIF_OK) throw std::runtime_error("broken GIF");
    Film film;
    for (int i = 0; i < gif->ImageCount; ++i) {
        const SavedImage& image = gif->SavedImages[i];
        for (int e = 0; e < image.ExtensionBlockCount; ++e) {
            const ExtensionBlock& block = image.ExtensionBlocks[e];
            if (block.Function == APPLICATION_EXT_FUNC_CODE && block.ByteCount == 11 &&
                std::memcmp(block.Bytes, "NETSCAPE2.0", 11) == 0 && e + 1 < image.ExtensionBlockCount) {
                const GifByteType* loop = image.ExtensionBlocks[e + 1].Bytes;
                film.loops_for_ever = loop[0] == 1 && loop[1] == 0 && loop[2] == 0;
            }
        }
        GraphicsControlBlock control;
        DGifSavedExtensionToGCB(gif, i, &control);
        film.disposes_to_background =
            film.disposes_to_background && control.DisposalMode == DISPOSE_BACKGROUND;
        film.delays.push_back(control.DelayTime);
        RgbaImage frame(gif->SWidth, gif->SHeight, Rgba8{0, 0, 0, 0});
        const GifImageDesc& box = image.ImageDesc;
        for (int y = 0; y < box.Height; ++y)
            for (int x = 0; x < box.Width; ++x) {
                const int index = image.RasterBits[y * box.Width + x];
                if (index == control.TransparentColor) continue;
                const GifColorType c = gif->SColorMap->Colors[index];
                frame(box.Left + x, box.Top + y) = {c.Red, c.Green, c.Blue, 255};
            }
        film.frames.push_back(frame);
    }
    DGifCloseFile(gif, &error);
    return film;
}
#endif

} // namespace pantin::test
