// SPDX-License-Identifier: MIT
// Which joints of a skeleton play which parts of a body, by their names alone.
#pragma once

#include <vector>

#include "animation/joint_names.hpp"
#include "pantin/motion.hpp"

namespace pantin {

// Joints of the tree of `root`; −1 where no name says it, and then the hips are what a name says or −1. Own.
MotionJoints joints_by_name(const Motion& motion, const std::vector<SimpleName>& names, int root);

} // namespace pantin
