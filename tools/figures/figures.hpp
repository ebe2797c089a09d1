// SPDX-License-Identifier: MIT
// The figures, one function for each, in groups of one file each. Names and contents: docs/figures/README.md.
#pragma once

#include <string>
#include <vector>

#include "figures/gallery.hpp"

namespace pantin::figures {

struct Figure {
    std::string name; // of the file
    std::string svg;
};

std::vector<Figure> network_figures(Gallery& gallery);        // 3.2, 3.3
std::vector<Figure> voronoi_figures(Gallery& gallery);        // 3.13, 3.14
std::vector<Figure> pipeline_figures(Gallery& gallery);       // 4.1, 4.2
std::vector<Figure> detection_figures(Gallery& gallery);      // 4.3, 4.6, 4.7, 4.9
std::vector<Figure> thinning_figures(Gallery& gallery);       // 4.10, Algorithm 4.1
std::vector<Figure> graph_figures(Gallery& gallery);          // 4.11, 4.12
std::vector<Figure> identification_figures(Gallery& gallery); // 4.13, Eq. 4.7
std::vector<Figure> path_figures(Gallery& gallery);           // 4.14, 4.15, Eq. 4.9
std::vector<Figure> mapping_figures(Gallery& gallery);        // Eq. 4.12, Eq. 4.14, 4.16
std::vector<Figure> mesh_figures(Gallery& gallery);           // 4.17, 4.18
std::vector<Figure> animation_figures(Gallery& gallery);      // Algorithm 4.4, 4.19
std::vector<Figure> failure_figures(Gallery& gallery);        // 6.7, 6.8, 6.10
std::vector<Figure> dog_figures(Gallery& gallery);            // 6.9, table 6.1

// All of them, in the order of the thesis, from the drawings of the folder.
std::vector<Figure> all_figures(const std::string& testdata);

} // namespace pantin::figures
