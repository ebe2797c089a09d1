// SPDX-License-Identifier: MIT
// docs/results.md: the counterparts of table 5.1 (times) and tables 6.1 to 6.3 (success of each step) of the
// thesis.
#pragma once

#include <filesystem>
#include <string>

#include "figures/verdicts.hpp"

namespace pantin::figures {

// Table 5.1 as Markdown: median times of the steps on the drawings of the folder, one thread. Differs from
// run to run.
std::string time_table(const std::string& testdata);

// Tables 6.1 to 6.3 as Markdown: a dataset of generated drawings run with both presets (results below
// `work`), and the drawings of testdata as judged by eye.
std::string success_tables(const std::filesystem::path& dataset, const std::filesystem::path& work,
                           const Verdicts& verdicts);

// The whole page.
std::string results_page(const std::filesystem::path& dataset, const std::filesystem::path& work,
                         const std::string& testdata, const Verdicts& verdicts);

} // namespace pantin::figures
