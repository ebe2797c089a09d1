// SPDX-License-Identifier: MIT
// What the user wants of a run, besides the options of the steps.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pantin/animation.hpp"
#include "pantin/options.hpp"

namespace pantin {

struct RenderRequest {
    std::string clip = "all"; // a clip of the reference, or all
    double fps = 25;          // 1 … 100
    // Names of the table in src/export/film_formats.cpp; empty: webp, and gif for the first clip.
    std::vector<std::string> formats;
    std::optional<int> quality; // of WebP films: 0 … 100; none: lossless
    bool scene = false;         // `animate`: the whole page as one film, too
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
    std::filesystem::path motion;  // a BVH file that characters of its kind of body follow, as one more clip
                                   // of its name; empty: none
    std::filesystem::path motion_map; // JSON: which of its joints plays which part; empty: found
    bool blend = false;               // clips of the two best types are mixed
    std::vector<int> only; // numbers of the page's characters that are animated, from 1; empty: all
    // Degrees by which a page is first turned clockwise: 0, 90, 180, 270. None: as the drawing seems to have
    // been meant (DetectionOptions::turn_probability); given results (`overrides`) stay as they are.
    std::optional<int> rotate;
    int threads = 1;                // results do not depend on it
    bool animated_drawings = false; // humanoids are also written as AnimatedDrawings character folders
    bool trace = false;             // intermediate products are written, too
    RenderRequest render;
    // Called before each step when set; `share` of the work done so far, 0 to 1.
    std::function<void(const std::string& what, double share)> progress;
    std::function<void(const std::string& line)> notice;  // facts that the user wants to check
    std::function<void(const std::string& line)> warning; // "folder: text" of each warning (warnings.hpp)
};

} // namespace pantin
