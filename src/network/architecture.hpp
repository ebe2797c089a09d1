// SPDX-License-Identifier: MIT
// Networks that one step may use: the metadata `model` of the weight file chooses. Own.
#pragma once

#include <memory>
#include <string>

#include "pantin/network.hpp"

namespace pantin::network {

template <class Network> struct Architecture {
    const char* model; // metadata of the file
    std::unique_ptr<Network> (*load)(const WeightFile&);
};

// The network of the row that the file names, of the first row when it names none. `what`: of the step, in
// messages. Error(weights) names the file and what it holds.
template <class Network, std::size_t rows>
std::unique_ptr<Network> load_network(const WeightFile& file, const Architecture<Network> (&table)[rows],
                                      const char* what) {
    if (!file.has_metadata("model")) return table[0].load(file);
    const std::string& model = file.metadata("model");
    std::string known;
    for (const Architecture<Network>& architecture : table) {
        if (model == architecture.model) return architecture.load(file);
        known += (known.empty() ? "" : ", ") + std::string(architecture.model);
    }
    file.fail("metadata 'model' is '" + model + "', which is no " + what + " (" + known + ")");
}

} // namespace pantin::network
