// SPDX-License-Identifier: MIT
// Numbers as text: the shortest decimals that read back to the same bits, whatever the locale.
#pragma once

#include <string>

namespace pantin {

// "3", "-0.5", "1e-07"; "-0.0" for the negative zero, so that a reader keeps its sign. Not for NaN or
// infinity.
std::string to_decimal(double value);
// The shortest decimals that read back to the same float.
std::string to_decimal(float value);

} // namespace pantin
