// SPDX-License-Identifier: MIT
#include "pipeline/stages.hpp"

#include "core/file.hpp"
#include "pantin/export.hpp"
#include "pantin/image.hpp"
#include "pipeline/animated_drawings.hpp"
#include "pipeline/clips.hpp"
#include "pipeline/json_files.hpp"
#include "pipeline/trace.hpp"

namespace pantin {

void run_segment(Character& character, Workshop& workshop) {
    if (character.labels) { // given
        save_png(character.folder / "labels.png", *character.labels);
        return;
    }
    SegmentationOptions options = workshop.options().segmentation;
    options.threads = workshop.settings().threads;
    Segmentation result = workshop.segmenter().segment(drawing_of(character), mask_of(character), options);
    if (workshop.settings().trace) trace_segmentation(character.folder, result);
    save_png(character.folder / "labels.png", result.labels);
    write_file(character.folder / "segmentation.json", segmentation_to_json(result));
    character.labels = result.labels;
    // The files are there: whoever knows better corrects labels.png and goes on with the next step.
    const bool scribble =
        result.confidence < options.least_confidence && result.stroke_ratio > options.scribble_ratio;
    if (workshop.keeps) character.segmentation = std::move(result);
    if (scribble)
        throw CharacterRejected(
            "segment", "looks like a scribble: many strokes, and no part that the network is sure of");
}

void run_skeletonize(Character& character, Workshop& workshop) {
    Skeletonization result = skeletonize(labels_of(character), workshop.options().skeletonization);
    if (workshop.settings().trace) trace_skeletonization(character.folder, result);
    write_file(character.folder / "contour.json", contour_to_json(result.contour));
    save_png(character.folder / "skeleton.png", to_grey(result.skeleton));
    write_file(character.folder / "skeleton.json", skeleton_to_json(result.graph));
    character.skeleton = result.graph;
    if (workshop.keeps) character.skeletonization = std::move(result);
}

void run_identify(Character& character, Workshop& workshop) {
    IdentificationOptions options = workshop.options().identification;
    options.reference = workshop.settings().given.reference;
    Identification result =
        identify(skeleton_of(character), labels_of(character), workshop.references(), options);
    write_file(character.folder / "identification.json", identification_to_json(result));
    character.identification = std::move(result);
}

void run_rig(Character& character, Workshop& workshop) {
    const Identification& identification = identification_of(character, workshop);
    const ReferenceSkeleton& reference = reference_of(character, workshop);
    const std::filesystem::path& mapping = workshop.settings().mapping;
    Rig result = mapping.empty() ? in_its_space(rig(skeleton_of(character), labels_of(character),
                                                    identification, {reference}, workshop.options().rigging),
                                                character, workshop)
                                 : rig_from_mapping(character, workshop, mapping);
    const std::vector<BoneAnimation> animations = animations_of(result, reference, workshop);
    const RgbaImage texture = texture_of(character, workshop);

    const std::filesystem::path& folder = character.folder;
    write_file(folder / "mapping.json", mapping_to_json(result.mapping));
    write_file(folder / "mesh.obj", to_obj(result, "mesh.mtl"));
    write_file(folder / "mesh.mtl", to_mtl("drawing.png"));
    write_file(folder / "weights.txt", to_weights_text(result));
    write_file(folder / "character.glb", to_glb(result, texture, animations));
    if (workshop.settings().animated_drawings &&
        !write_animated_drawings(folder / "animated_drawings", result, reference, texture) &&
        workshop.settings().notice)
        workshop.settings().notice(folder.string() +
                                   ": has not the arms and legs of an AnimatedDrawings character");
    character.rig = std::move(result);
}

} // namespace pantin
