// SPDX-License-Identifier: MIT
// Trees as lists of neighbours.
#pragma once

#include <vector>

namespace pantin {

// The chains of joints from an end or a junction to the next one, each once. A joint without neighbours is in
// none.
inline std::vector<std::vector<int>> chains_of(const std::vector<std::vector<int>>& neighbours) {
    std::vector<std::vector<int>> chains;
    for (int a = 0; a < static_cast<int>(neighbours.size()); ++a) {
        if (neighbours[a].size() == 2) continue;
        for (const int first : neighbours[a]) {
            std::vector<int> chain = {a, first};
            while (neighbours[chain.back()].size() == 2) {
                const std::vector<int>& n = neighbours[chain.back()];
                chain.push_back(n[0] == chain[chain.size() - 2] ? n[1] : n[0]);
            }
            if (chain.front() < chain.back()) chains.push_back(std::move(chain));
        }
    }
    return chains;
}

} // namespace pantin
