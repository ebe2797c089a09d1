// SPDX-License-Identifier: MIT
// Which joints of a skeleton are limbs, by its shape alone: two chains of like length from the hips, two from
// the chest, and what else goes on from there is neck and head.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "animation/joint_names.hpp"
#include "pantin/motion.hpp"

namespace pantin {

// The joints of all parts, left and right by the names where they say it, else by the feet, which point
// forwards; none where the skeleton has no such shape. Own.
// Of the tree of `root`.
std::optional<MotionJoints> joints_by_shape(const Motion& motion, const std::vector<SimpleName>& names,
                                            int root);

// The way from the children of `joint` outwards that is longest, without the ways over the joints of
// `without`.
std::vector<int> longest_way(const Motion& motion, int joint, const std::vector<int>& without);
// The child with the longest offset; −1: none.
int outermost_child(const Motion& motion, int joint);
// The head on a way from the neck outwards: where it branches to eyes and ears, or ends; −1: it is the neck
// alone.
int head_of(const Motion& motion, const std::vector<int>& way);
// The joints from `joint` up to the root, itself first.
std::vector<int> ancestors(const Motion& motion, int joint);
// The nearest joint that both hang from, one of them perhaps; −1: they are of two trees.
int common_ancestor(const Motion& motion, int a, int b);

} // namespace pantin
