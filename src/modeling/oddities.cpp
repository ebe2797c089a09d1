// SPDX-License-Identifier: MIT
// A model and its solid in, lines about parts that meet nothing or are hidden out.
#include <algorithm>

#include "core/plural.hpp"
#include "pantin/model.hpp"

namespace pantin {
namespace {

constexpr std::size_t most_named = 8;

// "2 parts: 'a', 'b'", of many the first ones.
std::string listed(const std::vector<std::string>& names) {
    std::string line;
    for (std::size_t i = 0; i < std::min(names.size(), most_named); ++i)
        line += (i == 0 ? " '" : ", '") + names[i] + "'";
    return names.size() > most_named ? line + ", …" : line;
}

} // namespace

std::vector<std::string> oddities_of(const Model& model, const SolidMesh& mesh) {
    std::vector<char> seen(model.parts().size(), 0);
    for (const int part : mesh.triangle_parts) seen[part] = 1;
    std::vector<std::string> alone, hidden;
    for (std::size_t p = 0; p < model.parts().size(); ++p) {
        if (p > 0 && model.parts()[p].parent < 0) alone.push_back(model.parts()[p].name());
        if (!seen[p]) hidden.push_back(model.parts()[p].name());
    }
    std::vector<std::string> lines;
    if (!alone.empty())
        lines.push_back(count_of(std::ssize(alone),
                                 "part meets no part before it and has a skeleton of its own",
                                 "parts meet no part before them and have skeletons of their own") +
                        ":" + listed(alone));
    if (!hidden.empty())
        lines.push_back(count_of(std::ssize(hidden), "part lies wholly inside others and is not seen",
                                 "parts lie wholly inside others and are not seen") +
                        ":" + listed(hidden));
    return lines;
}

} // namespace pantin
