// SPDX-License-Identifier: MIT
// The networks of a run: detector.safetensors and segmenter.safetensors, compiled in or of a folder.
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <utility>

#include "pantin/detection.hpp"
#include "pantin/segmentation.hpp"

namespace pantin {

// Each is loaded when it is first asked for, and stays. Several threads may share them: a network does not
// change when it is used.
class Networks {
public:
    explicit Networks(std::filesystem::path weights = {}) : folder_(std::move(weights)) {} // as in Settings
    // The detector (thesis 4.2) and the segmenter (4.3). Error(weights) names the file when the weights are
    // missing or invalid; the next call tries again.
    const CharacterFinder& finder();
    const Segmenter& segmenter();

private:
    template <class Network> const Network& loaded(std::optional<Network>& network, const char* name);

    std::filesystem::path folder_;
    std::mutex mutex_; // while a network is loaded, so that it is loaded once
    std::optional<CharacterFinder> finder_;
    std::optional<Segmenter> segmenter_;
};

} // namespace pantin
