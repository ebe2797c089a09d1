// SPDX-License-Identifier: MIT
// Elementary functions whose every bit is the same on every compiler, C library and processor
// (docs/determinism.md): only + − × ÷, fma, rint and integer operations on the bits, in a fixed order.
// Largest error seen in tests: below 1 ulp. Special values (0, ±∞, NaN) follow C17 Annex F. Use these, never
// <cmath>'s, for anything that reaches an output.
#pragma once

#include <cstdint>

namespace pantin::math {

// ⌊a / b⌋, b > 0.
constexpr std::int64_t floor_divide(std::int64_t a, std::int64_t b) { return a / b - (a % b != 0 && a < 0); }

inline constexpr double pi = 3.14159265358979323846;

double exp(double x);
double log(double x); // log(0) = −∞, NaN for x < 0
// Radians. Below 1 ulp for |x| ≤ 2^20·π/2 (about 1.6 million); beyond that the reduction loses precision, and
// from 2^52 on the result is NaN.
double sin(double x);
double cos(double x);
double atan2(double y, double x); // (−π, π]
double pow(double x, double y);   // NaN for x < 0 unless y is whole

} // namespace pantin::math
