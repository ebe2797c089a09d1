// SPDX-License-Identifier: MIT
// A program without `verify`.
#include "cli/command.hpp"

namespace pantin::cli {

void add_verify(Command app) { add_left_out(app, "verify", "VERIFY=0"); }

} // namespace pantin::cli
