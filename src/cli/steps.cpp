// SPDX-License-Identifier: MIT
// The steps one by one: pantin detect IMAGE -o DIR, then segment, skeletonize, identify, rig and render
// CHARACTER_DIR.
#include <memory>

#include "cli/command.hpp"

namespace pantin::cli {

namespace {

using FolderStep = std::function<void(const std::filesystem::path& folder, const Settings& settings)>;

struct DetectArguments {
    CommonOptions common;
    std::string image, out;
};

int run_detect(const DetectArguments& arguments) {
    const Page page = detect_page(arguments.image, arguments.out, make_settings(arguments.common));
    for (const PageCharacter& character : page.characters)
        print_result(arguments.common, (std::filesystem::path(arguments.out) / character.folder).string());
    return 0;
}

void add_detect(Command app) {
    const auto arguments = std::make_shared<DetectArguments>();
    Command command = app.subcommand("detect", "step 1: the page to characters");
    command.option("IMAGE", arguments->image, "page: PNG, JPEG, WebP, GIF or BMP").required();
    command.option("-o,--output", arguments->out, "folder for the results").required();
    add_rotate_option(command, arguments->common);
    add_detector_option(command, arguments->common);
    add_common_options(command, arguments->common);
    command.run([arguments] { return run_detect(*arguments); });
}

struct FolderArguments {
    CommonOptions common;
    RenderFlags render; // of `render` alone
    std::string folder;
};

// A subcommand `name` that takes a CHARACTER_DIR and does `step` on it.
Command add_folder_command(Command app, const std::string& name, const std::string& description,
                           const std::shared_ptr<FolderArguments>& arguments, const FolderStep& step) {
    Command command = app.subcommand(name, description);
    command.option("CHARACTER_DIR", arguments->folder, "folder of the character").required();
    add_common_options(command, arguments->common);
    command.run([arguments, step] {
        step(arguments->folder, make_settings(arguments->common, arguments->render));
        clear_progress();
        return 0;
    });
    return command;
}

void add_rig(Command app) {
    const auto mapping = std::make_shared<std::string>();
    const auto rig_with = [mapping](const std::filesystem::path& folder, Settings settings) {
        settings.mapping = *mapping;
        rig_folder(folder, settings);
    };
    const auto arguments = std::make_shared<FolderArguments>();
    Command command =
        add_folder_command(app, "rig", "step 5: mesh, bones, weights and character.glb", arguments, rig_with);
    add_motion_options(command, arguments->common);
    add_animated_drawings_option(command, arguments->common);
    command.option("--mapping", *mapping,
                   "mapping.json with the pairs of end-effectors to use instead of matching");
}

void add_skeletonize(Command app) {
    const auto method = std::make_shared<std::string>();
    const auto compare = std::make_shared<bool>(false);
    const auto skeletonize_by = [method, compare](const std::filesystem::path& folder, Settings settings) {
        SkeletonMethod& chosen = settings.options.skeletonization.method;
        if (*method == "voronoi") chosen = SkeletonMethod::voronoi;
        if (*method == "straight") chosen = SkeletonMethod::straight;
        if (*method == "thinning") chosen = SkeletonMethod::thinning;
        if (*method == "chordal") chosen = SkeletonMethod::chordal;
        skeletonize_folder(folder, settings);
        if (*compare) compare_skeletons_folder(folder, settings);
    };
    Command command = add_folder_command(app, "skeletonize", "step 3: part labels to the skeleton",
                                         std::make_shared<FolderArguments>(), skeletonize_by);
    command
        .option("--skeleton", *method,
                "voronoi (default), straight (straight skeleton), thinning (Zhang-Suen alone) or "
                "chordal (chordal axis)")
        .one_of({"voronoi", "straight", "thinning", "chordal"});
    command.flag("--compare", *compare,
                 "also draw the skeletons of all four side by side (skeletons.png, skeletons.json)");
}

void add_identify(Command app) {
    const auto reference = std::make_shared<std::string>();
    const auto identify_as = [reference](const std::filesystem::path& folder, Settings settings) {
        settings.overrides.reference = *reference;
        identify_folder(folder, settings);
    };
    add_folder_command(app, "identify", "step 4: the skeleton to the reference that it moves like",
                       std::make_shared<FolderArguments>(), identify_as)
        .option("--reference", *reference, "the reference to use, whatever the scores are");
}

void add_render(Command app) {
    const auto arguments = std::make_shared<FolderArguments>();
    Command command =
        add_folder_command(app, "render", "frames, WebP and GIF of the clips", arguments, render_folder);
    add_motion_options(command, arguments->common);
    add_render_options(command, arguments->render);
}

} // namespace

void add_steps(Command app) {
    const auto add = [&](const char* name, const char* description, const FolderStep& step) {
        add_folder_command(app, name, description, std::make_shared<FolderArguments>(), step);
    };
    add_detect(app);
    add("segment", "step 2: the character to part labels", segment_folder);
    add_skeletonize(app);
    add_identify(app);
    add_rig(app);
    add_render(app);
}

} // namespace pantin::cli
