// SPDX-License-Identifier: MIT
// What the name of a part says about it.
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "core/name_words.hpp"
#include "pantin/strokes.hpp"

namespace pantin {
namespace {

struct Known {
    std::string_view word;
    Label label;
};
// In the singular, sorted. A trunk is a torso's far more often than an elephant's.
constexpr auto known_words = std::to_array<Known>({
    {"abdomen", Label::body},  {"ankle", Label::limb},    {"antenna", Label::head},
    {"antennae", Label::head}, {"antler", Label::head},   {"arm", Label::limb},
    {"beak", Label::head},     {"beard", Label::head},    {"belly", Label::body},
    {"bill", Label::head},     {"body", Label::body},     {"boot", Label::limb},
    {"brow", Label::head},     {"cap", Label::head},      {"carapace", Label::body},
    {"cheek", Label::head},    {"chest", Label::body},    {"chin", Label::head},
    {"claw", Label::limb},     {"crest", Label::head},    {"crown", Label::head},
    {"ear", Label::head},      {"elbow", Label::limb},    {"eye", Label::head},
    {"eyeball", Label::head},  {"eyebrow", Label::head},  {"eyelid", Label::head},
    {"face", Label::head},     {"feet", Label::limb},     {"fin", Label::limb},
    {"finger", Label::limb},   {"flipper", Label::limb},  {"foot", Label::limb},
    {"hair", Label::head},     {"hand", Label::limb},     {"hat", Label::head},
    {"head", Label::head},     {"hip", Label::body},      {"hoof", Label::limb},
    {"horn", Label::head},     {"hump", Label::body},     {"jaw", Label::head},
    {"knee", Label::limb},     {"leg", Label::limb},      {"limb", Label::limb},
    {"mane", Label::head},     {"mouth", Label::head},    {"muzzle", Label::head},
    {"neck", Label::body},     {"nose", Label::head},     {"paw", Label::limb},
    {"pincer", Label::limb},   {"ponytail", Label::head}, {"pupil", Label::head},
    {"shell", Label::body},    {"shin", Label::limb},     {"shoe", Label::limb},
    {"shoulder", Label::body}, {"skull", Label::head},    {"sleeve", Label::limb},
    {"snout", Label::head},    {"stomach", Label::body},  {"tail", Label::tail},
    {"tentacle", Label::limb}, {"thigh", Label::limb},    {"thorax", Label::body},
    {"thumb", Label::limb},    {"toe", Label::limb},      {"tongue", Label::head},
    {"torso", Label::body},    {"trunk", Label::body},    {"tummy", Label::body},
    {"tusk", Label::head},     {"waist", Label::body},    {"whisker", Label::head},
    {"wing", Label::wing},
});
// Written together with the word they belong to: "leftwing", "forehead".
constexpr std::array<std::string_view, 12> prefixes = {"left", "right", "fore",  "hind",   "front", "back",
                                                       "rear", "upper", "lower", "middle", "inner", "outer"};

Label label_of_singular(std::string_view word) {
    const auto found =
        std::find_if(known_words.begin(), known_words.end(), [&](const Known& k) { return k.word == word; });
    return found == known_words.end() ? Label::background : found->label;
}

// "ears", "torsoes", "bellies".
Label label_of_number(std::string_view word) {
    Label label = label_of_singular(word);
    if (label == Label::background && word.ends_with('s'))
        label = label_of_singular(word.substr(0, word.size() - 1));
    if (label == Label::background && word.ends_with("es"))
        label = label_of_singular(word.substr(0, word.size() - 2));
    if (label == Label::background && word.ends_with("ies"))
        label = label_of_singular(std::string(word.substr(0, word.size() - 3)) + "y");
    return label;
}

} // namespace

Label label_of_word(std::string_view word) {
    Label label = label_of_number(word);
    for (const std::string_view prefix : prefixes)
        if (label == Label::background && word.starts_with(prefix))
            label = label_of_number(word.substr(prefix.size()));
    return label;
}

Label known_label(const std::string& name) {
    // In a compound the last word says what it is: a "head feather hand" is a hand.
    Label label = Label::background;
    for (const std::string& word : words_of(name))
        if (const Label own = label_of_word(word); own != Label::background) label = own;
    return label;
}

Label label_of_part(const std::string& name) {
    const Label label = known_label(name);
    return label == Label::background ? Label::limb : label;
}

} // namespace pantin
