// SPDX-License-Identifier: MIT
// Which joint of a recorded motion plays which part of a human body, by its name.
#include <algorithm>
#include <cctype>
#include <initializer_list>

#include "pantin/error.hpp"
#include "pantin/motion.hpp"

namespace pantin {
namespace {

enum class BodySide { none, left, right };

struct SimpleName {
    BodySide side = BodySide::none;
    std::string word; // lower case, without prefix, side and digits: "upperarm"
};

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_lower(char c) { return c >= 'a' && c <= 'z'; }

// "mixamorig:LeftUpLeg" → left, up, leg; "lShldr" → l, shldr; "LHipJoint" → l, hip, joint.
std::vector<std::string> words_of(const std::string& name) {
    const std::size_t colon = name.find_last_of(":|");
    const std::string text = colon == std::string::npos ? name : name.substr(colon + 1);
    std::vector<std::string> words;
    std::string word;
    const auto end_word = [&] {
        if (!word.empty()) words.push_back(word);
        word.clear();
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (!is_upper(c) && !is_lower(c)) { // digits too: "Spine1", "Bip01"
            end_word();
            continue;
        }
        const bool after_lower = i > 0 && is_lower(text[i - 1]);
        const bool before_lower =
            i + 1 < text.size() && is_lower(text[i + 1]) && i > 0 && is_upper(text[i - 1]);
        if (is_upper(c) && (after_lower || before_lower)) end_word();
        word += static_cast<char>(is_upper(c) ? c - 'A' + 'a' : c);
    }
    end_word();
    return words;
}

SimpleName simplified(const std::string& name) {
    static const std::initializer_list<std::string> prefixes = {
        "mixamorig", "bip", "j", "def", "org", "jnt", "valvebiped", "bone", "c"};
    SimpleName result;
    for (std::string word : words_of(name)) {
        for (const auto& [text, side] :
             {std::pair<std::string, BodySide>{"left", BodySide::left}, {"right", BodySide::right}})
            if (word.starts_with(text)) {
                result.side = side;
                word = word.substr(text.size());
            }
        if (word == "l") result.side = BodySide::left, word.clear();
        if (word == "r") result.side = BodySide::right, word.clear();
        if (std::find(prefixes.begin(), prefixes.end(), word) == prefixes.end()) result.word += word;
    }
    return result;
}

class Matcher {
public:
    Matcher(const Motion& motion, const std::string& file) : motion_(motion), file_(file) {
        for (const MotionJoint& joint : motion.joints) names_.push_back(simplified(joint.name));
    }

    MotionJoints match() const {
        MotionJoints joints;
        joints.hips = find(BodySide::none, {"hips", "hip", "pelvis", "root"});
        if (joints.hips < 0) joints.hips = 0;
        joints.neck = find(BodySide::none, {"neck"});
        joints.head = find(BodySide::none, {"head"});
        if (joints.head >= 0) joints.head_end = outermost_child(joints.head);
        joints.left = side(BodySide::left, "left");
        joints.right = side(BodySide::right, "right");
        return joints;
    }

private:
    // The first joint with the earliest of the words.
    int find(BodySide side, std::initializer_list<const char*> words) const {
        for (const std::string word : words)
            for (std::size_t j = 0; j < names_.size(); ++j)
                if (names_[j].side == side && names_[j].word == word) return static_cast<int>(j);
        return -1;
    }
    int outermost_child(int joint) const {
        int child = -1;
        double longest = -1;
        for (std::size_t j = 0; j < motion_.joints.size(); ++j) {
            const auto& [x, y, z] = motion_.joints[j].offset;
            if (motion_.joints[j].parent != joint || x * x + y * y + z * z <= longest) continue;
            longest = x * x + y * y + z * z;
            child = static_cast<int>(j);
        }
        return child;
    }
    [[noreturn]] void fail(const std::string& part) const {
        std::string names;
        for (const MotionJoint& joint : motion_.joints)
            if (!joint.name.empty() && names.size() < 300) names += (names.empty() ? "" : ", ") + joint.name;
        throw Error(ErrorKind::input, file_ + ": no joint plays the " + part + " (" + names + ")");
    }
    MotionJoints::Side side(BodySide which, const std::string& text) const {
        const auto wanted = [&](const char* part, std::initializer_list<const char*> words) {
            const int found = find(which, words);
            if (found < 0) fail(text + " " + part);
            return found;
        };
        // A skeleton with an "arm" calls its collar bone "shoulder"; one with an elbow joint, its upper arm.
        MotionJoints::Side s;
        s.upper_arm = wanted("upper arm",
                             {"arm", "upperarm", "uparm", "shldr", "humerus", "shoulder", "shoulderjoint"});
        s.forearm = wanted("forearm", {"forearm", "lowerarm", "lowarm", "elbow", "radius", "elbowjoint"});
        s.thigh = wanted("thigh", {"upleg", "upperleg", "thigh", "femur", "hip", "hipjoint"});
        s.shin = wanted("shin", {"lowerleg", "lowleg", "shin", "calf", "knee", "tibia", "kneejoint", "leg"});
        s.hand = find(which, {"hand", "wrist"});
        s.foot = find(which, {"foot", "ankle"});
        if (s.hand < 0) s.hand = outermost_child(s.forearm);
        if (s.foot < 0) s.foot = outermost_child(s.shin);
        if (s.hand < 0) fail(text + " hand");
        if (s.foot < 0) fail(text + " foot");
        return s;
    }

    const Motion& motion_;
    const std::string& file_;
    std::vector<SimpleName> names_;
};

} // namespace

MotionJoints match_joints(const Motion& motion, const std::string& file) {
    return Matcher(motion, file).match();
}

std::vector<std::pair<std::string, std::string>> match_table(const Motion& motion,
                                                             const MotionJoints& joints) {
    std::vector<std::pair<std::string, std::string>> table;
    const auto add = [&](const std::string& part, int joint) {
        if (joint < 0) return;
        const MotionJoint& j = motion.joints[static_cast<std::size_t>(joint)];
        const std::string end =
            j.parent >= 0 ? motion.joints[static_cast<std::size_t>(j.parent)].name + " (its end)" : "";
        table.emplace_back(part, j.name.empty() ? end : j.name);
    };
    add("hips", joints.hips);
    add("neck", joints.neck);
    add("head", joints.head);
    for (const auto& [side, name] :
         {std::pair{joints.left, std::string("left ")}, {joints.right, std::string("right ")}}) {
        add(name + "upper arm", side.upper_arm);
        add(name + "forearm", side.forearm);
        add(name + "hand", side.hand);
        add(name + "thigh", side.thigh);
        add(name + "shin", side.shin);
        add(name + "foot", side.foot);
    }
    return table;
}

} // namespace pantin
