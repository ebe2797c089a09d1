// SPDX-License-Identifier: MIT
// The table of part labels: names, roles, sets.
#include <set>

#include <catch2/catch.hpp>

#include "pantin/label.hpp"

using namespace pantin;

TEST_CASE("Labels are known by their names, and by what messages list", "[core]") {
    for (const LabelRow& row : label_table) {
        CHECK(label_from_name(row.name) == row.label);
        CHECK(name_of(row.label) == row.name);
    }
    CHECK(label_from_name("fin") == Label::background);
    CHECK(name_of(Label::count) == "background");
    CHECK(listed_parts().starts_with("head, body, limb, "));
    CHECK(listed_parts().ends_with(" or " + std::string(name_of(part_labels.back()))));
}

TEST_CASE("Every part has a role, a colour of its own and a value of its own", "[core]") {
    std::set<int> colours;
    std::set<double> values;
    for (const LabelRow& row : label_table) {
        colours.insert(row.colour.r << 16 | row.colour.g << 8 | row.colour.b);
        values.insert(row.value);
        CHECK(all_parts.contains(row.label) == (row.label != Label::background));
    }
    CHECK(colours.size() == label_table.size());
    CHECK(values.size() == label_table.size());
}

TEST_CASE("A set of labels holds what it was made of, and no value that is no label", "[core]") {
    CHECK(appendages.contains(Label::tail));
    CHECK_FALSE(appendages.contains(Label::head));
    CHECK_FALSE(LabelSet({Label::body}).contains(Label::wing));
    CHECK_FALSE(all_parts.contains(static_cast<Label>(200)));
}
