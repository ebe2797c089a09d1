// SPDX-License-Identifier: MIT
// The same evaluation with other values of some options: `pantin evaluate --sweep`. It redoes experiments
// such as those of thesis 4.4 (the weights of H2) and 4.5 (label distances, K).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pantin/evaluation.hpp"

namespace pantin {

struct SweptOption {
    std::string name;                // of list_options()
    std::vector<std::string> values; // as JSON text
};
// "option=value,value;option=value". An option is named as in list_options(), or by what follows the last
// point where only one option has that name, in small or capital letters ("K_v"). A comma does for the
// semicolon. Error(usage): there is no such option, it does not take the value, an option or a value stands
// twice, or there are more than 1000 combinations. Own.
std::vector<SweptOption> parse_sweep(const std::string& text);

// One combination: a value of each option, in their order.
struct SweepResult {
    std::vector<std::string> values;
    std::filesystem::path folder; // below `out`
    Evaluation evaluation;
};
// Evaluates each combination (the last option changes fastest) as evaluate() does with these values set, to
// out/combination-1, … Steps before the first that depends on a swept option run once. Their times stand in
// every evaluation. Same errors as evaluate(). Own.
std::vector<SweepResult> sweep(const Dataset& dataset, const std::filesystem::path& out,
                               const Settings& settings, const std::vector<SweptOption>& options);

// One row a combination, with the values that most people look for. No error. Own.
std::string sweep_to_text(const std::vector<SweptOption>& options, const std::vector<SweepResult>& results);
// Every measurement of every combination: a column for each option, then those of measurements_to_csv(). No
// error. Own.
std::string sweep_to_csv(const std::vector<SweptOption>& options, const std::vector<SweepResult>& results);

} // namespace pantin
