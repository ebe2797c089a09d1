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
