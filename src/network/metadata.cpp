// SPDX-License-Identifier: MIT
// Texts of a weight file's metadata to lists and numbers. The format is safetensors', the lists are ours.
#include "network/metadata.hpp"

#include <charconv>

namespace pantin::network {

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> items;
    std::size_t begin = 0;
    for (std::size_t end = text.find(separator); end != std::string::npos;
         end = text.find(separator, begin)) {
        items.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    items.push_back(text.substr(begin));
    return items;
}

int parse_number(const WeightFile& file, const std::string& key, const std::string& text, int min, int max) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < min || value > max)
        file.fail("metadata '" + key + "' has the impossible value '" + text + "'");
    return value;
}

std::vector<int> read_numbers(const WeightFile& file, const std::string& key, int min, int max,
                              std::size_t count) {
    const std::vector<std::string> items = split(file.metadata(key), ',');
    if (count != 0 && items.size() != count)
        file.fail("metadata '" + key + "' needs " + std::to_string(count) + " numbers");
    std::vector<int> values;
    for (const std::string& item : items) values.push_back(parse_number(file, key, item, min, max));
    return values;
}

} // namespace pantin::network
