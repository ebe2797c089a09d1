// SPDX-License-Identifier: MIT
// The networks' weights: compiled in, or from a folder.
#include "pantin/networks.hpp"
#include "core/file.hpp"
#include "core/resources.hpp"
#include "pantin/error.hpp"

namespace pantin {

namespace {

std::span<const unsigned char> compiled_in(const std::string& name) {
    const std::span<const unsigned char> bytes = find_resource(name);
    if (bytes.empty())
        throw Error(ErrorKind::weights,
                    name + " is not compiled into this program: give a folder with --weights");
    return bytes;
}

std::vector<unsigned char> read_weights(const std::filesystem::path& file) {
    try {
        return read_file(file);
    } catch (const Error& error) {
        throw Error(ErrorKind::weights, error.what());
    }
}

} // namespace

template <class Network> const Network& Networks::loaded(std::optional<Network>& network, const char* name) {
    const std::lock_guard lock(mutex_);
    if (network) return *network;
    if (folder_.empty()) {
        const std::string resource = std::string("weights/") + name;
        return network.emplace(compiled_in(resource), resource + " (compiled in)");
    }
    const std::filesystem::path file = folder_ / name;
    return network.emplace(read_weights(file),
                           file.string()); // the bytes are not needed any more once the network is there
}

const CharacterFinder& Networks::finder() { return loaded(finder_, "detector.safetensors"); }

const Segmenter& Networks::segmenter() { return loaded(segmenter_, "segmenter.safetensors"); }

} // namespace pantin
