// SPDX-License-Identifier: MIT
// What a weight file says of its numbers.
#include "network/arithmetic.hpp"

namespace pantin::network {

bool holds_integers(const WeightFile& file) {
    if (!file.has_metadata("arithmetic")) return false;
    if (const std::string& name = file.metadata("arithmetic"); name != "integer")
        file.fail("metadata 'arithmetic' is '" + name + "', not 'integer'");
    return true;
}

} // namespace pantin::network
