// SPDX-License-Identifier: MIT
#include "pipeline/workshop.hpp"

#include "core/file.hpp"

namespace pantin {

void Workshop::prepare() {
    segmenter();
    references();
    motion();
    if (!settings_.given.reference.empty()) reference(settings_.given.reference);
}

const std::vector<ReferenceSkeleton>& Workshop::references() {
    if (!references_) references_ = load_references(settings_.references);
    return *references_;
}

const ReferenceSkeleton& Workshop::reference(const std::string& name) {
    std::string names;
    for (const ReferenceSkeleton& reference : references()) {
        if (reference.name == name) return reference;
        names += (names.empty() ? "" : ", ") + reference.name;
    }
    throw Error(ErrorKind::input, "there is no reference '" + name + "' (" + names + ")");
}

const Workshop::NamedMotion* Workshop::motion() {
    const std::filesystem::path& file = settings_.motion;
    if (file.empty()) return nullptr;
    if (!motion_) {
        Motion motion = parse_bvh(read_text(file), file.string());
        motion.name = file.stem().string();
        const MotionJoints joints = match_joints(motion, file.string());
        if (settings_.notice)
            for (const auto& [part, joint] : match_table(motion, joints))
                settings_.notice(motion.name + ": " + part + ": " + joint);
        motion_ = {std::move(motion), joints};
    }
    return &*motion_;
}

} // namespace pantin
