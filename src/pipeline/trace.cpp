// SPDX-License-Identifier: MIT
#include "pipeline/trace.hpp"

#include <algorithm>
#include <cmath>

#include "core/file.hpp"
#include "pantin/image.hpp"
#include "pipeline/character.hpp"
#include "pipeline/json_files.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

fs::path trace_folder(const fs::path& folder) {
    create_folder(folder / "trace");
    return folder / "trace";
}

GreyImage to_grey(const Grid<float>& share) {
    GreyImage grey(share.width(), share.height());
    std::transform(share.begin(), share.end(), grey.begin(), [](float p) {
        return static_cast<std::uint8_t>(std::rint(255 * std::clamp(static_cast<double>(p), 0.0, 1.0)));
    });
    return grey;
}

} // namespace

void trace_detection(const fs::path& folder, const Detection& detection) {
    if (!detection.ink.empty()) save_png(trace_folder(folder) / "ink.png", to_grey(detection.ink));
}

void trace_segmentation(const fs::path& folder, const Segmentation& segmentation) {
    const fs::path trace = trace_folder(folder);
    for (std::size_t i = 0; i < segmentation.probabilities.size() && i < label_names.size(); ++i)
        save_png(trace / ("probability-" + std::string(label_names[i]) + ".png"),
                 to_grey(segmentation.probabilities[i]));
}

void trace_skeletonization(const fs::path& folder, const Skeletonization& skeletonization) {
    const fs::path trace = trace_folder(folder);
    save_png(trace / "silhouette.png", to_grey(skeletonization.mask));
    write_file(trace / "voronoi.json", voronoi_to_json(skeletonization.voronoi, skeletonization.residuals));
    save_png(trace / "voronoi.png", to_grey(skeletonization.voronoi_raster));
    save_png(trace / "thinned.png", to_grey(skeletonization.thinned));
    write_file(trace / "skeleton-raw.json", skeleton_to_json(skeletonization.raw));
    write_file(trace / "skeleton-h1.json", skeleton_to_json(skeletonization.after_h1));
}

} // namespace pantin
