// SPDX-License-Identifier: MIT
#include "pipeline/given.hpp"

#include <algorithm>

#include "pantin/image.hpp"
#include "pipeline/animated_drawings.hpp"
#include "pipeline/character.hpp"

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
    return is_animated_drawings_folder(image) ? image / "texture.png" : image;
}

std::optional<GivenCharacter> given_character(const RgbImage& page, const fs::path& image,
                                              const Settings& settings) {
    Given given = settings.given;
    const bool has_joints = is_animated_drawings_folder(image) && given.labels.empty();
    if (has_joints && given.mask.empty()) given.mask = image / "mask.png";
    if (given.mask.empty() && given.labels.empty()) return std::nullopt;
    Mask mask(page.width(), page.height(), 1);
    LabelMap labels;
    if (!given.mask.empty()) {
        mask = load_beside(given.mask, page, image, settings.rotate);
        for (std::uint8_t& pixel : mask) pixel = pixel >= 128;
    }
    if (!given.labels.empty()) {
        labels = load_beside(given.labels, page, image, settings.rotate);
        check_labels(labels, given.labels);
        for (std::size_t i = 0; i < mask.size(); ++i) {
            if (!mask.data()[i]) labels.data()[i] = 0;
            mask.data()[i] = labels.data()[i] != 0;
        }
    }
    if (has_joints && settings.rotate != 0)
        throw Error(ErrorKind::usage, "--rotate does not go with the joints of " + image.string());
    if (has_joints) labels = labels_from_joints(mask, read_joints(image, page.width(), page.height()));
    const fs::path& file = given.labels.empty() ? given.mask : given.labels;
    if (std::count(mask.begin(), mask.end(), 1) == 0)
        throw Error(ErrorKind::input, file.string() + ": has no pixel of the character");
    GivenCharacter character{character_of(page, mask, settings.options.detection), std::nullopt};
    const Mask& small = character.detected.mask;
    if (!labels.empty())
        character.labels =
            resize_nearest(crop(labels, character.detected.box), small.width(), small.height());
    return character;
}

} // namespace pantin
