// SPDX-License-Identifier: MIT
// The options of all steps, their presets and their names in a configuration file (docs/formats.md,
// "Configuration").
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pantin/animation.hpp"
#include "pantin/detection.hpp"
#include "pantin/identification.hpp"
#include "pantin/model.hpp"
#include "pantin/motion.hpp"
#include "pantin/rigging.hpp"
#include "pantin/segmentation.hpp"
#include "pantin/skeletonization.hpp"

namespace pantin {

struct AnimationOptions {
    ClipSet clips = ClipSet::standard; // of the references; `thesis`: those of its chapter 6.1
    int samples = 24; // key poses of a clip in character.glb and between which frames are interpolated
    double motion_start = 0, motion_seconds = 12; // the part of a recorded motion that is used
    Way motion_way = Way::automatic;              // what becomes of its way over the ground
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

// "default" (what gives the best results) or "thesis" (the thesis as printed where it can be, with its
// errata applied; each value's source stands beside it in options.cpp). Error(usage) for another name.
Options make_preset(std::string_view name);
// Sets the options that a JSON file names, as `{"skeletonization": {"residual_threshold": 20}}` or as
// `{"skeletonization.residual_threshold": 20}`. Error(input) names the file and the option. Own format
// (docs/formats.md, "Configuration").
void apply_config(Options& options, const std::filesystem::path& file);
// The same with the JSON at hand; `source` stands for the file in messages. Errors and source as above.
void apply_config_text(Options& options, const std::string& json, const std::string& source);
// Every option, "group.field", with its value as JSON text, in a fixed order. No errors. Own.
std::vector<std::pair<std::string, std::string>> list_options(const Options& options);

// An option that had another name; a configuration may use the former one for a release.
struct RenamedOption {
    std::string_view former, name;
};
// All of them. No errors. Own.
std::span<const RenamedOption> renamed_options();

// A switch that has become a choice, under another name or the same; a configuration may still say true or
// false, which stand for these two of its values.
struct FormerSwitch {
    std::string_view former, name, if_true, if_false;
};
// All of them. No errors. Own.
std::span<const FormerSwitch> former_switches();

} // namespace pantin
