// SPDX-License-Identifier: MIT
// Things that have a name, in a list.
#pragma once

#include <string>
#include <vector>

namespace pantin {

// −1 when there is none.
template <class T> int index_of(const std::vector<T>& list, const std::string& name) {
    for (std::size_t i = 0; i < list.size(); ++i)
        if (list[i].name == name) return static_cast<int>(i);
    return -1;
}

} // namespace pantin
