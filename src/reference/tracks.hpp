// SPDX-License-Identifier: MIT
// Kinds of tracks of a clip.
#pragma once

#include "pantin/reference.hpp"

namespace pantin {

// The foot of the track's leg keeps the ground.
constexpr bool on_ground(TrackKind kind) { return kind == TrackKind::step || kind == TrackKind::plant; }

} // namespace pantin
