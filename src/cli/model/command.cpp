// SPDX-License-Identifier: MIT
// pantin model STROKES|CHARACTER_DIR -o DIR
#include <cstdio>
#include <memory>

#include "cli/command.hpp"

namespace pantin::cli {

namespace {

struct Arguments {
    CommonOptions common;
    RenderFlags render;
    std::string input, out, calls, reference;
    bool animate = false;
};

int run_model(const Arguments& arguments) {
    Settings settings = make_settings(arguments.common, arguments.render);
    settings.overrides.reference = arguments.reference;
    const std::filesystem::path input = arguments.input;
    std::error_code ignored;
    const bool folder = std::filesystem::is_directory(input, ignored);
    if (arguments.out.empty() && !folder)
        throw Error(ErrorKind::usage, "--output is required with a file of strokes");
    const std::filesystem::path out =
        arguments.out.empty() ? input / "model" : std::filesystem::path(arguments.out);
    model_folder(input, out, arguments.calls, settings);
    if (arguments.animate) {
        const Identification identified = animate_folder(out, settings);
        char confidence[16];
        std::snprintf(confidence, sizeof confidence, " (%.2f)", identified.confidence);
        print_result(arguments.common, out.string() + ": moves like: " + identified.reference + confidence);
    }
    clear_progress();
    print_result(arguments.common, out.string());
    return 0;
}

} // namespace

void add_model(Command app) {
    const auto arguments = std::make_shared<Arguments>();
    Command command =
        app.subcommand("model", "strokes of parts, or a character's folder, to a rigged 3D model (RealSkel)");
    command
        .option("STROKES", arguments->input,
                "strokes (.json, .svg), or the folder of a character with labels.png")
        .required();
    command.option("-o,--output", arguments->out, "folder for the results; of a character: its folder model");
    command.option("--calls", arguments->calls,
                   "JSON file of calls to play after the strokes: move_part, set_symmetry, refine, ...");
    command.flag("--animate", arguments->animate, "then identify, rig and render the model");
    command.option("--reference", arguments->reference,
                   "with --animate: what the model moves like, instead of what fits best");
    add_motion_options(command, arguments->common);
    add_render_options(command, arguments->render);
    add_common_options(command, arguments->common);
    command.run([arguments] { return run_model(*arguments); });
}

} // namespace pantin::cli
