// SPDX-License-Identifier: MIT
// What all characters of a page share: the settings, the networks and the reference skeletons, each loaded
// once.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pantin/motion.hpp"
#include "pantin/pipeline.hpp"

namespace pantin {

class Workshop {
public:
    explicit Workshop(const Settings& settings)
        : settings_(settings), own_(std::in_place, settings.weights), networks_(*own_) {}
    // With networks that other workshops use, too.
    Workshop(const Settings& settings, Networks& networks) : settings_(settings), networks_(networks) {}
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;

    const Settings& settings() const { return settings_; }
    const Options& options() const { return settings_.options; }
    // Error(weights) when the weights are missing or invalid.
    const CharacterFinder& finder() { return networks_.finder(); }
    const Segmenter& segmenter() { return networks_.segmenter(); }
    // Error(input) when a reference file is invalid.
    const std::vector<ReferenceSkeleton>& references();
    const ReferenceSkeleton& reference(const std::string& name);
    // The recorded motion of the settings, or null. When it is read its table of joints goes to `notice`.
    // Error(input).
    struct NamedMotion {
        Motion motion;
        MotionJoints joints;
    };
    const NamedMotion* motion();

    // Loads what a run needs from the start: what is bad shows before anything is written.
    void prepare();

    bool keeps = false; // characters keep the intermediate products of their steps

    void progress(const std::string& what, double share = 0) const {
        if (settings_.progress) settings_.progress(what, share);
    }

private:
    const Settings& settings_;
    std::optional<Networks> own_;
    Networks& networks_;
    std::optional<std::vector<ReferenceSkeleton>> references_;
    std::optional<NamedMotion> motion_;
};

} // namespace pantin
