// SPDX-License-Identifier: MIT
// A program without `model`.
#include "cli/command.hpp"

namespace pantin::cli {

void add_model(Command app) { add_left_out(app, "model", "MODELING=0"); }

} // namespace pantin::cli
