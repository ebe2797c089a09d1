// SPDX-License-Identifier: MIT
// An outline in, its sharp corners out (own, on the straight skeleton).
#include "modeling/spikes.hpp"

#include "pantin/error.hpp"
#include "pantin/straight_skeleton.hpp"

namespace pantin {
namespace {

constexpr double least_slope = 2; // length by radius: 1 / sin 30°

} // namespace

std::vector<Spike> spikes_of(const SimplePolygon& outline) {
    std::vector<Spike> spikes;
    try {
        const StraightSkeleton skeleton = straight_skeleton({outline.corners});
        for (const StraightSkeleton::Arc& arc : skeleton.arcs) {
            const StraightSkeleton::Node &from = skeleton.nodes[arc.from], &to = skeleton.nodes[arc.to];
            if (from.time == 0 && distance(from.place, to.place) > least_slope * to.time)
                spikes.push_back({from.place, to.place, to.time});
        }
    } catch (const Error&) {
    }
    return spikes;
}

} // namespace pantin
