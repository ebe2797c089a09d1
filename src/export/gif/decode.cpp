// SPDX-License-Identifier: MIT
// GIF back to frames (giflib).
#include "export/decode_film.hpp"

#include <algorithm>
#include <cstring>
#include <memory>

#include <gif_lib.h>

namespace pantin {

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
    if (!gif || DGifSlurp(gif.get()) != GIF_OK) damaged_film(source_name, "GIF");
    check_film_size(gif->SWidth, gif->SHeight, source_name);
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

} // namespace pantin
