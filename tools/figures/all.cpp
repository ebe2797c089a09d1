// SPDX-License-Identifier: MIT
// The list of all figures (docs/figures/README.md).
#include "figures/figures.hpp"

namespace pantin::figures {

std::vector<Figure> all_figures(const std::string& testdata) {
    Gallery gallery(testdata);
    std::vector<Figure> all;
    for (const auto group : {network_figures, voronoi_figures, pipeline_figures, detection_figures,
                             thinning_figures, graph_figures, identification_figures, path_figures,
                             mapping_figures, mesh_figures, animation_figures, failure_figures, dog_figures})
        for (Figure& figure : group(gallery)) all.push_back(std::move(figure));
    return all;
}

} // namespace pantin::figures
