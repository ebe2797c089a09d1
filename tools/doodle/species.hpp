// SPDX-License-Identifier: MIT
// What `variety` adds: species that quick sketches show, beside those of figure.hpp.
#pragma once

#include "doodle/doodle.hpp"
#include "doodle/figure.hpp"

namespace pantin::doodle {

std::vector<std::string> perched_species(); // birds with folded wings, from the side
Figure build_perched(Random& random, const std::string& species);
std::vector<std::string> spread_species(); // birds from the front, bats, fairies, dragons, wings up
Figure build_spread(Random& random, const std::string& species);
std::vector<std::string> walker_species(); // four legs, from the side
Figure build_walker(Random& random, const std::string& species);
std::vector<std::string> sitter_species(); // animals that sit, lie, hop or crawl
Figure build_sitter(Random& random, const std::string& species);
std::vector<std::string> upright_species(); // humanoids
Figure build_upright(Random& random, const std::string& species);
std::vector<std::string> swimmer_species(); // type other: in the water and on many legs
Figure build_swimmer(Random& random, const std::string& species);

// One of varied_species(type), as often as people draw it.
std::string pick_varied(Random& random, const std::string& type);
Figure build_varied(Random& random, const std::string& type, const std::string& species);

} // namespace pantin::doodle
