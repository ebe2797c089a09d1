// SPDX-License-Identifier: MIT
// What the subcommands share: common options, the progress bar, the way errors reach the user. No algorithm
// lives in this module.
#pragma once

#include <string>
#include <vector>

#include "cli/arguments.hpp"
#include "pantin/pipeline.hpp"

namespace pantin::cli {

struct CommonOptions {
    std::string preset = "default";
    std::string config, detector, weights, references, motion, motion_map;
    std::string config_text; // a configuration at hand instead of in a file (of `batch`)
    int threads = 0;         // 0: all cores
    std::string rotate = "auto";
    std::vector<int> only;
    bool trace = false, quiet = false, animated_drawings = false, blend = false;
    bool in_place = false, follow = false; // a recorded motion's way
};
struct RenderFlags {
    std::string clip = "all", background = "transparent", quality = "lossless";
    double fps = 25;
    int size = 512;
    std::vector<std::string> formats;
    bool perspective = false, scene = false;
};

void add_common_options(Command command, CommonOptions& options);
void add_detector_option(Command command, CommonOptions& options); // of the commands that detect
void add_only_option(Command command, CommonOptions& options);
void add_rotate_option(Command command, CommonOptions& options);            // of those that read a page
void add_motion_options(Command command, CommonOptions& options);           // of those that move a character
void add_animated_drawings_option(Command command, CommonOptions& options); // of those that rig
void add_override_options(Command command,
                          Overrides& overrides); // of those that run all steps: results that the user gives
void add_render_options(Command command, RenderFlags& flags);

// Preset, then configuration file, then the other options. Error(usage) or Error(input).
Settings make_settings(const CommonOptions& options, const RenderFlags& flags = {});

// One line on standard error, whatever the message holds.
void print_error(const std::string& message);
// The same for a warning.
void print_warning(const std::string& message);
// Without a bar when the share is negative, that is unknown.
void show_progress(const std::string& what, double share);
// Takes the progress bar off the terminal.
void clear_progress();
// A result on standard output, unless --quiet.
void print_result(const CommonOptions& options, const std::string& line);

// What --version prints: libraries, kernel, weights, licence.
std::string version_text();

// A command that says that the program was made without it, with what switch of make.
void add_left_out(Command app, const std::string& name, const std::string& made_with);

void add_animate(Command app);
void add_steps(Command app);
void add_evaluate(Command app);
void add_options(Command app);
void add_model(Command app);
void add_batch(Command app);
void add_explain(Command app);
void add_verify(Command app);
void add_manual(Command app);
void add_completion(Command app);

} // namespace pantin::cli
