// SPDX-License-Identifier: MIT
// What a former run wrote, by the names of docs/formats.md, and its removal.
#include "pipeline/former_run.hpp"

#include <algorithm>
#include <string>
#include <system_error>
#include <vector>

#include "export/film_formats.hpp"
#include "formats/file_names.hpp"
#include "pantin/error.hpp"
#include "pantin/page.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

// What a run writes into a character's folder; `trace` and `frames` are folders.
constexpr const char* own_files[] = {file_names::drawing,
                                     file_names::ink,
                                     file_names::mask,
                                     file_names::labels,
                                     file_names::segmentation,
                                     file_names::contour,
                                     file_names::skeleton_picture,
                                     file_names::skeleton,
                                     file_names::identification,
                                     file_names::mapping,
                                     file_names::mesh,
                                     file_names::material,
                                     file_names::weights,
                                     file_names::glb,
                                     file_names::skeleton_comparison_picture,
                                     file_names::skeleton_comparison};
// A run that was killed may leave the beginning of a file: `.<name>.<process>.part`, and `<name>.mp4.part` of
// ffmpeg.
std::string without_part(const std::string& name) {
    if (!name.ends_with(".part")) return name;
    const std::string begun = name.substr(0, name.size() - 5);
    if (begun.ends_with(".mp4") && !begun.starts_with('.')) return begun;
    const std::size_t process = begun.rfind('.');
    return begun.starts_with('.') && process > 1 ? begun.substr(1, process - 1) : name;
}

// Whether the test holds for the ending of a film format.
bool is_film(const auto& test) {
    return std::ranges::any_of(film_formats(),
                               [&](const FilmFormat& f) { return !f.ending.empty() && test(f.ending); });
}

bool is_page_file(const std::string& name) {
    return name == file_names::page ||
           is_film([&](std::string_view ending) { return name == file_names::scene + std::string(ending); });
}

bool is_own_file(const std::string& name) {
    if (std::find(std::begin(own_files), std::end(own_files), name) != std::end(own_files)) return true;
    return name.starts_with(file_names::animation) &&
           is_film([&](std::string_view ending) { return name.ends_with(ending); });
}

void remove_files(const fs::path& folder, bool (*is_ours)(const std::string&)) {
    std::error_code ignored;
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
        if (is_ours(without_part(entry.path().filename().string()))) files.push_back(entry.path());
    for (const fs::path& file : files) fs::remove(file, ignored);
}

// Removes what a former run wrote; files that are not ours stay, and the folder with them.
void remove_character(const fs::path& folder) {
    std::error_code ignored;
    remove_files(folder, is_own_file);
    fs::remove_all(folder / file_names::trace, ignored);
    fs::remove_all(folder / file_names::frames, ignored);
    fs::remove_all(folder / file_names::animated_drawings, ignored);
    fs::remove(folder, ignored);
}

} // namespace

void remove_former_run(const fs::path& out) {
    std::error_code ignored;
    if (!fs::exists(out / file_names::page, ignored)) return;
    Page page;
    try {
        page = read_page(out / file_names::page);
    } catch (const Error&) {
        return;
    }
    for (const PageCharacter& character : page.characters)
        if (character.folder.starts_with("character-")) remove_character(out / character.folder);
    fs::remove_all(out / file_names::trace, ignored);
    fs::remove_all(out / file_names::frames, ignored);
    remove_files(out, is_page_file);
}

} // namespace pantin
