// SPDX-License-Identifier: MIT
// A picture to the page and its characters, by detection or as the user gives them; the status of a character
// in its page (thesis 4.2).
#include "pipeline/detected_page.hpp"

#include <system_error>

#include "core/file.hpp"
#include "formats/character_folder.hpp"
#include "formats/file_names.hpp"
#include "formats/page_file.hpp"
#include "formats/trace_files.hpp"
#include "pantin/image.hpp"
#include "pipeline/former_run.hpp"
#include "pipeline/overrides.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

Detection detect_on(const RgbImage& picture, const fs::path& image, Context& context) {
    const DetectionOptions& options = context.options().detection;
    const CharacterFinder* finder = options.detector == Detector::mask_rcnn ? &context.finder() : nullptr;
    try {
        return detect(picture, options, finder);
    } catch (const Error& error) {
        throw Error(error.kind(), image.string() + ": " + error.what());
    }
}

// The folder with its own name, also for "." and "character-1/".
fs::path resolved(const fs::path& folder) {
    std::error_code error;
    const fs::path canonical = fs::canonical(folder, error);
    return error ? folder : canonical;
}

// The page.json of the page to which a resolved folder belongs; empty when there is none.
fs::path page_beside(const fs::path& folder) {
    const fs::path file = folder.parent_path() / file_names::page;
    std::error_code ignored;
    return fs::exists(file, ignored) ? file : fs::path();
}

} // namespace

AnimatedPage detect_characters(const fs::path& image, Context& context) {
    const Settings& settings = context.settings();
    AnimatedPage result;
    result.picture = turned(load_image(picture_of(image)), settings.rotate);
    std::optional<GivenCharacter> given =
        given_character(result.picture, image, settings, context.options().detection);
    Detection detection;
    if (given)
        detection.characters.push_back(std::move(given->detected));
    else
        detection = detect_on(result.picture, image, context);
    result.ink = std::move(detection.ink);

    Page& page = result.page;
    page.source = image.filename().string();
    page.rotate = settings.rotate;
    page.width = result.picture.width();
    page.height = result.picture.height();
    page.detector =
        given ? "given" : detector_names[static_cast<std::size_t>(context.options().detection.detector)];
    for (DetectedCharacter& detected : detection.characters) {
        page.characters.push_back({"character-" + std::to_string(page.characters.size() + 1), detected.box,
                                   detected.scale, detected.score, unfinished_status});
        Character& character = result.characters.emplace_back();
        character.drawing = std::move(detected.drawing);
        character.mask = std::move(detected.mask);
        character.mask_given = given.has_value();
        if (given) character.given_labels = std::move(given->labels);
    }
    return result;
}

void save_detection(const fs::path& out, const AnimatedPage& detected, bool trace) {
    create_folder(out);
    remove_former_run(out);
    if (trace) trace_detection(out, detected.ink);
    write_page(out, detected.page); // first, so that the next run knows which folders to clear
    for (std::size_t i = 0; i < detected.characters.size(); ++i)
        save_detected(out / detected.page.characters[i].folder, detected.characters[i].drawing,
                      detected.characters[i].mask);
}

void require_folder(const fs::path& folder) {
    std::error_code error;
    if (!fs::is_directory(folder, error)) throw Error(ErrorKind::input, folder.string() + ": no such folder");
}

bool is_given(const fs::path& folder) {
    const fs::path file = page_beside(resolved(folder));
    return !file.empty() && read_page(file).detector == "given";
}

void set_result(const fs::path& folder, const std::string& status,
                const std::optional<std::vector<Warning>>& warnings) {
    const fs::path whole = resolved(folder), file = page_beside(whole);
    if (file.empty()) return;
    Page page = read_page(file);
    const std::string before = page_to_json(page);
    for (PageCharacter& character : page.characters) {
        if (character.folder != whole.filename()) continue;
        character.status = status;
        if (warnings) character.warnings = *warnings;
    }
    if (page_to_json(page) != before) write_page(whole.parent_path(), page);
}

} // namespace pantin
