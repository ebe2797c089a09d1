// SPDX-License-Identifier: MIT
// Files compiled into the program (tools/embed.sh): weights and reference skeletons.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace pantin {

struct Resource {
    std::string_view name; // path inside the repository, "weights/segmenter.safetensors"
    std::span<const unsigned char> bytes;
};

// Every compiled-in file, in the order of their names.
std::vector<Resource> resources();

// The bytes of one; empty when there is no file of that name.
std::span<const unsigned char> find_resource(std::string_view name);

} // namespace pantin
