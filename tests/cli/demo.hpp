// SPDX-License-Identifier: MIT
// The demo page animated once, in small, for all tests that look at the results.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/folders.hpp"
#include "support/program.hpp"

namespace pantin::test {

inline const std::string demo_page = "testdata/demo.png";
inline const std::string small_page = "testdata/humanoid.png"; // one character
// Small films: the rasteriser and the encoders have tests of their own.
inline const std::vector<std::string> small_films = {"--size", "64", "--fps", "5"};

inline std::vector<std::string> operator+(std::vector<std::string> a, const std::vector<std::string>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// The folder of `animate demo.png --threads 1`; the same for every caller.
inline const std::filesystem::path& animated_demo() {
    static const TemporaryFolder folder;
    static const std::filesystem::path out = [] {
        const std::filesystem::path to = folder / "out";
        const Outcome outcome =
            run_pantin(std::vector<std::string>{"animate", demo_page, "-o", to.string(), "--threads", "1"} +
                       small_films);
        if (outcome.code != 0) throw std::runtime_error("animate demo.png failed: " + outcome.err);
        return to;
    }();
    return out;
}

// The folder of the drawings on which the preset `thesis` is verified, each in a folder of its own; the same
// for every caller.
inline const std::filesystem::path& animated_thesis() {
    static const TemporaryFolder folder;
    static const std::filesystem::path out = [] {
        const std::filesystem::path to = folder / "out";
        for (const std::string drawing : {"hole", "unpaired", "crossed"}) {
            const Outcome outcome = run_pantin(
                std::vector<std::string>{"animate", "testdata/vectors/thesis/" + drawing + "/page.png", "-o",
                                         (to / drawing).string(), "--preset", "thesis"} +
                small_films);
            if (outcome.code != 0)
                throw std::runtime_error("animate of " + drawing + " failed: " + outcome.err);
        }
        return to;
    }();
    return out;
}

// The folder of a model that was animated; the same for every caller.
inline const std::filesystem::path& animated_model() {
    static const TemporaryFolder folder;
    static const std::filesystem::path out = [] {
        const std::filesystem::path to = folder / "out";
        const Outcome outcome =
            run_pantin(std::vector<std::string>{"model", "testdata/models/cat.json", "-o", to.string(),
                                                "--animate", "--clip", "idle"} +
                       small_films);
        if (outcome.code != 0) throw std::runtime_error("model cat.json failed: " + outcome.err);
        return to;
    }();
    return out;
}

// A copy of the demo to work on.
inline void copy_demo(const std::filesystem::path& to) {
    std::filesystem::copy(animated_demo(), to, std::filesystem::copy_options::recursive);
}

} // namespace pantin::test
