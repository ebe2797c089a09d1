// SPDX-License-Identifier: MIT
// Animated WebP, lossless or lossy, with alpha: each frame is encoded by itself, as what it changes of the
// one before (libwebp), and they are put together (libwebpmux); so threads can share them out.
#include "pantin/export.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include <webp/encode.h>
#include <webp/mux.h>

#include "core/thread_pool.hpp"
#include "export/frame_times.hpp"
#include "pantin/error.hpp"
#include "pantin/point.hpp"

namespace pantin {

namespace {

struct Picture {
    WebPPicture data;
    Picture() {
        if (!WebPPictureInit(&data))
            throw Error(ErrorKind::internal, "libwebp: the library's version differs");
    }
    ~Picture() { WebPPictureFree(&data); }
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;
};

[[noreturn]] void fail(const std::string& what) { throw Error(ErrorKind::internal, "libwebp: " + what); }

// Colours are lossy, alpha is not: an edge that is not quite opaque shows on every background.
WebPConfig lossy_config(int quality) {
    WebPConfig config;
    if (!WebPConfigInit(&config)) fail("the library's version differs");
    config.quality = static_cast<float>(quality);
    config.alpha_quality = 100;
    config.thread_level = 0;
    return config;
}

// Method and quality are the effort here, not loss. More of either hardly makes the files smaller (humanoid,
// walk, 25 frames of 512 pixels): 0, 0: 977 KB in 0.12 s; 1, 0: 895 KB, 0.15 s; 1, 50: 684 KB, 0.25 s;
// 2, 50: 684 KB, 0.37 s; 4, 75: 683 KB, 1.3 s; 6, 100: 649 KB, 29 s.
WebPConfig lossless_config() {
    WebPConfig config;
    if (!WebPConfigInit(&config)) fail("the library's version differs");
    config.lossless = 1;
    config.exact = 1; // colours below alpha 0 stay: we set them to 0 ourselves
    config.method = 1;
    config.quality = 50;
    config.thread_level = 0;
    return config;
}

// What a frame changes of the one before it: a box, and what is in it.
struct Change {
    Box box;                // its left upper corner even, as the format wants it
    bool blend = false;     // pixels that stay are left out, alpha 0
    int begin = 0, end = 0; // when it is shown, milliseconds
    std::vector<unsigned char> bytes;
};

// Colours that nobody sees are set to 0, so that decoded pixels are one and the same for every encoder.
Rgba8 visible(Rgba8 p) { return p.a == 0 ? Rgba8{} : p; }

// The changed pixels' box, empty when there are none. Where all of them are opaque, they can be put over the
// frame before, whose pixels show through the others: a third less for a figure on a page, but more when the
// colours are lossy, which holes between them cost dearly.
Change change_between(const RgbaImage& before, const RgbaImage& frame, bool lossless) {
    int left = frame.width(), top = frame.height(), right = 0, bottom = 0;
    bool blend = lossless;
    for (int y = 0; y < frame.height(); ++y) {
        const Rgba8 *p = frame.row(y), *q = before.row(y);
        for (int x = 0; x < frame.width(); ++x) {
            if (p[x] == q[x] || visible(p[x]) == visible(q[x])) continue;
            left = std::min(left, x), right = std::max(right, x + 1);
            top = std::min(top, y), bottom = y + 1;
            blend = blend && p[x].a == 255;
        }
    }
    if (right <= left) return {};
    left -= left % 2, top -= top % 2;
    return {{left, top, right - left, bottom - top}, blend, 0, 0, {}};
}

void import_change(const RgbaImage& before, const RgbaImage& frame, const Change& change, Picture& picture) {
    picture.data.use_argb = 1;
    picture.data.width = change.box.width;
    picture.data.height = change.box.height;
    if (!WebPPictureAlloc(&picture.data)) throw std::bad_alloc();
    for (int y = 0; y < change.box.height; ++y) {
        const Rgba8 *p = frame.row(change.box.y + y) + change.box.x,
                    *q = before.row(change.box.y + y) + change.box.x;
        std::uint32_t* out = picture.data.argb + static_cast<std::ptrdiff_t>(y) * picture.data.argb_stride;
        for (int x = 0; x < change.box.width; ++x) {
            const Rgba8 c = change.blend && p[x] == q[x] ? Rgba8{} : visible(p[x]);
            out[x] = static_cast<std::uint32_t>(c.a) << 24 | static_cast<std::uint32_t>(c.r) << 16 |
                     static_cast<std::uint32_t>(c.g) << 8 | static_cast<std::uint32_t>(c.b);
        }
    }
}

struct MemoryWriter {
    WebPMemoryWriter data;
    MemoryWriter() { WebPMemoryWriterInit(&data); }
    ~MemoryWriter() { WebPMemoryWriterClear(&data); }
    MemoryWriter(const MemoryWriter&) = delete;
    MemoryWriter& operator=(const MemoryWriter&) = delete;
};

std::vector<unsigned char> encoded(const RgbaImage& before, const RgbaImage& frame, const Change& change,
                                   const WebPConfig& config) {
    Picture picture;
    import_change(before, frame, change, picture);
    MemoryWriter writer;
    picture.data.writer = WebPMemoryWrite;
    picture.data.custom_ptr = &writer.data;
    if (!WebPEncode(&config, &picture.data))
        fail("error " + std::to_string(static_cast<int>(picture.data.error_code)));
    return {writer.data.mem, writer.data.mem + writer.data.size};
}

struct MuxDeleter {
    void operator()(WebPMux* mux) const { WebPMuxDelete(mux); }
};

std::vector<unsigned char> assembled(const std::vector<Change>& changes, int width, int height) {
    const std::unique_ptr<WebPMux, MuxDeleter> mux(WebPMuxNew());
    const auto check = [](WebPMuxError error) {
        if (error != WEBP_MUX_OK) fail("error " + std::to_string(static_cast<int>(error)));
    };
    for (const Change& change : changes) {
        WebPMuxFrameInfo info{};
        info.bitstream = {change.bytes.data(), change.bytes.size()};
        info.x_offset = change.box.x, info.y_offset = change.box.y;
        info.duration = change.end - change.begin;
        info.id = WEBP_CHUNK_ANMF;
        info.dispose_method = WEBP_MUX_DISPOSE_NONE;
        info.blend_method = change.blend ? WEBP_MUX_BLEND : WEBP_MUX_NO_BLEND;
        check(WebPMuxPushFrame(mux.get(), &info, 0));
    }
    const WebPMuxAnimParams params{0, 0}; // background; loops for ever
    check(WebPMuxSetAnimationParams(mux.get(), &params));
    check(WebPMuxSetCanvasSize(mux.get(), width, height));
    WebPData data;
    WebPDataInit(&data);
    check(WebPMuxAssemble(mux.get(), &data));
    std::vector<unsigned char> bytes(data.bytes, data.bytes + data.size);
    WebPDataClear(&data);
    return bytes;
}

} // namespace

bool webp_available() { return true; }

std::vector<unsigned char> encode_webp(const std::vector<RgbaImage>& frames, double fps,
                                       std::optional<int> quality, int threads) {
    if (frames.empty()) throw Error(ErrorKind::internal, "an animation without frames");
    const RgbaImage empty(frames[0].width(), frames[0].height());
    const auto before = [&](std::size_t i) -> const RgbaImage& { return i == 0 ? empty : frames[i - 1]; };
    const WebPConfig config = quality ? lossy_config(*quality) : lossless_config();
    std::vector<Change> changes(frames.size());
    parallel_for(threads, static_cast<int>(frames.size()), [&](int frame) {
        const auto i = static_cast<std::size_t>(frame);
        Change change = change_between(before(i), frames[i], !quality);
        change.begin = milliseconds(i, fps), change.end = milliseconds(i + 1, fps);
        if (i == 0 && change.box.width == 0) change.box = {0, 0, 1, 1};
        if (change.box.width > 0) change.bytes = encoded(before(i), frames[i], change, config);
        changes[i] = std::move(change);
    });
    // A frame that changes nothing: the one before it is shown for longer. When that is all, it is a picture.
    std::vector<Change> shown;
    for (Change& change : changes)
        if (change.bytes.empty())
            shown.back().end = change.end;
        else
            shown.push_back(std::move(change));
    if (shown.size() == 1) {
        const Change whole{{0, 0, empty.width(), empty.height()}, false, 0, 0, {}};
        return encoded(empty, frames[0], whole, config);
    }
    return assembled(shown, empty.width(), empty.height());
}

} // namespace pantin
