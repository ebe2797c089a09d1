// SPDX-License-Identifier: MIT
// One file against another of its name.
#include <algorithm>
#include <string_view>

#include "pantin/image.hpp"
#include "verify/bytes.hpp"
#include "verify/values.hpp"

namespace pantin {

namespace {

bool ends_with_one_of(const std::string& name, std::initializer_list<std::string_view> endings) {
    return std::any_of(endings.begin(), endings.end(),
                       [&](std::string_view ending) { return name.ends_with(ending); });
}

} // namespace

std::optional<FileDifference> compare_files(const std::string& name, const std::string& first,
                                            const std::string& second) {
    if (first == second) return std::nullopt;
    Differences differences(name);
    if (ends_with_one_of(name, {".json"}))
        compare_json(differences, name, first, second);
    else if (ends_with_one_of(name, {".glb"}))
        compare_glb(differences, name, first, second);
    else if (ends_with_one_of(name, {".png"}))
        compare_pictures(differences, "", decode_rgba(as_bytes(first), name),
                         decode_rgba(as_bytes(second), name));
    else if (ends_with_one_of(name, {".webp", ".gif"}))
        compare_films(differences, name, first, second);
    else if (ends_with_one_of(name, {".obj", ".mtl", ".txt", ".bvh", ".md", ".yaml"}))
        compare_words(differences, first, second);
    else
        compare_bytes(differences, first, second);
    return differences.result();
}

} // namespace pantin
