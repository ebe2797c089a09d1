// SPDX-License-Identifier: MIT
// Are the results on this machine those that were released? Every stage of the pipeline on three small
// drawings of our own for each preset, each stage's output compared with the stored one to the last bit
// (docs/determinism.md, "pantin verify"); and two folders of results compared with each other.
//
// The stored outputs are the reference vectors (testdata/vectors/README.md): files in the formats of
// docs/formats.md, compiled in.
//
// Every stage takes its input from the stored files, not from the stage before it. So a stage that differs is
// reported alone, and the stages after it are still checked, each for itself. Nothing is lost: when every
// stage turns the stored input into the stored output, the whole run does, since files keep every bit of what
// a stage hands on. `end_to_end` runs the chain instead.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/pipeline.hpp"

namespace pantin {

// Names below a folder, with '/' between, and the files' bytes.
using Files = std::map<std::string, std::string>;

// --- differences -------------------------------------------------------------------------------------------

// How one file differs from another of its name. JSON, GLB (its accessors' values, its picture), text and
// pixels are compared as values, whatever the encoding; any other file as bytes.
struct FileDifference {
    std::string file;
    // Of the first value that differs: "vertices[3].x", "pixel (4, 17), green", "line 12, word 3".
    std::string place;
    std::string first, second; // the two values there, or two facts: "12 elements", "missing"
    std::size_t values = 0;    // that differ, as far as the two have the same structure
    double largest = 0;        // difference of two numbers; 0 when none of those that differ are numbers
    std::string largest_place;
    // Of pictures and films: the first one in light grey, pixels that differ in red.
    std::optional<RgbImage> picture;
};
// name: decides how they are compared; first, second: bytes. None when all values are equal. Error(input)
// when one of them is damaged. Own.
std::optional<FileDifference> compare_files(const std::string& name, const std::string& first,
                                            const std::string& second);

struct StageDifferences {
    std::string stage;
    std::string drawing; // of verify()
    std::vector<FileDifference> files;
};

// --- the stored outputs ------------------------------------------------------------------------------------

struct VerificationSettings {
    std::string preset = "default"; // whose drawings and stored outputs
    Options options = verification_options();
    int threads = 1;         // results do not depend on it
    bool end_to_end = false; // stages take what the stage before has just made
    std::function<void(const std::string& stage, double share)> progress; // as in Settings

    // The preset with coarser animations and solids, so that the stored files are small. Error(usage) when
    // there is no such preset. Own.
    static Options verification_options(std::string_view preset = "default");
    // Of a preset; the same error. Own.
    static VerificationSettings of(std::string_view preset);
};

// The presets with stored outputs, in the order in which they are verified. No error. Own.
std::span<const std::string_view> verified_presets();

struct Verification {
    std::vector<std::string> drawings, stages; // columns and rows of the table, in the order of the flow
    // Of each stage on each drawing that it is for; `files` is empty where all agree.
    std::vector<StageDifferences> results;
    Files outputs;      // `<drawing>/<file>`, of `thesis` `thesis/<drawing>/<file>`: the inputs, and what the
                        // stages made
    std::string digest; // of the values of all outputs: equal where the results are
    // The first one that differs, none when all agree.
    const StageDifferences* first_difference() const;
};
// Writes nothing. A stage that throws differs by its message. In a FileDifference the stored value is the
// first one. Error(usage) when there is no such preset, Error(internal) when the compiled-in files are
// damaged. Own (docs/determinism.md).
Verification verify(const VerificationSettings& settings = {});

// Rows stages, columns drawings, "ok" or "DIFFERS"; below it a line for each file that differs; last the
// digest. No error. Own.
std::string verification_table(const Verification& verification);

// --- two folders -------------------------------------------------------------------------------------------

// Output folders of `verify`, of `animate` or of any step, made on two machines or by two versions.
struct FolderComparison {
    int files = 0;                        // that at least one of the two has
    std::vector<StageDifferences> stages; // in the order of the flow, those with differences only
};
// Error(input) when one of them is no folder or has no files, or a file is damaged. Own.
FolderComparison compare_folders(const std::filesystem::path& first, const std::filesystem::path& second);

// For each stage the files that differ, with the number of values, the first and the largest difference. No
// error. Own.
std::string comparison_table(const FolderComparison& comparison);

} // namespace pantin
