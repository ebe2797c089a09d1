// SPDX-License-Identifier: MIT
// A page on its way through the steps, which may stop between two of them and go on from a copy of its
// folder.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "evaluation/answers.hpp"
#include "pantin/evaluation.hpp"

namespace pantin {

using StepSeconds = std::array<std::vector<double>, evaluated_steps.size()>;

struct PageRun {
    std::vector<std::string> status; // of each character that was found: "ok", or the step and why not
};

// Steps first … last − 1 of evaluated_steps on a page whose folder is `out`; those before `first` ran
// already. Adds how long each took. Errors are those of the steps, without "no character" and "not animated".
void run_steps(PageRun& run, const TruePage& truth, const std::filesystem::path& out,
               const Settings& settings, std::size_t first, std::size_t last, StepSeconds& seconds);
// What the steps left in the page's folder. Error(input) when the page is not as large as its label map.
std::vector<Answer> read_answers(const PageRun& run, const TruePage& truth, const std::filesystem::path& out);
// The settings for the steps of a page: not turned by itself, without progress and warnings.
Settings quiet(const Settings& settings);

} // namespace pantin
