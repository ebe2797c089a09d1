// SPDX-License-Identifier: MIT
// pantin explain IMAGE -o DIR
#include <memory>

#include "cli/character_lines.hpp"
#include "cli/command.hpp"
#include "formats/file_names.hpp"
#include "pantin/explain.hpp"

namespace pantin::cli {

namespace {

struct Arguments {
    CommonOptions common;
    RenderFlags render;
    Overrides overrides;
    std::string image, out;
};

int run_explain(const Arguments& arguments) {
    const std::filesystem::path out = arguments.out;
    Settings settings = make_settings(arguments.common, arguments.render);
    settings.overrides = arguments.overrides;
    const std::string written = (out / file_names::walkthrough).string();
    try {
        const Page page = explain(arguments.image, out, settings);
        print_result(arguments.common, written);
        for (const PageCharacter& character : page.characters)
            if (character.status != "ok")
                print_error(character_line(out, character, !arguments.overrides.reference.empty()));
    } catch (const Error& error) {
        // Written all the same, and of most use then.
        if (error.kind() == ErrorKind::not_animated) print_result(arguments.common, written);
        throw;
    }
    return 0;
}

} // namespace

void add_explain(Command app) {
    const auto arguments = std::make_shared<Arguments>();
    Command command = app.subcommand(
        "explain", "the whole pipeline, and a page that shows what every step did: DIR/index.html");
    command
        .option("IMAGE", arguments->image,
                "page (PNG, JPEG, WebP, GIF or BMP), or AnimatedDrawings character folder")
        .required();
    command.option("-o,--output", arguments->out, "folder for the results").required();
    add_render_options(command, arguments->render);
    add_override_options(command, arguments->overrides);
    add_motion_options(command, arguments->common);
    add_only_option(command, arguments->common);
    add_rotate_option(command, arguments->common);
    add_detector_option(command, arguments->common);
    add_common_options(command, arguments->common);
    command.run([arguments] { return run_explain(*arguments); });
}

} // namespace pantin::cli
