// SPDX-License-Identifier: MIT
// Names to side and part of the body. A name is cut into words where its letters change from small to capital
// or something else stands between them, and a word without such marks ("leftupleg", "lshldr") where the
// words of the body's parts meet.
#include "animation/joint_names.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "core/name_words.hpp"

namespace pantin {
namespace {

constexpr double most = 0.6; // of the names share a prefix

// Words that names are made of. `means`: what stands for it, "" for nothing.
struct Word {
    std::string_view text, means;
};
constexpr auto words = std::to_array<Word>({// sides and qualifiers
                                            {"left", "<"},
                                            {"right", ">"},
                                            {"l", "<"},
                                            {"r", ">"},
                                            {"lft", "<"},
                                            {"rgt", ">"},
                                            {"upper", "up"},
                                            {"up", "up"},
                                            {"u", "up"},
                                            {"lower", "low"},
                                            {"low", "low"},
                                            {"lo", "low"},
                                            {"fore", "low"},
                                            {"f", "low"},
                                            // parts of the body
                                            {"arm", "arm"},
                                            {"elbow", "elbow"},
                                            {"wrist", "wrist"},
                                            {"hand", "hand"},
                                            {"humerus", "humerus"},
                                            {"radius", "radius"},
                                            {"shldr", "shoulder"},
                                            {"shoulder", "shoulder"},
                                            {"collar", "collar"},
                                            {"clavicle", "collar"},
                                            {"leg", "leg"},
                                            {"thigh", "thigh"},
                                            {"femur", "femur"},
                                            {"knee", "knee"},
                                            {"shin", "shin"},
                                            {"calf", "calf"},
                                            {"tibia", "tibia"},
                                            {"ankle", "ankle"},
                                            {"foot", "foot"},
                                            {"hips", "hips"},
                                            {"hip", "hip"},
                                            {"pelvis", "pelvis"},
                                            {"root", "root"},
                                            {"spine", "spine"},
                                            {"chest", "chest"},
                                            {"neck", "neck"},
                                            {"head", "head"},
                                            {"wing", "wing"},
                                            {"tail", "tail"},
                                            {"base", "base"},
                                            {"center", "center"},
                                            {"centre", "center"},
                                            // of no meaning
                                            {"joint", ""},
                                            {"jnt", ""},
                                            {"bone", ""},
                                            {"bend", ""},
                                            {"def", ""},
                                            {"org", ""},
                                            {"bip", ""},
                                            {"j", ""},
                                            {"c", ""},
                                            {"m", ""},
                                            {"b", ""},
                                            // beside the main joints
                                            {"twist", "!"},
                                            {"roll", "!"},
                                            {"end", "!"},
                                            {"tip", "!"},
                                            {"site", "!"},
                                            {"nub", "!"},
                                            {"top", "!"},
                                            {"toe", "!"},
                                            {"toes", "!"},
                                            {"finger", "!"},
                                            {"thumb", "!"},
                                            {"ik", "!"},
                                            {"target", "!"},
                                            {"metacarpal", "!"}});

// Of the skeletons that MikuMikuDance has made common; the side is the first character.
constexpr auto japanese = std::to_array<Word>({{"腕", "arm"},
                                               {"ひじ", "elbow"},
                                               {"手首", "wrist"},
                                               {"足", "thigh"},
                                               {"ひざ", "knee"},
                                               {"足首", "ankle"},
                                               {"首", "neck"},
                                               {"頭", "head"}});

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_letter(char c) { return is_upper(c) || (c >= 'a' && c <= 'z'); }
char lower(char c) { return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c; }

std::string lower(std::string text) {
    for (char& c : text) c = lower(c);
    return text;
}

const Word* find_word(std::string_view text) {
    const auto found =
        std::find_if(words.begin(), words.end(), [&](const Word& w) { return w.text == text; });
    return found == words.end() ? nullptr : &*found;
}

// The known words that make up all of a word, as few as possible; empty: there are none such. Single letters
// stand at the beginning only: "lfarm" is l, f, arm.
std::vector<std::string> cut_into_known(const std::string& word) {
    std::vector<int> count(word.size() + 1, -1);
    std::vector<std::size_t> from(word.size() + 1, 0);
    count[0] = 0;
    for (std::size_t end = 1; end <= word.size(); ++end)
        for (std::size_t begin = 0; begin < end; ++begin) {
            const bool single = end - begin == 1;
            if (count[begin] < 0 || (single && begin > 1) ||
                !find_word(std::string_view(word).substr(begin, end - begin)))
                continue;
            if (count[end] >= 0 && count[end] <= count[begin] + 1) continue;
            count[end] = count[begin] + 1;
            from[end] = begin;
        }
    std::vector<std::string> result;
    if (count[word.size()] < 0) return result;
    for (std::size_t end = word.size(); end > 0; end = from[end])
        result.push_back(word.substr(from[end], end - from[end]));
    std::reverse(result.begin(), result.end());
    return result;
}

SimpleName simple(const std::string& name) {
    SimpleName result;
    const bool left = name.starts_with("左"), right = name.starts_with("右");
    const std::string_view sideless = std::string_view(name).substr(left || right ? 3 : 0); // bytes
    for (const Word& word : japanese)
        if (word.text == sideless)
            return {left    ? BodySide::left
                    : right ? BodySide::right
                            : BodySide::none,
                    std::string(word.means)};
    std::string qualifier;
    for (const std::string& marked : words_of(name)) {
        std::vector<std::string> parts = cut_into_known(marked);
        if (parts.empty()) parts = {marked};
        for (const std::string& part : parts) {
            const Word* known = find_word(part);
            const std::string means = known ? std::string(known->means) : part;
            if (means == "<")
                result.side = BodySide::left;
            else if (means == ">")
                result.side = BodySide::right;
            else if (means == "!")
                result.helper = true;
            else if (means == "up" || means == "low")
                qualifier = means;
            else
                result.word += means;
        }
    }
    result.word = qualifier + result.word;
    return result;
}

// The longest beginning that most of the names share; none where it would leave most of them without letters.
std::string shared_beginning(const std::vector<std::string>& names) {
    std::string shared;
    const auto wanted = static_cast<std::ptrdiff_t>(most * static_cast<double>(names.size()) + 0.999);
    while (true) {
        std::map<char, std::ptrdiff_t> next;
        for (const std::string& name : names)
            if (name.size() > shared.size() && lower(name).starts_with(shared))
                ++next[lower(name[shared.size()])];
        const auto best = std::max_element(next.begin(), next.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        if (best == next.end() || best->second < wanted) return shared;
        shared += best->first;
    }
}

std::string reversed(const std::string& text) { return {text.rbegin(), text.rend()}; }

} // namespace

std::vector<SimpleName> simplified(const std::vector<std::string>& names) {
    std::vector<std::string> named, backwards;
    for (const std::string& name : names)
        if (!name.empty()) named.push_back(name), backwards.push_back(reversed(name));
    const bool several = named.size() > 3;
    const std::string prefix = several ? shared_beginning(named) : "";
    std::string suffix = several ? reversed(shared_beginning(backwards)) : "";
    // Half a word is no suffix: "…Leg" of "LeftLeg" and "…g" are.
    if (!suffix.empty() && is_letter(suffix.front())) suffix.clear();
    std::vector<SimpleName> result;
    for (const std::string& name : names) {
        std::string rest = name;
        if (!prefix.empty() && lower(rest).starts_with(prefix)) rest = rest.substr(prefix.size());
        if (!suffix.empty() && lower(rest).ends_with(suffix))
            rest = rest.substr(0, rest.size() - suffix.size());
        result.push_back(simple(rest));
    }
    return result;
}

} // namespace pantin
