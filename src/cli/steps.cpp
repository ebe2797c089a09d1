// SPDX-License-Identifier: MIT
// The steps one by one: pantin detect IMAGE -o DIR, then segment, skeletonize, identify, rig and render
// CHARACTER_DIR. They share a file because they are few lines around one header that takes long to compile.
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

void add_detect(CLI::App& app, Run& run) {
    const auto arguments = std::make_shared<DetectArguments>();
    CLI::App* command = app.add_subcommand("detect", "step 1: the page to characters");
    command->add_option("IMAGE", arguments->image, "PNG or JPEG page")->required();
    command->add_option("-o,--output", arguments->out, "folder for the results")->required();
    add_rotate_option(*command, arguments->common);
    add_detector_option(*command, arguments->common);
    add_common_options(*command, arguments->common);
    command->callback([arguments, &run] { run = [arguments] { return run_detect(*arguments); }; });
}

struct FolderArguments {
    CommonOptions common;
    RenderFlags render; // of `render` alone
    std::string folder;
};

// A subcommand `name` that takes a CHARACTER_DIR and does `step` on it.
CLI::App* add_folder_command(CLI::App& app, Run& run, const std::string& name, const std::string& description,
                             const std::shared_ptr<FolderArguments>& arguments, const FolderStep& step) {
    CLI::App* command = app.add_subcommand(name, description);
    command->add_option("CHARACTER_DIR", arguments->folder, "folder of the character")->required();
    add_common_options(*command, arguments->common);
    command->callback([arguments, step, &run] {
        run = [arguments, step] {
            step(arguments->folder, make_settings(arguments->common, arguments->render));
            clear_progress();
            return 0;
        };
    });
    return command;
}

void add_rig(CLI::App& app, Run& run) {
    const auto mapping = std::make_shared<std::string>();
    const auto rig_with = [mapping](const std::filesystem::path& folder, Settings settings) {
        settings.mapping = *mapping;
        rig_folder(folder, settings);
    };
    const auto arguments = std::make_shared<FolderArguments>();
    CLI::App* command = add_folder_command(app, run, "rig", "step 5: mesh, bones, weights and character.glb",
                                           arguments, rig_with);
    add_motion_options(*command, arguments->common);
    add_animated_drawings_option(*command, arguments->common);
    command->add_option("--mapping", *mapping,
                        "mapping.json with the pairs of end-effectors to use instead of matching");
}

void add_skeletonize(CLI::App& app, Run& run) {
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
    CLI::App* command = add_folder_command(app, run, "skeletonize", "step 3: part labels to the skeleton",
                                           std::make_shared<FolderArguments>(), skeletonize_by);
    command
        ->add_option("--skeleton", *method,
                     "voronoi (default), straight (straight skeleton), thinning (Zhang-Suen alone) or "
                     "chordal (chordal axis)")
        ->check(CLI::IsMember({"voronoi", "straight", "thinning", "chordal"}));
    command->add_flag("--compare", *compare,
                      "also draw the skeletons of all four side by side (skeletons.png, skeletons.json)");
}

void add_identify(CLI::App& app, Run& run) {
    const auto reference = std::make_shared<std::string>();
    const auto identify_as = [reference](const std::filesystem::path& folder, Settings settings) {
        settings.overrides.reference = *reference;
        identify_folder(folder, settings);
    };
    add_folder_command(app, run, "identify", "step 4: the skeleton to the reference that it moves like",
                       std::make_shared<FolderArguments>(), identify_as)
        ->add_option("--reference", *reference, "the reference to use, whatever the scores are");
}

void add_render(CLI::App& app, Run& run) {
    const auto arguments = std::make_shared<FolderArguments>();
    CLI::App* command =
        add_folder_command(app, run, "render", "frames, WebP and GIF of the clips", arguments, render_folder);
    add_motion_options(*command, arguments->common);
    add_render_options(*command, arguments->render);
}

} // namespace

void add_steps(CLI::App& app, Run& run) {
    const auto add = [&](const char* name, const char* description, const FolderStep& step) {
        add_folder_command(app, run, name, description, std::make_shared<FolderArguments>(), step);
    };
    add_detect(app, run);
    add("segment", "step 2: the character to part labels", segment_folder);
    add_skeletonize(app, run);
    add_identify(app, run);
    add_rig(app, run);
    add_render(app, run);
}

} // namespace pantin::cli
