// SPDX-License-Identifier: MIT
// A file to the picture of the page that step 1 sees: on paper or cut out, the sheet alone, turned; and its
// ink.
#pragma once

#include <filesystem>
#include <optional>

#include "pantin/image.hpp"
#include "pantin/settings.hpp"
#include "pantin/sheet.hpp"

namespace pantin {

inline constexpr int pale = 200;               // luma from which a figure would vanish on white …
inline constexpr Rgb8 dark_ground{48, 52, 60}; // … and is put on this

struct PagePicture {
    RgbImage picture;
    PageInk ink;
    std::optional<SheetCorners> sheet; // in the file's picture, when it was flattened
};

// flattens: whether a sheet on a photograph is looked for. A figure on a transparent ground keeps its colours
// and stands on white, or on dark when it is itself nearly white. A sheet of paper that was cut out is a
// page. Error(input) names the file.
PagePicture load_page_picture(const std::filesystem::path& file, int rotate, bool flattens);
// A figure on a transparent ground, as above. No error.
PagePicture cut_out_picture(const RgbaImage& figure);

} // namespace pantin
