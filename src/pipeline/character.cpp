// SPDX-License-Identifier: MIT
// Products of steps that need more than one call, and all products back from a folder.
#include "pipeline/character.hpp"

#include <algorithm>

#include "core/math.hpp"
#include "formats/character_folder.hpp"
#include "formats/file_names.hpp"
#include "pipeline/detected_page.hpp"

namespace pantin {

namespace fs = std::filesystem;

Character load_character(const fs::path& folder, Step step, Context& context) {
    Character c;
    c.reached = static_cast<Step>(static_cast<int>(step) - 1);
    c.mask = read_mask(folder);
    c.exact_mask = is_exact_mask(folder);
    if (step == Step::segment) c.drawing = read_drawing(folder), c.ink = read_ink(folder, c.drawing);
    if (step <= Step::segment) return c;

    c.segmentation.labels = read_labels(folder, c.mask);
    if (step <= Step::skeletonize) return c;

    c.skeletonization.graph = read_skeleton(folder, c.segmentation.labels);
    c.segmentation.type = read_type_probabilities(folder);
    if (step <= Step::identify) return c;

    c.identification = read_identification(folder, c.skeletonization.graph, context.references());
    c.reference = choose_reference(c.identification, context.references(), context.settings().blend);
    c.drawing = read_drawing(folder);
    if (!is_model_folder(folder)) c.ink = read_ink(folder, c.drawing);
    if (is_model_folder(folder)) c.solid = read_solid(folder, context.options().modeling);
    if (step <= Step::rig) return c;

    // Rigged anew (a matter of milliseconds), so that mapping and weights can be corrected by hand.
    c.rig = make_rig(c, folder / file_names::mapping, context);
    c.rig.weights = read_weights(folder, c.rig);
    c.texture = make_texture(c);
    c.animations = make_animations(c.rig, c.reference, context);
    return c;
}

ReferenceSkeleton choose_reference(const Identification& identification,
                                   const std::vector<ReferenceSkeleton>& references, bool blended) {
    const ReferenceSkeleton& chosen = find_reference(references, identification.reference);
    if (!blended) return chosen;
    const std::vector<Candidate>& all = identification.candidates;
    const auto own =
        std::find_if(all.begin(), all.end(), [&](const Candidate& c) { return c.reference == chosen.name; });
    const auto other = std::find_if(all.begin(), all.end(), [&](const Candidate& c) {
        const ReferenceSkeleton& r = find_reference(references, c.reference);
        return r.like.empty() && r.name != chosen.name && r.name != chosen.like;
    });
    if (own == all.end() || other == all.end()) return chosen;
    const double share = 1 / (1 + math::exp(own->score - other->score));
    return blend(chosen, find_reference(references, other->reference), share);
}

bool is_mirrored(const Identification& identification) {
    return std::any_of(
        identification.candidates.begin(), identification.candidates.end(),
        [&](const Candidate& c) { return c.reference == identification.reference && c.mirrored; });
}

Rig make_rig(const Character& c, const fs::path& mapping, Context& context) {
    const SkeletonGraph& graph = c.skeletonization.graph;
    const LabelMap& labels = c.segmentation.labels;
    const RigOptions& options = context.options().rigging;
    Rig made = mapping.empty() ? rig(graph, labels, c.identification, {c.reference}, options)
                               : rig_with_mapping(graph, labels, c.reference, is_mirrored(c.identification),
                                                  read_mapping(mapping, graph, c.reference), options);
    if (!c.solid) return made;
    return lifted(made, c.solid->model, c.solid->mesh, c.solid->view, c.solid->colours);
}

RgbaImage make_texture(const Character& c) {
    return c.solid ? make_solid_texture(c.drawing, c.segmentation.labels)
                   : make_texture(c.drawing, c.exact_mask ? GreyImage() : c.ink, c.segmentation.labels);
}

std::vector<BoneAnimation> make_animations(const Rig& rig, const ReferenceSkeleton& reference,
                                           Context& context) {
    const AnimationOptions& options = context.options().animation;
    std::vector<BoneAnimation> animations;
    for (const ReferenceClip& clip : reference.clips)
        animations.push_back(retarget(rig, reference, clip, options.samples));
    const NamedMotion* motion = context.motion();
    if (!motion || !can_follow(reference, motion->joints.plan)) return animations;
    BoneAnimation followed = follow(rig, reference, motion->motion, motion->joints,
                                    {options.motion_start, options.motion_seconds, options.motion_way});
    const auto same = std::find_if(animations.begin(), animations.end(),
                                   [&](const BoneAnimation& a) { return a.name == followed.name; });
    if (same != animations.end())
        *same = std::move(followed);
    else
        animations.push_back(std::move(followed));
    return animations;
}

} // namespace pantin
