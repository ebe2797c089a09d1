// SPDX-License-Identifier: MIT
// pantin animate IMAGE... -o DIR
#include <map>
#include <memory>

#include "cli/character_lines.hpp"
#include "cli/command.hpp"
#include "core/shell_word.hpp"
#include "export/film_formats.hpp"
#include "formats/file_names.hpp"

namespace pantin::cli {

namespace fs = std::filesystem;

namespace {

struct Arguments {
    CommonOptions common;
    RenderFlags render;
    std::vector<std::string> images;
    std::string out;
    Overrides overrides;
};

// One page goes to DIR itself, several to DIR/<name of the picture without its ending>; the second of a name
// gets -2.
std::vector<fs::path> page_folders(const Arguments& arguments) {
    if (arguments.images.size() == 1) return {arguments.out};
    std::vector<fs::path> folders;
    std::map<std::string, int> seen;
    for (const fs::path image : arguments.images) {
        const std::string stem = image.stem().string();
        const int count = ++seen[stem];
        folders.push_back(fs::path(arguments.out) / (count == 1 ? stem : stem + "-" + std::to_string(count)));
    }
    return folders;
}

void print_characters(const Page& page, const fs::path& folder, const Arguments& arguments) {
    for (const PageCharacter& character : page.characters)
        print_result(arguments.common,
                     character_line(folder, character, !arguments.overrides.reference.empty()));
}

void animate_page(const fs::path& image, const fs::path& folder, const Arguments& arguments,
                  const Settings& settings, Networks& networks) {
    try {
        print_characters(animate(image, folder, settings, networks), folder, arguments);
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::not_animated) // page.json was written
            print_characters(read_page(folder / file_names::page), folder, arguments);
        throw;
    }
}

// What to do now: look at the scene, or at what every step did.
void print_next(const fs::path& image, const fs::path& folder, const Arguments& arguments) {
    if (arguments.render.scene) {
        for (const FilmFormat& format : film_formats()) {
            const fs::path scene = folder / (file_names::scene + std::string(format.ending));
            std::error_code error;
            if (format.ending.empty() || !fs::exists(scene, error)) continue;
            return print_result(arguments.common, "the page: " + scene.string());
        }
    }
    std::string name = folder.string();
    while (name.size() > 1 && name.ends_with('/')) name.pop_back();
    print_result(arguments.common, "what every step did: pantin explain " + shell_word(image.string()) +
                                       " -o " + shell_word(name + "-explained"));
}

// A bad page does not keep the others from being done. 0 when a character of any page was animated, else the
// code of the first page.
int run_animate(const Arguments& arguments) {
    Settings settings = make_settings(arguments.common, arguments.render);
    settings.overrides = arguments.overrides;
    if (arguments.images.size() > 1 &&
        !(arguments.overrides.mask.empty() && arguments.overrides.labels.empty()))
        throw Error(ErrorKind::usage, "--mask and --labels go with one page");
    const std::vector<fs::path> folders = page_folders(arguments);
    Networks networks(settings.weights);
    int first_code = 0;
    bool any = false;
    for (std::size_t i = 0; i < folders.size(); ++i) {
        try {
            animate_page(arguments.images[i], folders[i], arguments, settings, networks);
            if (i == 0 || arguments.render.scene) print_next(arguments.images[i], folders[i], arguments);
            any = true;
        } catch (const Error& error) {
            print_error(error.what());
            if (first_code == 0) first_code = static_cast<int>(error.kind());
            if (error.kind() == ErrorKind::weights || error.kind() == ErrorKind::output) return first_code;
        }
    }
    return any ? 0 : first_code;
}

} // namespace

void add_animate(Command app) {
    const auto arguments = std::make_shared<Arguments>();
    Command command = app.subcommand("animate", "the whole pipeline: pages to animated characters");
    command
        .option("IMAGE", arguments->images,
                "pages (PNG, JPEG, WebP, GIF or BMP), or AnimatedDrawings character folders; several go to "
                "DIR/<name>/")
        .required();
    command.option("-o,--output", arguments->out, "folder for the results").required();
    add_render_options(command, arguments->render);
    command.flag("--scene", arguments->render.scene,
                 "the whole page comes alive, too: DIR/scene.webp, scene.gif");
    add_override_options(command, arguments->overrides);
    add_motion_options(command, arguments->common);
    add_animated_drawings_option(command, arguments->common);
    add_only_option(command, arguments->common);
    add_rotate_option(command, arguments->common);
    add_detector_option(command, arguments->common);
    add_common_options(command, arguments->common);
    command.run([arguments] { return run_animate(*arguments); });
}

} // namespace pantin::cli
