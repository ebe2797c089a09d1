// SPDX-License-Identifier: MIT
// Verifications and comparisons as text.
#include <algorithm>

#include "core/decimal.hpp"
#include "pantin/verify.hpp"

namespace pantin {

namespace {

// One line of a table, without white space at its end.
std::string row(std::string line, const std::vector<std::string>& cells, std::size_t width) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
        line.resize(std::max(line.size(), (i + 1) * width), ' ');
        line += cells[i];
    }
    return line + "\n";
}

std::string described(const FileDifference& d, const std::string& one, const std::string& between,
                      const std::string& other) {
    std::string text = d.file + ": " + (d.place.empty() ? "" : d.place + ": ") + one + between + other;
    if (d.values < 2) return text;
    text += "; " + std::to_string(d.values) + " values differ";
    if (d.largest > 0) text += ", most by " + to_decimal(d.largest) + " (" + d.largest_place + ")";
    return text;
}

const StageDifferences* find(const Verification& verification, const std::string& stage,
                             const std::string& drawing) {
    const auto found =
        std::find_if(verification.results.begin(), verification.results.end(),
                     [&](const StageDifferences& r) { return r.stage == stage && r.drawing == drawing; });
    return found == verification.results.end() ? nullptr : &*found;
}

} // namespace

std::string verification_table(const Verification& verification) {
    constexpr std::size_t width = 12;
    std::string text = row("stage", verification.drawings, width), below;
    std::size_t checked = 0, equal = 0;
    for (const std::string& stage : verification.stages) {
        std::vector<std::string> cells;
        for (const std::string& drawing : verification.drawings) {
            const StageDifferences* result = find(verification, stage, drawing);
            cells.push_back(!result ? "-" : result->files.empty() ? "ok" : "DIFFERS");
            if (!result) continue;
            ++checked;
            equal += result->files.empty();
            for (const FileDifference& d : result->files)
                below += stage + ": " + described(d, d.second, ", stored ", d.first) + "\n";
        }
        text += row(stage, cells, width);
    }
    return text + below + std::to_string(equal) + " of " + std::to_string(checked) + " agree, digest " +
           verification.digest;
}

std::string comparison_table(const FolderComparison& comparison) {
    std::string text;
    std::size_t files = 0;
    for (const StageDifferences& stage : comparison.stages) {
        text += stage.stage + "\n";
        files += stage.files.size();
        for (const FileDifference& d : stage.files)
            text += "  " + described(d, d.first, " and ", d.second) + "\n";
    }
    return text + std::to_string(files) + " of " + std::to_string(comparison.files) + " files differ";
}

} // namespace pantin
