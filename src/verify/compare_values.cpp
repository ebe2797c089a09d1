// SPDX-License-Identifier: MIT
// Numbers, words and JSON side by side.
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "core/decimal.hpp"
#include "core/json.hpp"
#include "core/plural.hpp"
#include "verify/values.hpp"

namespace pantin {

namespace {

constexpr std::size_t most_shown = 60; // characters of a value in a report
constexpr int deepest = 200;           // values in values; ours lie no deeper than 8

std::string shown(const Json& value) {
    if (value.is_array()) return std::to_string(value.size()) + " elements";
    if (value.is_object()) return "an object of " + std::to_string(value.size());
    return to_compact_json_text(value);
}

void walk(Differences& differences, const std::string& place, const Json& first, const Json& second,
          int depth);

void walk_objects(Differences& differences, const std::string& place, const Json& first, const Json& second,
                  int depth) {
    const std::string before = place.empty() ? "" : place + ".";
    for (const auto& [key, value] : first.items()) {
        const auto other = second.find(key);
        if (other == second.end())
            differences.text(before + key, shown(value), "missing");
        else
            walk(differences, before + key, value, *other, depth + 1);
    }
    for (const auto& [key, value] : second.items())
        if (!first.contains(key)) differences.text(before + key, "missing", shown(value));
}

void walk_arrays(Differences& differences, const std::string& place, const Json& first, const Json& second,
                 int depth) {
    if (first.size() != second.size()) differences.text(place, shown(first), shown(second));
    for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i)
        walk(differences, place + "[" + std::to_string(i) + "]", first[i], second[i], depth + 1);
}

void walk(Differences& differences, const std::string& place, const Json& first, const Json& second,
          int depth) {
    if (first.is_number() && second.is_number())
        return differences.number(place, first.get<double>(), second.get<double>());
    if (depth > deepest)
        return differences.text(place.substr(0, most_shown), "nested too deeply", "nested too deeply");
    if (first.is_object() && second.is_object())
        return walk_objects(differences, place, first, second, depth);
    if (first.is_array() && second.is_array()) return walk_arrays(differences, place, first, second, depth);
    if (first != second) differences.text(place, shown(first), shown(second));
}

std::vector<std::string_view> split(std::string_view text, std::string_view separators) {
    std::vector<std::string_view> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of(separators), text.size());
        if (end > 0 || separators == "\n") parts.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

bool to_number(std::string_view word, double& number) {
    const auto result = std::from_chars(word.data(), word.data() + word.size(), number);
    return result.ec == std::errc() && result.ptr == word.data() + word.size() && std::isfinite(number);
}

void compare_lines(Differences& differences, const std::string& line, std::string_view first,
                   std::string_view second) {
    const std::vector<std::string_view> a = split(first, " \t\r"), b = split(second, " \t\r");
    if (a.size() != b.size()) return differences.text(line, std::string(first), std::string(second));
    for (std::size_t i = 0; i < a.size(); ++i) {
        const std::string place = line + ", word " + std::to_string(i + 1);
        double x = 0, y = 0;
        if (to_number(a[i], x) && to_number(b[i], y))
            differences.number(place, x, y);
        else if (a[i] != b[i])
            differences.text(place, std::string(a[i]), std::string(b[i]));
    }
}

} // namespace

void Differences::add(const std::string& place, const std::string& first, const std::string& second) {
    if (found_.values++ > 0) return;
    const auto cut = [](const std::string& text) {
        return text.size() > most_shown ? text.substr(0, most_shown) + "..." : text;
    };
    found_.place = place;
    found_.first = cut(first);
    found_.second = cut(second);
}

void Differences::number(const std::string& place, double first, double second) {
    if (std::bit_cast<std::uint64_t>(first) == std::bit_cast<std::uint64_t>(second)) return;
    add(place, to_decimal(first), to_decimal(second));
    const double difference = std::fabs(first - second);
    if (!(difference > found_.largest)) return;
    found_.largest = difference;
    found_.largest_place = place;
}

void Differences::text(const std::string& place, const std::string& first, const std::string& second) {
    add(place, first, second);
}

void compare_json(Differences& differences, const std::string& name, const std::string& first,
                  const std::string& second) {
    walk(differences, "", parse_json(first, name), parse_json(second, name), 0);
}

void compare_words(Differences& differences, const std::string& first, const std::string& second) {
    const std::vector<std::string_view> a = split(first, "\n"), b = split(second, "\n");
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        if (a[i] != b[i]) compare_lines(differences, "line " + std::to_string(i + 1), a[i], b[i]);
    if (a.size() != b.size())
        differences.text("", count_of(static_cast<long>(a.size()), "line"),
                         count_of(static_cast<long>(b.size()), "line"));
}

void compare_bytes(Differences& differences, const std::string& first, const std::string& second) {
    for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i)
        differences.number("byte " + std::to_string(i), static_cast<unsigned char>(first[i]),
                           static_cast<unsigned char>(second[i]));
    if (first.size() != second.size())
        differences.text("", count_of(static_cast<long>(first.size()), "byte"),
                         count_of(static_cast<long>(second.size()), "byte"));
}

} // namespace pantin
