// SPDX-License-Identifier: MIT
// Steps 4 to 6: skeleton graph to moving meshes and files for other programs.
#include <algorithm>

#include "formats/file_names.hpp"
#include "formats/identification_file.hpp"
#include "formats/mapping_file.hpp"
#include "formats/pictures.hpp"
#include "formats/segmentation_file.hpp"
#include "formats/skeleton_file.hpp"
#include "pantin/export.hpp"
#include "verify/bytes.hpp"
#include "verify/stage.hpp"
#include "verify/step_files.hpp"

namespace pantin {

namespace {

const std::string labels_file = character_path + file_names::labels,
                  segmentation_file = character_path + file_names::segmentation,
                  graph_file = character_path + file_names::skeleton,
                  identification_file = character_path + file_names::identification,
                  mapping_file = character_path + file_names::mapping, mesh_file = trace_path + "mesh.json",
                  bones_file = trace_path + "bones.json", weights_file = character_path + file_names::weights,
                  depths_file = trace_path + "depths.json", animations_file = trace_path + "animations.json",
                  posed_file = trace_path + "posed.json";
constexpr double posed_share = 0.3; // of the first clip's duration: a pose that is no key pose
constexpr int frame_size = 128;

SkeletonGraph graph_of(const StageContext& c) { return skeleton_from_json(c.text(graph_file), graph_file); }

// What identification decided: the reference and its candidate.
struct Decision {
    const ReferenceSkeleton& reference;
    Candidate candidate;
};
Decision decision_of(const StageContext& c, const SkeletonGraph& graph) {
    const Identification found =
        identification_from_json(c.text(identification_file), identification_file, graph, c.references);
    const auto reference =
        std::find_if(c.references.begin(), c.references.end(),
                     [&](const ReferenceSkeleton& r) { return r.name == found.reference; });
    const auto candidate = std::find_if(found.candidates.begin(), found.candidates.end(),
                                        [&](const Candidate& k) { return k.reference == found.reference; });
    return {*reference, *candidate}; // the reader has checked both
}

Files identify_character(const StageContext& c) {
    const TypeProbabilities seen = type_probabilities_from_json(c.text(segmentation_file), segmentation_file);
    return {
        {identification_file, identification_to_json(identify(graph_of(c), c.grey(labels_file), c.references,
                                                              c.options.identification, seen))}};
}

Files map_ends(const StageContext& c) {
    const SkeletonGraph graph = graph_of(c);
    const Decision decision = decision_of(c, graph);
    const Mapping mapping = map_end_effectors(graph, c.grey(labels_file), decision.reference,
                                              decision.candidate, c.options.rigging.mapping);
    return {{mapping_file, mapping_to_json(mapping)}};
}

Rig rigged(const StageContext& c) {
    const SkeletonGraph graph = graph_of(c);
    const Decision decision = decision_of(c, graph);
    const Mapping mapping = mapping_from_json(c.text(mapping_file), mapping_file, graph, decision.reference);
    return rig_with_mapping(graph, c.grey(labels_file), decision.reference, decision.candidate.mirrored,
                            mapping, c.options.rigging);
}

Files mesh(const StageContext& c) { return {{mesh_file, mesh_to_json(rigged(c))}}; }
Files bones(const StageContext& c) { return {{bones_file, bones_to_json(rigged(c))}}; }
Files weights(const StageContext& c) {
    const Rig rig = rigged(c);
    return {{weights_file, to_weights_text(rig)}, {depths_file, depths_to_json(rig)}};
}

// --- the rig at hand
// -------------------------------------------------------------------------------------------

Rig rig_of(const StageContext& c) {
    return rig_from_files(c.text(mesh_file), c.text(bones_file), c.text(weights_file), c.text(depths_file));
}

std::vector<BoneAnimation> animations_of(const StageContext& c) {
    return animations_from_json(c.text(animations_file), animations_file);
}

RgbaImage texture_of(const StageContext& c) {
    return make_texture(c.picture(character_path + file_names::drawing),
                        inverted(c.grey(character_path + file_names::ink)), c.grey(labels_file));
}

Files animate_bones(const StageContext& c) {
    const Rig rig = rig_of(c);
    const Decision decision = decision_of(c, graph_of(c));
    std::vector<BoneAnimation> animations;
    for (const ReferenceClip& clip : decision.reference.clips)
        animations.push_back(retarget(rig, decision.reference, clip, c.options.animation.samples));
    return {{animations_file, animations_to_json(animations)}};
}

Files pose(const StageContext& c) {
    const BoneAnimation first = animations_of(c).at(0);
    return {{posed_file, places_to_json(skin(rig_of(c), first, posed_share * first.duration))}};
}

Files render_pose(const StageContext& c) {
    const Rig rig = rig_of(c);
    RenderOptions options;
    options.size = frame_size;
    const RgbaImage frame = render_frame(rig, places_from_json(c.text(posed_file), posed_file), texture_of(c),
                                         view_of(rig, animations_of(c)), options);
    return {{trace_path + "frame.png", png(frame)}};
}

Files export_files(const StageContext& c) {
    const Rig rig = rig_of(c);
    return {{character_path + file_names::mesh, to_obj(rig, file_names::material)},
            {character_path + file_names::material, to_mtl(file_names::drawing)},
            {character_path + file_names::glb, as_text(to_glb(rig, texture_of(c), animations_of(c)))}};
}

} // namespace

std::vector<Stage> motion_stages() {
    const std::vector<std::string> for_rig = {graph_file, labels_file, identification_file, mapping_file},
                                   rig = {mesh_file, bones_file, weights_file, depths_file};
    const auto with = [](std::vector<std::string> files, const std::vector<std::string>& more) {
        files.insert(files.end(), more.begin(), more.end());
        return files;
    };
    return {
        {"identify", {graph_file, labels_file, segmentation_file}, {identification_file}, identify_character},
        {"map", {graph_file, labels_file, identification_file}, {mapping_file}, map_ends},
        {"mesh", for_rig, {mesh_file}, mesh},
        {"bones", for_rig, {bones_file}, bones},
        {"weights", for_rig, {weights_file, depths_file}, weights},
        {"animate", with(rig, {identification_file, graph_file}), {animations_file}, animate_bones},
        {"skin", with(rig, {animations_file}), {posed_file}, pose},
        {"render",
         with(rig, {animations_file, posed_file, character_path + file_names::drawing, labels_file}),
         {trace_path + "frame.png"},
         render_pose},
        {"export",
         with(rig, {animations_file, character_path + file_names::drawing, labels_file}),
         {character_path + file_names::mesh, character_path + file_names::material,
          character_path + file_names::glb},
         export_files},
    };
}

} // namespace pantin
