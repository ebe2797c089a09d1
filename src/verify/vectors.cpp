// SPDX-License-Identifier: MIT
// The compiled-in archive in, its files out: gzip (RFC 1952; inflated by stb_image) and tar (POSIX ustar).
#include "verify/vectors.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "core/resources.hpp"
#include "pantin/error.hpp"

// Of stb_image (Sean Barrett, public domain) the inflater alone; it decodes one format so that it compiles.
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_SIMD
#define STBI_NO_STDIO
#include <stb/stb_image.h>

namespace pantin {

namespace {

constexpr std::size_t block = 512;
constexpr const char* archive = "vectors.tar.gz";

[[noreturn]] void damaged() {
    throw Error(ErrorKind::internal, std::string(archive) + " (compiled in) is damaged");
}

struct FreeBytes {
    void operator()(char* bytes) const { std::free(bytes); }
};

// One member without optional fields, as `gzip -n` writes it: ten bytes of header, eight of checksum and
// length.
std::string gunzip(std::span<const unsigned char> bytes) {
    constexpr std::size_t header = 10, trailer = 8;
    if (bytes.size() < header + trailer || bytes[0] != 0x1f || bytes[1] != 0x8b || bytes[2] != 8 ||
        bytes[3] != 0)
        damaged();
    const auto* deflated = reinterpret_cast<const char*>(bytes.data()) + header;
    int length = 0;
    // The trailer is given, too: the inflater of stb_image 2.27 gives up when the input ends within 16 bits
    // before the last code does, and stops by itself at the end of the last block.
    const std::unique_ptr<char, FreeBytes> inflated(
        stbi_zlib_decode_noheader_malloc(deflated, static_cast<int>(bytes.size() - header), &length));
    if (!inflated) damaged();
    return std::string(inflated.get(), static_cast<std::size_t>(length));
}

// A field of a header: text up to the first zero.
std::string_view field(std::string_view header, std::size_t at, std::size_t length) {
    const std::string_view text = header.substr(at, length);
    return text.substr(0, text.find('\0'));
}

std::size_t octal(std::string_view digits) {
    std::size_t value = 0;
    if (std::from_chars(digits.data(), digits.data() + digits.size(), value, 8).ec != std::errc()) damaged();
    return value;
}

} // namespace

Files read_archive(std::span<const unsigned char> bytes) {
    const std::string tar = gunzip(bytes);
    Files files;
    for (std::size_t at = 0; at + block <= tar.size();) {
        const std::string_view header(tar.data() + at, block);
        const std::string_view name = field(header, 0, 100), prefix = field(header, 345, 155);
        if (name.empty()) break; // two blocks of zeros close the archive
        const std::size_t size = octal(field(header, 124, 12));
        at += block;
        if (size > tar.size() - at) damaged();
        if (header[156] == '0')
            files[(prefix.empty() ? "" : std::string(prefix) + "/") + std::string(name)] =
                tar.substr(at, size);
        at += (size + block - 1) / block * block;
    }
    return files;
}

Files stored_vectors() {
    constexpr std::string_view folder = "vectors/";
    Files files;
    for (auto& [name, bytes] : read_archive(find_resource(archive)))
        if (name.starts_with(folder)) files[name.substr(folder.size())] = std::move(bytes);
    return files;
}

} // namespace pantin
