// SPDX-License-Identifier: MIT
// This work is based on: Loren Carpenter, The A-buffer, an antialiased hidden surface method, 1984.
// What is seen of a pixel is a list of fragments: a face and the samples of the pixel that it is seen in.
// Most pixels have one fragment; those that an outline crosses have some more.
#pragma once

#include <cstdint>
#include <vector>

#include "animation/film_texture.hpp"
#include "pantin/grid.hpp"

namespace pantin {

constexpr int most_samples = 5; // of a pixel, per axis: a mask has a bit for each

using SampleMask = std::uint32_t; // of sample (i, j) of a pixel the bit j · samples + i

struct Fragment {
    SampleMask samples = 0; // 0: nothing
    int face = 0;
    int next = -1;           // of the same pixel
    TexturePoint place = {}; // of the pixel's middle; x is -1 where that does not stand for all samples

    bool even() const { return place.x >= 0; }
};

// A band of a frame's pixel rows. The fragments of a pixel have no sample in common.
class FragmentBuffer {
public:
    FragmentBuffer(int width, int rows) : pixels_(width, rows) {}

    Fragment* row(int y) { return pixels_.row(y); } // the first fragment of each pixel

    // The face takes these samples, not all of the pixel's, from all other fragments.
    void put(Fragment& pixel, const Fragment& fragment) {
        Fragment* free = nullptr;
        for (Fragment* f = &pixel; f; f = next(*f)) {
            f->samples &= ~fragment.samples;
            if (f->samples == 0 && !free) free = f; // the first of the list is never left empty
        }
        if (free) {
            const int next = free->next;
            *free = fragment;
            free->next = next;
            return;
        }
        more_.push_back(fragment);
        more_.back().next = pixel.next;
        pixel.next = static_cast<int>(more_.size()) - 1;
    }

    const Fragment* next(const Fragment& f) const { return f.next < 0 ? nullptr : &more_[index(f)]; }
    Fragment* next(const Fragment& f) { return f.next < 0 ? nullptr : &more_[index(f)]; }

    // After the rows have been emptied.
    void forget_lists() { more_.clear(); }

private:
    static std::size_t index(const Fragment& f) { return static_cast<std::size_t>(f.next); }

    Grid<Fragment> pixels_;
    std::vector<Fragment> more_;
};

} // namespace pantin
