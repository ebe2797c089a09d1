// SPDX-License-Identifier: MIT
// The walkthrough: one page on which every step shows what it did to a drawing.
#pragma once

#include <filesystem>

#include "pantin/pipeline.hpp"

namespace pantin {

// All that `animate` does and writes, and out/index.html: one self-contained HTML file (pictures, data,
// scripts and a 3D viewer are inside; it asks for nothing over the network) with a chapter a step for each
// character, drawn from the intermediate results of this very run. With more than six characters the solids
// are left out. Readable without scripts; with them the pictures are interactive. A character that could not
// go on has the chapters up to there, and why. image: a page's file; out: a folder. Errors are those of
// animate(); Error(not_animated) after index.html is written. Own; the steps are those of thesis ch. 4.
Page explain(const std::filesystem::path& image, const std::filesystem::path& out, const Settings& settings);

} // namespace pantin
