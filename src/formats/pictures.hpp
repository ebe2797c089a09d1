// SPDX-License-Identifier: MIT
// drawing.png, ink.png, mask.png and labels.png of a character's folder (docs/formats.md). Readers throw
// Error(input) that names the file and what is wrong.
#pragma once

#include <filesystem>
#include <string>

#include "pantin/image.hpp"
#include "pantin/label.hpp"

namespace pantin {

RgbImage read_drawing(const std::filesystem::path& folder); // the crop, page pixels
// What of it is drawn: 0 paper, 255 the strongest strokes (in the file black). Without a file, which only a
// folder made by hand lacks, it is found on the drawing.
GreyImage read_ink(const std::filesystem::path& folder, const RgbImage& drawing);
Mask read_mask(const std::filesystem::path& folder); // working size, 0 or 1 (file: at least 128)
LabelMap read_labels(const std::filesystem::path& folder, const Mask& mask); // of the mask's size

// A label map has a value that is none.
void check_labels(const LabelMap& labels, const std::filesystem::path& file);
// Two pictures that belong together have different sizes.
[[noreturn]] void fail_size(const std::filesystem::path& file, int width, int height,
                            const std::string& other, int other_width, int other_height);

// Masks have 0 and 255 in files.
GreyImage to_grey(const Mask& mask);

} // namespace pantin
