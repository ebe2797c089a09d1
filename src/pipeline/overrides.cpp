// SPDX-License-Identifier: MIT
// Mask, labels or joints that the user gives to a character as detection would make it.
#include "pipeline/overrides.hpp"

#include <algorithm>

#include "formats/animated_drawings.hpp"
#include "formats/figure_joints.hpp"
#include "formats/file_names.hpp"
#include "formats/joint_labels.hpp"
#include "formats/joint_places.hpp"
#include "formats/pictures.hpp"
#include "pantin/image.hpp"
#include "pipeline/given_mask.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

void check_size(const fs::path& file, int width, int height, const RgbImage& page, const fs::path& image) {
    if (width != page.width() || height != page.height())
        fail_size(file, width, height, picture_of(image).string(), page.width(), page.height());
}

Mask mask_beside(const fs::path& file, const RgbImage& page, const fs::path& image, int rotate,
                 std::vector<std::string>& remarks) {
    GivenMask given = load_given_mask(file, rotate);
    check_size(file, given.mask.width(), given.mask.height(), page, image);
    if (!given.remark.empty()) remarks.push_back(given.remark);
    return std::move(given.mask);
}

// Of a folder's joints; none, and a remark, when the part network has to say what the parts are.
LabelMap labels_beside(const Mask& mask, const fs::path& folder, int rotate,
                       std::vector<std::string>& remarks) {
    constexpr const char* instead = "; the network's parts are taken";
    const FigureJoints figure = read_joints(folder, mask.width(), mask.height());
    if (figure.joints.empty()) {
        remarks.push_back(figure.remark + instead);
        return {};
    }
    LabelMap labels = labels_from_joints(mask, figure.joints);
    if (labels.empty()) {
        remarks.push_back(joints_file(folder).string() +
                          ": its joints do not say what is trunk, head, limb, tail or wing" + instead);
        return {};
    }
    if (rotate != 0)
        throw Error(ErrorKind::usage, "--rotate does not go with the joints of " + folder.string());
    // Of another picture, say, or of this one at another size.
    const int outside = joints_outside(mask, figure.joints), all = static_cast<int>(figure.joints.size());
    if (2 * outside > all) {
        remarks.push_back(joints_file(folder).string() + ": " + std::to_string(outside) + " of its " +
                          std::to_string(all) + " joints lie outside of the mask" + instead);
        return {};
    }
    if (!figure.remark.empty()) remarks.push_back(figure.remark);
    return labels;
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
    const int rotate = settings.rotate.value_or(0);
    Mask mask(page.width(), page.height(), 1);
    LabelMap labels;
    std::vector<std::string> remarks;
    if (!overrides.mask.empty()) mask = mask_beside(overrides.mask, page, image, rotate, remarks);
    if (!overrides.labels.empty()) {
        labels = load_grey(overrides.labels);
        labels = turned(std::move(labels), rotate);
        check_size(overrides.labels, labels.width(), labels.height(), page, image);
        check_labels(labels, overrides.labels);
        for (std::size_t i = 0; i < mask.size(); ++i) {
            if (!mask.data()[i]) labels.data()[i] = 0;
            mask.data()[i] = labels.data()[i] != 0;
        }
    }
    if (has_joints) labels = labels_beside(mask, image, rotate, remarks);
    const fs::path& file = overrides.labels.empty() ? overrides.mask : overrides.labels;
    if (std::count(mask.begin(), mask.end(), 1) == 0)
        throw Error(ErrorKind::input, file.string() + ": has no pixel of the character");
    GivenCharacter character{character_of(page, ink, mask, options), std::nullopt, std::move(remarks)};
    const Mask& small = character.detected.mask;
    if (!labels.empty())
        character.labels =
            resize_nearest(crop(labels, character.detected.box), small.width(), small.height());
    return character;
}

} // namespace pantin
