// SPDX-License-Identifier: MIT
// Pictures in and out: every kind of PNG and JPEG, and damaged ones.
#include <catch2/catch.hpp>

#include <thread>

#include "image/containers.hpp"
#include "image_files.hpp"
#include "pantin/image.hpp"

using namespace pantin;
using namespace pantin::test;
using Catch::Matchers::Contains;

namespace {

std::string message_of(const std::filesystem::path& file, ErrorKind expected = ErrorKind::input) {
    try {
        load_image(file);
    } catch (const Error& error) {
        CHECK(error.kind() == expected);
        CHECK(std::string(error.what()).find('\n') == std::string::npos);
        CHECK_THAT(error.what(), Contains(file.filename().string()));
        return error.what();
    }
    return "no error";
}

// What a PNG of 16 x 16 grey pixels says with this in its IDAT chunk.
std::string message_of_data(const Bytes& compressed) {
    Bytes png = png_header(16, 16, 8, 0);
    append(png, chunk("IDAT", compressed));
    append(png, chunk("IEND", {}));
    try {
        decode_image(png, "page.png", 16);
    } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::input);
        return error.what();
    }
    return "no error";
}

// 24×16, one quadrant black: every one of the 8 orientations shows a different picture.
RgbImage asymmetric_picture() {
    RgbImage image(24, 16, Rgb8{255, 255, 255});
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) image(x, y) = {0, 0, 0};
    for (int y = 8; y < 16; ++y)
        for (int x = 16; x < 24; ++x) image(x, y) = {128, 128, 128};
    return image;
}

std::ptrdiff_t files_in(const std::filesystem::path& folder) {
    return std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator());
}

std::vector<Bytes> rows_of(int height, const Bytes& row) {
    return std::vector<Bytes>(static_cast<std::size_t>(height), row);
}

} // namespace

TEST_CASE("A saved PNG is read back as it was") {
    const TemporaryFolder folder;
    RgbImage image(33, 17);
    for (int y = 0; y < 17; ++y)
        for (int x = 0; x < 33; ++x)
            image(x, y) = {static_cast<std::uint8_t>(x * 7), static_cast<std::uint8_t>(y * 13),
                           static_cast<std::uint8_t>(x ^ y)};
    const auto file = folder.path() / "page.png";
    save_png(file, image);
    CHECK(load_image(file) == image);
    CHECK(files_in(folder.path()) == 1); // no temporary file stays

    GreyImage grey(3, 2, 7);
    grey(1, 1) = 255;
    save_png(folder.path() / "grey.png", grey);
    CHECK(load_grey(folder.path() / "grey.png") == grey);
}

TEST_CASE("Alpha is composited on white") {
    const TemporaryFolder folder;
    RgbaImage image(16, 16, Rgba8{0, 0, 0, 0});
    image(1, 0) = {0, 100, 200, 255};
    image(2, 0) = {0, 100, 200, 128};
    save_png(folder.path() / "a.png", image);
    const RgbImage loaded = load_image(folder.path() / "a.png");
    CHECK(loaded(0, 0) == Rgb8{255, 255, 255});
    CHECK(loaded(1, 0) == Rgb8{0, 100, 200});
    CHECK(loaded(2, 0) == Rgb8{127, 177, 227}); // (200·128 + 255·127 + 127) / 255 = 227
}

TEST_CASE("PNG with 16 bits, palette, one bit and grey are read") {
    const TemporaryFolder folder;
    Bytes row;
    for (int x = 0; x < 16; ++x) append(row, {0xab, 0xcd, 0x12, 0x34, 0xff, 0xff}); // high bytes count
    CHECK(load_image(folder.write("deep.png", make_png(16, rows_of(16, row), 16, 2)))(5, 5) ==
          Rgb8{0xab, 0x12, 0xff});

    row = Bytes(16, 1);
    row[3] = 2;
    Bytes palette = chunk("PLTE", {1, 2, 3, 40, 50, 60, 70, 80, 90});
    append(palette, chunk("tRNS", {255, 255, 0}));
    const RgbImage indexed =
        load_image(folder.write("palette.png", make_png(16, rows_of(16, row), 8, 3, palette)));
    CHECK(indexed(0, 0) == Rgb8{40, 50, 60});
    CHECK(indexed(3, 0) == Rgb8{255, 255, 255}); // transparent entry

    const RgbImage bits = load_image(folder.write("bits.png", make_png(16, rows_of(16, {0x80, 0x01}), 1, 0)));
    CHECK(bits(0, 0) == Rgb8{255, 255, 255});
    CHECK(bits(1, 0) == Rgb8{0, 0, 0});
    CHECK(bits(15, 0) == Rgb8{255, 255, 255});

    row = Bytes(16, 77);
    CHECK(load_image(folder.write("grey.png", make_png(16, rows_of(16, row), 8, 0)))(9, 9) ==
          Rgb8{77, 77, 77});
}

TEST_CASE("A JPEG is read and turned as each of the 8 EXIF orientations says") {
    const TemporaryFolder folder;
    const Bytes jpeg = make_jpeg(asymmetric_picture(), 100);
    // Where the black corner and the grey one are found when upright: {x, y} of a pixel inside each.
    struct Case {
        int orientation, width, height;
        Point2i black, grey;
    };
    const std::vector<Case> cases = {{1, 24, 16, {3, 3}, {20, 12}}, {2, 24, 16, {20, 3}, {3, 12}},
                                     {3, 24, 16, {20, 12}, {3, 3}}, {4, 24, 16, {3, 12}, {20, 3}},
                                     {5, 16, 24, {3, 3}, {12, 20}}, {6, 16, 24, {12, 3}, {3, 20}},
                                     {7, 16, 24, {12, 20}, {3, 3}}, {8, 16, 24, {3, 20}, {12, 3}}};
    for (const Case& c : cases) {
        for (bool little : {true, false}) {
            INFO("orientation " << c.orientation);
            const RgbImage image =
                load_image(folder.write("photo.jpg", with_orientation(jpeg, c.orientation, little)));
            REQUIRE(image.width() == c.width);
            REQUIRE(image.height() == c.height);
            CHECK(image(c.black.x, c.black.y).g < 40);
            CHECK(std::abs(image(c.grey.x, c.grey.y).g - 128) < 40);
            CHECK(image(c.width - 1 - c.black.x, c.black.y).g > 215);
        }
    }
    // Orientations that do not exist count as upright.
    CHECK(load_image(folder.write("photo.jpg", with_orientation(jpeg, 9, true))).width() == 24);
    CHECK(load_image(folder.write("photo.jpg", with_orientation(jpeg, 0, true))).width() == 24);
}

TEST_CASE("A quarter turn clockwise brings the left column to the top") {
    const RgbImage image = asymmetric_picture();
    const RgbImage quarter = turned(image, 90);
    REQUIRE(quarter.width() == image.height());
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) CHECK(quarter(image.height() - 1 - y, x) == image(x, y));
    CHECK(turned(quarter, 90) == turned(image, 180));
    CHECK(turned(quarter, 180) == turned(image, 270));
    CHECK(turned(quarter, 270) == image);
    CHECK(turned(image, 0) == image);
    CHECK_THROWS_AS(turned(image, 45), Error);
}

TEST_CASE("An EXIF structure that is damaged anywhere never reads out of bounds") {
    const Bytes tiff{'I', 'I', 42, 0, 8, 0, 0, 0, 1, 0, 0x12, 1, 3, 0, 1, 0, 0, 0, 6, 0, 0, 0};
    CHECK(exif_orientation(tiff) == 6);
    for (std::size_t n = 0; n < tiff.size(); ++n) {
        const Bytes prefix(tiff.begin(), tiff.begin() + static_cast<std::ptrdiff_t>(n));
        CHECK(exif_orientation(prefix) == 1);
    }
    for (std::size_t i = 0; i < tiff.size(); ++i) {
        for (unsigned char value : {0x00, 0x01, 0x7f, 0x80, 0xff}) {
            Bytes damaged = tiff;
            damaged[i] = value;
            const int orientation = exif_orientation(damaged);
            CHECK((orientation >= 1 && orientation <= 8));
        }
    }
}

TEST_CASE("Files that are no page are errors of one line that say why") {
    const TemporaryFolder folder;
    CHECK_THAT(message_of(folder.path() / "missing.png"), Contains("no such file"));
    std::filesystem::create_directory(folder.path() / "sub.png");
    CHECK_THAT(message_of(folder.path() / "sub.png"), Contains("is a folder"));
    CHECK_THAT(message_of(folder.write("empty.png", {})), Contains("empty"));
    CHECK_THAT(message_of(folder.write("text.png", {'h', 'e', 'l', 'l', 'o'})),
               Contains("neither a PNG, JPEG"));
    CHECK_THAT(message_of(folder.write("gif.png", {'G', 'I', 'F', '9', '9', 'a', 0, 0})),
               Contains("neither"));
    CHECK_THAT(message_of(folder.write("dot.png", make_png(1, {{0}}, 8, 0))),
               Contains("smallest side allowed is 16"));
    CHECK_THAT(message_of(folder.write("flat.png", make_png(16, rows_of(15, Bytes(16, 0)), 8, 0))),
               Contains("16x15"));
    CHECK_THAT(message_of(folder.write("none.png", make_png(0, {}, 8, 0))), Contains("0x0"));
}

TEST_CASE("Dimensions over the limits are refused before anything is decoded") {
    const TemporaryFolder folder;
    const auto header_only = [&](std::uint32_t w, std::uint32_t h) {
        Bytes bytes = png_header(w, h, 8, 2);
        append(bytes, chunk("IDAT", {0x78, 0x01}));
        append(bytes, chunk("IEND", {}));
        return message_of(folder.write("huge.png", bytes));
    };
    CHECK_THAT(header_only(20000, 20000), Contains("20000x20000") && Contains("16384"));
    CHECK_THAT(header_only(16385, 16), Contains("16384"));
    CHECK_THAT(header_only(16, 0xffffffffu), Contains("16384"));
    CHECK_THAT(header_only(8001, 8000), Contains("64 megapixels"));
    CHECK_THAT(header_only(8000, 8000), Contains("cannot be decoded"));

    Bytes jpeg = make_jpeg(asymmetric_picture(), 90);
    for (std::size_t i = 0; i + 9 < jpeg.size(); ++i)
        if (jpeg[i] == 0xff && jpeg[i + 1] == 0xc0) jpeg[i + 5] = jpeg[i + 7] = 0x4e; // 20000-odd a side
    CHECK_THAT(message_of(folder.write("huge.jpg", jpeg)), Contains("16384"));
}

TEST_CASE("Truncated and damaged files are errors at every length") {
    const TemporaryFolder folder;
    const std::vector<Bytes> files = {encode_png(asymmetric_picture()), make_jpeg(asymmetric_picture(), 90)};
    for (const Bytes& whole : files) {
        REQUIRE(message_of(folder.write("whole", whole)) == "no error");
        for (std::size_t n = 1; n < whole.size(); n += n < 64 ? 1 : 7) {
            const Bytes prefix(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(n));
            INFO("first " << n << " of " << whole.size() << " bytes");
            CHECK(message_of(folder.write("part", prefix)) != "no error");
        }
    }
    Bytes flipped = files[0];
    flipped[files[0].size() / 2] ^= 0x10;
    CHECK_THAT(message_of(folder.write("flipped.png", flipped)), Contains("checksum"));
    Bytes longer = files[1];
    append(longer, {1, 2, 3}); // cameras append data behind the picture
    CHECK(message_of(folder.write("longer.jpg", longer)) == "no error");
}

TEST_CASE("Compressed data of any first bytes is a picture or an error with a reason") {
    CHECK(message_of_data(stored_zlib(Bytes(16 * 17, 0))) == "no error");
    const std::string prefix = "page.png: cannot be decoded: ";
    for (int byte = 0; byte < 256; ++byte) {
        const auto any = static_cast<unsigned char>(byte);
        for (const Bytes& compressed :
             {Bytes{any}, Bytes{0x78, any}, Bytes{0x78, 0x01, any}, Bytes{0x78, 0x01, any, 0x24},
              Bytes{0x78, 0x01, 0x01, any, 0, any, 0}}) {
            // In a thread of its own: the decoder's reason is the thread's, and null before the first.
            std::string message;
            std::thread([&] { message = message_of_data(compressed); }).join();
            CAPTURE(byte, compressed.size());
            CHECK(message.starts_with(prefix));
            CHECK(message.size() > prefix.size());
        }
    }
}

TEST_CASE("A JPEG whose Huffman tables have too many codes, or end early, is damaged") {
    const Bytes whole = make_jpeg(asymmetric_picture(), 90);
    constexpr unsigned char marker[] = {0xff, 0xc4};
    const auto table = std::search(whole.begin(), whole.end(), std::begin(marker), std::end(marker));
    REQUIRE(table != whole.end());
    const auto counts = static_cast<std::size_t>(table - whole.begin()) + 5; // behind marker, length and name
    for (std::size_t length = 0; length < 16; ++length) {
        Bytes damaged = whole;
        damaged[counts + length] = 0xff;
        CHECK_THROWS_WITH(decode_image(damaged, "page.jpg", 16),
                          Contains("page.jpg: the JPEG is damaged (a Huffman table)"));
    }
}

TEST_CASE("A reason is not that of the picture before") {
    const Bytes without_reason{0x78, 0x01, 0x07}; // a kind of block that does not exist
    std::string alone;
    std::thread([&] { alone = message_of_data(without_reason); }).join();
    CHECK(message_of_data({0x79, 0x01}) != alone);
    CHECK(message_of_data(without_reason) == alone);
}

TEST_CASE("A grey file with colours is refused, one saved with colour channels is read") {
    const TemporaryFolder folder;
    RgbImage image(4, 4, Rgb8{3, 3, 3});
    save_png(folder.path() / "rgb.png", image);
    CHECK(load_grey(folder.path() / "rgb.png")(2, 2) == 3);
    image(1, 1) = {3, 4, 3};
    save_png(folder.path() / "coloured.png", image);
    CHECK_THROWS_WITH(load_grey(folder.path() / "coloured.png"), Contains("has colours"));
    CHECK_THROWS_WITH(load_grey(folder.write("photo.png", make_jpeg(asymmetric_picture(), 90))),
                      Contains("not a PNG"));
}

TEST_CASE("What cannot be written is an output error and leaves nothing behind") {
    const TemporaryFolder folder;
    const GreyImage image(16, 16);
    const auto kind_of = [&](const std::filesystem::path& file) {
        try {
            save_png(file, image);
        } catch (const Error& error) {
            CHECK_THAT(error.what(), Contains(file.string()));
            return error.kind();
        }
        return ErrorKind::internal;
    };
    CHECK(kind_of(folder.path() / "no" / "such" / "folder.png") == ErrorKind::output);
    std::filesystem::create_directory(folder.path() / "taken.png");
    CHECK(kind_of(folder.path() / "taken.png") == ErrorKind::output); // a folder stands where the file should
    CHECK(files_in(folder.path()) == 1);
}
