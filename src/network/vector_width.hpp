// SPDX-License-Identifier: MIT
#pragma once

namespace pantin::network {

// No instruction set's vector has more elements of four bytes; memory that vectors read ends with as many
// spare ones.
inline constexpr int max_vector_width = 16;

} // namespace pantin::network
