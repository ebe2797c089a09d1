// SPDX-License-Identifier: MIT
// An entry of page.json and the films in its folder to one line for people.
#include "cli/character_lines.hpp"

#include <cstdio>
#include <set>

#include "core/plural.hpp"
#include "core/shell_word.hpp"
#include "export/film_formats.hpp"
#include "formats/file_names.hpp"

namespace pantin::cli {

namespace fs = std::filesystem;

namespace {

std::string two_digits(double confidence) {
    char text[16];
    std::snprintf(text, sizeof text, "%.2f", confidence);
    return text;
}

std::string type_text(const PageCharacter& character, bool reference_given) {
    const TypeGuess& found = *character.found;
    if (reference_given) return found.type;
    std::string text = found.type + " (" + two_digits(found.confidence) + ")";
    if (found.confidence < low_confidence && character.second)
        text += ", or " + character.second->type + " (" + two_digits(character.second->confidence) +
                "): --reference " + character.second->type;
    return text;
}

struct Films {
    std::set<std::string> clips; // by the stems of their files
    fs::path first;              // what to open
};
// The files animation[-CLIP].ENDING and the folders frames/CLIP.
Films films_of(const fs::path& folder) {
    Films films;
    std::set<fs::path> files; // in an order that does not depend on the machine
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) files.insert(entry.path());
    const auto take = [&](const std::string& clip, const fs::path& path) {
        films.clips.insert(clip);
        // The first clip's file has the shortest name.
        if (films.first.empty() || (clip == file_names::animation && films.first.stem() != clip))
            films.first = path;
    };
    for (const FilmFormat& format : film_formats())
        for (const fs::path& file : files)
            if (!format.ending.empty() && file.extension() == format.ending &&
                file.stem().string().starts_with(file_names::animation))
                take(file.stem().string(), file);
    if (!films.clips.empty()) return films;
    for (const auto& entry : fs::directory_iterator(folder / file_names::frames, error))
        take(entry.path().filename().string(), folder / file_names::frames);
    return films;
}

// What to do when the character cannot go on. A reference overrules the first refusals and can be another one
// when the rig is impossible; it does not help where there is no skeleton, or no such clip.
std::string advice(const fs::path& folder, const std::string& status, bool reference_given) {
    if (status.starts_with("left out")) return "";
    if (status.starts_with("render: ")) return "";
    const bool may_help =
        status.starts_with("rig: ") || (!reference_given && !status.starts_with("skeletonize: "));
    std::string text =
        may_help ? std::string(" · try ") + (reference_given ? "another " : "") + "--reference NAME" : "";
    std::error_code error;
    if (fs::exists(folder / file_names::labels, error))
        text += (may_help ? ", or correct " : " · correct ") + (folder / file_names::labels).string() +
                " and run: pantin skeletonize " + shell_word(folder.string());
    return text;
}

} // namespace

std::string character_line(const fs::path& out, const PageCharacter& character, bool reference_given) {
    const fs::path folder = out / character.folder;
    std::string line = folder.string() + ": " + character.status;
    if (character.status != "ok") return line + advice(folder, character.status, reference_given);
    if (character.found) line += " · " + type_text(character, reference_given);
    const Films films = films_of(folder);
    if (films.clips.empty()) return line;
    return line + " · " + count_of(static_cast<long>(films.clips.size()), "clip") + " · " +
           films.first.string();
}

} // namespace pantin::cli
