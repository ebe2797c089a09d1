// SPDX-License-Identifier: MIT
// Every failure is Error(input).
#include "core/json_reader.hpp"

#include <cmath>

#include "core/decimal.hpp"
#include "pantin/error.hpp"

namespace pantin {

void JsonReader::fail(const std::string& fact) const {
    throw Error(ErrorKind::input, file_ + ": " + (place_.empty() ? "" : place_ + ": ") + fact);
}

JsonReader JsonReader::at(const char* key) const {
    if (!value_.is_object()) fail("must be an object");
    const Json* found = value_.find(key);
    if (found == value_.end()) fail("misses \"" + std::string(key) + "\"");
    return {*found, file_, place_.empty() ? key : place_ + "." + key};
}

std::vector<JsonReader> JsonReader::elements(std::size_t least, std::size_t most) const {
    if (!value_.is_array()) fail("must be a list");
    if (value_.size() < least) fail("has fewer than " + std::to_string(least) + " elements");
    if (value_.size() > most) fail("has more than " + std::to_string(most) + " elements");
    std::vector<JsonReader> all;
    all.reserve(value_.size());
    for (std::size_t i = 0; i < value_.size(); ++i)
        all.emplace_back(value_[i], file_, place_ + "[" + std::to_string(i) + "]");
    return all;
}

std::vector<std::pair<std::string, JsonReader>> JsonReader::entries() const {
    if (!value_.is_object()) fail("must be an object");
    std::vector<std::pair<std::string, JsonReader>> all;
    for (const auto& [key, value] : value_.items())
        all.emplace_back(key, JsonReader(value, file_, place_.empty() ? key : place_ + "." + key));
    return all;
}

std::string JsonReader::text() const {
    if (!value_.is_string()) fail("must be a string");
    return value_.get<std::string>();
}

bool JsonReader::boolean() const {
    if (!value_.is_boolean()) fail("must be true or false");
    return value_.get<bool>();
}

double JsonReader::number(double low, double high) const {
    if (!value_.is_number()) fail("must be a number");
    const double x = value_.get<double>();
    if (!(x >= low && x <= high)) fail("must lie between " + to_decimal(low) + " and " + to_decimal(high));
    return x;
}

long JsonReader::integer(long low, long high) const {
    const double x = number(static_cast<double>(low), static_cast<double>(high));
    if (x != std::floor(x)) fail("must be a whole number");
    return static_cast<long>(x);
}

} // namespace pantin
