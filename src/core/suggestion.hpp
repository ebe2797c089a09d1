// SPDX-License-Identifier: MIT
// What was probably meant by a word that is not known.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pantin {

// The least number of letters to put in, take out, change or exchange with the next, from one word to the
// other (optimal string alignment: Damerau 1964, Wagner and Fischer 1974). No error.
int edit_distance(std::string_view a, std::string_view b);

// "; did you mean 'animate'?" with the nearest of the known words, the first among equals; empty when none is
// near: more than a third of the word's letters would change, and more than one; or more than three. No
// error. Own.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

} // namespace pantin
