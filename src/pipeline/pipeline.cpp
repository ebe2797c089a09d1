// SPDX-License-Identifier: MIT
// The driver: from a page to animated characters, one step after the other (thesis Fig. 4.1). The file to
// read first: every product is handed on by its name, and written where it is made.
#include "pantin/pipeline.hpp"

#include <algorithm>

#include "formats/animated_drawings.hpp"
#include "formats/character_folder.hpp"
#include "formats/figure_joints.hpp"
#include "formats/file_names.hpp"
#include "formats/page_file.hpp"
#include "pantin/image.hpp"
#include "pipeline/animated_page.hpp"
#include "pipeline/clip_films.hpp"
#include "pipeline/detected_page.hpp"
#include "pipeline/film.hpp"
#include "pipeline/motion_notice.hpp"
#include "pipeline/page_types.hpp"
#include "pipeline/scene.hpp"
#include "pipeline/segmentation_options.hpp"
#include "pipeline/self_check.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

// Thesis 4.3 takes every drawing for a character.
constexpr const char* scribble_text = "looks like a scribble: many strokes, and no parts";

// Steps `first` to `last` on a character that has the products of the steps before. CharacterRejected says
// why it cannot go on. `progress` is told of each step.
void run_steps(Character& c, const fs::path& folder, Step first, Step last, Context& context,
               const std::function<void(Step)>& progress) {
    const Settings& settings = context.settings();
    const Options& options = context.options();
    const auto runs = [&](Step step) {
        if (step < first || step > last) return false;
        progress(step);
        return true;
    };

    // Step 2 (thesis 4.3): which pixels are head, body, limb, tail, wing.
    if (runs(Step::segment)) {
        if (c.given_labels)
            c.segmentation.labels = *c.given_labels;
        else
            c.segmentation = context.segmenter().segment(
                c.ink, c.mask, segmentation_options(c.drawing, options.segmentation), c.exact_mask);
        save_segmentation(folder, c.segmentation, settings.trace);
        c.reached = Step::segment;
        // The files are there: whoever knows better corrects labels.png and goes on with the next step.
        if (is_scribble(c.segmentation, options.segmentation)) {
            if (settings.overrides.reference.empty()) throw CharacterRejected("segment", scribble_text);
            context.notice(folder.string() + ": " + scribble_text);
        }
    }

    // Step 3 (4.4): the Voronoi skeleton of the silhouette as a labelled graph.
    if (runs(Step::skeletonize)) {
        c.skeletonization = skeletonize(c.segmentation.labels, options.skeletonization);
        save_skeletonization(folder, c.skeletonization, settings.trace);
        c.reached = Step::skeletonize;
    }

    // Step 4 (4.5): the reference skeleton that is nearest by geometric graph distance.
    if (runs(Step::identify)) {
        c.identification = identify(c.skeletonization.graph, c.segmentation.labels, context.references(),
                                    options.identification, c.segmentation.type);
        save_identification(folder, c.identification);
        c.reached = Step::identify;
        if (last == Step::identify) // later steps have it among their warnings
            if (const std::string line = unproven_line(c.identification); !line.empty())
                context.warn(folder.string() + ": " + line);
    }

    // Step 5 (4.6): end-effectors matched, mesh and skin weights made, clips carried over to the bones.
    if (runs(Step::rig)) {
        c.reference = choose_reference(c.identification, context.references(), settings.blend);
        notice_motion(folder, c, context);
        c.rig = make_rig(c, settings.mapping, context);
        c.texture = make_texture(c);
        c.animations = make_animations(c.rig, c.reference, context);
        save_rig(folder, c.rig, c.texture, c.animations);
        if (settings.animated_drawings &&
            !write_animated_drawings(folder / file_names::animated_drawings, c.rig, c.reference, c.texture))
            context.notice(folder.string() + ": has not the arms and legs of an AnimatedDrawings character");
        c.reached = Step::rig;
    }

    // Step 6 (4.6, 6.1): the clips, frame by frame.
    std::vector<ClipFilm> films;
    if (runs(Step::render)) {
        if (first == Step::render) notice_motion(folder, c, context);
        films = clip_films(c, context);
        for (const ClipFilm& clip : films) {
            write_motions(c.rig, clip.animation, folder, clip.stem, settings.render, clip.first);
            if (!wants_pictures(settings.render)) continue;
            const Film film = render_film(c.rig, clip.filmed, c.texture, clip.view, settings);
            write_film(film, folder, clip.stem, folder / file_names::frames / clip.animation.name, settings,
                       clip.first);
        }
        c.reached = Step::render;
    }

    // What a person would see at once in the result.
    if (last >= Step::rig) {
        if (films.empty() && !c.animations.empty()) films = clip_films(c, context);
        c.warnings = check_result(c, films, context);
        for (const Warning& warning : c.warnings) context.warn(folder.string() + ": " + warning.text);
    }
}

// Steps 2 to 6 on one character. Returns its status: "ok", or the step and the reason why it cannot go on.
std::string animate_character(Character& character, const fs::path& folder, Context& context,
                              const std::function<void(Step)>& progress) {
    try {
        run_steps(character, folder, Step::segment, Step::render, context, progress);
        return "ok";
    } catch (const CharacterRejected& rejected) {
        return rejected.step() + ": " + rejected.what();
    }
}

bool is_chosen(const std::vector<int>& only, int number) {
    return only.empty() || std::find(only.begin(), only.end(), number) != only.end();
}

bool any_animated(const Page& page) {
    return std::any_of(page.characters.begin(), page.characters.end(),
                       [](const PageCharacter& c) { return c.status == "ok"; });
}

} // namespace

AnimatedPage animate_page(const fs::path& image, const fs::path& out, Context& context,
                          bool keep_intermediate) {
    // Step 1 (4.2): the page to characters.
    context.progress(name_of(Step::detect));
    AnimatedPage animated = detect_characters(image, context);
    save_detection(out, animated, context);
    if (!keep_intermediate) animated.ink = {};
    if (!keep_intermediate && !context.settings().render.scene) animated.picture = {};

    // Steps 2 to 6, one character after the other.
    Page& page = animated.page;
    const bool scene = context.settings().render.scene;
    const double total =
        1.0 + static_cast<double>(step_names.size() - 1) * static_cast<double>(animated.characters.size());
    double done = 1;
    for (std::size_t i = 0; i < animated.characters.size(); ++i) {
        Character& character = animated.characters[i];
        PageCharacter& entry = page.characters[i];
        if (!is_chosen(context.settings().only, static_cast<int>(i) + 1)) {
            entry.status = "left out: not one of --only";
            continue;
        }
        const double before = done;
        entry.status = animate_character(character, out / entry.folder, context, [&](Step step) {
            context.progress(entry.folder + ": " + name_of(step), done++ / total);
        });
        if (character.reached >= Step::identify)
            set_type(entry, character.identification, context.references());
        entry.warnings = character.warnings;
        done = before + static_cast<double>(step_names.size() - 1);
        if (!scene && !keep_intermediate) character = {}; // its pictures are not needed any more
    }

    // All characters in their places, as one film.
    if (scene && any_animated(page)) {
        context.progress(file_names::scene, 1);
        render_scene(animated.picture, out, page, animated.characters, context);
    }
    write_page(out, page); // last: whoever finds it without unfinished characters finds everything
    return animated;
}

Settings settings_for(const fs::path& image, const Settings& wanted) {
    Settings settings = wanted;
    if (settings.overrides.reference.empty() && is_animated_drawings_folder(image) && names_humanoid(image))
        settings.overrides.reference = "humanoid";
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
    Context context(settings, networks);
    context.prepare();
    Page page = animate_page(image, out, context, false).page;
    require_animated(image, page);
    return page;
}

Page detect_page(const fs::path& image, const fs::path& out, const Settings& settings) {
    Context context(settings);
    context.progress(name_of(Step::detect));
    AnimatedPage detected = detect_characters(image, context);
    save_detection(out, detected, context);
    for (PageCharacter& character : detected.page.characters) character.status = "ok";
    write_page(out, detected.page);
    return std::move(detected.page);
}

// --- a step alone, on a character's folder -----------------------------------------------------------------

namespace {

Identification run_steps_on(const fs::path& folder, const Settings& settings, Step first, Step last) {
    require_folder(folder);
    Context context(settings);
    std::optional<std::vector<Warning>> warnings; // those of the films before are still of the films
    Identification identification;
    try {
        Character character = load_character(folder, first, context);
        run_steps(character, folder, first, last, context, [&](Step s) { context.progress(name_of(s)); });
        identification = std::move(character.identification);
        if (first == Step::identify) update_type(folder, identification, context.references());
        if (last >= Step::rig) warnings = character.warnings;
    } catch (const CharacterRejected& rejected) {
        const std::string status = rejected.step() + ": " + rejected.what();
        set_result(folder, status, std::vector<Warning>());
        throw Error(ErrorKind::not_animated, folder.string() + ": " + status);
    }
    set_result(folder, "ok", warnings);
    return identification;
}
void run_step(const fs::path& folder, const Settings& settings, Step step) {
    run_steps_on(folder, settings, step, step);
}

} // namespace

void segment_folder(const fs::path& folder, const Settings& settings) {
    run_step(folder, settings, Step::segment);
}
void skeletonize_folder(const fs::path& folder, const Settings& settings) {
    run_step(folder, settings, Step::skeletonize);
}
void identify_folder(const fs::path& folder, const Settings& settings) {
    run_step(folder, settings, Step::identify);
}
void rig_folder(const fs::path& folder, const Settings& settings) { run_step(folder, settings, Step::rig); }
void render_folder(const fs::path& folder, const Settings& settings) {
    run_step(folder, settings, Step::render);
}
Identification animate_folder(const fs::path& folder, const Settings& settings) {
    Identification identification = run_steps_on(folder, settings, Step::identify, Step::identify);
    run_steps_on(folder, settings, Step::rig, Step::render);
    return identification;
}

} // namespace pantin
