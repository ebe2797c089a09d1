// SPDX-License-Identifier: MIT
// Words of joints, beside those of drawn parts (label_of_word).
#include "formats/joint_words.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/name_words.hpp"
#include "pantin/strokes.hpp"

namespace pantin {

namespace {

struct Known {
    std::string_view word;
    Label label;
};
// In the singular, sorted.
constexpr auto joint_words = std::to_array<Known>({
    {"ankle", Label::limb},    {"calf", Label::limb},       {"caudal", Label::tail},
    {"clavicle", Label::limb}, {"collarbone", Label::limb}, {"elbow", Label::limb},
    {"feather", Label::wing},  {"feeler", Label::head},     {"femur", Label::limb},
    {"fetlock", Label::limb},  {"flipper", Label::limb},    {"fluke", Label::tail},
    {"heel", Label::limb},     {"hip", Label::body},        {"hock", Label::limb},
    {"hoove", Label::limb},    {"humerus", Label::limb},    {"knee", Label::limb},
    {"pastern", Label::limb},  {"pelvis", Label::body},     {"proboscis", Label::head},
    {"root", Label::body},     {"rump", Label::body},       {"scapula", Label::limb},
    {"shin", Label::limb},     {"shoulder", Label::limb},   {"spine", Label::body},
    {"stifle", Label::limb},   {"tentacle", Label::limb},   {"thigh", Label::limb},
    {"thumb", Label::limb},    {"tibia", Label::limb},      {"waist", Label::body},
    {"wrist", Label::limb},
});

// "knees", but "pelvis".
bool is(std::string_view word, std::string_view singular) {
    return word == singular || (word.ends_with('s') && word.substr(0, word.size() - 1) == singular);
}

template <std::size_t count>
bool is_one_of(std::string_view word, const std::array<std::string_view, count>& words) {
    return std::any_of(words.begin(), words.end(), [&](std::string_view w) { return is(word, w); });
}

// "fins", and written together with its side, "leftfin", as label_of_word() splits it.
bool says_fin(std::string_view word) {
    return is(word, "fin") ||
           (label_of_word(word) == Label::limb && (word.ends_with("fin") || word.ends_with("fins")));
}

Label label_of_joint_word(std::string_view word) {
    // A fin is no leg: one of the back or the side is body, as in the training data.
    if (says_fin(word)) return Label::body;
    for (const Known& known : joint_words)
        if (is(word, known.word)) return known.label;
    return label_of_word(word);
}

constexpr std::array<std::string_view, 4> shoulders = {"shoulder", "clavicle", "collarbone", "scapula"};
constexpr std::array<std::string_view, 4> beginnings = {"base", "root", "start", "begin"};
constexpr std::array<std::string_view, 5> middles = {"center", "centre", "mid", "middle", "joint"};

} // namespace

Label label_of_joint_name(const std::string& name) {
    Label label = Label::background;
    for (const std::string& word : words_of(name)) {
        const Label own = label_of_joint_word(word);
        if (own == Label::wing || own == Label::tail) return own; // they have elbows, roots and tips
        // "leg1_hip" and "arm_root" are the limb's; of other words the last one counts.
        const bool weaker = own == Label::body && label != Label::background;
        if (own != Label::background && !weaker) label = own;
    }
    return label == Label::body && begins_limb(name) ? Label::limb : label;
}

bool begins_limb(const std::string& name) {
    const std::vector<std::string> words = words_of(name);
    bool hip = false,
         more = std::any_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
    bool begins = false, known = false;
    for (const std::string& word : words) {
        if (is_one_of(word, shoulders)) return true;
        begins = begins || is_one_of(word, beginnings);
        known = known ||
                (label_of_joint_word(word) != Label::background && label_of_joint_word(word) != Label::body);
        if (is(word, "hip"))
            hip = true;
        else
            more = more || !is_one_of(word, middles);
    }
    return (hip && more) || (begins && known);
}

bool is_fin(const std::string& name) {
    const std::vector<std::string> words = words_of(name);
    return label_of_joint_name(name) == Label::body && std::any_of(words.begin(), words.end(), says_fin);
}

bool is_neck(const std::string& name) {
    const std::vector<std::string> words = words_of(name);
    return std::any_of(words.begin(), words.end(), [](const std::string& word) { return is(word, "neck"); });
}

} // namespace pantin
