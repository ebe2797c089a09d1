// SPDX-License-Identifier: MIT
// The walkthrough: one page on which every step shows what it did to a drawing.
#pragma once

#include <filesystem>

#include "pantin/pipeline.hpp"

namespace pantin {

// All that `animate` does and writes, and out/index.html: one self-contained HTML file (pictures, data,
// program text and a 3D viewer are inside; it asks for nothing over the network) with a chapter a step for
// each character, drawn from the intermediate results of this very run. With more than six characters the
// solids are left out. Readable without a script; with one, the pictures answer. A character that could not
// go on has the chapters up to there, and why. Throws what `animate` throws; Error(not_animated) after
// index.html is written.
Page explain(const std::filesystem::path& image, const std::filesystem::path& out, const Settings& settings);

} // namespace pantin
