// SPDX-License-Identifier: MIT
// Pictures to judge by eye what became of a drawing: docs/verdicts.csv.
#pragma once

#include <filesystem>
#include <string>

namespace pantin::figures {

// Each character of every picture in a folder as one SVG in `out`: drawing with its silhouette, parts,
// skeleton, mapping, frames of the first clip; where it was rejected, the step and the reason. (Scribbles,
// which `pantin segment` turns away, go on here.)
void write_review(const std::string& pictures, const std::filesystem::path& out);

} // namespace pantin::figures
