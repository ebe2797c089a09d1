// SPDX-License-Identifier: MIT
// A character's reference and the recorded motion in, at most one line out.
#include "pipeline/motion_notice.hpp"

#include <algorithm>
#include <cstdio>

namespace pantin {

namespace {

std::string seconds_text(double seconds) {
    char text[40];
    std::snprintf(text, sizeof text, "%.1f s", seconds);
    return text;
}

// Those who can follow a motion, and the reference that makes a character one of them.
std::pair<std::string, std::string> kind_of(BodyPlan plan) {
    switch (plan) {
    case BodyPlan::quadruped:
        return {"quadrupeds", "quadruped"};
    case BodyPlan::bird:
        return {"flying animals", "flying"};
    case BodyPlan::humanoid:
        break;
    }
    return {"humanoids", "humanoid"};
}

} // namespace

void notice_motion(const std::filesystem::path& folder, const Character& character, Context& context) {
    const NamedMotion* recorded = context.motion();
    if (!recorded) return;
    const std::string file = context.settings().motion.string();
    if (!can_follow(character.reference, recorded->joints.plan)) {
        const auto [kind, reference] = kind_of(recorded->joints.plan);
        context.notice(folder.string() + ": does not follow " + file + ", which is for " + kind +
                       "; it moves like: " + character.reference.name + " (--reference " + reference + ")");
        return;
    }
    const AnimationOptions& options = context.options().animation;
    const Motion& motion = recorded->motion;
    const double length = motion.frame_time * static_cast<double>(motion.frames() - 1);
    const double start = std::clamp(options.motion_start, 0.0, length);
    if (length - start <= options.motion_seconds + motion.frame_time / 2) return;
    context.notice(folder.string() + ": follows " + file + " from " + seconds_text(start) + " to " +
                   seconds_text(start + options.motion_seconds) + " of " + seconds_text(length) +
                   " (options animation.motion_start, animation.motion_seconds)");
}

} // namespace pantin
