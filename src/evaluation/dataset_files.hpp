// SPDX-License-Identifier: MIT
// The files of a dataset (docs/formats.md), which another program's answers have, too.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pantin/evaluation.hpp"

namespace pantin {

struct IndexRow {
    std::string id;
    std::vector<TrueCharacter> characters; // without masks
    std::vector<double> scores;            // of answers; 1 where none is given
};
// The lines of an index.ndjson. Error(input) names the line.
std::vector<IndexRow> read_index(const std::filesystem::path& index);

struct PagePictures {
    LabelMap labels;         // empty without label/<id>.png
    std::vector<Mask> masks; // of the characters 1, 2, … of instance/<id>.png; else of all labels
};
// Empty when there is neither file. Error(input) when the two have different sizes.
PagePictures read_pictures(const std::filesystem::path& folder, const std::string& id);

} // namespace pantin
