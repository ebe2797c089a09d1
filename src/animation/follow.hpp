// SPDX-License-Identifier: MIT
// Recorded animals on drawn ones.
#pragma once

#include <vector>

#include "animation/limb_angles.hpp"
#include "animation/recording.hpp"

namespace pantin {

using BoneTurns =
    std::vector<std::vector<double>>; // [bone][pose], against the drawing, in its plane, radians
// Whether the bone's limb has another bone outwards.
bool goes_on(const Rig& rig, std::size_t bone);

// What every bone of a quadruped or a bird does. Drawings of animals differ from recorded ones in the pose at
// rest much more than people do, so bones turn by as much as the recorded limbs turn from their own rest, or
// from the middle of their way when that is not known. Own.
class AnimalFollower {
public:
    AnimalFollower(const Rig& rig, const ReferenceSkeleton& reference, const Recording& recording,
                   const MotionJoints& joints);
    const BoneTurns& turns() const { return turns_; }
    double forwards() const { return forwards_; } // 1: it looks to the right of the picture, −1: to the left

private:
    struct Limb {
        std::vector<int> chain;
        bool wing = false;
    };
    Limb limb_of(const std::string& joint) const;
    void drive(std::size_t bone);
    std::vector<double> swing(int from, int to, bool wing) const;

    const Rig& rig_;
    const ReferenceSkeleton& reference_;
    const Recording& recording_;
    const MotionJoints& joints_;
    double forwards_ = -1;
    BoneTurns turns_;
};

} // namespace pantin
