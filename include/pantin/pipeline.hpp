// SPDX-License-Identifier: MIT
// The whole way from a page to animated characters, and each step of it alone on a character's folder.
//
// Files and folders: docs/formats.md. Every step keeps what it makes in memory and writes it; a step that
// runs alone reads the files of the steps before it. Both ways give the same bytes.
#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pantin/animation.hpp"
#include "pantin/detection.hpp"
#include "pantin/error.hpp"
#include "pantin/identification.hpp"
#include "pantin/model.hpp"
#include "pantin/page.hpp"
#include "pantin/rigging.hpp"
#include "pantin/segmentation.hpp"
#include "pantin/skeletonization.hpp"

namespace pantin {

// --- options -----------------------------------------------------------------------------------------------

struct AnimationOptions {
    int samples = 24; // key poses of a clip in character.glb and between which frames are interpolated
    double motion_start = 0, motion_seconds = 12; // the part of a recorded motion that is used
};

// The options of all steps. Their names in a configuration file are `<group>.<field>` (docs/formats.md).
struct Options {
    DetectionOptions detection;
    SegmentationOptions segmentation;
    SkeletonizationOptions skeletonization;
    IdentificationOptions identification;
    RigOptions rigging;
    ModelOptions modeling;
    AnimationOptions animation;
};

// "default" or "thesis" (the thesis to the letter where it can be, with its errata applied).
// Error(usage) for another name.
Options make_preset(std::string_view name);
// Sets the options that a JSON file names, as `{"skeletonization": {"residual_threshold": 20}}` or as
// `{"skeletonization.residual_threshold": 20}`. Error(input) names the file and the option.
void apply_config(Options& options, const std::filesystem::path& file);
// The same with the JSON at hand; `source` stands for the file in messages.
void apply_config_text(Options& options, const std::string& json, const std::string& source);
// Every option with its value as JSON text, in a fixed order.
std::vector<std::pair<std::string, std::string>> list_options(const Options& options);

// An option that had another name; a configuration may use the former one for a release. No errors; own.
struct RenamedOption {
    std::string_view former, name;
};
std::span<const RenamedOption> renamed_options();

// --- settings of a run -------------------------------------------------------------------------------------

struct RenderRequest {
    std::string clip = "all"; // a clip of the reference, or all
    double fps = 25;          // 1 … 100
    // Names of the table in src/export/film_formats.cpp; empty: webp, and gif for the first clip.
    std::vector<std::string> formats;
    bool scene = false; // `animate`: the whole page as one film, too
    RenderOptions picture;
};

// Results of steps that the user gives; `animate` then skips those steps. Pictures have the page's size
// (before `rotate`).
struct Overrides {
    std::filesystem::path mask; // grey PNG, the one character is where it is at least 128
    std::filesystem::path
        labels;            // grey PNG of label values; without a mask the character is where they are not 0
    std::string reference; // name of the reference that every character moves like
};

struct Settings {
    Options options;
    Overrides overrides;
    std::filesystem::path weights;    // folder of segmenter.safetensors; empty: compiled in
    std::filesystem::path references; // folder of more reference skeletons; empty: none
    std::filesystem::path mapping; // rig_folder: pairs as in mapping.json instead of matching; empty: match
    std::filesystem::path
        motion;         // a BVH file that humanoids follow, as one more clip of its name; empty: none
    bool blend = false; // clips of the two best types are mixed
    int rotate = 0;     // degrees by which a page is first turned clockwise: 0, 90, 180, 270
    int threads = 1;    // results do not depend on it
    bool animated_drawings = false; // humanoids are also written as AnimatedDrawings character folders
    bool trace = false;             // intermediate products are written, too
    RenderRequest render;
    // Called before each step when set; `share` of the work done so far, 0 to 1.
    std::function<void(const std::string& what, double share)> progress;
    std::function<void(const std::string& line)> notice; // facts that the user wants to check
};

// --- networks ----------------------------------------------------------------------------------------------

// Each is loaded when it is first asked for, and stays. Several threads may share them: a network does not
// change when it is used.
class Networks {
public:
    explicit Networks(std::filesystem::path weights = {}) : folder_(std::move(weights)) {} // as in Settings
    // Error(weights) when the weights are missing or invalid; the next call tries again.
    const CharacterFinder& finder();
    const Segmenter& segmenter();

private:
    template <class Network> const Network& loaded(std::optional<Network>& network, const char* name);

    std::filesystem::path folder_;
    std::mutex mutex_; // while a network is loaded, so that it is loaded once
    std::optional<CharacterFinder> finder_;
    std::optional<Segmenter> segmenter_;
};

// --- the steps ---------------------------------------------------------------------------------------------

// The whole pipeline: `image`, a picture or an AnimatedDrawings character folder, to out/page.json and one
// folder a character (and out/scene.* when that is wanted). A character that cannot go on keeps the files it
// has and says why in its status. Throws Error(not_animated) when none could be animated, after page.json is
// written; Error(no_character) when there is none. page.json is the last file to get its final content, so a
// run that was cut off does not look finished.
Page animate(const std::filesystem::path& image, const std::filesystem::path& out, const Settings& settings);
// The same with networks that other pages use, too; the weights of the settings do not count.
Page animate(const std::filesystem::path& image, const std::filesystem::path& out, const Settings& settings,
             Networks& networks);

// Step 1. Replaces the characters of a former run in `out`.
Page detect_page(const std::filesystem::path& image, const std::filesystem::path& out,
                 const Settings& settings);

// Steps 2 to 6 on a character's folder. They keep the status in the page.json beside the folder, if there is
// one, up to date, and throw Error(not_animated) when the character cannot go on.
void segment_folder(const std::filesystem::path& folder, const Settings& settings);
void skeletonize_folder(const std::filesystem::path& folder, const Settings& settings);
// The skeletons of all methods side by side, for looking at: skeletons.png and skeletons.json. Reads labels
// and drawing.
void compare_skeletons_folder(const std::filesystem::path& folder, const Settings& settings);
void identify_folder(const std::filesystem::path& folder, const Settings& settings);
void rig_folder(const std::filesystem::path& folder, const Settings& settings);
void render_folder(const std::filesystem::path& folder, const Settings& settings);

// --- models -----------------------------------------------------------------------------------------------

// Strokes (JSON or SVG, strokes.hpp) or a character's folder with labels.png to a rigged model:
// out/strokes.json, model.json, model.obj, model.mtl, model.glb, views.png, and what identify_folder takes:
// drawing.png, mask.png, labels.png, skeleton.json. `calls`: a strokes.json whose calls come after the
// input's own; empty: none. rig_folder and render_folder find the strokes and move the solid. Error(input): a
// stroke or a call is invalid, or a file is none of these.
void model_folder(const std::filesystem::path& input, const std::filesystem::path& out,
                  const std::filesystem::path& calls, const Settings& settings);

} // namespace pantin
