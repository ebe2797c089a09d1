// SPDX-License-Identifier: MIT
// The steps alone, on a character's folder.
#include "pantin/pipeline.hpp"

#include <system_error>

#include "pipeline/pages.hpp"
#include "pipeline/stages.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

// The folder with its own name, also for "." and "character-1/".
fs::path resolved(const fs::path& folder) {
    std::error_code error;
    if (!fs::is_directory(folder, error)) throw Error(ErrorKind::input, folder.string() + ": no such folder");
    const fs::path canonical = fs::canonical(folder, error);
    return error ? folder : canonical;
}

// Keeps the entry of the character in the page.json beside its folder; a folder may also stand alone.
void set_status(const fs::path& folder, const std::string& status) {
    const fs::path whole = resolved(folder), file = whole.parent_path() / "page.json";
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return;
    Page page = read_page(file);
    for (PageCharacter& character : page.characters) {
        if (character.folder != whole.filename() || character.status == status) continue;
        character.status = status;
        write_page(whole.parent_path(), page);
    }
}

void run_step(const fs::path& folder, const Settings& settings, const char* name,
              void (*step)(Character&, Workshop&)) {
    resolved(folder);
    Workshop workshop(settings);
    Character character;
    character.folder = folder;
    workshop.progress(name);
    try {
        step(character, workshop);
    } catch (const CharacterRejected& rejected) {
        const std::string status = rejected.step() + ": " + rejected.what();
        set_status(folder, status);
        throw Error(ErrorKind::not_animated, folder.string() + ": " + status);
    }
    set_status(folder, "ok");
}

} // namespace

void segment_folder(const fs::path& folder, const Settings& settings) {
    run_step(folder, settings, "segment", run_segment);
}
void skeletonize_folder(const fs::path& folder, const Settings& settings) {
    run_step(folder, settings, "skeletonize", run_skeletonize);
}
void identify_folder(const fs::path& folder, const Settings& settings) {
    run_step(folder, settings, "identify", run_identify);
}
void rig_folder(const fs::path& folder, const Settings& settings) {
    run_step(folder, settings, "rig", run_rig);
}
void render_folder(const fs::path& folder, const Settings& settings) {
    run_step(folder, settings, "render", run_render);
}

} // namespace pantin
