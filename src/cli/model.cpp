// SPDX-License-Identifier: MIT
// pantin model STROKES|CHARACTER_DIR -o DIR
#include <cstdio>
#include <memory>

#include "cli/command.hpp"
#include "core/file.hpp"
#include "core/json_reader.hpp"
#include "formats/file_names.hpp"

namespace pantin::cli {

namespace {

struct Arguments {
    CommonOptions common;
    RenderFlags render;
    std::string input, out, calls, reference;
    bool animate = false;
};

// "quadruped (0.97)", of a folder that was identified.
std::string type_line(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / file_names::identification;
    const Json json = parse_json(read_text(file), file.string());
    const JsonReader reader(json, file.string());
    char confidence[16];
    std::snprintf(confidence, sizeof confidence, "%.2f", reader.at("confidence").number(0, 1));
    return reader.at("reference").text() + " (" + confidence + ")";
}

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
        identify_folder(out, settings);
        Settings quiet = settings;
        quiet.warning = nullptr; // render says it again
        rig_folder(out, quiet);
        render_folder(out, settings);
        print_result(arguments.common, out.string() + ": moves like: " + type_line(out));
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
