// SPDX-License-Identifier: MIT
// Kinds of tracks of a clip.
#pragma once

#include "pantin/identification.hpp"

namespace pantin {

// The foot of the track's leg keeps the ground.
inline bool on_ground(const ReferenceTrack& track) { return track.axis == "step" || track.axis == "plant"; }

} // namespace pantin
