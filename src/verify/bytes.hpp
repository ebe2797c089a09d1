// SPDX-License-Identifier: MIT
// Files in memory are strings; decoders take bytes.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace pantin {

inline std::span<const unsigned char> as_bytes(const std::string& text) {
    return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}
inline std::string as_text(const std::vector<unsigned char>& bytes) { return {bytes.begin(), bytes.end()}; }

} // namespace pantin
