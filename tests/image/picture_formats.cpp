// SPDX-License-Identifier: MIT
// GIF, BMP and WebP pages, whole and damaged; EXIF orientation of PNG and WebP; what is said of other
// formats.
#include <catch2/catch.hpp>

#include <map>

#include "image/webp.hpp"
#include "image_files.hpp"
#include "pantin/export.hpp"
#include "pantin/image.hpp"

using namespace pantin;
using namespace pantin::test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;

namespace {

// "no error", or the one line that is said.
std::string message_of(const Bytes& bytes, const std::string& name = "page") {
    try {
        decode_image(bytes, name);
    } catch (const Error& error) {
        const std::string message = error.what();
        CHECK(error.kind() == ErrorKind::input);
        CHECK(message.find('\n') == std::string::npos);
        CHECK(message.starts_with(name + ": "));
        return message;
    }
    return "no error";
}

Bytes text(const std::string& characters) { return Bytes(characters.begin(), characters.end()); }
void put(Bytes& to, std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i) to.push_back(static_cast<unsigned char>(value >> (8 * i)));
}

// Every cut of the file is an error; every changed byte is one or a picture of the same size or less.
void check_damaged(const Bytes& whole) {
    REQUIRE(message_of(whole) == "no error");
    for (std::size_t n = 1; n < whole.size(); n += n < 128 ? 1 : 5) {
        INFO("first " << n << " of " << whole.size() << " bytes");
        CHECK(message_of(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(n))) != "no error");
    }
    for (std::size_t i = 0; i < whole.size(); i += i < 128 ? 1 : 3)
        for (const unsigned char value : {0x00, 0x01, 0x7f, 0x80, 0xff}) {
            Bytes damaged = whole;
            damaged[i] = value;
            CHECK(!message_of(damaged).empty());
        }
}

// --- GIF ---------------------------------------------------------------------------------------------------

struct GifPage {
    int width = 20, height = 17; // the frame, at (left, top)
    int left = 0, top = 0, screen_width = 20, screen_height = 17;
    bool interlaced = false;
    int transparent = -1;
    int background = 0;
    Bytes numbers; // of 8 colours, row by row
};

// The colours of all these pages.
Rgb8 gif_colour(int number) {
    return {static_cast<std::uint8_t>(30 * number), static_cast<std::uint8_t>(255 - 20 * number),
            static_cast<std::uint8_t>(number == 3 ? 200 : 10)};
}

// LZW of 3-bit numbers with a dictionary of strings, unlike the program's. The blocks hold 255 bytes each.
Bytes gif_data(const Bytes& numbers) {
    Bytes packed;
    std::uint32_t bits = 0, held = 0, width = 4;
    const auto code = [&](std::uint32_t value) {
        bits |= value << held;
        for (held += width; held >= 8; held -= 8, bits >>= 8)
            packed.push_back(static_cast<unsigned char>(bits));
    };
    std::map<std::string, std::uint32_t> known;
    const auto clear = [&] {
        code(8);
        known.clear();
        for (std::uint32_t i = 0; i < 8; ++i) known[std::string(1, static_cast<char>(i))] = i;
        width = 4;
    };
    clear();
    std::uint32_t next = 10;
    std::string current;
    for (const unsigned char number : numbers) {
        const std::string longer = current + static_cast<char>(number);
        if (known.contains(longer)) {
            current = longer;
            continue;
        }
        code(known[current]);
        if (next == 4096) {
            clear();
            next = 10;
        } else {
            if (next == 1u << width) ++width;
            known[longer] = next++;
        }
        current = std::string(1, static_cast<char>(number));
    }
    code(known[current]);
    if (next == 1u << width && width < 12) ++width;
    code(9);
    if (held > 0) packed.push_back(static_cast<unsigned char>(bits));
    Bytes out{3};
    for (std::size_t at = 0; at < packed.size(); at += 255) {
        const std::size_t n = std::min<std::size_t>(255, packed.size() - at);
        out.push_back(static_cast<unsigned char>(n));
        out.insert(out.end(), packed.begin() + static_cast<std::ptrdiff_t>(at),
                   packed.begin() + static_cast<std::ptrdiff_t>(at + n));
    }
    out.push_back(0);
    return out;
}

Bytes gif_frame(const GifPage& page) {
    Bytes out;
    append(out, {0x21, 0xf9, 4, static_cast<unsigned char>(page.transparent >= 0 ? 1 : 0), 0, 0,
                 static_cast<unsigned char>(std::max(page.transparent, 0)), 0, 0x2c});
    for (const int value : {page.left, page.top, page.width, page.height})
        put(out, static_cast<std::uint32_t>(value), 2);
    out.push_back(page.interlaced ? 0x40 : 0);
    Bytes stored;
    const std::vector<std::pair<int, int>> passes =
        page.interlaced ? std::vector<std::pair<int, int>>{{0, 8}, {4, 8}, {2, 4}, {1, 2}}
                        : std::vector<std::pair<int, int>>{{0, 1}};
    for (const auto& [start, step] : passes)
        for (int row = start; row < page.height; row += step)
            stored.insert(stored.end(), page.numbers.begin() + row * page.width,
                          page.numbers.begin() + (row + 1) * page.width);
    append(out, gif_data(stored));
    return out;
}

Bytes make_gif(const GifPage& page) {
    Bytes out = text("GIF89a");
    put(out, static_cast<std::uint32_t>(page.screen_width), 2);
    put(out, static_cast<std::uint32_t>(page.screen_height), 2);
    append(out, {0x82, static_cast<unsigned char>(page.background), 0});
    for (int i = 0; i < 8; ++i) append(out, {gif_colour(i).r, gif_colour(i).g, gif_colour(i).b});
    append(out, gif_frame(page));
    out.push_back(0x3b);
    return out;
}

GifPage gif_page(int width, int height) {
    GifPage page;
    page.width = page.screen_width = width;
    page.height = page.screen_height = height;
    std::uint32_t state = 1;
    for (int i = 0; i < width * height; ++i) {
        state = state * 1664525u + 1013904223u;
        page.numbers.push_back(i % 3 == 0 ? (state >> 24) % 8 : page.numbers.back());
    }
    return page;
}

RgbImage expected_of(const GifPage& page) {
    RgbImage image(page.screen_width, page.screen_height, Rgb8{255, 255, 255});
    for (int y = 0; y < page.height; ++y)
        for (int x = 0; x < page.width; ++x)
            if (const int number = page.numbers[static_cast<std::size_t>(y * page.width + x)];
                number != page.transparent)
                image(page.left + x, page.top + y) = gif_colour(number);
    return image;
}

// --- BMP ---------------------------------------------------------------------------------------------------

struct BmpPage {
    std::uint32_t header = 40, depth = 24, compression = 0, colours = 0;
    int width = 17, height = 16; // negative: top row first
    std::vector<std::uint32_t> masks;
    Bytes palette;
    std::vector<Bytes> rows; // as stored, without padding
};

Bytes make_bmp(const BmpPage& page) {
    Bytes body;
    put(body, page.header, 4);
    if (page.header == 12) {
        put(body, static_cast<std::uint32_t>(page.width), 2);
        put(body, static_cast<std::uint32_t>(page.height), 2);
        put(body, 1, 2), put(body, page.depth, 2);
    } else {
        put(body, static_cast<std::uint32_t>(page.width), 4);
        put(body, static_cast<std::uint32_t>(page.height), 4);
        put(body, 1, 2), put(body, page.depth, 2), put(body, page.compression, 4);
        put(body, 0, 4), put(body, 2835, 4), put(body, 2835, 4), put(body, page.colours, 4), put(body, 0, 4);
        for (const std::uint32_t mask : page.masks) put(body, mask, 4);
        if (body.size() < page.header) body.resize(page.header);
    }
    append(body, page.palette);
    const std::size_t offset = 14 + body.size();
    for (const Bytes& row : page.rows) {
        append(body, row);
        body.resize(body.size() + (4 - row.size() % 4) % 4);
    }
    Bytes out = text("BM");
    put(out, static_cast<std::uint32_t>(14 + body.size()), 4), put(out, 0, 4);
    put(out, static_cast<std::uint32_t>(offset), 4);
    append(out, body);
    return out;
}

BmpPage bmp_page(std::uint32_t depth, const Bytes& row) {
    BmpPage page;
    page.depth = depth;
    page.rows.assign(16, row);
    return page;
}

// --- WebP --------------------------------------------------------------------------------------------------

RgbaImage noise(int width, int height) {
    RgbaImage image(width, height);
    std::uint32_t state = 7;
    for (Rgba8& pixel : image) {
        state = state * 1664525u + 1013904223u;
        const auto value = static_cast<std::uint8_t>(state >> 24);
        pixel = {value, static_cast<std::uint8_t>(value / 2), 9, static_cast<std::uint8_t>(state >> 16 | 1)};
    }
    return image;
}

RgbImage over_white(const RgbaImage& image) { return decode_image(encode_png(image), "expected"); }

// Adds an EXIF chunk with that orientation; `named`: with the name of a JPEG's segment before it.
Bytes webp_turned(Bytes webp, int orientation, bool named) {
    Bytes exif = named ? Bytes{'E', 'x', 'i', 'f', 0, 0} : Bytes{};
    append(exif, {'I',
                  'I',
                  42,
                  0,
                  8,
                  0,
                  0,
                  0,
                  1,
                  0,
                  0x12,
                  1,
                  3,
                  0,
                  1,
                  0,
                  0,
                  0,
                  static_cast<unsigned char>(orientation),
                  0,
                  0,
                  0});
    append(webp, text("EXIF"));
    put(webp, static_cast<std::uint32_t>(exif.size()), 4);
    append(webp, exif);
    Bytes size;
    put(size, static_cast<std::uint32_t>(webp.size() - 8), 4);
    std::copy(size.begin(), size.end(), webp.begin() + 4);
    return webp;
}

} // namespace

TEST_CASE("A GIF page is read, interlaced or not, with the codes of any length", "[image]") {
    for (const auto& [width, height] : {std::pair{20, 17}, {16, 16}, {211, 160}})
        for (const bool interlaced : {false, true}) {
            GifPage page = gif_page(width, height);
            page.interlaced = interlaced;
            CHECK(decode_image(make_gif(page), "page.gif") == expected_of(page));
        }
    GifPage flat = gif_page(300, 300); // codes of long strings, each made of the one before
    flat.numbers.assign(flat.numbers.size(), 5);
    CHECK(decode_image(make_gif(flat), "page.gif") == expected_of(flat));
}

TEST_CASE("What a GIF's first picture does not cover, and its transparent colour, are white", "[image]") {
    GifPage page = gif_page(10, 9);
    page.screen_width = page.screen_height = 24;
    page.left = 5, page.top = 6;
    page.transparent = 3;
    page.background = 2; // which browsers ignore, too
    const Bytes gif = make_gif(page);
    CHECK(decode_image(gif, "page.gif") == expected_of(page));
    const TemporaryFolder folder;
    const RgbaImage image = load_rgba(folder.write("page.gif", gif));
    CHECK(image(0, 0).a == 0);
    for (int i = 0; i < 90; ++i)
        CHECK(image(5 + i % 10, 6 + i / 10).a == (page.numbers[static_cast<std::size_t>(i)] == 3 ? 0 : 255));
}

TEST_CASE("Of an animated GIF the first picture is read", "[image]") {
    GifPage page = gif_page(20, 17), second = page;
    second.numbers.assign(second.numbers.size(), 1);
    Bytes gif = make_gif(page);
    gif.pop_back();
    append(gif, gif_frame(second));
    gif.push_back(0x3b);
    CHECK(decode_image(gif, "page.gif") == expected_of(page));
}

TEST_CASE("Our own GIF films are read as pages", "[image][needs-gif]") {
    RgbaImage image(40, 30, Rgba8{0, 0, 0, 0});
    for (int i = 0; i < 30; ++i) image(i, i) = {200, 10, 30, 255};
    CHECK(decode_image(encode_gif({image, image}, 10), "film.gif") == over_white(image));
}

TEST_CASE("Truncated and damaged GIF files are one line", "[image]") {
    const Bytes whole = make_gif(gif_page(20, 17));
    check_damaged(whole);
    CHECK_THAT(message_of(Bytes(whole.begin(), whole.end() - 1)), Contains("the GIF ends early"));
    GifPage huge = gif_page(16, 16);
    huge.screen_width = 20000;
    CHECK_THAT(message_of(make_gif(huge)), Contains("20000x16") && Contains("16384"));
    GifPage outside = gif_page(16, 16);
    outside.left = 1;
    CHECK_THAT(message_of(make_gif(outside)), Contains("the GIF is damaged (its first picture)"));
    GifPage little = gif_page(16, 16);
    little.height = 15;
    Bytes fewer = make_gif(little); // the data of 15 rows for 16
    fewer[6 + 7 + 24 + 8 + 1 + 6] = 16;
    CHECK_THAT(message_of(fewer), Contains("cannot be decoded"));
    Bytes none(whole.begin(), whole.begin() + 6 + 7 + 24);
    none.push_back(0x3b);
    CHECK_THAT(message_of(none), Contains("the GIF has no picture"));
}

TEST_CASE("BMP pages of 1, 4, 8, 16, 24 and 32 bits are read", "[image]") {
    const auto pixel = [](const BmpPage& page, int x) {
        return decode_image(make_bmp(page), "page.bmp")(x, 7);
    };
    Bytes row;
    for (int x = 0; x < 17; ++x) append(row, {static_cast<unsigned char>(x), 20, 30});
    CHECK(pixel(bmp_page(24, row), 9) == Rgb8{30, 20, 9});
    BmpPage core = bmp_page(24, row);
    core.header = 12;
    CHECK(pixel(core, 16) == Rgb8{30, 20, 16});

    BmpPage bits = bmp_page(1, {0x40, 0, 0x80});
    bits.palette = {1, 2, 3, 0, 4, 5, 6, 0};
    CHECK(pixel(bits, 0) == Rgb8{3, 2, 1});
    CHECK(pixel(bits, 1) == Rgb8{6, 5, 4});
    CHECK(pixel(bits, 16) == Rgb8{6, 5, 4});
    BmpPage nibbles = bmp_page(4, {0x01, 0x10, 0, 0, 0, 0, 0, 0, 0xf0}); // 15 is not in the palette
    nibbles.palette = bits.palette;
    CHECK(pixel(nibbles, 1) == Rgb8{6, 5, 4});
    CHECK(pixel(nibbles, 2) == Rgb8{6, 5, 4});
    CHECK(pixel(nibbles, 16) == Rgb8{0, 0, 0});
    BmpPage bytes = bmp_page(8, Bytes(17, 1));
    bytes.palette = bits.palette;
    bytes.colours = 2;
    CHECK(pixel(bytes, 11) == Rgb8{6, 5, 4});

    Bytes words;
    for (int x = 0; x < 17; ++x) put(words, x == 4 ? 0x7c1fu : 0x0210u, 2);
    CHECK(pixel(bmp_page(16, words), 4) == Rgb8{255, 0, 255});
    CHECK(pixel(bmp_page(16, words), 5) == Rgb8{0, 132, 132}); // 16 of 31
    BmpPage masked = bmp_page(16, words);
    masked.compression = 3;
    masked.masks = {0xf800, 0x07e0, 0x001f};
    CHECK(pixel(masked, 4) == Rgb8{123, 130, 255}); // 15 of 31, 32 of 63
}

TEST_CASE("Rows of a BMP go up, or with a negative height down", "[image]") {
    BmpPage page = bmp_page(24, Bytes(51, 200));
    page.rows[0] = Bytes(51, 10);
    CHECK(decode_image(make_bmp(page), "page.bmp")(0, 15) == Rgb8{10, 10, 10});
    page.height = -16;
    CHECK(decode_image(make_bmp(page), "page.bmp")(0, 0) == Rgb8{10, 10, 10});
}

TEST_CASE("Alpha of a BMP counts where its header has a mask for it, and not when it is 0 everywhere",
          "[image]") {
    const TemporaryFolder folder;
    Bytes row;
    for (int x = 0; x < 17; ++x) append(row, {10, 20, 30, static_cast<unsigned char>(x * 15)});
    const auto loaded = [&](const BmpPage& page) {
        return load_rgba(folder.write("page.bmp", make_bmp(page)));
    };
    CHECK(loaded(bmp_page(32, row))(3, 3) == Rgba8{30, 20, 10, 255}); // the fourth byte means nothing
    BmpPage page = bmp_page(32, row);
    page.header = 124, page.compression = 3;
    page.masks = {0xff0000, 0xff00, 0xff, 0xff000000};
    CHECK(loaded(page)(3, 3) == Rgba8{30, 20, 10, 45});
    for (Bytes& each : page.rows)
        for (std::size_t i = 3; i < each.size(); i += 4) each[i] = 0;
    CHECK(loaded(page)(3, 3) == Rgba8{30, 20, 10, 255});
}

TEST_CASE("Truncated and damaged BMP files are one line", "[image]") {
    BmpPage bits = bmp_page(1, {0x40, 0, 0x80});
    bits.palette = {1, 2, 3, 0, 4, 5, 6, 0};
    check_damaged(make_bmp(bits));
    BmpPage deep = bmp_page(32, Bytes(17 * 4, 7));
    deep.compression = 3;
    deep.masks = {0xff, 0xff00, 0xff0000};
    check_damaged(make_bmp(deep));
    deep.masks = {0xfd, 0xff00, 0xff0000};
    CHECK_THAT(message_of(make_bmp(deep)), Contains("the BMP is damaged"));
    bits.compression = 1;
    CHECK_THAT(message_of(make_bmp(bits)), Contains("is a compressed BMP"));
    BmpPage huge = bmp_page(24, Bytes(51, 0));
    huge.width = 16385;
    CHECK_THAT(message_of(make_bmp(huge)), Contains("16385x16"));
    huge.width = 17, huge.height = std::numeric_limits<int>::min();
    CHECK_THAT(message_of(make_bmp(huge)), Contains("17x2147483648"));
    CHECK_THAT(message_of(text("BMW, VW and Fiat are makes of cars")), Contains("is neither"));
}

TEST_CASE("A WebP page is read with its alpha, of an animation the first picture", "[image][needs-webp]") {
    const TemporaryFolder folder;
    const RgbaImage image = noise(33, 18);
    const Bytes still = encode_webp({image}, 10), film = encode_webp({image, RgbaImage(33, 18)}, 10);
    CHECK(load_rgba(folder.write("page.webp", still)) == image);
    CHECK(decode_image(still, "page.webp") == over_white(image));
    CHECK(decode_image(film, "film.webp") == over_white(image));
}

TEST_CASE("EXIF turns a WebP and a PNG as it turns a JPEG", "[image]") {
    const TemporaryFolder folder;
    RgbaImage image(24, 16, Rgba8{255, 255, 255, 255});
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) image(x, y) = {0, 0, 0, 255};
    const RgbImage quarter = turned(over_white(image), 90); // orientation 6
    const Bytes tiff{'M', 'M', 0, 42, 0, 0, 0, 8, 0, 1, 1, 0x12, 0, 3, 0, 0, 0, 1, 0, 6, 0, 0};
    Bytes png = encode_png(image);
    const Bytes exif = chunk("eXIf", tiff);
    png.insert(png.end() - 12, exif.begin(), exif.end());
    CHECK(decode_image(png, "page.png") == quarter);
    CHECK(decode_rgba(png, "page.png") == image); // as it is stored
    CHECK(load_rgba(folder.write("page.png", png)).width() == 16);
    if (!webp_available()) return;
    for (const bool named : {false, true})
        CHECK(decode_image(webp_turned(encode_webp({image}, 10), 6, named), "page.webp") == quarter);
}

TEST_CASE("Truncated and damaged WebP files are one line", "[image][needs-webp]") {
    const RgbaImage image = noise(33, 18);
    check_damaged(encode_webp({image}, 10));
    check_damaged(webp_turned(encode_webp({image, RgbaImage(33, 18)}, 10), 8, true));
    Bytes whole = encode_webp({image}, 10);
    whole.resize(whole.size() - 1);
    CHECK_THAT(message_of(whole), Contains("the WebP ends early"));
}

TEST_CASE("The dimensions of a WebP are known without the library, and over the limit refused", "[image]") {
    Bytes webp = text("RIFF");
    put(webp, 4 + 8 + 10, 4);
    append(webp, text("WEBPVP8X"));
    put(webp, 10, 4), put(webp, 0, 4), put(webp, 19999, 3), put(webp, 29, 3);
    CHECK(read_webp(webp).width == 20000);
    CHECK(read_webp(webp).height == 30);
    CHECK_THAT(message_of(webp), Contains("20000x30") && Contains("16384"));
    put(webp, 0, 1); // data behind the picture
    CHECK(read_webp(webp).problem == "the WebP has no picture");
    if (webp_pictures_available()) return;
    webp[24] = webp[25] = webp[26] = 20;
    webp[26] = 0;
    CHECK_THAT(message_of(webp, "page.webp"), EndsWith("convert it: dwebp page.webp -o page.png"));
}

TEST_CASE("Other formats are named, with the command that converts them", "[image]") {
    using namespace std::string_literals;
    const auto check = [](const std::string& bytes, const std::string& file, const std::string& expected) {
        CHECK(message_of(text(bytes), file) == file + ": " + expected);
    };
    check("II*\0........"s, "page.tif",
          "is a TIFF image, which is not read; convert it: convert page.tif page.png");
    check("MM\0*........"s, "a b/it's.tiff",
          "is a TIFF image, which is not read; convert it: convert 'a b/it'\\''s.tiff' 'a b/it'\\''s.png'");
    check("\0\0\0\x18"
          "ftypheic\0\0\0\0mif1heic"s,
          "page.heic", "is a HEIC image, which is not read; convert it: heif-convert page.heic page.png");
    check("\0\0\0\x18"
          "ftypmif1\0\0\0\0avifmif1"s,
          "page.avif", "is an AVIF image, which is not read; convert it: avifdec page.avif page.png");
    check("%PDF-1.7\n", "page.pdf",
          "is a PDF document, which is not read; convert it: pdftoppm -r 150 -png page.pdf page");
    check("<?xml version='1.0'?>\n<svg xmlns='http://www.w3.org/2000/svg'/>", "page.svg",
          "is an SVG drawing, which is not read; pantin model page.svg -o DIR --animate moves it, or convert "
          "it: rsvg-convert -b white "
          "-o page.png page.svg");
    check("\xff\x0a............", "page.jxl",
          "is a JPEG XL image, which is not read; convert it: djxl page.jxl page.png");
    check("8BPS............", "page.psd",
          "is a Photoshop document, which is not read; convert it: convert 'page.psd[0]' page.png");
    // A name that is not what the file is.
    check("II*\0........"s, "page.png",
          "is a TIFF image, which is not read; convert it: convert page.png page-converted.png");
    for (const std::string& bytes : {"hello"s, "<p>svg</p>"s,
                                     "\0\0\0\x18"
                                     "ftypisom"s,
                                     "RIFF"s, "GIF"s, "I"s})
        check(bytes, "page.png", "is neither a PNG, JPEG, WebP, GIF nor BMP image");
}
