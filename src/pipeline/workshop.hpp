// What all characters of a run share: the settings, the networks and the reference skeletons, each loaded
// once.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pantin/motion.hpp"
#include "pantin/pipeline.hpp"

namespace pantin {

class Workshop {
public:
    explicit Workshop(const Settings& settings) : settings_(settings) {}

    const Settings& settings() const { return settings_; }
    const Options& options() const { return settings_.options; }
    // Error(weights) when the weights are missing or invalid.
    const CharacterFinder& finder();
    const Segmenter& segmenter();
    // Error(input) when a reference file is invalid.
    const std::vector<ReferenceSkeleton>& references();
    const ReferenceSkeleton& reference(const std::string& name);
    // The recorded motion of the settings, or null. When it is read its table of joints goes to `notice`. Error(input).
    struct NamedMotion {
        Motion motion;
        MotionJoints joints;
    };
    const NamedMotion* motion();

    void progress(const std::string& what, double share = 0) const {
        if (settings_.progress) settings_.progress(what, share);
    }

private:
    // The bytes of weights/<name>, compiled in, or read into `file` from the folder of the settings. `source`
    // names them.
    std::span<const unsigned char> weights(const std::string& name, std::string& source,
                                           std::vector<unsigned char>& file) const;

    template <class Network> const Network& loaded(std::optional<Network>& network, const char* name);

    const Settings& settings_;
    std::optional<CharacterFinder> finder_;
    std::optional<Segmenter> segmenter_;
    std::optional<std::vector<ReferenceSkeleton>> references_;
    std::optional<NamedMotion> motion_;
};

} // namespace pantin
