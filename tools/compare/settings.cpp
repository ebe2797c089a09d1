// SPDX-License-Identifier: MIT
// What the README of the reference folder says, as options. What it does not mention was not done.
#include "settings.hpp"

namespace pantin::compare {

SkeletonizationOptions skeleton_settings(Residual residual) {
    SkeletonizationOptions options;
    options.method = SkeletonMethod::voronoi;
    options.residual = residual;
    options.residual_threshold = 30;
    options.merge_distance = 5;
    options.fill_holes_share = 1;
    options.recover_parts_share = 0;
    options.cut_cycles = false;
    options.thinning_stop = ThinningStop::both;
    options.fill_pockets = true;
    options.lower_threshold = false;
    options.reject_point = false;
    return options;
}

GgdOptions distance_settings(const std::string& key) {
    GgdOptions options;
    options.k_v = key == "Kv038" ? 0.38 : 1;
    options.k_e = 1;
    options.k_l = key == "K1_1_0.1" ? 0.1 : 5;
    options.label_values = label_column(&LabelRow::value); // thesis ch. 5
    options.max_nodes = 2'000'000;
    return options;
}

MappingOptions mapping_settings() {
    MappingOptions options;
    options.samples = 50;
    options.alpha = 0.1;
    options.length_in_pixels = true;
    options.osb = OsbForm::icdm2007;
    options.label_aware = false; // none of the following is used
    options.path_weight = options.position_weight = options.trunk_weight = 0;
    options.prominence_weight = options.label_penalty = options.prior_weight = 0;
    options.mixed_reach = options.unmatched_cost = 0;
    return options;
}

MeshOptions mesh_settings(int cell) {
    MeshOptions options;
    options.method = MeshMethod::marching_squares;
    options.cell = cell;
    options.margin = 0;
    options.interpolate_distance = true;
    options.snap = 0;
    options.cut_touching_parts = false;
    return options;
}

} // namespace pantin::compare
