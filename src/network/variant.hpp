// SPDX-License-Identifier: MIT
// From the public name of an instruction set to its kernel.
#pragma once

#include "network/kernel.hpp"
#include "pantin/network.hpp"

namespace pantin::network {

const Kernel& kernel_of(Simd simd);

} // namespace pantin::network
