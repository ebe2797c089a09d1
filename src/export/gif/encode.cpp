// SPDX-License-Identifier: MIT
// Animated GIF with transparency (giflib writes the LZW stream).
//
// Delays are whole hundredths of a second, and players slow down below 2/100 s. So the file runs at the legal
// rate 100/n next to the wanted one, n ≥ 2, and the frames are resampled to it; the length of the loop is
// kept to within half a frame. Pixels are transparent or opaque: the drawn colour where alpha ≥ ½.
#include "pantin/export.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <gif_lib.h>

#include "core/thread_pool.hpp"
#include "export/palette.hpp"
#include "pantin/error.hpp"
#include "pantin/point.hpp"

namespace pantin {

namespace {

int append_bytes(GifFileType* file, const GifByteType* bytes, int count) {
    auto& out = *static_cast<std::vector<unsigned char>*>(file->UserData);
    out.insert(out.end(), bytes, bytes + count);
    return count;
}

struct MapFree {
    void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};
using ColourMap = std::unique_ptr<ColorMapObject, MapFree>;

class GifWriter {
public:
    GifWriter(std::vector<unsigned char>& out, int width, int height, const ColorMapObject* map) {
        int error = 0;
        file_ = EGifOpen(&out, append_bytes, &error);
        if (!file_) throw Error(ErrorKind::internal, "giflib: cannot start a file");
        EGifSetGifVersion(file_, true);
        check(EGifPutScreenDesc(file_, width, height, 8, transparent_index, map));
        loop_for_ever();
    }
    ~GifWriter() {
        int error = 0;
        if (file_) EGifCloseFile(file_, &error);
    }
    GifWriter(const GifWriter&) = delete;
    GifWriter& operator=(const GifWriter&) = delete;

    static constexpr int transparent_index = 0;

    // `rows` holds the palette indices of the box, row by row.
    void add(Box box, std::vector<GifByteType>& rows, int delay) {
        const GraphicsControlBlock control{DISPOSE_BACKGROUND, false, delay, transparent_index};
        GifByteType bytes[4];
        EGifGCBToExtension(&control, bytes);
        check(EGifPutExtension(file_, GRAPHICS_EXT_FUNC_CODE, sizeof bytes, bytes));
        check(EGifPutImageDesc(file_, box.x, box.y, box.width, box.height, false, nullptr));
        for (int y = 0; y < box.height; ++y)
            check(EGifPutLine(file_, rows.data() + static_cast<std::ptrdiff_t>(y) * box.width, box.width));
    }

    void close() {
        int error = 0;
        GifFileType* file = std::exchange(file_, nullptr);
        check(EGifCloseFile(file, &error));
    }

private:
    GifFileType* file_ = nullptr;

    static void check(int status) {
        if (status == GIF_ERROR) throw Error(ErrorKind::internal, "giflib: cannot write a frame");
    }
    void loop_for_ever() {
        const unsigned char forever[3] = {1, 0, 0};
        check(EGifPutExtensionLeader(file_, APPLICATION_EXT_FUNC_CODE));
        check(EGifPutExtensionBlock(file_, 11, "NETSCAPE2.0"));
        check(EGifPutExtensionBlock(file_, sizeof forever, forever));
        check(EGifPutExtensionTrailer(file_));
    }
};

// Transparent first, then the colours, filled up to a power of two as the format wants.
ColourMap make_colour_map(const Palette& palette) {
    std::vector<GifColorType> entries{{0, 0, 0}};
    for (const Rgb8 c : palette.colours()) entries.push_back({c.r, c.g, c.b});
    std::size_t size = 2;
    while (size < entries.size()) size *= 2;
    entries.resize(size, {0, 0, 0});
    ColourMap map(GifMakeMapObject(static_cast<int>(size), entries.data()));
    if (!map) throw std::bad_alloc();
    return map;
}

// The box of the opaque pixels; one transparent pixel when there is none.
Box opaque_box(const RgbaImage& frame) {
    int left = frame.width(), top = frame.height(), right = -1, bottom = -1;
    for (int y = 0; y < frame.height(); ++y)
        for (int x = 0; x < frame.width(); ++x) {
            if (frame(x, y).a < opaque_alpha) continue;
            left = std::min(left, x);
            right = std::max(right, x);
            top = std::min(top, y);
            bottom = std::max(bottom, y);
        }
    return right < 0 ? Box{0, 0, 1, 1} : Box{left, top, right - left + 1, bottom - top + 1};
}

struct IndexedFrame {
    Box box;
    std::vector<GifByteType> rows; // palette indices of the box, row by row
};

IndexedFrame indexed_frame(const RgbaImage& frame, const Palette& palette) {
    const Box box = opaque_box(frame);
    std::vector<GifByteType> rows;
    rows.reserve(static_cast<std::size_t>(box.width) * static_cast<std::size_t>(box.height));
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) {
            const Rgba8 c = frame(x, y);
            rows.push_back(c.a < opaque_alpha ? GifWriter::transparent_index
                                              : static_cast<GifByteType>(palette.index_of(c) + 1));
        }
    return {box, std::move(rows)};
}

} // namespace

bool gif_available() { return true; }

std::vector<unsigned char> encode_gif(const std::vector<RgbaImage>& frames, double fps, int threads) {
    if (frames.empty()) throw Error(ErrorKind::internal, "an animation without frames");
    const int delay = std::max(2, static_cast<int>(std::rint(100 / fps)));
    const double length = 100.0 * static_cast<double>(frames.size()) / fps; // of the loop, in 1/100 s
    const int count = std::max(1, static_cast<int>(std::rint(length / delay)));

    const Palette palette(frames, 255);
    const ColourMap map = make_colour_map(palette);
    std::vector<unsigned char> bytes;
    GifWriter writer(bytes, frames[0].width(), frames[0].height(), map.get());
    std::vector<IndexedFrame> indexed(frames.size());
    parallel_for(threads, static_cast<int>(frames.size()), [&](int frame) {
        const auto i = static_cast<std::size_t>(frame);
        indexed[i] = indexed_frame(frames[i], palette);
    });
    for (int i = 0; i < count; ++i) {
        // The frame shown at this time, counted in whole frames to keep clear of rounding.
        const auto shown = static_cast<std::size_t>(i) * frames.size() / static_cast<std::size_t>(count);
        writer.add(indexed[shown].box, indexed[shown].rows, delay);
    }
    writer.close();
    return bytes;
}

} // namespace pantin
