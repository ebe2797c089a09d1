#include "pipeline/given.hpp"

#include <algorithm>

#include "pantin/image.hpp"
#include "pipeline/character.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

GreyImage load_beside(const fs::path& file, const RgbImage& page, const fs::path& image, int rotate) {
    GreyImage picture = turned(load_grey(file), rotate);
    if (picture.width() != page.width() || picture.height() != page.height())
        fail_size(file, picture.width(), picture.height(), image.string(), page.width(), page.height());
    return picture;
}

} // namespace

std::optional<GivenCharacter> given_character(const RgbImage& page, const fs::path& image, const Settings& settings) {
    const Given& given = settings.given;
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
    const fs::path& file = given.labels.empty() ? given.mask : given.labels;
    if (std::count(mask.begin(), mask.end(), 1) == 0)
        throw Error(ErrorKind::input, file.string() + ": has no pixel of the character");
    GivenCharacter character{character_of(page, mask, settings.options.detection), std::nullopt};
    const Mask& small = character.detected.mask;
    if (!given.labels.empty())
        character.labels = resize_nearest(crop(labels, character.detected.box), small.width(), small.height());
    return character;
}

} // namespace pantin
