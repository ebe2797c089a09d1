// SPDX-License-Identifier: MIT
// Animated WebP, lossless or lossy, with alpha (libwebp's WebPAnimEncoder).
#include "pantin/export.hpp"

#include <memory>

#include <webp/encode.h>
#include <webp/mux.h>

#include "export/frame_times.hpp"
#include "pantin/error.hpp"

namespace pantin {

namespace {

struct EncoderCloser {
    void operator()(WebPAnimEncoder* encoder) const { WebPAnimEncoderDelete(encoder); }
};
using Encoder = std::unique_ptr<WebPAnimEncoder, EncoderCloser>;

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

WebPConfig lossless_config() {
    WebPConfig config;
    if (!WebPConfigInit(&config)) fail("the library's version differs");
    config.lossless = 1;
    config.exact = 1; // colours below alpha 0 stay: we set them to 0 ourselves
    config.method = 0;
    config.quality = 0; // effort, not loss
    config.thread_level = 0;
    return config;
}

// Colours that nobody sees are set to 0, so that decoded pixels are one and the same for every encoder.
void import_frame(const RgbaImage& frame, Picture& picture) {
    picture.data.use_argb = 1;
    picture.data.width = frame.width();
    picture.data.height = frame.height();
    if (!WebPPictureAlloc(&picture.data)) throw std::bad_alloc();
    for (int y = 0; y < frame.height(); ++y)
        for (int x = 0; x < frame.width(); ++x) {
            const Rgba8 c = frame(x, y);
            const auto argb = static_cast<std::uint32_t>(c.a) << 24 | static_cast<std::uint32_t>(c.r) << 16 |
                              static_cast<std::uint32_t>(c.g) << 8 | static_cast<std::uint32_t>(c.b);
            picture.data.argb[static_cast<std::ptrdiff_t>(y) * picture.data.argb_stride + x] =
                c.a == 0 ? 0 : argb;
        }
}

} // namespace

bool webp_available() { return true; }

std::vector<unsigned char> encode_webp(const std::vector<RgbaImage>& frames, double fps,
                                       std::optional<int> quality) {
    if (frames.empty()) throw Error(ErrorKind::internal, "an animation without frames");
    WebPAnimEncoderOptions options;
    if (!WebPAnimEncoderOptionsInit(&options)) fail("the library's version differs");
    options.anim_params.loop_count = 0; // for ever
    options.anim_params.bgcolor = 0;
    const Encoder encoder(WebPAnimEncoderNew(frames[0].width(), frames[0].height(), &options));
    if (!encoder) fail("cannot make frames of this size");
    const WebPConfig config = quality ? lossy_config(*quality) : lossless_config();
    for (std::size_t i = 0; i < frames.size(); ++i) {
        Picture picture;
        import_frame(frames[i], picture);
        if (!WebPAnimEncoderAdd(encoder.get(), &picture.data, milliseconds(i, fps), &config))
            fail(WebPAnimEncoderGetError(encoder.get()));
    }
    WebPData data;
    WebPDataInit(&data);
    if (!WebPAnimEncoderAdd(encoder.get(), nullptr, milliseconds(frames.size(), fps), nullptr) ||
        !WebPAnimEncoderAssemble(encoder.get(), &data))
        fail(WebPAnimEncoderGetError(encoder.get()));
    std::vector<unsigned char> bytes(data.bytes, data.bytes + data.size);
    WebPDataClear(&data);
    return bytes;
}

} // namespace pantin
