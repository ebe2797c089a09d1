// SPDX-License-Identifier: MIT
// Doubles and floats to text by std::to_chars, which knows no locale (own; docs/determinism.md, "Files").
#include "core/decimal.hpp"

#include <charconv>
#include <cmath>

namespace pantin {

namespace {
template <class Real> std::string shortest(Real value) {
    if (value == 0) return std::signbit(value) ? "-0.0" : "0";
    char text[64];
    const auto result = std::to_chars(text, text + sizeof text, value);
    return std::string(text, result.ptr);
}
} // namespace

std::string to_decimal(double value) { return shortest(value); }
std::string to_decimal(float value) { return shortest(value); }

} // namespace pantin
