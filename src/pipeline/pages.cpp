// SPDX-License-Identifier: MIT
#include "pipeline/pages.hpp"

#include <algorithm>
#include <system_error>

#include "core/file.hpp"
#include "export/film_formats.hpp"
#include "pantin/image.hpp"
#include "pipeline/given.hpp"
#include "pipeline/json_files.hpp"
#include "pipeline/trace.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

// What a run writes into a character's folder; `trace` and `frames` are folders.
constexpr const char* own_files[] = {"drawing.png",   "mask.png",      "labels.png",    "segmentation.json",
                                     "contour.json",  "skeleton.png",  "skeleton.json", "identification.json",
                                     "mapping.json",  "mesh.obj",      "mesh.mtl",      "weights.txt",
                                     "character.glb", "skeletons.png", "skeletons.json"};

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
    return name == "page.json" ||
           is_film([&](std::string_view ending) { return name == "scene" + std::string(ending); });
}

bool is_own_file(const std::string& name) {
    if (std::find(std::begin(own_files), std::end(own_files), name) != std::end(own_files)) return true;
    return name.starts_with("animation") &&
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
    fs::remove_all(folder / "trace", ignored);
    fs::remove_all(folder / "frames", ignored);
    fs::remove_all(folder / "animated_drawings", ignored);
    fs::remove(folder, ignored);
}

// The characters that the page.json of a former run lists. A file that is not ours lists none.
void remove_former_run(const fs::path& out) {
    std::error_code ignored;
    if (!fs::exists(out / "page.json", ignored)) return;
    Page page;
    try {
        page = read_page(out / "page.json");
    } catch (const Error&) {
        return;
    }
    for (const PageCharacter& character : page.characters)
        if (character.folder.starts_with("character-")) remove_character(out / character.folder);
    fs::remove_all(out / "trace", ignored);
    fs::remove_all(out / "frames", ignored);
    remove_files(out, is_page_file);
}

PageCharacter describe(const DetectedCharacter& detected, std::size_t number) {
    return {"character-" + std::to_string(number), detected.box, detected.scale, detected.score,
            unfinished_status};
}

} // namespace

void write_page(const fs::path& out, const Page& page) { write_file(out / "page.json", page_to_json(page)); }

Page read_page(const fs::path& file) { return page_from_json(read_text(file), file.string()); }

namespace {

Detection detect_on(const RgbImage& page, const fs::path& image, Workshop& workshop) {
    DetectionOptions options = workshop.options().detection;
    options.threads = workshop.settings().threads;
    const CharacterFinder* finder = options.detector == Detector::mask_rcnn ? &workshop.finder() : nullptr;
    try {
        return detect(page, options, finder);
    } catch (const Error& error) {
        throw Error(error.kind(), image.string() + ": " + error.what());
    }
}

} // namespace

DetectedPage run_detect(const fs::path& image, const fs::path& out, Workshop& workshop) {
    workshop.progress("detect");
    const Detector detector = workshop.options().detection.detector;
    RgbImage page = turned(load_image(picture_of(image)), workshop.settings().rotate);
    std::optional<GivenCharacter> given = given_character(page, image, workshop.settings());
    Detection detection;
    if (given)
        detection = {page.width(), page.height(), Mask(), {std::move(given->detected)}};
    else
        detection = detect_on(page, image, workshop);
    DetectedPage result;
    result.page.source = image.filename().string();
    result.page.detector = given ? "given" : detector_names[static_cast<std::size_t>(detector)];
    result.page.rotate = workshop.settings().rotate;
    result.page.width = detection.width;
    result.page.height = detection.height;

    if (workshop.keeps) {
        result.picture = std::move(page);
        result.ink = detection.ink;
    }

    create_folder(out);
    remove_former_run(out);
    if (workshop.settings().trace) trace_detection(out, detection);
    for (const DetectedCharacter& detected : detection.characters)
        result.page.characters.push_back(describe(detected, result.page.characters.size() + 1));
    // First, so that the next run knows which folders to clear should this one be cut off.
    write_page(out, result.page);
    for (std::size_t i = 0; i < detection.characters.size(); ++i) {
        DetectedCharacter& detected = detection.characters[i];
        Character character;
        character.folder = out / result.page.characters[i].folder;
        create_folder(character.folder);
        save_png(character.folder / "drawing.png", detected.drawing);
        save_png(character.folder / "mask.png", to_grey(detected.mask));
        character.drawing = std::move(detected.drawing);
        character.mask = std::move(detected.mask);
        if (given) character.labels = std::move(given->labels);
        result.characters.push_back(std::move(character));
    }
    return result;
}

} // namespace pantin
