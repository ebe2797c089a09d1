// SPDX-License-Identifier: MIT
// A picture to the page and its characters, by detection or as the user gives them; the status of a character
// in its page (thesis 4.2).
#include "pipeline/detected_page.hpp"

#include <algorithm>
#include <system_error>

#include "core/file.hpp"
#include "formats/character_folder.hpp"
#include "formats/file_names.hpp"
#include "formats/page_file.hpp"
#include "formats/trace_files.hpp"
#include "pantin/image.hpp"
#include "pipeline/former_run.hpp"
#include "pipeline/overrides.hpp"
#include "pipeline/overview.hpp"
#include "pipeline/page_picture.hpp"
#include "pipeline/upright.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

Detection detect_on(const RgbImage& picture, const PageInk& ink, const fs::path& image, Context& context) {
    const DetectionOptions& options = context.options().detection;
    const CharacterFinder* finder = options.detector == Detector::mask_rcnn ? &context.finder() : nullptr;
    try {
        return detect(picture, ink, options, finder);
    } catch (const Error& error) {
        throw Error(error.kind(), image.string() + ": " + error.what());
    }
}

struct FoundOnPage {
    PagePicture page;
    Detection detection;
    int rotate = 0;
};

// As the user turns the page, or upright (upright.hpp).
FoundOnPage find_on_page(const fs::path& image, Context& context) {
    const Settings& settings = context.settings();
    const bool flattens = context.options().detection.flatten_sheet;
    const auto find = [&](int rotate) {
        FoundOnPage found{load_page_picture(image, rotate, flattens), {}, rotate};
        found.detection = detect_on(found.page.picture, found.page.ink, image, context);
        return found;
    };
    FoundOnPage found = find(settings.rotate.value_or(0));
    if (settings.rotate) return found;
    const int rotate = find_page_turn(found.detection.characters, context);
    if (rotate == 0) return found;
    try {
        FoundOnPage upright = find(rotate);
        context.notice(image.string() + ": " + (rotate == 180 ? "stands on its head" : "lies on its side") +
                       ", is turned clockwise by " + std::to_string(rotate) +
                       " degrees (--rotate 0: as it is)");
        return upright;
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::no_character) throw;
        return found;
    }
}

constexpr double least_bare_border = 0.4; // of the picture's border is paper, or the picture shows more

// Numbers of characters that the page does not have.
void check_choice(const std::vector<int>& only, const Page& page, const fs::path& image) {
    const int count = static_cast<int>(page.characters.size());
    for (int number : only)
        if (number < 1 || number > count)
            throw Error(ErrorKind::usage, "--only " + std::to_string(number) + ": " + image.string() +
                                              " has " + std::to_string(count) +
                                              (count == 1 ? " character" : " characters"));
}

// What a person should know before looking at the result.
void tell_of_paper(const fs::path& image, const PagePicture& loaded, bool given, const Context& context) {
    if (loaded.sheet)
        context.notice(image.string() +
                       ": shows a sheet of paper on something else; the sheet alone is read");
    else if (!given && !loaded.ink.cut_out && loaded.ink.bare_border < least_bare_border)
        context.notice(
            image.string() +
            ": only part of the picture seems to be paper, and no whole sheet is in sight: crop the "
            "picture to the paper");
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
    std::optional<GivenCharacter> given;
    FoundOnPage found;
    if (has_given_character(image, settings)) {
        found.rotate = settings.rotate.value_or(0);
        found.page = load_page_picture(picture_of(image), found.rotate, false);
        given =
            given_character(found.page.picture, found.page.ink, image, settings, context.options().detection);
        found.detection.characters.push_back(std::move(given->detected));
    } else {
        found = find_on_page(image, context);
    }
    Detection& detection = found.detection;
    tell_of_paper(image, found.page, given.has_value(), context);
    result.picture = std::move(found.page.picture);
    if (given) result.page.remarks = given->remarks;
    for (const std::string& remark : result.page.remarks) context.notice(remark);
    result.ink = std::move(detection.ink);

    Page& page = result.page;
    page.source = image.filename().string();
    page.sheet = found.page.sheet;
    page.rotate = found.rotate;
    page.width = result.picture.width();
    page.height = result.picture.height();
    page.detector =
        given ? "given" : detector_names[static_cast<std::size_t>(context.options().detection.detector)];
    for (DetectedCharacter& detected : detection.characters) {
        page.characters.push_back({"character-" + std::to_string(page.characters.size() + 1), detected.box,
                                   detected.scale, detected.score, unfinished_status, detected.exact_mask});
        Character& character = result.characters.emplace_back();
        character.drawing = std::move(detected.drawing);
        character.ink = std::move(detected.ink);
        character.mask = std::move(detected.mask);
        character.exact_mask = detected.exact_mask;
        character.ink_mask = std::move(detected.ink_mask);
        character.network_mask = std::move(detected.network_mask);
        if (given) character.given_labels = std::move(given->labels);
    }
    check_choice(settings.only, page, image);
    return result;
}

void save_detection(const fs::path& out, const AnimatedPage& detected, const Context& context) {
    std::error_code ignored;
    const fs::path overview = out / file_names::overview;
    const bool foreign = fs::exists(overview, ignored) && (!fs::exists(out / file_names::page, ignored) ||
                                                           detected.page.source == file_names::overview);
    create_folder(out);
    remove_former_run(out);
    if (foreign)
        context.notice(overview.string() + ": is not replaced by the overview of the characters");
    else
        save_png(overview, draw_overview(detected.picture, detected.page));
    if (context.settings().trace) trace_detection(out, detected.ink);
    write_page(out, detected.page); // first, so that the next run knows which folders to clear
    for (std::size_t i = 0; i < detected.characters.size(); ++i) {
        const Character& character = detected.characters[i];
        const fs::path folder = out / detected.page.characters[i].folder;
        save_detected(folder, character.drawing, character.ink, character.mask);
        if (context.settings().trace) trace_masks(folder, character.ink_mask, character.network_mask);
    }
}

void require_folder(const fs::path& folder) {
    std::error_code error;
    if (!fs::is_directory(folder, error)) throw Error(ErrorKind::input, folder.string() + ": no such folder");
}

bool is_exact_mask(const fs::path& folder) {
    const fs::path whole = resolved(folder), file = page_beside(whole);
    if (file.empty()) return false;
    const Page page = read_page(file);
    return std::any_of(page.characters.begin(), page.characters.end(), [&](const PageCharacter& character) {
        return character.folder == whole.filename() && character.exact_mask;
    });
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
