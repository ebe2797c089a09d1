// SPDX-License-Identifier: MIT
// Runs the program that the environment variable PANTIN names (make test-run sets it).
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace pantin::test {

struct Outcome {
    int code = -1;        // exit code; 128 + signal when it was killed
    std::string out, err; // standard output and standard error
};

using Environment = std::vector<std::pair<std::string, std::string>>;

// `standard_output`: a file to write to instead of keeping the output. `standard_input`: what the program
// reads there.
Outcome run_pantin(const std::vector<std::string>& arguments, const Environment& environment = {},
                   const std::string& standard_output = "", const std::string& standard_input = "");

// Commands of the shell in a folder, where `pantin` is the program; they end at the first that fails.
Outcome run_shell(const std::string& script, const std::filesystem::path& folder);

} // namespace pantin::test
