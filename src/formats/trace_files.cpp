// SPDX-License-Identifier: MIT
// Intermediate products of the steps to the pictures and JSON files of the folder trace.
#include "formats/trace_files.hpp"

#include <algorithm>
#include <cmath>

#include "core/file.hpp"
#include "formats/file_names.hpp"
#include "formats/pictures.hpp"
#include "formats/skeleton_file.hpp"
#include "formats/voronoi_file.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

fs::path trace_folder(const fs::path& folder) {
    create_folder(folder / file_names::trace);
    return folder / file_names::trace;
}

GreyImage to_grey(const Grid<float>& share) {
    GreyImage grey(share.width(), share.height());
    std::transform(share.begin(), share.end(), grey.begin(), [](float p) {
        return static_cast<std::uint8_t>(std::rint(255 * std::clamp(static_cast<double>(p), 0.0, 1.0)));
    });
    return grey;
}

} // namespace

void trace_detection(const fs::path& folder, const Mask& ink) {
    if (!ink.empty()) save_png(trace_folder(folder) / file_names::trace_ink, to_grey(ink));
}

void trace_masks(const fs::path& folder, const Mask& ink_mask, const Mask& network_mask) {
    if (!ink_mask.empty()) save_png(trace_folder(folder) / file_names::trace_ink_mask, to_grey(ink_mask));
    if (!network_mask.empty())
        save_png(trace_folder(folder) / file_names::trace_network_mask, to_grey(network_mask));
}

void trace_segmentation(const fs::path& folder, const Segmentation& segmentation) {
    const fs::path trace = trace_folder(folder);
    for (std::size_t i = 0; i < segmentation.probabilities.size() && i < label_names.size(); ++i)
        save_png(trace / (file_names::trace_probability + std::string(label_names[i]) + ".png"),
                 to_grey(segmentation.probabilities[i]));
}

void trace_skeletonization(const fs::path& folder, const Skeletonization& skeletonization) {
    const fs::path trace = trace_folder(folder);
    save_png(trace / file_names::trace_silhouette, to_grey(skeletonization.mask));
    write_file(trace / file_names::trace_voronoi,
               voronoi_to_json(skeletonization.voronoi, skeletonization.residuals));
    save_png(trace / file_names::trace_voronoi_picture, to_grey(skeletonization.voronoi_raster));
    save_png(trace / file_names::trace_thinned, to_grey(skeletonization.thinned));
    write_file(trace / file_names::trace_skeleton_raw, skeleton_to_json(skeletonization.raw));
    write_file(trace / file_names::trace_skeleton_h1, skeleton_to_json(skeletonization.after_h1));
}

} // namespace pantin
