// SPDX-License-Identifier: MIT
// A 64-bit digest of results (FNV-1a: Fowler, Noll, Vo). It finds differences; it is no protection against
// forgery.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

#include "pantin/grid.hpp"

namespace pantin {

class Digest {
public:
    void add(const void* data, std::size_t size) {
        const auto* bytes = static_cast<const unsigned char*>(data);
        for (std::size_t i = 0; i < size; ++i) hash_ = (hash_ ^ bytes[i]) * 0x100000001b3u;
    }
    void add(std::string_view text) { add(text.data(), text.size()); }
    void add(int number) { add(std::to_string(number) + ";"); }
    template <class Pixel> void add(const Grid<Pixel>& image) {
        add(image.width());
        add(image.height());
        add(image.data(), image.size() * sizeof(Pixel));
    }
    // 16 hexadecimal digits.
    std::string text() const {
        char digits[17];
        std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash_));
        return digits;
    }

private:
    std::uint64_t hash_ = 0xcbf29ce484222325u;
};

} // namespace pantin
