// SPDX-License-Identifier: MIT
// From the public name of an instruction set to its kernels.
#pragma once

#include "network/integer/kernel.hpp"
#include "network/kernel.hpp"
#include "pantin/network.hpp"

namespace pantin::network {

const Kernel& kernel_of(Simd simd);
const integer::Kernel& integer_kernel_of(Simd simd);

} // namespace pantin::network
