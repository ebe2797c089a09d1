// SPDX-License-Identifier: MIT
// The whole way from a page to animated characters, and each step of it alone on a character's folder.
//
// Files and folders: docs/formats.md. Every step keeps what it makes in memory and writes it; a step that
// runs alone reads the files of the steps before it. Both ways give the same bytes.
#pragma once

#include <filesystem>

#include "pantin/error.hpp"
#include "pantin/networks.hpp"
#include "pantin/options.hpp"
#include "pantin/page.hpp"
#include "pantin/settings.hpp"

namespace pantin {

// --- the steps ---------------------------------------------------------------------------------------------

// The whole pipeline: `image`, a picture or an AnimatedDrawings character folder, to out/page.json and one
// folder a character (and out/scene.* when that is wanted). A character that cannot go on keeps the files it
// has and says why in its status. Throws Error(not_animated) when none could be animated, after page.json is
// written; Error(no_character) when there is none (thesis Fig. 4.1). page.json is the last file to get its
// final content, so a run that was cut off does not look finished.
Page animate(const std::filesystem::path& image, const std::filesystem::path& out, const Settings& settings);
// The same with networks that other pages use, too; the weights of the settings do not count. Same errors.
Page animate(const std::filesystem::path& image, const std::filesystem::path& out, const Settings& settings,
             Networks& networks);

// Step 1 (thesis 4.2): page.json, and drawing and mask of each character. Replaces the results of a former
// run in `out`. Error(no_character) when there is none, Error(input) for a bad picture.
Page detect_page(const std::filesystem::path& image, const std::filesystem::path& out,
                 const Settings& settings);

// Steps 2 to 6 (thesis 4.3 to 4.6) on a character's folder: each reads the files of the steps before it and
// writes its own. They keep the status in the page.json beside the folder, if there is one, up to date, and
// throw Error(not_animated) when the character cannot go on. Error(input) names the file that is missing,
// invalid, or does not fit the others.
void segment_folder(const std::filesystem::path& folder, const Settings& settings);
void skeletonize_folder(const std::filesystem::path& folder, const Settings& settings);
// The skeletons of all methods side by side, to compare them by eye: skeletons.png and skeletons.json. Reads
// labels and drawing. Error(input) as above. Own.
void compare_skeletons_folder(const std::filesystem::path& folder, const Settings& settings);
void identify_folder(const std::filesystem::path& folder, const Settings& settings);
void rig_folder(const std::filesystem::path& folder, const Settings& settings);
void render_folder(const std::filesystem::path& folder, const Settings& settings);
// The last three, one after the other; what was identified.
Identification animate_folder(const std::filesystem::path& folder, const Settings& settings);

// --- models -----------------------------------------------------------------------------------------------

// Strokes (JSON or SVG, strokes.hpp) or a character's folder with labels.png to a rigged model; where the
// strokes' names do not tell the parts, the part network does (docs/modeling.md). Makes out/strokes.json,
// model.json, model.obj, model.mtl, model.glb, views.png, and what identify_folder takes: drawing.png,
// mask.png, labels.png, skeleton.json. `calls`: a strokes.json whose calls come after the input's own; empty:
// none. rig_folder and render_folder find the strokes and move the solid. Error(input): a stroke or a call is
// invalid, or a file is none of these.
void model_folder(const std::filesystem::path& input, const std::filesystem::path& out,
                  const std::filesystem::path& calls, const Settings& settings);

} // namespace pantin
