// SPDX-License-Identifier: MIT
// The parts of a character (thesis 4.3), and all that the steps know of each in one table. A new part is an
// enumerator and a row (CONTRIBUTING.md, "A new part label").
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "pantin/grid.hpp"

namespace pantin {

// The values are those of `labels.png`. Whatever is indexed by a label has `label_count` entries.
enum class Label : std::uint8_t { background = 0, head = 1, body = 2, limb = 3, tail = 4, wing = 5, count };

inline constexpr int label_count = static_cast<int>(Label::count); // background included

// What a part is to identification and rigging. An appendage swings at a joint of the trunk, a head turns on
// it.
enum class PartRole : std::uint8_t { none, head, trunk, appendage };

struct LabelRow {
    Label label = Label::count;
    std::string_view name; // in JSON, options and the metadata of weights
    PartRole role = PartRole::none;
    Rgb8 colour, pale, solid; // in pictures of the steps, as in the thesis's Fig. 4.13; under the lines of
                              // `skeletons.png`; of a solid's part without texture and colour
    double value = 0;         // whose differences are the label distance (thesis ch. 5)
    double layer = 0;         // draw order at rest, from back to front (own) …
    double second = 0;        // … and of every second part of the label
    bool sided = false;       // has a left and a right one, whose ends do not cross (own)
    bool alternates = false;  // an unmatched one moves half a cycle after its neighbour, as legs do (own)
};

// clang-format off
inline constexpr std::array<LabelRow, label_count> label_table = {{
    // label           name          role                 colour           pale             solid         value layer second sided alternates
    {Label::background, "background", PartRole::none,      {120, 120, 120}, {255, 255, 255}, {210, 210, 210}, 0,  0,  0, false, false},
    {Label::head,       "head",       PartRole::head,      { 60, 100, 224}, {255, 226, 200}, {240, 196, 150}, 1,  3,  3, false, false},
    {Label::body,       "body",       PartRole::trunk,     {220,  60,  60}, {226, 236, 255}, {226, 170, 120}, 2,  0,  0, false, false},
    {Label::limb,       "limb",       PartRole::appendage, { 40, 160,  75}, {226, 246, 220}, {214, 152, 104}, 7,  2, -1, true,  true},
    {Label::tail,       "tail",       PartRole::appendage, {240, 130,  40}, {246, 226, 250}, {200, 138,  92}, 4, -2, -2, false, false},
    {Label::wing,       "wing",       PartRole::appendage, {206, 162,   0}, {255, 246, 196}, {170, 196, 226}, 10, 1,  1, true,  false},
}};
// clang-format on

// The row of the label; of `background` for `count` and what is none. No error. Own.
inline constexpr const LabelRow& row_of(Label label) {
    return label < Label::count ? label_table[static_cast<std::size_t>(label)] : label_table[0];
}

// One column of the table, indexed by label: `label_column(&LabelRow::colour)`. No error. Own.
template <class T> constexpr std::array<T, label_count> label_column(T LabelRow::*field) {
    std::array<T, label_count> column{};
    for (std::size_t i = 0; i < column.size(); ++i) column[i] = label_table[i].*field;
    return column;
}

inline constexpr std::array<std::string_view, label_count> label_names = label_column(&LabelRow::name);

// All labels but the background, by value.
inline constexpr std::array<Label, label_count - 1> part_labels = [] {
    std::array<Label, label_count - 1> labels{};
    for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = label_table[i + 1].label;
    return labels;
}();

// The name of the label, as in files. No error. Own.
inline constexpr std::string_view name_of(Label label) { return row_of(label).name; }

// What the part is to identification and rigging. No error. Own.
inline constexpr PartRole role_of(Label label) { return row_of(label).role; }

// The label of that name; `background` when there is none. No error. Own.
inline constexpr Label label_from_name(std::string_view name) {
    for (const LabelRow& row : label_table)
        if (row.name == name) return row.label;
    return Label::background;
}

// "head, body, limb, tail or wing", for messages. No error. Own.
inline std::string listed_parts() {
    std::string text;
    for (const Label label : part_labels) {
        if (!text.empty()) text += label == part_labels.back() ? " or " : ", ";
        text += name_of(label);
    }
    return text;
}

// A set of labels; made of a list, no error. Own.
class LabelSet {
public:
    constexpr LabelSet(std::initializer_list<Label> labels) {
        for (const Label label : labels) bits_ |= bit(label);
    }
    // All labels with one of the roles. No error. Own.
    static constexpr LabelSet with_role(std::initializer_list<PartRole> roles) {
        LabelSet set({});
        for (const LabelRow& row : label_table)
            for (const PartRole role : roles)
                if (row.role == role) set.bits_ |= bit(row.label);
        return set;
    }
    // No error: a value that is no label is in no set. Own.
    constexpr bool contains(Label label) const { return (bits_ & bit(label)) != 0; }

private:
    static constexpr std::uint32_t bit(Label label) {
        return label < Label::count ? std::uint32_t{1} << static_cast<int>(label) : 0;
    }
    std::uint32_t bits_ = 0;
};

inline constexpr LabelSet all_parts =
    LabelSet::with_role({PartRole::head, PartRole::trunk, PartRole::appendage});
inline constexpr LabelSet appendages = LabelSet::with_role({PartRole::appendage});

namespace detail {
constexpr bool is_complete(const std::array<LabelRow, label_count>& table) {
    for (std::size_t i = 0; i < table.size(); ++i)
        if (static_cast<std::size_t>(table[i].label) != i || table[i].name.empty() ||
            (table[i].role == PartRole::none) != (i == 0))
            return false;
    return true;
}
} // namespace detail
static_assert(detail::is_complete(label_table),
              "every label has a row with name and role, in the order of values");
static_assert(label_count <= 32, "LabelSet has 32 bits");

} // namespace pantin
