// SPDX-License-Identifier: MIT
// A program without `explain`.
#include "cli/command.hpp"

namespace pantin::cli {

void add_explain(Command app) { add_left_out(app, "explain", "EXPLAIN=0"); }

} // namespace pantin::cli
