// SPDX-License-Identifier: MIT
// Weight files with one fault.
#pragma once

#include <catch2/catch.hpp>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "pantin/error.hpp"

namespace pantin {

// The bytes with the first occurrence of one text replaced by another of the same length.
inline std::vector<unsigned char> with_text(std::vector<unsigned char> bytes, const std::string& from,
                                            const std::string& to) {
    REQUIRE(from.size() == to.size());
    const auto found = std::search(bytes.begin(), bytes.end(), from.begin(), from.end());
    REQUIRE(found != bytes.end());
    std::copy(to.begin(), to.end(), found);
    return bytes;
}

// The same in the header with a text of any length; the header's length follows.
inline std::vector<unsigned char> with_header(const std::vector<unsigned char>& bytes,
                                              const std::string& from, const std::string& to) {
    std::size_t length = 0;
    for (int i = 7; i >= 0; --i) length = length << 8 | bytes[static_cast<std::size_t>(i)];
    const auto data = bytes.begin() + 8 + static_cast<std::ptrdiff_t>(length);
    std::string header(bytes.begin() + 8, data);
    const std::size_t found = header.find(from);
    REQUIRE(found != std::string::npos);
    header.replace(found, from.size(), to);
    std::vector<unsigned char> changed;
    for (int i = 0; i < 8; ++i) changed.push_back(static_cast<unsigned char>(header.size() >> (8 * i)));
    changed.insert(changed.end(), header.begin(), header.end());
    changed.insert(changed.end(), data, bytes.end());
    return changed;
}

// The message of the Error(weights) that `load` throws; "" when it throws none.
inline std::string failure_of(const std::function<void()>& load) {
    try {
        load();
    } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::weights);
        return error.what();
    }
    return "";
}

} // namespace pantin
