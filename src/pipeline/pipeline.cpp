// SPDX-License-Identifier: MIT
// The driver: from a page to animated characters, one step after the other. The file to read first.
#include "pantin/pipeline.hpp"

#include <algorithm>

#include "pipeline/animated_drawings.hpp"
#include "pipeline/pages.hpp"
#include "pipeline/scene.hpp"
#include "pipeline/stages.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

constexpr int steps = 5; // of a character

// Steps 2 to 6 on one character. Returns its status: "ok", or the step and the reason why it cannot go on.
// `progress` announces a step by its name and number.
std::string animate_character(Character& character, Workshop& workshop,
                              const std::function<void(const char*, int)>& progress) {
    try {
        // Step 2 (thesis 4.3): which pixels are head, body, limb, tail, wing.
        progress("segment", 0);
        run_segment(character, workshop);

        // Step 3 (4.4): the Voronoi skeleton of the silhouette as a labelled graph.
        progress("skeletonize", 1);
        run_skeletonize(character, workshop);

        // Step 4 (4.5): the reference skeleton that is nearest by geometric graph distance.
        progress("identify", 2);
        run_identify(character, workshop);

        // Step 5 (4.6): end-effectors matched, mesh and skin weights made.
        progress("rig", 3);
        run_rig(character, workshop);

        // Step 6 (4.6, 6.1): the reference's clips on the character, frame by frame.
        progress("render", 4);
        run_render(character, workshop);
        return "ok";
    } catch (const CharacterRejected& rejected) {
        return rejected.step() + ": " + rejected.what();
    }
}

bool any_animated(const Page& page) {
    return std::any_of(page.characters.begin(), page.characters.end(),
                       [](const PageCharacter& c) { return c.status == "ok"; });
}

} // namespace

DetectedPage run_animate(const fs::path& image, const fs::path& out, Workshop& workshop) {
    // Step 1 (4.2): the page to characters.
    DetectedPage detected = run_detect(image, out, workshop);

    const bool scene = workshop.settings().render.scene;
    for (std::size_t i = 0; i < detected.characters.size(); ++i) {
        PageCharacter& entry = detected.page.characters[i];
        Character& character = detected.characters[i];
        const double total = 1.0 + steps * static_cast<double>(detected.characters.size());
        entry.status = animate_character(character, workshop, [&](const char* step, int number) {
            const double done = 1.0 + steps * static_cast<double>(i) + number;
            workshop.progress(entry.folder + ": " + step, done / total);
        });
        if (!scene && !workshop.keeps) character = {}; // its pictures are not needed any more
    }
    if (scene && any_animated(detected.page)) {
        workshop.progress("scene", 1);
        run_scene(image, out, detected.page, detected.characters, workshop);
    }
    write_page(out, detected.page); // last: whoever finds it without unfinished characters finds everything
    return detected;
}

Settings settings_for(const fs::path& image, const Settings& wanted) {
    Settings settings = wanted;
    if (is_animated_drawings_folder(image) && settings.given.reference.empty())
        settings.given.reference = "humanoid";
    return settings;
}

void require_animated(const fs::path& image, const Page& page) {
    if (any_animated(page)) return;
    std::string reasons;
    for (const PageCharacter& entry : page.characters)
        reasons += (reasons.empty() ? "" : "; ") + entry.folder + ": " + entry.status;
    throw Error(ErrorKind::not_animated,
                image.string() + ": no character could be animated (" + reasons + ")");
}

Page animate(const fs::path& image, const fs::path& out, const Settings& settings) {
    Networks networks(settings.weights);
    return animate(image, out, settings, networks);
}

Page animate(const fs::path& image, const fs::path& out, const Settings& wanted, Networks& networks) {
    const Settings settings = settings_for(image, wanted);
    Workshop workshop(settings, networks);
    workshop.prepare();
    Page page = run_animate(image, out, workshop).page;
    require_animated(image, page);
    return page;
}

Page detect_page(const fs::path& image, const fs::path& out, const Settings& settings) {
    Workshop workshop(settings);
    Page page = run_detect(image, out, workshop).page;
    for (PageCharacter& character : page.characters) character.status = "ok";
    write_page(out, page);
    return page;
}

} // namespace pantin
