// SPDX-License-Identifier: MIT
// The two presets, and every option by its name in a configuration file.
#include <algorithm>
#include <deque>
#include <map>

#include "core/decimal.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "core/json_reader.hpp"
#include "core/suggestion.hpp"
#include "pantin/error.hpp"
#include "pantin/options.hpp"

namespace pantin {

namespace {

// Former names of options. A configuration may use them for one release; they are not listed.
constexpr RenamedOption former_names[] = {
    {"detection.room_gain", "detection.enclosed_gain"},
    {"segmentation.sharpness", "segmentation.inverse_temperature"},
    {"segmentation.sure_enough", "segmentation.sufficient_confidence"},
    {"segmentation.least_sureness", "segmentation.least_confidence"},
};

// Switches that have become choices.
constexpr FormerSwitch switches[] = {
    {"identification.use_ilp", "identification.solver", "tightened", "branch_and_bound"},
    {"segmentation.grey_erosion", "segmentation.grey_erosion", "always", "never"},
};

// Calls visit(name, field, low, high) for numbers and visit(name, field, names) for choices, in a fixed
// order.
template <class Visitor> void visit_detection(DetectionOptions& o, Visitor& visit) {
    visit("detection.detector", o.detector, {"contour", "mask-rcnn"});
    visit("detection.working_size", o.working_size, 64, 2048);
    visit("detection.max_characters", o.max_characters, 1, 64);
    visit("detection.flatten_sheet", o.flatten_sheet);
    visit("detection.turn_probability", o.turn_probability, 0, 2);
    visit("detection.ink_contrast", o.ink_contrast, 0, 1);
    visit("detection.lightest_stroke", o.lightest_stroke, 0, 1);
    visit("detection.filled_darkness", o.filled_darkness, 0, 1);
    visit("detection.threshold_windows", o.threshold_windows, 1, 1000);
    visit("detection.grouping_size", o.grouping_size, 64, 4096);
    visit("detection.mark_size", o.mark_size, 0, 1);
    visit("detection.mark_gap", o.mark_gap, 0, 1);
    visit("detection.touching_gap", o.touching_gap, 0, 1);
    visit("detection.closed_share", o.closed_share, 0, 1);
    visit("detection.deepest_pen", o.deepest_pen, 0, 1);
    visit("detection.contact_share", o.contact_share, 0, 1);
    visit("detection.head_size", o.head_size, 0, 1);
    visit("detection.stacked_head_size", o.stacked_head_size, 0, 1);
    visit("detection.head_gap", o.head_gap, 0, 1);
    visit("detection.open_gap", o.open_gap, 0, 1);
    visit("detection.stacked_gap", o.stacked_gap, 0, 1);
    visit("detection.enclosed_gain", o.enclosed_gain, 0, 1);
    visit("detection.min_share", o.min_share, 0, 1);
    visit("detection.min_side", o.min_side, 1, 16384);
    visit("detection.mask", o.mask, {"ink", "network"});
    visit("detection.network_score", o.network_score, 0, 1);
    visit("detection.contained_share", o.contained_share, 0, 1);
    visit("detection.part_score", o.part_score, 0, 1);
    visit("detection.part_overlap", o.part_overlap, 0, 1);
    visit("detection.shared_claim", o.shared_claim, 0, 1);
    visit("detection.inside_share", o.inside_share, 0, 2);
    visit("detection.claimed_reach", o.claimed_reach, 0, 10);
    visit("detection.claimed_extent", o.claimed_extent, 0, 10);
    visit("detection.unclaimed_reach", o.unclaimed_reach, 0, 1);
    visit("detection.unclaimed_extent", o.unclaimed_extent, 0, 10);
}

template <class Visitor> void visit_segmentation(SegmentationOptions& o, Visitor& visit) {
    visit("segmentation.grey_erosion", o.grey_erosion, {"never", "photographs", "always"});
    visit("segmentation.refine_silhouette", o.refine_silhouette);
    visit("segmentation.mirror", o.mirror);
    visit("segmentation.tilt", o.tilt, 0, 90);
    visit("segmentation.inverse_temperature", o.inverse_temperature, 0, 1000);
    visit("segmentation.sufficient_confidence", o.sufficient_confidence, 0, 2);
    visit("segmentation.least_confidence", o.least_confidence, 0, 1);
    visit("segmentation.scribble_ratio", o.scribble_ratio, 0, 1000);
    visit("segmentation.scribble_other", o.scribble_other, 0, 1);
    visit("segmentation.scribble_part", o.scribble_part, 0, 1);
    visit("segmentation.fill_probability", o.silhouette.fill_probability, 0, 1);
    visit("segmentation.keep_probability", o.silhouette.keep_probability, 0, 1);
    visit("segmentation.open_share", o.silhouette.open_share, 0, 1);
    visit("segmentation.hole_probability", o.silhouette.hole_probability, 0, 1);
    visit("segmentation.hole_cut_share", o.silhouette.hole_cut_share, 0, 1);
    visit("segmentation.region_probability", o.silhouette.region_probability, 0, 1);
    visit("segmentation.region_share", o.silhouette.region_share, 0, 1);
    visit("segmentation.region_ink_share", o.silhouette.region_ink_share, 0, 1);
    visit("segmentation.enclosed_share", o.silhouette.enclosed_share, 0, 1);
    visit("segmentation.hollow_share", o.silhouette.hollow_share, 0, 1);
    visit("segmentation.ink_darkness", o.silhouette.ink_darkness, 0, 1);
    visit("segmentation.tolerance", o.silhouette.tolerance, 0, 1);
    visit("segmentation.piece_share", o.silhouette.piece_share, 0, 1);
    visit("segmentation.bridge_length", o.silhouette.bridge_length, 0, 1);
    visit("segmentation.hole_share", o.silhouette.hole_share, 0, 1);
    visit("segmentation.rim", o.silhouette.rim, 0, 1);
    visit("segmentation.rim_probability", o.silhouette.rim_probability, 0, 1);
    visit("segmentation.part_probability", o.silhouette.part_probability, 0, 1);
    visit("segmentation.speck_share", o.silhouette.speck_share, 0, 1);
}

template <class Visitor> void visit_skeletonization(SkeletonizationOptions& o, Visitor& visit) {
    visit("skeletonization.method", o.method, {"voronoi", "straight", "thinning", "chordal"});
    visit("skeletonization.residual", o.residual, {"arc", "chord"});
    visit("skeletonization.residual_threshold", o.residual_threshold, 0, 10000);
    visit("skeletonization.merge_distance", o.merge_distance, 0, 10000);
    visit("skeletonization.merge_weighting", o.merge_weighting, {"equal", "edges", "vertices"});
    visit("skeletonization.fill_holes_share", o.fill_holes_share, 0, 1);
    visit("skeletonization.recover_parts_share", o.recover_parts_share, 0, 1);
    visit("skeletonization.cut_cycles", o.cut_cycles);
    visit("skeletonization.thinning_stop", o.thinning_stop, {"both", "either"});
    visit("skeletonization.fill_pockets", o.fill_pockets);
    visit("skeletonization.lower_threshold", o.lower_threshold);
    visit("skeletonization.reject_point", o.reject_point);
}

template <class Visitor> void visit_identification(IdentificationOptions& o, Visitor& visit) {
    visit("identification.k_v", o.ggd.k_v, 0, 1000);
    visit("identification.k_e", o.ggd.k_e, 0, 1000);
    visit("identification.k_l", o.ggd.k_l, 0, 1000);
    for (std::size_t i = 1; i < o.ggd.label_values.size(); ++i)
        visit("identification.label_values." + std::string(label_names[i]), o.ggd.label_values[i], 0, 1000);
    visit("identification.max_nodes", o.ggd.max_nodes, 1, 1'000'000'000);
    visit("identification.thesis_score", o.thesis_score);
    visit("identification.use_evidence", o.use_evidence);
    visit("identification.solver", o.solver, {"branch_and_bound", "literal", "tightened"});
    visit("identification.ilp_gap", o.ilp.gap, 0, 1);
    visit("identification.ilp_iterations", o.ilp.iterations, 0, 1'000'000'000);
    visit("identification.k_n", o.k_n, 0, 1000);
    visit("identification.k_n_replaces", o.k_n_replaces, {"none", "k_v", "k_e", "k_l", "all"});
    visit("identification.mirrored", o.mirrored, {"none", "distance", "head"});
    visit("identification.reject_unmovable", o.reject_unmovable);
}

template <class Visitor> void visit_modeling(ModelOptions& o, Visitor& visit) {
    visit("modeling.samples", o.inflation.polygon.samples, 0, 100000);
    visit("modeling.tolerance", o.skeleton.coarsest, 0, 1);
    visit("modeling.printed_axis", o.skeleton.printed_axis);
    visit("modeling.per_part", o.per_part);
    visit("modeling.first_collapse", o.skeleton.collapse, 0, 1);
    visit("modeling.simplify", o.skeleton.threshold, 0.0001, 1.0);
    visit("modeling.simplify_factor", o.skeleton.threshold_factor, 0.01, 0.99);
    visit("modeling.shape_weight", o.skeleton.shape_weight, 0, 1000);
    visit("modeling.prune", o.refinement.prune, 0, 10);
    visit("modeling.merge", o.refinement.merge, 0, 10);
    visit("modeling.collapse", o.refinement.collapse, 0, 10);
    visit("modeling.least_bone", o.refinement.least_bone, 0, 1);
    visit("modeling.longest_edge", o.inflation.longest_edge, 0.005, 1.0);
    visit("modeling.poisson_load", o.inflation.load, 0.01, 100.0);
}

template <class Visitor> void visit_rigging(RigOptions& o, Visitor& visit) {
    visit("rigging.samples", o.mapping.samples, 2, 10000);
    visit("rigging.alpha", o.mapping.alpha, 0, 1000);
    visit("rigging.length_in_pixels", o.mapping.length_in_pixels);
    visit("rigging.osb", o.mapping.osb, {"icdm2007", "printed"});
    visit("rigging.label_aware", o.mapping.label_aware);
    visit("rigging.path_weight", o.mapping.path_weight, 0, 1000);
    visit("rigging.position_weight", o.mapping.position_weight, 0, 1000);
    visit("rigging.trunk_weight", o.mapping.trunk_weight, 0, 1000);
    visit("rigging.prominence_weight", o.mapping.prominence_weight, 0, 1000);
    visit("rigging.label_penalty", o.mapping.label_penalty, 0, 1000);
    visit("rigging.mixed_reach", o.mapping.mixed_reach, 0, 2);
    visit("rigging.unmatched_cost", o.mapping.unmatched_cost, 0, 1000);
    visit("rigging.prior_weight", o.mapping.prior_weight, 0, 1000);
    visit("rigging.mesh", o.mesh.method, {"marching_squares", "voronoi_regions"});
    visit("rigging.cell", o.mesh.cell, 0, 512);
    visit("rigging.margin", o.mesh.margin, -1, 100);
    visit("rigging.interpolate_distance", o.mesh.interpolate_distance);
    visit("rigging.snap", o.mesh.snap, 0, 1);
    visit("rigging.cut_touching_parts", o.mesh.cut_touching_parts);
    visit("rigging.thesis_weights", o.thesis_weights);
    visit("rigging.weight_ends", o.weight_ends, {"mapped", "all"});
    visit("rigging.limb_segments", o.limb_segments, 1, 4);
}

template <class Visitor> void visit_options(Options& o, Visitor visit) {
    visit_detection(o.detection, visit);
    visit_segmentation(o.segmentation, visit);
    visit_skeletonization(o.skeletonization, visit);
    visit_identification(o.identification, visit);
    visit_rigging(o.rigging, visit);
    visit_modeling(o.modeling, visit);
    visit("animation.clips", o.animation.clips, {"default", "thesis"});
    visit("animation.samples", o.animation.samples, 2, 1000);
    visit("animation.motion_start", o.animation.motion_start, 0.0, 1e6);
    visit("animation.motion_seconds", o.animation.motion_seconds, 0.01, 600.0);
    visit("animation.motion_way", o.animation.motion_way, {"automatic", "whole", "follow", "in_place"});
}

using Choices = std::initializer_list<const char*>;

// Sets the options that the file names and strikes them off the list.
struct Setter {
    std::map<std::string, JsonReader>& given;

    template <class Set> void take(const std::string& name, Set set) {
        const auto found = given.find(name);
        if (found == given.end()) return;
        set(found->second);
        given.erase(found);
    }
    void operator()(const std::string& name, bool& field) {
        take(name, [&](const JsonReader& reader) { field = reader.boolean(); });
    }
    void operator()(const std::string& name, double& field, double low, double high) {
        take(name, [&](const JsonReader& reader) { field = reader.number(low, high); });
    }
    template <class Integer> void operator()(const std::string& name, Integer& field, long low, long high) {
        take(name,
             [&](const JsonReader& reader) { field = static_cast<Integer>(reader.integer(low, high)); });
    }
    template <class Enum> void operator()(const std::string& name, Enum& field, Choices names) {
        take(name, [&](const JsonReader& reader) {
            const auto chosen = std::find(names.begin(), names.end(), reader.text());
            if (chosen == names.end()) {
                std::string list;
                for (const char* choice : names) list += (list.empty() ? "" : " or ") + std::string(choice);
                reader.fail("must be " + list);
            }
            field = static_cast<Enum>(chosen - names.begin());
        });
    }
};

struct Lister {
    std::vector<std::pair<std::string, std::string>>& list;

    void operator()(const std::string& name, bool field) {
        list.emplace_back(name, field ? "true" : "false");
    }
    template <class Number, class Bound>
    void operator()(const std::string& name, Number field, Bound, Bound) {
        list.emplace_back(name, to_decimal(static_cast<double>(field)));
    }
    template <class Enum> void operator()(const std::string& name, Enum field, Choices names) {
        list.emplace_back(name, '"' + std::string(names.begin()[static_cast<std::size_t>(field)]) + '"');
    }
};

// `{"a": {"b": 1}, "a.c": 2}` to {a.b: 1, a.c: 2}.
void flatten(const JsonReader& object, const std::string& prefix, std::map<std::string, JsonReader>& out) {
    for (const auto& [key, reader] : object.entries()) {
        const std::string name = prefix.empty() ? key : prefix + "." + key;
        if (std::count(name.begin(), name.end(), '.') > 8) reader.fail("is nested too deeply");
        if (reader.value().is_object())
            flatten(reader, name, out);
        else if (!out.emplace(name, reader).second)
            reader.fail("is given twice");
    }
}

// What stands under a former name counts as the new one.
void take_former_names(std::map<std::string, JsonReader>& given) {
    for (const RenamedOption& option : former_names) {
        const auto former = given.find(std::string(option.former));
        if (former == given.end()) continue;
        if (!given.emplace(option.name, former->second).second)
            former->second.fail("is given twice, also as '" + std::string(option.name) + "'");
        given.erase(former);
    }
}

// The thesis up to the skeleton (4.2 to 4.4).
void set_thesis_shape(Options& options) {
    options.detection.working_size = 321;    // ch. 5: the network's input
    options.detection.flatten_sheet = false; // 4.2: the picture as it is
    options.detection.turn_probability = 2;
    options.detection.part_score = 0;               // 4.2: whatever was detected is a character
    options.detection.mask = MaskSource::network;   // 4.4: "the mask computed in the detection step" …
    options.segmentation.refine_silhouette = false; // … and not another one
    options.segmentation.grey_erosion = GreyErosion::photographs; // ch. 5
    options.segmentation.mirror = false;                          // 4.3: one view of the drawing
    options.segmentation.tilt = 0;
    options.segmentation.scribble_ratio = 1000;       // 4.3: whatever was detected is a character
    options.segmentation.silhouette.rim = 0;          // 4.2: the detector's mask
    options.skeletonization.residual = Residual::arc; // 3.4, ERRATA 1
    options.skeletonization.recover_parts_share = 0;
    options.skeletonization.cut_cycles = false;
    options.skeletonization.lower_threshold = false;
    options.skeletonization.reject_point = false;
    options.skeletonization.thinning_stop = ThinningStop::either; // Algorithm 4.1, lines 11 and 21
    options.skeletonization.fill_pockets = false;                 // ERRATA 3: what thinning keeps stays
    options.skeletonization.fill_holes_share = 0;                 // ERRATA 4: holes are kept
}

// From the graph on (4.5, 4.6, 6.1).
void set_thesis_motion(Options& options) {
    options.identification.thesis_score = true;           // Eq. 4.3–4.7
    options.identification.use_evidence = false;          // ERRATA 10
    options.identification.solver = GgdSolver::literal;   // 4.5, ch. 5: the program as printed, by GLPK
    options.identification.k_n_replaces = KnReading::k_v; // ERRATA 8
    options.identification.mirrored = Mirroring::none;    // ERRATA 11
    options.identification.reject_unmovable = false;      // 4.5: there is always a nearest reference
    options.rigging.mapping.length_in_pixels = true;      // Eq. 4.9, ERRATA 15
    options.rigging.mapping.label_aware = false;          // ERRATA 19
    options.rigging.mesh.interpolate_distance = false;    // 4.6: a binary mask, so midpoints (ERRATA 21)
    options.rigging.mesh.snap = 0;
    options.rigging.mesh.margin = 0;                 // 4.6: the mask itself
    options.rigging.mesh.cut_touching_parts = false; // ERRATA 22
    options.rigging.thesis_weights = true;           // Algorithm 4.4
    options.rigging.weight_ends = WeightEnds::all;   // its EF
    options.rigging.limb_segments = 1;               // one bone an end-effector
    options.animation.clips = ClipSet::thesis;       // 6.1
}

// A former switch counts as the choice that it stands for. The values must outlive the readers: `values`.
void take_former_switches(std::map<std::string, JsonReader>& given, std::deque<Json>& values) {
    for (const FormerSwitch& option : switches) {
        const auto former = given.find(std::string(option.former));
        if (former == given.end()) continue;
        const JsonReader reader = former->second;
        if (option.former == option.name && !reader.value().is_boolean()) continue;
        values.push_back(std::string(reader.boolean() ? option.if_true : option.if_false));
        given.erase(former);
        const std::string name(option.name);
        if (!given.emplace(name, JsonReader(values.back(), reader.file(), name)).second)
            reader.fail("is given twice, also as '" + std::string(option.name) + "'");
    }
}

} // namespace

std::span<const RenamedOption> renamed_options() { return former_names; }
std::span<const FormerSwitch> former_switches() { return switches; }

Options make_preset(std::string_view name) {
    Options options;
    if (name == "default") return options;
    if (name != "thesis")
        throw Error(ErrorKind::usage, "--preset: there is no preset '" + std::string(name) +
                                          "' (default, thesis)" + did_you_mean(name, {"default", "thesis"}));
    set_thesis_shape(options);
    set_thesis_motion(options);
    return options;
}

void apply_config_text(Options& options, const std::string& text, const std::string& source) {
    const Json json = parse_json(text, source);
    std::map<std::string, JsonReader> given;
    flatten(JsonReader(json, source), "", given);
    take_former_names(given);
    std::deque<Json> values;
    take_former_switches(given, values);
    visit_options(options, Setter{given});
    if (given.empty()) return;
    std::vector<std::string> names;
    for (const auto& [name, value] : list_options(options)) names.push_back(name);
    const std::string& unknown = given.begin()->first;
    throw Error(ErrorKind::input,
                source + ": there is no option '" + unknown + "'" + did_you_mean(unknown, names));
}

void apply_config(Options& options, const std::filesystem::path& file) {
    apply_config_text(options, read_text(file), file.string());
}

std::vector<std::pair<std::string, std::string>> list_options(const Options& options) {
    std::vector<std::pair<std::string, std::string>> list;
    Options copy = options;
    visit_options(copy, Lister{list});
    return list;
}

} // namespace pantin
