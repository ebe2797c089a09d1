// SPDX-License-Identifier: MIT
// pantin verify [--preset NAME] [-o DIR]     every stage against the stored outputs
// pantin verify DIR --against DIR [-o DIR]   two folders of results
#include <memory>

#include "cli/command.hpp"
#include "core/file.hpp"
#include "pantin/image.hpp"
#include "pantin/verify.hpp"

namespace pantin::cli {

namespace {

namespace fs = std::filesystem;

struct Arguments {
    CommonOptions common;
    std::string folder, against, out, preset;
    bool end_to_end = false;
};

void write_files(const fs::path& out, const Files& files) {
    for (const auto& [name, bytes] : files) {
        create_folder((out / name).parent_path());
        write_file(out / name, bytes);
    }
}

// <file>.png of each picture and film that differs.
void write_pictures(const fs::path& out, const FolderComparison& comparison) {
    for (const StageDifferences& stage : comparison.stages)
        for (const FileDifference& file : stage.files) {
            if (!file.picture) continue;
            const fs::path picture = out / (file.file + (file.file.ends_with(".png") ? "" : ".png"));
            create_folder(picture.parent_path());
            save_png(picture, *file.picture);
        }
}

int compare(const Arguments& arguments) {
    const FolderComparison comparison = compare_folders(arguments.folder, arguments.against);
    print_result(arguments.common, comparison_table(comparison));
    if (!arguments.out.empty()) write_pictures(arguments.out, comparison);
    if (comparison.stages.empty()) return 0;
    const StageDifferences& first = comparison.stages.front();
    throw Error(ErrorKind::differs, arguments.folder + " differs from " + arguments.against + ", first in " +
                                        first.stage + " (" + first.files.front().file + ")");
}

Verification verify_preset(const Arguments& arguments, std::string_view preset) {
    const Settings common = make_settings(arguments.common);
    VerificationSettings settings = VerificationSettings::of(preset);
    if (!arguments.common.config.empty()) apply_config(settings.options, arguments.common.config);
    settings.threads = common.threads;
    settings.progress = common.progress;
    settings.end_to_end = arguments.end_to_end;
    return verify(settings);
}

int run_verify(const Arguments& arguments) {
    if (arguments.folder.empty() != arguments.against.empty())
        throw Error(ErrorKind::usage, "two folders are compared: pantin verify DIR --against DIR");
    if (!arguments.folder.empty()) return compare(arguments);
    std::string message;
    bool first_table = true;
    for (const std::string_view preset : verified_presets()) {
        if (!arguments.preset.empty() && arguments.preset != preset) continue;
        const Verification verification = verify_preset(arguments, preset);
        print_result(arguments.common, (first_table ? "" : "\n") + ("preset " + std::string(preset)) + "\n" +
                                           verification_table(verification));
        first_table = false;
        if (!arguments.out.empty()) write_files(arguments.out, verification.outputs);
        const StageDifferences* first = verification.first_difference();
        if (first && message.empty())
            message = "stage " + first->stage + " differs on the " + first->drawing + " (" +
                      first->files.front().file + ")";
    }
    if (message.empty()) return 0;
    throw Error(ErrorKind::differs, message);
}

} // namespace

void add_verify(Command app) {
    const auto arguments = std::make_shared<Arguments>();
    Command command = app.subcommand(
        "verify", "every stage on built-in drawings against stored results; or two folders of results");
    command.option("DIR", arguments->folder,
                   "folder to compare with that of --against, instead of verifying");
    command.option("--against", arguments->against, "the other folder: of verify, animate or any step");
    command.option("-o,--output", arguments->out,
                   "folder for the stages' outputs; of a comparison for pictures of where they differ");
    command.option("--preset", arguments->preset, "default or thesis (default: both, one after the other)")
        .one_of({"default", "thesis"});
    command.flag("--end-to-end", arguments->end_to_end,
                 "every stage takes what the stage before has just made, not the stored input");
    command.option("--config", arguments->common.config,
                   "JSON file of options to change: shows which stages depend on them");
    command
        .option("--threads", arguments->common.threads,
                "number of threads (default: all cores); results do not depend on it")
        .range(1, 256);
    command.flag("--quiet", arguments->common.quiet, "print errors only");
    command.run([arguments] { return run_verify(*arguments); });
}

} // namespace pantin::cli
