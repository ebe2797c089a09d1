// SPDX-License-Identifier: MIT
// Mask, labels or joints that the user gives to a character as detection would make it.
#include "pipeline/overrides.hpp"

#include <algorithm>

#include "formats/animated_drawings.hpp"
#include "formats/file_names.hpp"
#include "formats/pictures.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

GreyImage load_beside(const fs::path& file, const RgbImage& page, const fs::path& image, int rotate) {
    GreyImage picture = turned(load_grey(file), rotate);
    if (picture.width() != page.width() || picture.height() != page.height())
        fail_size(file, picture.width(), picture.height(), picture_of(image).string(), page.width(),
                  page.height());
    return picture;
}

} // namespace

fs::path picture_of(const fs::path& image) {
    return is_animated_drawings_folder(image) ? image / file_names::texture : image;
}

bool has_given_character(const fs::path& image, const Settings& settings) {
    return !settings.overrides.mask.empty() || !settings.overrides.labels.empty() ||
           is_animated_drawings_folder(image);
}

std::optional<GivenCharacter> given_character(const RgbImage& page, const PageInk& ink, const fs::path& image,
                                              const Settings& settings, const DetectionOptions& options) {
    Overrides overrides = settings.overrides;
    const bool has_joints = is_animated_drawings_folder(image) && overrides.labels.empty();
    if (has_joints && overrides.mask.empty()) overrides.mask = image / file_names::mask;
    if (overrides.mask.empty() && overrides.labels.empty()) return std::nullopt;
    Mask mask(page.width(), page.height(), 1);
    LabelMap labels;
    if (!overrides.mask.empty()) {
        mask = load_beside(overrides.mask, page, image, settings.rotate);
        for (std::uint8_t& pixel : mask) pixel = pixel >= 128;
    }
    if (!overrides.labels.empty()) {
        labels = load_beside(overrides.labels, page, image, settings.rotate);
        check_labels(labels, overrides.labels);
        for (std::size_t i = 0; i < mask.size(); ++i) {
            if (!mask.data()[i]) labels.data()[i] = 0;
            mask.data()[i] = labels.data()[i] != 0;
        }
    }
    if (has_joints && settings.rotate != 0)
        throw Error(ErrorKind::usage, "--rotate does not go with the joints of " + image.string());
    if (has_joints) labels = labels_from_joints(mask, read_joints(image, page.width(), page.height()));
    const fs::path& file = overrides.labels.empty() ? overrides.mask : overrides.labels;
    if (std::count(mask.begin(), mask.end(), 1) == 0)
        throw Error(ErrorKind::input, file.string() + ": has no pixel of the character");
    GivenCharacter character{character_of(page, ink, mask, options), std::nullopt};
    const Mask& small = character.detected.mask;
    if (!labels.empty())
        character.labels =
            resize_nearest(crop(labels, character.detected.box), small.width(), small.height());
    return character;
}

} // namespace pantin
