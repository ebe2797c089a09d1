// SPDX-License-Identifier: MIT
// Whether something on a page that touches a larger character is a figure of its own. Own.
#pragma once

#include "pantin/detection.hpp"
#include "pipeline/context.hpp"

namespace pantin {

// By what the type head says of it (DetectionOptions::figure_other). Empty when the options ask for no test;
// the context outlives it. The test throws Error(weights).
FigureTest make_figure_test(Context& context);

} // namespace pantin
