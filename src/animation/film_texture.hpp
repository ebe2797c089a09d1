// SPDX-License-Identifier: MIT
// The drawing as the rasteriser reads it: colours filtered to the width of a pixel, so that one lookup is the
// mean of the pixel's samples, and opacity apart from them, so that most pixels need no test of their
// samples.
#pragma once

#include <algorithm>
#include <cstdint>

#include "pantin/grid.hpp"

namespace pantin {

// A place in the texture: 1/256 texels from the centre of the first texel.
struct TexturePoint {
    int x = 0, y = 0;
};
inline TexturePoint operator+(TexturePoint a, TexturePoint b) { return {a.x + b.x, a.y + b.y}; }

class FilmTexture {
public:
    enum class Opacity : std::uint8_t { none, mixed, full };

    // `pixels`: of the frame, to the texture's height at rest; `samples` of a pixel, per axis; `perspective`:
    // of the camera.
    FilmTexture(RgbaImage texture, double pixels, int samples, bool perspective);

    int width() const { return width_; }
    int height() const { return height_; }

    // Texels that the place may change by, along u or v, over a pixel's width and height together, for one
    // lookup to stand for all samples of the pixel.
    double longest_step() const { return longest_step_; }

    // The place at (x, y) texels, at the border where that is outside.
    TexturePoint place(double x, double y) const {
        return {static_cast<int>(std::clamp(x, 0.0, width_ - 1.0) * 256 + 0.5),
                static_cast<int>(std::clamp(y, 0.0, height_ - 1.0) * 256 + 0.5)};
    }

    // What loops read by, a copy of their own, which stays in registers. Valid as long as the texture.
    class Reader {
    public:
        // The opacity of all places within the reach of a pixel around this one.
        Opacity opacity(TexturePoint p) const { return opacities_[index_of(p)]; }

        // Bilinear alpha of at least one half, unfiltered; also of places within the reach of a pixel.
        bool opaque(TexturePoint p) const {
            const auto tx = static_cast<std::uint32_t>(p.x & 255), ty = static_cast<std::uint32_t>(p.y & 255);
            const std::uint32_t four = alphas_[index_of(p)];
            const std::uint32_t rows = (256 - tx) * (four & 0xff00ffu) + tx * (four >> 8 & 0xff00ffu);
            const std::uint32_t sum = (256 - ty) * (rows & 0xffffu) + ty * (rows >> 16);
            return sum >= 128 * 65536 - 32768; // 128 when rounded
        }

        // Bilinear and filtered. The four weights are whole 256ths and add up to 256, so that three channels,
        // 16 bits apart, share each product.
        Rgb8 colour(TexturePoint p) const {
            const std::uint64_t *top = colours_ + index_of(p), *bottom = top + stride_;
            const int tx = p.x & 255, ty = p.y & 255, both = (tx * ty + 128) >> 8;
            const std::uint64_t sum = weight(256 - tx - ty + both) * top[0] + weight(tx - both) * top[1] +
                                      weight(ty - both) * bottom[0] + weight(both) * bottom[1] +
                                      0x0000008000800080u;
            return {channel(sum, 0), channel(sum, 1), channel(sum, 2)};
        }

    private:
        friend class FilmTexture;
        std::ptrdiff_t index_of(TexturePoint p) const { return (p.y >> 8) * stride_ + (p.x >> 8); }
        static std::uint64_t weight(int value) { return static_cast<std::uint64_t>(value); }
        static std::uint8_t channel(std::uint64_t sum, int i) {
            return static_cast<std::uint8_t>(sum >> (16 * i + 8));
        }
        const std::uint64_t* colours_ = nullptr;
        const std::uint32_t* alphas_ = nullptr;
        const Opacity* opacities_ = nullptr;
        std::ptrdiff_t stride_ = 0;
    };
    Reader reader() const {
        Reader reader;
        reader.colours_ = colours_.data() + first_, reader.alphas_ = alphas_.data() + first_;
        reader.opacities_ = opacities_.data() + first_, reader.stride_ = stride_;
        return reader;
    }

private:
    int width_ = 0, height_ = 0;
    double longest_step_ = 1;
    // All of them have a margin, where the border's texels go on, so that every place within a pixel's reach
    // has four texels.
    std::ptrdiff_t stride_ = 0, first_ = 0;
    std::vector<std::uint64_t> colours_; // red, green, blue, 16 bits each
    std::vector<std::uint32_t> alphas_;  // of the texel, its right neighbour and those below, 8 bits each
    std::vector<Opacity> opacities_;
};

} // namespace pantin
