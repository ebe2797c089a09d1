// SPDX-License-Identifier: MIT
#include "pipeline/clips.hpp"

#include <algorithm>

namespace pantin {

std::vector<BoneAnimation> animations_of(const Rig& rig, const ReferenceSkeleton& reference,
                                         Workshop& workshop) {
    const AnimationOptions& options = workshop.options().animation;
    std::vector<BoneAnimation> animations;
    for (const ReferenceClip& clip : reference.clips)
        animations.push_back(retarget(rig, reference, clip, options.samples));
    const Workshop::NamedMotion* motion = workshop.motion();
    if (!motion || !is_humanoid(reference)) return animations;
    BoneAnimation followed =
        follow(rig, reference, motion->motion, motion->joints, options.motion_start, options.motion_seconds);
    const auto same = std::find_if(animations.begin(), animations.end(),
                                   [&](const BoneAnimation& a) { return a.name == followed.name; });
    if (same != animations.end())
        *same = std::move(followed);
    else
        animations.push_back(std::move(followed));
    return animations;
}

} // namespace pantin
