// SPDX-License-Identifier: MIT
// Lists and numbers in the metadata of a weight file. What is not as it should be is Error(weights) naming
// the file, the key and the value.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pantin/network.hpp"

namespace pantin::network {

// The items between the separators; one empty item for an empty text.
std::vector<std::string> split(const std::string& text, char separator);

// The whole number that `text`, a part of the value of `key`, says.
int parse_number(const WeightFile& file, const std::string& key, const std::string& text, int min, int max);

// The value of `key`: whole numbers separated by commas. count 0: any.
std::vector<int> read_numbers(const WeightFile& file, const std::string& key, int min, int max,
                              std::size_t count);

} // namespace pantin::network
