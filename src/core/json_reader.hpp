// SPDX-License-Identifier: MIT
// A JSON value and where it stands, for strict readers whose errors name the file, the place and the fact:
// `skeleton.json: vertices[3].x: must be a number`.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/decimal.hpp"
#include "pantin/error.hpp"

namespace pantin {

class JsonReader {
public:
    using Json = nlohmann::ordered_json;

    // Refers to `value`, which must outlive it.
    JsonReader(const Json& value, std::string file, std::string place = "")
        : value_(value), file_(std::move(file)), place_(std::move(place)) {}

    [[noreturn]] void fail(const std::string& fact) const {
        throw Error(ErrorKind::input, file_ + ": " + (place_.empty() ? "" : place_ + ": ") + fact);
    }
    const std::string& file() const { return file_; }
    const Json& value() const { return value_; }
    bool has(const char* key) const { return value_.is_object() && value_.contains(key); }

    JsonReader at(const char* key) const {
        if (!value_.is_object()) fail("must be an object");
        const auto found = value_.find(key);
        if (found == value_.end()) fail("misses \"" + std::string(key) + "\"");
        return {*found, file_, place_.empty() ? key : place_ + "." + key};
    }
    // Between `least` and `most` elements.
    std::vector<JsonReader> elements(std::size_t least = 0, std::size_t most = SIZE_MAX) const {
        if (!value_.is_array()) fail("must be a list");
        if (value_.size() < least) fail("has fewer than " + std::to_string(least) + " elements");
        if (value_.size() > most) fail("has more than " + std::to_string(most) + " elements");
        std::vector<JsonReader> all;
        all.reserve(value_.size());
        for (std::size_t i = 0; i < value_.size(); ++i)
            all.emplace_back(value_[i], file_, place_ + "[" + std::to_string(i) + "]");
        return all;
    }
    // The entries of an object, in the file's order.
    std::vector<std::pair<std::string, JsonReader>> entries() const {
        if (!value_.is_object()) fail("must be an object");
        std::vector<std::pair<std::string, JsonReader>> all;
        for (auto entry = value_.begin(); entry != value_.end(); ++entry)
            all.emplace_back(
                entry.key(),
                JsonReader(entry.value(), file_, place_.empty() ? entry.key() : place_ + "." + entry.key()));
        return all;
    }

    std::string text() const {
        if (!value_.is_string()) fail("must be a string");
        return value_.get<std::string>();
    }
    bool boolean() const {
        if (!value_.is_boolean()) fail("must be true or false");
        return value_.get<bool>();
    }
    double number(double low, double high) const {
        if (!value_.is_number()) fail("must be a number");
        const double x = value_.get<double>();
        if (!(x >= low && x <= high))
            fail("must lie between " + to_decimal(low) + " and " + to_decimal(high));
        return x;
    }
    long integer(long low, long high) const {
        const double x = number(static_cast<double>(low), static_cast<double>(high));
        if (x != std::floor(x)) fail("must be a whole number");
        return static_cast<long>(x);
    }

private:
    const Json& value_;
    std::string file_, place_;
};

} // namespace pantin
