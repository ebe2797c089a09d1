// SPDX-License-Identifier: MIT
// Colours and papers that a drawing may have in place of a dark pen on white.
#pragma once

#include <string>
#include <vector>

#include "doodle/canvas.hpp"

namespace pantin::doodle {

// Changes the hand's colours and ground to the look's; no look, no change. Throws Error(usage) for another
// name.
void apply_look(const std::string& look, Hand& hand, Random& random);
// What is printed on the sheet beneath the ink: the lines of "grid".
void print_lines(const std::string& look, const Hand& hand, Grid<Colour>& ink, Random& random);

} // namespace pantin::doodle
