// SPDX-License-Identifier: MIT
// The first bytes of a file in; what it is and a command of Debian that makes a PNG of it, out. (TIFF 6.0,
// section 2; ISO/IEC 14496-12, ftyp; ISO 32000-1, 7.5.2; SVG 1.1; ISO/IEC 18181-2; Adobe Photoshop File
// Formats.)
#include "image/other_formats.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "core/shell_word.hpp"

namespace pantin {

namespace {

using namespace std::string_view_literals;

struct OtherFormat {
    std::string_view what, command; // IN, OUT: the files; STEM: OUT without its ending; [0]: its first layer
};

// The kind of an ISO media file: the major brand, or one of those it is compatible with.
bool has_brand(ByteView bytes, std::string_view brand) {
    if (!has_at(bytes, 4, "ftyp")) return false;
    const std::size_t end = std::min<std::size_t>(bytes.size(), big_endian_32(bytes, 0));
    for (std::size_t at = 8; at + 4 <= end; at += 4)
        if (at != 12 && has_at(bytes, at, brand)) return true;
    return false;
}

bool is_svg(ByteView bytes) {
    const ByteView start = bytes.first(std::min<std::size_t>(bytes.size(), 4096));
    const std::string_view text(reinterpret_cast<const char*>(start.data()), start.size());
    const std::size_t first = text.find_first_not_of("\xef\xbb\xbf \t\r\n");
    return first != std::string_view::npos && text[first] == '<' &&
           text.find("<svg") != std::string_view::npos;
}

OtherFormat format_of(ByteView bytes) {
    const auto begins = [&](std::string_view text) { return has_at(bytes, 0, text); };
    if (begins("II*\0"sv) || begins("MM\0*"sv) || begins("II+\0"sv) || begins("MM\0+"sv))
        return {"a TIFF image", "convert IN OUT"};
    if (has_brand(bytes, "avif") || has_brand(bytes, "avis")) return {"an AVIF image", "avifdec IN OUT"};
    for (const std::string_view brand : {"heic", "heix", "heim", "heis", "hevc", "mif1", "msf1"})
        if (has_brand(bytes, brand)) return {"a HEIC image", "heif-convert IN OUT"};
    if (begins("%PDF-")) return {"a PDF document", "pdftoppm -r 150 -png IN STEM"};
    if (is_svg(bytes)) return {"an SVG drawing", "rsvg-convert -b white -o OUT IN"};
    if (begins("\xff\x0a") || begins("\0\0\0\x0cJXL \r\n\x87\n"sv)) return {"a JPEG XL image", "djxl IN OUT"};
    if (begins("8BPS")) return {"a Photoshop document", "convert IN[0] OUT"};
    return {};
}

} // namespace

std::string convert_it(const std::string& command, const std::string& file) {
    std::filesystem::path stem = std::filesystem::path(file).replace_extension();
    if (std::filesystem::path(file).extension() == ".png") stem += "-converted"; // its name is not what it is
    std::string line = "convert it:";
    std::istringstream words(command);
    for (std::string word; words >> word;) {
        if (word == "IN") word = shell_word(file);
        if (word == "IN[0]") word = shell_word(file + "[0]");
        if (word == "OUT") word = shell_word(stem.string() + ".png");
        if (word == "STEM") word = shell_word(stem.string());
        line += " " + word;
    }
    return line;
}

std::string other_format(ByteView bytes, const std::string& file) {
    const OtherFormat format = format_of(bytes);
    if (format.what.empty()) return "";
    const std::string animates = // vector drawings have a command of their own
        format.what == "an SVG drawing"
            ? "pantin model " + shell_word(file) + " -o DIR --animate moves it, or "
            : "";
    return "is " + std::string(format.what) + ", which is not read; " + animates +
           convert_it(std::string(format.command), file);
}

} // namespace pantin
