// SPDX-License-Identifier: MIT
// The options that the stored results were computed with. Every field is given a value: a default that
// changes must not change what is compared.
#pragma once

#include <string>

#include "pantin/identification.hpp"
#include "pantin/rigging.hpp"
#include "pantin/skeletonization.hpp"

namespace pantin::compare {

SkeletonizationOptions skeleton_settings(Residual residual);
// `key`: K115, Kv038 or K1_1_0.1 of the stored results.
GgdOptions distance_settings(const std::string& key);
MappingOptions mapping_settings();
MeshOptions mesh_settings(int cell);

} // namespace pantin::compare
