// SPDX-License-Identifier: MIT
// What the subcommands share: common options, the bar, the way errors reach the user. No algorithm lives in
// this room.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "pantin/pipeline.hpp"

namespace pantin::cli {

// The exit code of the command line. `run` is set by the subcommand that the user chose.
using Run = std::function<int()>;

struct CommonOptions {
    std::string preset = "default";
    std::string config, detector, weights, references, motion;
    std::string config_text; // a configuration at hand instead of in a file (of `batch`)
    int threads = 0;         // 0: all cores
    int rotate = 0;
    bool trace = false, quiet = false, animated_drawings = false, blend = false;
};
struct RenderFlags {
    std::string clip = "all", background = "transparent";
    double fps = 25;
    int size = 512;
    std::vector<std::string> formats;
    bool perspective = false, scene = false;
};

void add_common_options(CLI::App& command, CommonOptions& options);
void add_detector_option(CLI::App& command, CommonOptions& options); // of the commands that detect
void add_rotate_option(CLI::App& command, CommonOptions& options);   // of those that read a page
void add_motion_options(CLI::App& command, CommonOptions& options);  // of those that move a character
void add_animated_drawings_option(CLI::App& command, CommonOptions& options); // of those that rig
void add_override_options(CLI::App& command,
                          Overrides& overrides); // of those that run all steps: results that the user gives
void add_render_options(CLI::App& command, RenderFlags& flags);

// Preset, then configuration file, then the other options. Error(usage) or Error(input).
Settings make_settings(const CommonOptions& options, const RenderFlags& flags = {});

// One line on standard error, whatever the message holds.
void print_error(const std::string& message);
// Without a bar when the share is negative, that is unknown.
void show_progress(const std::string& what, double share);
// Takes the progress bar off the terminal.
void clear_progress();
// A result on standard output, unless --quiet.
void print_result(const CommonOptions& options, const std::string& line);

void add_animate(CLI::App& app, Run& run);
void add_steps(CLI::App& app, Run& run);
void add_evaluate(CLI::App& app, Run& run);
void add_model(CLI::App& app, Run& run);
void add_batch(CLI::App& app, Run& run);
void add_explain(CLI::App& app, Run& run);
void add_verify(CLI::App& app, Run& run);
void add_manual(CLI::App& app, Run& run);
void add_completion(CLI::App& app, Run& run);

} // namespace pantin::cli
