// SPDX-License-Identifier: MIT
// An evaluation as text.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <set>

#include "evaluation/cells.hpp"
#include "pantin/evaluation.hpp"

namespace pantin {

namespace {

constexpr int name_width = 36;
constexpr const char* none = "–";

// A text of `width` characters, filled up on the left; "–" has three bytes.
std::string right(const std::string& text, std::size_t width) {
    const auto bytes = static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
    return std::string(bytes < width ? width - bytes : 0, ' ') + text;
}

std::string number(double value, const char* format = "%.3f") {
    return std::isnan(value) ? none : printed(format, value);
}

std::string range(const Interval& interval, const char* format = "%.2f") {
    if (std::isnan(interval.low)) return none;
    return number(interval.low, format) + none + number(interval.high, format);
}

// "  name   12 of 30   0.400 [0.25–0.58]"
std::string row(const Measurement& m, const std::string& name) {
    const std::string of = m.hits ? printed("%d of %d", *m.hits, m.count) : printed("%d", m.count);
    const char* format = m.table == "seconds" ? "%.4f" : "%.2f";
    return printed("  %-*s", name_width, name.c_str()) + right(of, 12) + "  " +
           right(number(m.value, m.table == "seconds" ? "%.4f" : "%.3f"), 7) + " [" +
           range(m.interval, format) + "]\n";
}

// Every group has two lines: its values, and below them the intervals.
std::string segmentation_table(const std::vector<Measurement>& rows) {
    std::string heads, text, values, ranges, group;
    std::set<std::string> seen;
    const auto finish = [&] {
        if (!group.empty())
            text += printed("  %-*s", name_width, group.c_str()) + values + "\n" + ranges + "\n";
        values.clear(), ranges = std::string(name_width + 2, ' ');
    };
    for (const Measurement& m : rows) {
        if (m.table != "segmentation") continue;
        if (m.group != group) finish(), group = m.group;
        if (seen.insert(m.measure).second) heads += right(m.measure, 11);
        const bool whole = m.measure == "characters";
        values += right(whole ? std::to_string(m.count) : number(m.value), 11);
        ranges += right(whole ? "" : range(m.interval), 11);
    }
    finish();
    return "\nsegmentation" + std::string(name_width + 2 - 12, ' ') + heads + "\n" + text;
}

std::string table(
    const std::vector<Measurement>& rows, const std::string& name, const std::string& title,
    const std::function<bool(const Measurement&)>& shown = [](auto&) { return true; }) {
    std::string text;
    for (const Measurement& m : rows)
        if (m.table == name && shown(m))
            text += row(m, name == "identification" ? m.group + " → " + m.measure
                           : name == "ends"         ? m.measure + ", limbs " + m.group
                                                    : m.measure);
    return text.empty() ? "" : "\n" + title + "\n" + text;
}

} // namespace

int unlabelled_pages(const Evaluation& e) { return e.pages - static_cast<int>(e.labelled_pages.size()); }

int labelled_characters(const Evaluation& e) {
    return static_cast<int>(std::count_if(e.characters.begin(), e.characters.end(),
                                          [](const CharacterResult& c) { return c.labelled; }));
}

std::string evaluation_to_text(const Evaluation& e) {
    const std::vector<Measurement> rows = measurements_of(e);
    std::string text =
        printed("%d pages, %d characters, %zu found\n", e.pages, labelled_characters(e), e.found.size());
    if (const int others = unlabelled_pages(e); others > 0)
        text += printed("%d without a label map: they count in the table of types alone\n", others);
    if (e.unanswered_pages > 0) text += printed("%d without a prediction\n", e.unanswered_pages);
    text +=
        "in brackets: 95 % intervals\n" + table(rows, "detection", "detection") + segmentation_table(rows);
    text += table(rows, "identification", "identification (true type → answer)");
    text += table(rows, "stages", "stages");
    text +=
        table(rows, "ends",
              "heads, limbs, tails and wings with an end of the skeleton (as pieces: legs that have grown "
              "together are one)");
    text += table(rows, "warnings", "warnings (of all characters)",
                  [](const Measurement& m) { return m.hits && (m.measure == "any" || *m.hits > 0); });
    if (e.measured.steps) text += table(rows, "seconds", "seconds (detect: a page; else a character)");
    return text;
}

} // namespace pantin
