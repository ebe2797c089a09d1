// SPDX-License-Identifier: MIT
// Files of a character's folder to drawing, mask and labels, checked against each other.
#include "formats/pictures.hpp"

#include "formats/file_names.hpp"
#include "pantin/error.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

std::string size_text(int width, int height) { return std::to_string(width) + "×" + std::to_string(height); }

} // namespace

RgbImage read_drawing(const fs::path& folder) { return load_image(folder / file_names::drawing, 1); }

GreyImage read_ink(const fs::path& folder, const RgbImage& drawing) {
    const fs::path file = folder / file_names::ink;
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return ink_of_crop(ink_darkness(drawing));
    GreyImage ink = inverted(load_grey(file));
    if (ink.width() != drawing.width() || ink.height() != drawing.height())
        fail_size(file, ink.width(), ink.height(), file_names::drawing, drawing.width(), drawing.height());
    return ink;
}

Mask read_mask(const fs::path& folder) {
    Mask mask = load_grey(folder / file_names::mask);
    for (std::uint8_t& pixel : mask) pixel = pixel >= 128 ? 1 : 0;
    return mask;
}

LabelMap read_labels(const fs::path& folder, const Mask& mask) {
    const fs::path file = folder / file_names::labels;
    LabelMap labels = load_grey(file);
    if (labels.width() != mask.width() || labels.height() != mask.height())
        fail_size(file, labels.width(), labels.height(), file_names::mask, mask.width(), mask.height());
    check_labels(labels, file);
    return labels;
}

void check_labels(const LabelMap& labels, const fs::path& file) {
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x)
            if (labels(x, y) >= label_count)
                throw Error(ErrorKind::input, file.string() + ": pixel (" + std::to_string(x) + ", " +
                                                  std::to_string(y) + ") has the value " +
                                                  std::to_string(labels(x, y)) + ", labels are 0 to " +
                                                  std::to_string(label_count - 1));
}

void fail_size(const fs::path& file, int width, int height, const std::string& other, int other_width,
               int other_height) {
    throw Error(ErrorKind::input, file.string() + ": is " + size_text(width, height) + " pixels, but " +
                                      other + " is " + size_text(other_width, other_height));
}

GreyImage to_grey(const Mask& mask) {
    GreyImage grey = mask;
    for (std::uint8_t& pixel : grey) pixel = pixel != 0 ? 255 : 0;
    return grey;
}

} // namespace pantin
