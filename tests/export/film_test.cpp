// SPDX-License-Identifier: MIT
// WebP and GIF: pixels, palette, times and loop, decoded again; the table of film formats.
#include <catch2/catch.hpp>

#include "core/file.hpp"
#include "export/film_formats.hpp"
#include "pantin/error.hpp"
#include "pantin/export.hpp"
#include "support/films.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

// A disc that walks over a transparent frame, with a soft edge; `count` frames.
std::vector<RgbaImage> walking_disc(int count) {
    std::vector<RgbaImage> frames;
    for (int i = 0; i < count; ++i) {
        RgbaImage frame(40, 24, Rgba8{0, 0, 0, 0});
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 40; ++x) {
                const int dx = x - 8 - 2 * i, dy = y - 12, d = dx * dx + dy * dy;
                if (d < 36)
                    frame(x, y) = {static_cast<std::uint8_t>(40 + 5 * x), 60,
                                   static_cast<std::uint8_t>(8 * y), 255};
                if (d >= 36 && d < 49) frame(x, y) = {200, 10, 10, 100};
                if (d >= 49 && d < 64) frame(x, y) = {7, 7, 7, 0}; // a colour that nobody sees
            }
        frames.push_back(frame);
    }
    return frames;
}

} // namespace

TEST_CASE("An animated WebP decodes to the frames, pixel by pixel, and loops for ever",
          "[export][needs-webp]") {
    const std::vector<RgbaImage> frames = walking_disc(8);
    const Film film = read_webp(encode_webp(frames, 25));
    CHECK(film.loops_for_ever);
    REQUIRE(film.frames.size() == frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        CHECK(film.delays[i] == 40);
        RgbaImage wanted = frames[i];
        for (Rgba8& c : wanted)
            if (c.a == 0) c = {0, 0, 0, 0};
        CHECK(film.frames[i] == wanted);
    }
}

TEST_CASE("WebP times are rounded from the start, so a clip keeps its length", "[export][needs-webp]") {
    const Film film = read_webp(encode_webp(walking_disc(12), 30));
    int total = 0;
    for (const int delay : film.delays) total += delay;
    CHECK(total == 400);
}

TEST_CASE(
    "A film on a page stores what changes; a pause, a turn back and a last frame like the first survive",
    "[export][needs-webp]") {
    std::vector<RgbaImage> frames = walking_disc(4);
    for (RgbaImage& frame : frames)
        for (int y = 0; y < frame.height(); ++y)
            for (int x = 0; x < frame.width(); ++x)
                if (frame(x, y).a < 255)
                    frame(x, y) = {static_cast<std::uint8_t>(7 * x * y),
                                   static_cast<std::uint8_t>(90 + 3 * x),
                                   static_cast<std::uint8_t>(x * x + 5 * y), 255};
    frames.insert(frames.begin() + 2, frames[1]); // shown twice as long
    frames.push_back(frames[2]);
    frames.push_back(frames[0]);
    const Film film = read_webp(encode_webp(frames, 25));
    frames.erase(frames.begin() + 2);
    CHECK(film.frames == frames);
    CHECK(film.delays == std::vector<int>{40, 80, 40, 40, 40, 40});
}

TEST_CASE("A film that never changes is one picture", "[export][needs-webp]") {
    const RgbaImage frame = walking_disc(1)[0];
    RgbaImage wanted = frame;
    for (Rgba8& c : wanted)
        if (c.a == 0) c = {0, 0, 0, 0};
    const Film film = read_webp(encode_webp({frame, frame, frame}, 25));
    REQUIRE(film.frames.size() == 1);
    CHECK(film.frames[0] == wanted);
    const Film nothing = read_webp(encode_webp({RgbaImage(9, 7), RgbaImage(9, 7)}, 25));
    REQUIRE(nothing.frames.size() == 1);
    CHECK(nothing.frames[0] == RgbaImage(9, 7));
}

TEST_CASE("Films are the same bytes for any number of threads", "[export]") {
    const std::vector<RgbaImage> frames = walking_disc(7);
    CHECK(encode_apng(frames, 25, 3) == encode_apng(frames, 25));
    if (webp_available()) CHECK(encode_webp(frames, 25, {}, 3) == encode_webp(frames, 25));
    if (webp_available()) CHECK(encode_webp(frames, 25, 80, 3) == encode_webp(frames, 25, 80));
    if (gif_available()) CHECK(encode_gif(frames, 25, 3) == encode_gif(frames, 25));
}

TEST_CASE("The same frames encode to the same WebP", "[export][needs-webp]") {
    CHECK(encode_webp(walking_disc(3), 25) == encode_webp(walking_disc(3), 25));
}

TEST_CASE("A GIF shows the frames with transparency, restored to the background, for ever",
          "[export][needs-gif]") {
    const std::vector<RgbaImage> frames = walking_disc(8);
    const Film film = read_gif(encode_gif(frames, 25));
    CHECK(film.loops_for_ever);
    CHECK(film.disposes_to_background);
    REQUIRE(film.frames.size() == frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        CHECK(film.delays[i] == 4);
        for (int y = 0; y < frames[i].height(); ++y)
            for (int x = 0; x < frames[i].width(); ++x) {
                const Rgba8 wanted = frames[i](x, y), got = film.frames[i](x, y);
                REQUIRE((got.a == 255) == (wanted.a >= 128));
                if (got.a == 0) continue;
                CHECK(std::abs(got.r - wanted.r) <= 6);
                CHECK(std::abs(got.g - wanted.g) <= 6);
                CHECK(std::abs(got.b - wanted.b) <= 6);
            }
    }
}

TEST_CASE("A GIF of few colours keeps them exactly", "[export][needs-gif]") {
    RgbaImage frame(16, 16, Rgba8{255, 255, 255, 255});
    frame(3, 3) = {0, 0, 0, 255};
    frame(4, 4) = {17, 101, 203, 255};
    frame(5, 5) = {0, 0, 0, 0};
    const Film film = read_gif(encode_gif({frame}, 10));
    CHECK(film.frames.at(0) == frame);
}

TEST_CASE("GIF delays are whole hundredths of at least 2, and the loop keeps its length",
          "[export][needs-gif]") {
    const auto [fps, delay, count] = GENERATE(table<double, int, int>(
        {{25, 4, 30}, {30, 3, 33}, {60, 2, 25}, {100, 2, 15}, {24, 4, 31}, {10, 10, 30}, {1, 100, 30}}));
    const Film film = read_gif(encode_gif(walking_disc(30), fps));
    CHECK(film.frames.size() == static_cast<std::size_t>(count));
    for (const int each : film.delays) CHECK(each == delay);
    CHECK(std::abs(static_cast<double>(count * delay) - 3000 / fps) <= delay / 2.0);
}

TEST_CASE("A GIF frame without a visible pixel is still a frame", "[export][needs-gif]") {
    const Film film = read_gif(encode_gif({RgbaImage(20, 20), RgbaImage(20, 20, Rgba8{1, 2, 3, 255})}, 25));
    REQUIRE(film.frames.size() == 2);
    CHECK(film.frames[0](10, 10).a == 0);
    CHECK(film.frames[1](10, 10) == Rgba8{1, 2, 3, 255});
}

TEST_CASE("An animation without frames is an internal error", "[export]") {
    CHECK_THROWS_AS(encode_webp({}, 25), Error);
    CHECK_THROWS_AS(encode_gif({}, 25), Error);
}

TEST_CASE("Film formats are found by name, and docs/formats.md has the ending of each", "[export]") {
    const std::string document = read_text("docs/formats.md");
    for (const FilmFormat& format : film_formats()) {
        INFO(format.name);
        CHECK_FALSE(format.name.empty());
        CHECK((format.film == nullptr) != (format.motion == nullptr));
        CHECK(film_format(format.name) == &format);
        CHECK(document.find(format.ending.empty() ? std::string(format.name) : std::string(format.ending)) !=
              std::string::npos);
    }
    CHECK(film_format("avi") == nullptr);
    CHECK(film_format_names(" or ") == "webp, gif, apng, mp4, png or bvh");
}

TEST_CASE("A build without an encoder says so", "[export]") {
    const std::vector<RgbaImage> frames = walking_disc(1);
    if (!webp_available())
        CHECK_THROWS_WITH(encode_webp(frames, 25), "this pantin was built without WebP (make WEBP=1)");
    if (!gif_available())
        CHECK_THROWS_WITH(encode_gif(frames, 25), "this pantin was built without GIF (make GIF=1)");
}
