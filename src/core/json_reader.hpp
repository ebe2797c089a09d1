// SPDX-License-Identifier: MIT
// A JSON value and where it stands, for strict readers whose errors name the file, the place and the fact:
// `skeleton.json: vertices[3].x: must be a number`.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/json.hpp"

namespace pantin {

class JsonReader {
public:
    // Refers to `value`, which must outlive it.
    JsonReader(const Json& value, std::string file, std::string place = "")
        : value_(value), file_(std::move(file)), place_(std::move(place)) {}

    [[noreturn]] void fail(const std::string& fact) const;
    const std::string& file() const { return file_; }
    const Json& value() const { return value_; }
    bool has(const char* key) const { return value_.contains(key); }

    // A member of an object.
    JsonReader at(const char* key) const;
    // Between `least` and `most` elements.
    std::vector<JsonReader> elements(std::size_t least = 0, std::size_t most = SIZE_MAX) const;
    // The entries of an object, in the file's order.
    std::vector<std::pair<std::string, JsonReader>> entries() const;

    std::string text() const;
    bool boolean() const;
    double number(double low, double high) const; // both allowed
    long integer(long low, long high) const;

private:
    const Json& value_;
    std::string file_, place_;
};

} // namespace pantin
