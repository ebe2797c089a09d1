// SPDX-License-Identifier: MIT
// What all characters of a run share: options, networks, reference skeletons and the recorded motion. Each is
// loaded when it is first asked for, so that a step that runs alone loads no more than it uses.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pantin/motion.hpp"
#include "pantin/networks.hpp"
#include "pantin/settings.hpp"

namespace pantin {

struct NamedMotion {
    Motion motion;
    MotionJoints joints;
};

class Context {
public:
    explicit Context(const Settings& settings);
    // With networks that other contexts use, too.
    Context(const Settings& settings, Networks& networks);
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    const Settings& settings() const { return settings_; }
    // Of the settings, with what the steps take from elsewhere in them: threads, the reference that the user
    // names.
    const Options& options() const { return options_; }

    // Error(weights) when the weights are missing or invalid.
    const CharacterFinder& finder() { return networks_.finder(); }
    const Segmenter& segmenter() { return networks_.segmenter(); }
    // Error(input) when a reference file is invalid.
    const std::vector<ReferenceSkeleton>& references();
    // Null when the settings name none. When it is read its table of joints goes to `notice`. Error(input).
    const NamedMotion* motion();

    // Loads what a run of all steps needs: what is bad shows before anything is written.
    void prepare();

    void progress(const std::string& what, double share = 0) const {
        if (settings_.progress) settings_.progress(what, share);
    }
    void notice(const std::string& line) const {
        if (settings_.notice) settings_.notice(line);
    }
    void warn(const std::string& line) const {
        if (settings_.warning) settings_.warning(line);
    }

private:
    const Settings& settings_;
    const Options options_;
    std::optional<Networks> own_;
    Networks& networks_;
    std::optional<std::vector<ReferenceSkeleton>> references_;
    std::optional<NamedMotion> motion_;
};

} // namespace pantin
