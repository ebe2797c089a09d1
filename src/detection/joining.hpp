// SPDX-License-Identifier: MIT
// Internal: groups of ink that are parts of the figure that they touch.
#pragma once

#include <functional>

#include "detection/grouping.hpp"

namespace pantin {

// A group whose ink touches that of a larger one (by box), and which is no figure of its own, joins the one
// that it touches most: a ball, a halo, a tail, the second half of an animal. Smallest first; each is asked
// once, and only those that touch. is_figure: of a group, from 0.
Grouping join_pieces(Grouping grouping, const std::function<bool(int group)>& is_figure);

} // namespace pantin
