// SPDX-License-Identifier: MIT
// Settings to what a run shares: references and the recorded motion, loaded when a step asks for them.
#include "pipeline/context.hpp"

#include "animation/body_axes.hpp"
#include "core/file.hpp"

namespace pantin {

namespace {

Options options_of(const Settings& settings) {
    Options options = settings.options;
    options.detection.threads = settings.threads;
    options.segmentation.threads = settings.threads;
    options.identification.reference = settings.overrides.reference;
    return options;
}

std::string name_of_axis(Vec3 axis) {
    const std::string sign = axis.x + axis.y + axis.z < 0 ? "-" : "";
    return sign + (axis.x != 0 ? "x" : axis.y != 0 ? "y" : "z");
}

// Where the vertical is not what people expect; else empty.
std::string vertical_line(const Motion& motion, const MotionJoints& joints) {
    const BodyAxes axes = body_axes(motion, joints);
    if (axes.rest_up)
        return "the figure stands along " + name_of_axis(axes.up) + " in its frames and along " +
               name_of_axis(*axes.rest_up) + " at rest; the frames are followed";
    if (!axes.stands_at_rest && axes.up != Vec3{0, 1, 0})
        return "does not stand at rest; " + name_of_axis(axes.up) + " points up, as its frames say";
    return "";
}

} // namespace

Context::Context(const Settings& settings)
    : settings_(settings), options_(options_of(settings)), own_(std::in_place, settings.weights),
      networks_(*own_) {}

Context::Context(const Settings& settings, Networks& networks)
    : settings_(settings), options_(options_of(settings)), networks_(networks) {}

void Context::prepare() {
    segmenter();
    references();
    motion();
    if (const std::string& name = settings_.overrides.reference; !name.empty())
        find_reference(references(), name);
}

const std::vector<ReferenceSkeleton>& Context::references() {
    if (!references_) references_ = load_references(settings_.references, options_.animation.clips);
    return *references_;
}

const NamedMotion* Context::motion() {
    const std::filesystem::path& file = settings_.motion;
    if (file.empty()) return nullptr;
    if (!motion_) {
        Motion motion = parse_bvh(read_text(file), file.string());
        motion.name = file.stem().string();
        for (const std::string& repair : motion.repairs) notice(file.string() + ": " + repair);
        const std::filesystem::path& map = settings_.motion_map;
        const MotionJoints joints = match_joints(
            motion, file.string(), map.empty() ? JointMap() : parse_motion_map(read_text(map), map.string()));
        if (const std::string line = vertical_line(motion, joints); !line.empty())
            notice(file.string() + ": " + line);
        for (const auto& [part, joint] : match_table(motion, joints))
            notice(motion.name + ": " + part + ": " + joint);
        motion_ = {std::move(motion), joints};
    }
    return &*motion_;
}

} // namespace pantin
