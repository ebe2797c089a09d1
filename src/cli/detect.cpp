// pantin detect IMAGE -o DIR
#include <memory>

#include "cli/command.hpp"

namespace pantin::cli {

namespace {

struct Arguments {
    CommonOptions common;
    std::string image, out;
};

int run_detect(const Arguments& arguments) {
    const Page page = detect_page(arguments.image, arguments.out, make_settings(arguments.common));
    for (const PageCharacter& character : page.characters)
        print_result(arguments.common, (std::filesystem::path(arguments.out) / character.folder).string());
    return 0;
}

} // namespace

void add_detect(CLI::App& app, Run& run) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("detect", "step 1: the page to characters");
    command->add_option("IMAGE", arguments->image, "PNG or JPEG page")->required();
    command->add_option("-o,--output", arguments->out, "folder for the results")->required();
    add_common_options(*command, arguments->common);
    command->callback([arguments, &run] { run = [arguments] { return run_detect(*arguments); }; });
}

} // namespace pantin::cli
