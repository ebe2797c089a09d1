#include "pipeline/workshop.hpp"

#include "core/file.hpp"
#include "core/resources.hpp"

namespace pantin {

std::span<const unsigned char> Workshop::weights(const std::string& name, std::string& source,
                                                 std::vector<unsigned char>& bytes) const {
    if (settings_.weights.empty()) {
        source = "weights/" + name + " (compiled in)";
        const std::span<const unsigned char> compiled = find_resource("weights/" + name);
        if (compiled.empty())
            throw Error(ErrorKind::weights,
                        "weights/" + name + " is not compiled into this program: give a folder with --weights");
        return compiled;
    }
    const std::filesystem::path file = settings_.weights / name;
    source = file.string();
    try {
        return bytes = read_file(file);
    } catch (const Error& error) {
        throw Error(ErrorKind::weights, error.what());
    }
}

template <class Network> const Network& Workshop::loaded(std::optional<Network>& network, const char* name) {
    if (!network) {
        std::string source;
        std::vector<unsigned char> file; // not needed any more once the network is there
        const std::span<const unsigned char> bytes = weights(name, source, file);
        network.emplace(bytes, source);
    }
    return *network;
}

const CharacterFinder& Workshop::finder() { return loaded(finder_, "detector.safetensors"); }

const Segmenter& Workshop::segmenter() { return loaded(segmenter_, "segmenter.safetensors"); }

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
