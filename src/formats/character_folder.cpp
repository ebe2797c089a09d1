// SPDX-License-Identifier: MIT
// Products of the steps to the files of a character's folder, and back (docs/formats.md).
#include "formats/character_folder.hpp"

#include "core/file.hpp"
#include "formats/contour_file.hpp"
#include "formats/file_names.hpp"
#include "formats/identification_file.hpp"
#include "formats/mapping_file.hpp"
#include "formats/segmentation_file.hpp"
#include "formats/skeleton_file.hpp"
#include "formats/trace_files.hpp"
#include "formats/weights_file.hpp"
#include "pantin/export.hpp"

namespace pantin {

namespace fs = std::filesystem;

void save_detected(const fs::path& folder, const RgbImage& drawing, const GreyImage& ink, const Mask& mask) {
    create_folder(folder);
    save_png(folder / file_names::drawing, drawing);
    save_png(folder / file_names::ink, inverted(ink));
    save_png(folder / file_names::mask, to_grey(mask));
}

void save_segmentation(const fs::path& folder, const Segmentation& segmentation, bool trace) {
    save_png(folder / file_names::labels, segmentation.labels);
    if (segmentation.router.empty()) return;
    if (trace) trace_segmentation(folder, segmentation);
    write_file(folder / file_names::segmentation, segmentation_to_json(segmentation));
}

void save_skeletonization(const fs::path& folder, const Skeletonization& skeletonization, bool trace) {
    if (trace) trace_skeletonization(folder, skeletonization);
    write_file(folder / file_names::contour, contour_to_json(skeletonization.contour));
    save_png(folder / file_names::skeleton_picture, to_grey(skeletonization.skeleton));
    write_file(folder / file_names::skeleton, skeleton_to_json(skeletonization.graph));
}

void save_identification(const fs::path& folder, const Identification& identification) {
    write_file(folder / file_names::identification, identification_to_json(identification));
}

void save_rig(const fs::path& folder, const Rig& rig, const RgbaImage& texture,
              const std::vector<BoneAnimation>& animations) {
    write_file(folder / file_names::mapping, mapping_to_json(rig.mapping));
    write_file(folder / file_names::mesh, to_obj(rig, file_names::material));
    write_file(folder / file_names::material, to_mtl(file_names::drawing));
    write_file(folder / file_names::weights, to_weights_text(rig));
    write_file(folder / file_names::glb, to_glb(rig, texture, animations));
}

SkeletonGraph read_skeleton(const fs::path& folder, const LabelMap& labels) {
    const fs::path file = folder / file_names::skeleton;
    SkeletonGraph graph = skeleton_from_json(read_text(file), file.string());
    if (graph.width != labels.width() || graph.height != labels.height())
        fail_size(file, graph.width, graph.height, file_names::labels, labels.width(), labels.height());
    return graph;
}

TypeProbabilities read_type_probabilities(const fs::path& folder) {
    const fs::path file = folder / file_names::segmentation;
    return fs::exists(file) ? type_probabilities_from_json(read_text(file), file.string())
                            : TypeProbabilities();
}

Identification read_identification(const fs::path& folder, const SkeletonGraph& graph,
                                   const std::vector<ReferenceSkeleton>& references) {
    const fs::path file = folder / file_names::identification;
    return identification_from_json(read_text(file), file.string(), graph, references);
}

Mapping read_mapping(const fs::path& file, const SkeletonGraph& graph, const ReferenceSkeleton& reference) {
    return mapping_from_json(read_text(file), file.string(), graph, reference);
}

std::vector<VertexWeights> read_weights(const fs::path& folder, const Rig& rig) {
    const fs::path file = folder / file_names::weights;
    return weights_from_text(read_text(file), file.string(), rig);
}

} // namespace pantin
