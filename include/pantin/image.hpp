// SPDX-License-Identifier: MIT
// Step 0: files to pixels, and the pixel operations that every later step shares.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "pantin/error.hpp"
#include "pantin/grid.hpp"
#include "pantin/point.hpp"

namespace pantin {

// --- files -----------------------------------------------------------------------------------------------

inline constexpr int min_image_side = 16;
inline constexpr int max_image_side = 16384;
inline constexpr long max_image_pixels = 64'000'000;

// Loads a page: PNG, JPEG, WebP (in a build with libwebp), GIF or BMP; of an animation its first picture.
// EXIF orientation is applied, alpha is composited on white, 16-bit samples keep their high byte. Dimensions
// and completeness are checked before anything is decoded: damaged and truncated files are errors.
// Error(input) names the file, and for another known format a command that converts it. A character's
// drawing.png may be smaller than a page: min_side 1, pixels. Own, over stb_image and libwebp.
RgbImage load_image(const std::filesystem::path& file, int min_side = min_image_side);
// The same with its alpha (straight) instead of composited; 255 where the format has none.
RgbaImage load_rgba(const std::filesystem::path& file, int min_side = min_image_side);
// Colours over white paper. No error. Own.
RgbImage composite_on_white(const RgbaImage& image);
// Turned clockwise by 0, 90, 180 or 270 degrees, no pixel lost; else Error(usage). Own.
RgbImage turned(RgbImage image, int degrees);
GreyImage turned(GreyImage image, int degrees);
RgbaImage turned(RgbaImage image, int degrees);
// Light for dark: 255 − each value. No error. Own.
RgbImage inverted(RgbImage image);
GreyImage inverted(GreyImage image);
// Loads a grey PNG that the pipeline wrote (mask, labels, skeleton), any size, values as stored; an editor
// may have saved it with colour channels or a palette as long as every pixel is grey; fully transparent
// pixels count as 0. Error(input) names the file. Own.
GreyImage load_grey(const std::filesystem::path& file);
// The same from memory; `source` stands for the file in messages. Errors as from files. Own.
RgbImage decode_image(std::span<const unsigned char> bytes, const std::string& source,
                      int min_side = min_image_side);
GreyImage decode_grey(std::span<const unsigned char> bytes, const std::string& source);
// A PNG of any kind with its colours and its alpha (straight) as they are stored. Errors as decode_image().
// Own.
RgbaImage decode_rgba(std::span<const unsigned char> bytes, const std::string& source);

// PNG, written to a temporary name in the same folder and renamed. Values as given (a Mask must be scaled to
// 255). Error(output) names the file. Own, over stb_image_write; so is encode_png(), which has no error.
void save_png(const std::filesystem::path& file, const GreyImage& image);
void save_png(const std::filesystem::path& file, const RgbImage& image);
void save_png(const std::filesystem::path& file, const RgbaImage& image);
std::vector<unsigned char> encode_png(const GreyImage& image);
std::vector<unsigned char> encode_png(const RgbImage& image);
std::vector<unsigned char> encode_png(const RgbaImage& image);

// --- tone ------------------------------------------------------------------------------------------------

// Luma 0 … 255 with integer weights: (299 r + 587 g + 114 b + 500) / 1000. No error. ITU-R BT.601.
GreyImage greyscale(const RgbImage& image);

// Ink where a pixel is darker than the mean of its (2·radius+1)² neighbourhood by more than `offset` (0…255),
// window cut at the border. Shadows and yellow paper move the mean with them and do not become ink. radius:
// pixels, ≥ 1. No error. Wellner 1993.
Mask adaptive_threshold(const GreyImage& image, int radius, int offset);

// --- ink and paper ---------------------------------------------------------------------------------------

// What of a page is drawn. Decided once, on the whole page; every later step sees this and not the colours.
struct PageInk {
    // 0 paper, 1 the strongest strokes. A photograph, a scan and a digital drawing, dark on light and light
    // on dark are alike in it; black on white comes out as 1 and 0.
    Grid<float> darkness;
    Mask fills; // filled areas, pale ones too
    bool light_on_dark =
        false;              // chalk on a board; a page in colours is turned round before a network sees it
    bool cut_out = false;   // a figure without paper: what is opaque is drawn
    double bare_border = 1; // share of the page's border that is bare paper
};

// 1. Light on dark, when the ground is dull and more of the page is lighter than darker than it: turned
// round.
// 2. Blocks of max(8, ⌈longer side / 64⌉) pixels; a block's paper is the 80th percentile of its brightness,
// in
//    its tint. The ground is the largest region of blocks that lead on to each other by small steps (shadow,
//    tint); in a block that is unlike the ground (a filled area) the paper continues as around it.
// 3. Binomial 3×3 mean of the blocks, bilinear in between: paper(x, y) ≥ 1 in each channel. d = 1 − colour /
//    paper of the channel where it is largest, clamped to [0, 1]; on a dull ground with light ink on it, the
//    share of the way to white, too.
// 4. Ruled lines and grids are taken out (image/ruling.hpp).
// 5. Divided by the 95th percentile of d over the pixels with d > 0.15 (at least 0.25), clamped to 1.
// The networks' training sees drawings through steps 2, 3 and 5. No error. Own; for the parts see
// src/image/ink.cpp.
PageInk find_page_ink(const RgbImage& page);
// Of a figure on a transparent ground: what is opaque is drawn, at least faintly; white is the paper. No
// error. Own.
PageInk find_cut_out_ink(const RgbaImage& page);
inline bool is_opaque(Rgba8 pixel) { return pixel.a >= 128; }
// 1 where the picture is opaque. No error. Own.
Mask opaque_pixels(const RgbaImage& image);

// find_page_ink().darkness.
Grid<float> ink_darkness(const RgbImage& image);
// One character's ink from its crop of the page's darkness, step 5 for itself: 0 paper, 255 the strongest
// strokes. No error. Own.
GreyImage ink_of_crop(const Grid<float>& darkness);
// Back to [0, 1]. No error. Own.
Grid<float> darkness_of(const GreyImage& ink);

// How unevenly a page is lit, and how grainy its paper is: what a camera leaves and a drawing program does
// not.
struct PaperLight {
    double fall = 0;  // by how much the darkest bare paper falls short of the brightest (5th and 95th
                      // percentile of its blocks), 0 to 1
    double grain = 0; // median over the bare blocks of the mean difference of horizontal neighbours, 0 to 255
};
// No error; zeros of an empty picture. Own.
PaperLight paper_light(const RgbImage& page);
// Whether the picture is a photograph of a drawing rather than a scan or a digital drawing: the light falls
// off over its paper by more than 4 % (docs/robustness.md, "Photographs"). No error. Own; the thesis (ch. 5)
// treats photographs apart and does not say how it knows them.
bool is_photograph(const RgbImage& page);

// --- size ------------------------------------------------------------------------------------------------

// Per axis: area average when it shrinks, bilinear when it grows (pixel centres at integer + ½ of the scaled
// grid). Every target side, in pixels, must be at least 1; colours are rounded to nearest. No error. Own.
Grid<float> resize(const Grid<float>& image, int width, int height);
RgbImage resize(const RgbImage& image, int width, int height);
// A mask shrinks by majority of area (half counts as foreground) and grows by nearest pixel. No error. Own.
Mask resize_mask(const Mask& mask, int width, int height);
// The label of the nearest pixel, no mixing. No error. Own.
LabelMap resize_nearest(const LabelMap& labels, int width, int height);
// The box, which must lie inside. No error. Own.
template <class T> Grid<T> crop(const Grid<T>& image, Box box) {
    Grid<T> out(box.width, box.height);
    for (int y = 0; y < box.height; ++y)
        for (int x = 0; x < box.width; ++x) out(x, y) = image(box.x + x, box.y + y);
    return out;
}

// --- masks -----------------------------------------------------------------------------------------------

// Where a label map has a part: labels ≠ 0. No error. Own.
Mask foreground(const LabelMap& labels);

// The mask with `margin` background pixels around it, and without. No error. Own.
Mask pad(const Mask& mask, int margin);
Mask unpad(const Mask& mask, int margin);

// Whether the pixel belongs to the mask and one of its 4-neighbours does not; outside is background. (x, y)
// lies inside. No error. Own.
inline bool on_border(const Mask& mask, int x, int y) {
    return mask(x, y) && !(mask.value_or(x - 1, y, 0) && mask.value_or(x + 1, y, 0) &&
                           mask.value_or(x, y - 1, 0) && mask.value_or(x, y + 1, 0));
}

// Share of the image's outermost pixels that belong to the mask. No error. Own.
double share_of_frame(const Mask& mask);

// Morphology with a (2·radius+1)² square or with the discrete disc of that radius (all pixels whose centre is
// at most `radius` away); outside is background. radius: pixels, ≥ 0. A closing does not lose pixels at the
// image's border. No error. Serra 1982.
Mask dilate_square(const Mask& mask, int radius);
Mask erode_square(const Mask& mask, int radius);
Mask close_square(const Mask& mask, int radius);
Mask dilate_disc(const Mask& mask, double radius);
Mask erode_disc(const Mask& mask, double radius);
Mask close_disc(const Mask& mask, double radius);
Mask open_disc(const Mask& mask, double radius);

struct Component {
    int id = 0; // 1, 2, … in raster order of the first pixel
    int area = 0;
    Box box;
};
struct Components {
    Grid<int> ids; // 0 background
    std::vector<Component> list;
};
// 8-connected components of the foreground, numbered in raster order; areas in pixels. No error. Own.
Components connected_components(const Mask& mask);
// 4-connected components of the background, as above. No error. Own.
Components background_components(const Mask& mask);
// The pixels of one component; id: 1 … list.size(). No error. Own.
Mask component_mask(const Components& components, int id);
// Whether the component's box reaches the border of an image of that size, pixels. No error. Own.
bool touches_border(const Component& component, int width, int height);
// The largest 8-connected component (the first in raster order among equals); empty mask stays empty. No
// error. Own.
Mask largest_component(const Mask& mask);

// Fills 4-connected background regions that do not touch the border and are at most max_area pixels large. No
// error. Own.
Mask fill_holes(const Mask& mask, long max_area = max_image_pixels);

// The pixels of `hole` (of the image's size) take colours that continue their surroundings smoothly; the
// others stay. No error. Push-pull (Gortler et al. 1996) and Laplace's equation.
RgbImage fill_in(const RgbImage& image, const Mask& hole);

// --- distance --------------------------------------------------------------------------------------------

// Exact squared Euclidean distance of every pixel to the nearest pixel with mask == 0 (Felzenszwalb &
// Huttenlocher 2012, in integers as in Meijster et al. 2000). Pixels outside the image count as background.
// No error. Thesis 4.6 (Fig. 4.15).
Grid<int> squared_distance_transform(const Mask& mask);
// Its square root, pixels. No error. Thesis 4.6.
Grid<float> distance_transform(const Mask& mask);
// For every pixel the index (y·width + x) of a nearest pixel with seeds == 1, −1 when there is none. Ties:
// the smallest index. No error. Own, after Meijster et al. 2000.
Grid<int> nearest_seed(const Mask& seeds);

} // namespace pantin
