// Step 0: files to pixels, and the pixel operations that every later step shares.
#pragma once

#include <filesystem>
#include <vector>

#include "pantin/error.hpp"
#include "pantin/grid.hpp"
#include "pantin/point.hpp"

namespace pantin {

// --- files -----------------------------------------------------------------------------------------------

inline constexpr int min_image_side = 16;
inline constexpr int max_image_side = 16384;
inline constexpr long max_image_pixels = 64'000'000;

// Loads a PNG or JPEG page. EXIF orientation of a JPEG is applied, alpha is composited on white.
// Dimensions are checked before anything is decoded. Throws Error(input) naming the file.
RgbImage load_image(const std::filesystem::path& file);
// Loads an 8-bit PNG that the pipeline wrote (mask, labels, skeleton), any size; Error(input) if it is none.
GreyImage load_grey(const std::filesystem::path& file);

// PNG, written to a temporary name and renamed. Throws Error(output).
void save_png(const std::filesystem::path& file, const GreyImage& image);
void save_png(const std::filesystem::path& file, const RgbImage& image);
void save_png(const std::filesystem::path& file, const RgbaImage& image);
std::vector<unsigned char> encode_png(const RgbaImage& image);
std::vector<unsigned char> encode_png(const RgbImage& image);

// --- tone ------------------------------------------------------------------------------------------------

// Rec. 601 luma with integer weights: (299 r + 587 g + 114 b + 500) / 1000.
GreyImage greyscale(const RgbImage& image);

// Ink where a pixel is darker than the mean of its (2·radius+1)² neighbourhood by more than `offset` (0…255),
// window cut at the border. Shadows and yellow paper move the mean with them and do not become ink.
Mask adaptive_threshold(const GreyImage& image, int radius, int offset);

// Ink darkness in [0, 1]: 0 paper, 1 the darkest strokes. The paper's brightness is estimated locally, so that
// a photograph, a scan and a digital drawing look alike to the networks. The training code does the same.
Grid<float> ink_darkness(const RgbImage& image);

// --- size ------------------------------------------------------------------------------------------------

// Area average when it shrinks, bilinear when it grows (pixel centres at integer + ½ of the scaled grid).
Grid<float> resize(const Grid<float>& image, int width, int height);
// A mask shrinks by majority of area and grows by nearest pixel.
Mask resize_mask(const Mask& mask, int width, int height);
LabelMap resize_nearest(const LabelMap& labels, int width, int height);
template <class T> Grid<T> crop(const Grid<T>& image, Box box) {
    Grid<T> out(box.width, box.height);
    for (int y = 0; y < box.height; ++y)
        for (int x = 0; x < box.width; ++x) out(x, y) = image(box.x + x, box.y + y);
    return out;
}

// --- masks -----------------------------------------------------------------------------------------------

// Morphology with a (2·radius+1)² square or with the discrete disc of that radius; outside is background.
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
// 8-connected components of the foreground.
Components connected_components(const Mask& mask);
// The largest 8-connected component (the first in raster order among equals); empty mask stays empty.
Mask largest_component(const Mask& mask);

// Fills 4-connected background regions that do not touch the border and are at most max_area pixels large.
Mask fill_holes(const Mask& mask, long max_area = max_image_pixels);

// --- distance --------------------------------------------------------------------------------------------

// Exact squared Euclidean distance of every pixel to the nearest pixel with mask == 0 (Felzenszwalb &
// Huttenlocher 2012, in integers). Pixels outside the image count as background.
Grid<int> squared_distance_transform(const Mask& mask);
// Its square root.
Grid<float> distance_transform(const Mask& mask);
// For every pixel the index (y·width + x) of a nearest pixel with seeds == 1, −1 when there is none. Ties: the
// smallest index.
Grid<int> nearest_seed(const Mask& seeds);

} // namespace pantin
