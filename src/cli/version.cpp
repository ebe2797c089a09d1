// SPDX-License-Identifier: MIT
// pantin --version: what this binary is made of, and the licence that follows.
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "cli/command.hpp"
#include "core/digest.hpp"
#include "core/file.hpp"
#include "core/resources.hpp"
#include "core/yaml.hpp"
#include "pantin/export.hpp"
#include "pantin/identification.hpp"
#include "pantin/network.hpp"
#include "pantin/strokes.hpp"
#include "pantin/version.hpp"

namespace pantin::cli {

namespace {

std::string libraries_text() {
    std::string with, without;
    for (const auto& [name, available] : {std::pair{"GLPK", ilp_available()},
                                          {"WebP", webp_available()},
                                          {"GIF", gif_available()},
                                          {"yaml-cpp", yaml_available()},
                                          {"pugixml", svg_available()}})
        (available ? with : without) += std::string(" ") + name;
    return "with:" + (with.empty() ? " no optional library" : with) +
           (without.empty() ? "" : "\nwithout:" + without);
}

// 64 bits, FNV-1a.
std::string digest_of(std::span<const unsigned char> bytes) {
    Digest digest;
    digest.add(bytes.data(), bytes.size());
    return digest.text();
}

// Those that a run without --weights takes.
std::string weights_text() {
    const char* variable = std::getenv("PANTIN_WEIGHTS");
    const std::filesystem::path folder = variable ? variable : "";
    std::string text = "weights (" + (folder.empty() ? "compiled in" : folder.string()) + "):";
    for (const char* name : {"detector.safetensors", "segmenter.safetensors"}) {
        std::string digest = "missing";
        try {
            if (!folder.empty())
                digest = digest_of(read_file(folder / name));
            else if (const auto bytes = find_resource(std::string("weights/") + name); !bytes.empty())
                digest = digest_of(bytes);
        } catch (const Error&) { // said by `digest`
        }
        text += std::string(" ") + name + " " + digest;
    }
    return text;
}

// GLPK is under the GPL, and so is a binary that contains it.
std::string licence_text() {
    return std::string("licence: ") +
           (ilp_available() ? "GPL-3.0-or-later (source MIT, linked with GLPK)" : "MIT") +
           "; weights CC BY 4.0";
}

} // namespace

std::string version_text() {
    return "pantin " PANTIN_VERSION "\n" + libraries_text() +
           "\nnetwork kernel: " + std::string(network::name_of(network::best_simd())) + "\n" +
           weights_text() + "\n" + licence_text();
}

} // namespace pantin::cli
