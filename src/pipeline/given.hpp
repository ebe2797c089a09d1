// What the user gives instead of a step's result.
#pragma once

#include <filesystem>
#include <optional>

#include "pantin/pipeline.hpp"

namespace pantin {

struct GivenCharacter {
    DetectedCharacter detected;
    std::optional<LabelMap> labels; // of the mask's size
};

// The character of the given mask or labels; none when neither is given. `page` is turned already. Error(input) names the
// file that does not fit.
std::optional<GivenCharacter> given_character(const RgbImage& page, const std::filesystem::path& image,
                                              const Settings& settings);

} // namespace pantin
