// SPDX-License-Identifier: MIT
// Which species `variety` draws, and how often each.
#include "doodle/species.hpp"

#include <algorithm>

namespace pantin::doodle {
namespace {

struct Family {
    const char* type;
    double weight; // within its type
    std::vector<std::string> species;
    Figure (*build)(Random&, const std::string&);
};

const std::vector<Family>& families() {
    static const std::vector<Family> all = {
        {"flying", 3.0, perched_species(), build_perched},
        {"flying", 1.6, spread_species(), build_spread},
        {"quadruped", 3.0, walker_species(), build_walker},
        {"quadruped", 1.2, sitter_species(), build_sitter},
        {"humanoid", 1.0, upright_species(), build_upright},
        {"other", 1.0, swimmer_species(), build_swimmer},
    };
    return all;
}

// Sketched more often than their share of the list.
const std::vector<std::string>& favourites(const std::string& type) {
    static const std::vector<std::string> birds = {"songbird",     "songbird",     "round bird",
                                                   "slender bird", "crested bird", "swimming duck"},
                                          animals = {"quick dog", "quick dog", "long dog", "quick cat",
                                                     "quick horse"},
                                          people = {"posed person", "posed stick person", "sketched monkey",
                                                    "sketched monkey", "person from the side"},
                                          none;
    return type == "flying" ? birds : type == "quadruped" ? animals : type == "humanoid" ? people : none;
}

} // namespace

std::vector<std::string> varied_species(const std::string& type) {
    std::vector<std::string> names;
    for (const Family& family : families())
        if (family.type == type) names.insert(names.end(), family.species.begin(), family.species.end());
    return names;
}

std::string pick_varied(Random& random, const std::string& type) {
    std::vector<const Family*> list;
    std::vector<double> weights;
    for (const Family& family : families())
        if (family.type == type) list.push_back(&family), weights.push_back(family.weight);
    const std::vector<std::string>& often = favourites(type);
    if (!often.empty() && random.chance(0.35)) return random.pick(often);
    return random.pick(list[random.weighted(weights)]->species);
}

Figure build_varied(Random& random, const std::string& type, const std::string& species) {
    for (const Family& family : families())
        if (family.type == type &&
            std::find(family.species.begin(), family.species.end(), species) != family.species.end())
            return family.build(random, species);
    return {};
}

} // namespace pantin::doodle
