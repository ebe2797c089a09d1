// SPDX-License-Identifier: MIT
// Internal: groups of ink that are parts of the figure that they touch.
#pragma once

#include "detection/grouping.hpp"

namespace pantin {

// A group whose ink touches that of a larger one (by box), and of which the network is not sure
// (DetectionOptions::part_score, part_overlap), joins the one that it touches most: a halo, a tail, the
// second half of an animal. A part of a part belongs to the whole. Groups without scores stay. The one that
// is joined keeps its score. Own.
Grouping join_pieces(Grouping grouping, const DetectionOptions& options);

} // namespace pantin
