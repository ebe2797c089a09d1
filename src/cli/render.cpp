// pantin render CHARACTER_DIR
#include <memory>

#include "cli/command.hpp"

namespace pantin::cli {

namespace {

struct Arguments {
    CommonOptions common;
    RenderFlags render;
    std::string folder;
};

} // namespace

void add_render(CLI::App& app, Run& run) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("render", "frames, WebP and GIF of the clips");
    command->add_option("CHARACTER_DIR", arguments->folder, "folder of the character")->required();
    add_render_options(*command, arguments->render);
    add_common_options(*command, arguments->common);
    command->callback([arguments, &run] {
        run = [arguments] {
            render_folder(arguments->folder, make_settings(arguments->common, arguments->render));
            clear_progress();
            return 0;
        };
    });
}

} // namespace pantin::cli
