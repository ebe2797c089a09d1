// SPDX-License-Identifier: MIT
// The tables of an evaluation as rows: one value, its interval and what it was counted on.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "pantin/evaluation.hpp"

namespace pantin {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Members = std::vector<const CharacterResult*>;
// What a character adds to a mean; −1: nothing.
using Measure = std::function<double(const CharacterResult&)>;

struct Column {
    std::string name;
    Measure measure;
    bool share = false; // each value is 0 or 1
};

std::vector<Column> segmentation_columns() {
    std::vector<Column> columns = {{"mean IoU", &CharacterResult::mean_overlap}};
    for (int part = 1; part < label_count; ++part)
        columns.push_back({std::string(label_names[part]),
                           [part](const CharacterResult& c) { return c.part_overlap[part]; }});
    const auto judged = [](const CharacterResult& c) { return c.mean_overlap() >= 0; };
    columns.push_back({"pixels", [=](const auto& c) { return judged(c) ? c.pixel_accuracy : -1; }});
    columns.push_back({"silhouette", [=](const auto& c) { return judged(c) ? c.silhouette_overlap : -1; }});
    columns.push_back({"router", [](const auto& c) { return c.expert_right; }, true});
    columns.push_back({"pose", [](const auto& c) { return c.pose_right; }, true});
    return columns;
}

// "all", then every type, then every species of it; of labelled pages.
std::map<std::string, Members> groups_of(const Evaluation& evaluation) {
    std::map<std::string, Members> groups;
    groups["all"];
    for (const CharacterResult& c : evaluation.characters) {
        if (!c.labelled) continue;
        groups["all"].push_back(&c);
        if (!c.type.empty()) groups["all, " + c.type].push_back(&c);
        if (!c.type.empty() && !c.species.empty()) groups["all, " + c.type + ", " + c.species].push_back(&c);
    }
    return groups;
}

class Rows {
public:
    explicit Rows(const Evaluation& evaluation) : e_(evaluation), groups_(groups_of(evaluation)) {}

    std::vector<Measurement> all() {
        detection();
        segmentation();
        identification();
        stages();
        ends();
        warnings();
        times();
        return std::move(rows_);
    }

private:
    void share(const std::string& table, const std::string& group, const std::string& measure, int hits,
               int count, bool measured = true) {
        if (!measured) return rows_.push_back({table, group, measure, nan, {nan, nan}, 0, std::nullopt});
        const double value = count == 0 ? nan : static_cast<double>(hits) / count;
        rows_.push_back({table, group, measure, value, share_interval(hits, count), count, hits});
    }

    void mean(const std::string& table, const std::string& group, const std::string& measure,
              const std::vector<double>& values) {
        double sum = 0;
        for (const double value : values) sum += value;
        const double value = values.empty() ? nan : sum / static_cast<double>(values.size());
        Interval interval = mean_interval(values);
        if (table == "segmentation") // of values in [0, 1]
            interval = {std::max(0.0, interval.low), std::min(1.0, interval.high)};
        if (values.size() < 2) interval = {nan, nan};
        rows_.push_back(
            {table, group, measure, value, interval, static_cast<int>(values.size()), std::nullopt});
    }

    void detection() {
        const bool masks = e_.measured.masks;
        const int all = static_cast<int>(groups_["all"].size()), found = static_cast<int>(e_.found.size());
        for (const bool by_mask : {true, false})
            for (const int percent : {50, 75}) {
                const std::string name =
                    std::string(by_mask ? "mask" : "silhouette") + " AP" + std::to_string(percent);
                const double least = percent / 100.0;
                if (!masks) {
                    share("detection", "all", name, 0, 0, false);
                    continue;
                }
                rows_.push_back({"detection", "all", name, average_precision(e_, least, by_mask),
                                 average_precision_interval(e_, least, by_mask), all, std::nullopt});
            }
        const auto missed = count(groups_["all"], [](auto& c) { return !c.found; });
        const auto wrong = std::count_if(e_.found.begin(), e_.found.end(),
                                         [](const FoundCharacter& f) { return f.mask_overlap < 0.5; });
        share("detection", "all", "missed", missed, all, masks);
        share("detection", "all", "false", static_cast<int>(wrong), found, masks);
    }

    void segmentation() {
        for (const auto& [name, members] : groups_) {
            const int n = static_cast<int>(members.size());
            rows_.push_back(
                {"segmentation", name, "characters", static_cast<double>(n), {nan, nan}, n, std::nullopt});
            for (const Column& column : segmentation_columns()) {
                std::vector<double> values;
                for (const CharacterResult* c : members)
                    if (const double value = column.measure(*c); value >= 0) values.push_back(value);
                if (column.share)
                    share("segmentation", name, column.name,
                          static_cast<int>(std::count(values.begin(), values.end(), 1.0)),
                          static_cast<int>(values.size()));
                else
                    mean("segmentation", name, column.name, values);
            }
        }
    }

    void identification() {
        std::map<std::string, std::map<std::string, int>> confusion;
        std::map<std::string, int> totals;
        int right = 0, all = 0;
        for (const CharacterResult& c : e_.characters)
            if (!c.type.empty()) {
                ++confusion[c.type][c.identified.empty() ? "none" : c.identified], ++totals[c.type];
                right += c.identified == c.type, ++all;
            }
        share("identification", "all", "right", right, all, e_.measured.types);
        if (!e_.measured.types) return;
        for (const auto& [type, answers] : confusion)
            for (const auto& [answer, number] : answers)
                share("identification", type, answer, number, totals[type]);
    }

    // As in tables 6.1 to 6.3 of the thesis. Segmented: mean IoU of at least one half, where it is known;
    // identified: as its true type.
    void stages() {
        const Members& all = groups_["all"];
        const Measured& m = e_.measured;
        const auto row = [&](const char* name, bool measured,
                             const std::function<bool(const CharacterResult&)>& holds) {
            share("stages", "all", name, count(all, holds), static_cast<int>(all.size()), measured);
        };
        const auto identified = [](const CharacterResult& c) { return c.found && !c.identified.empty(); };
        row("detected", m.masks, [](auto& c) { return c.found; });
        row("segmented", m.labels, [](const CharacterResult& c) {
            return c.found && (c.mean_overlap() < 0 || c.mean_overlap() >= 0.5);
        });
        row("skeleton", m.steps, identified);
        row("identified", m.types, [&](auto& c) { return identified(c) && c.identified == c.type; });
        row("rigged", m.steps, [](auto& c) { return c.found && c.status == "ok"; });
    }

    void ends() {
        for (const bool known : {true, false}) {
            int characters = 0, whole = 0, parts = 0, reached = 0;
            for (const CharacterResult* c : groups_["all"])
                if (c->ends.parts > 0 && c->ends.limbs_known == known) {
                    ++characters, whole += c->ends.all();
                    parts += c->ends.parts, reached += c->ends.reached;
                }
            if (characters == 0) continue;
            share("ends", known ? "as drawn" : "as pieces", "every part", whole, characters);
            share("ends", known ? "as drawn" : "as pieces", "parts", reached, parts);
        }
    }

    void warnings() {
        const int n = static_cast<int>(e_.characters.size());
        const auto number = [&](auto holds) {
            return static_cast<int>(std::count_if(e_.characters.begin(), e_.characters.end(), holds));
        };
        share("warnings", "all", "any", number([](auto& c) { return !c.warnings.empty(); }), n,
              e_.measured.steps);
        for (const WarningRow& row : warning_table)
            share("warnings", "all", std::string(row.name), number([&](const CharacterResult& c) {
                      return std::any_of(c.warnings.begin(), c.warnings.end(),
                                         [&](const Warning& w) { return w.kind == row.kind; });
                  }),
                  n, e_.measured.steps);
    }

    void times() {
        for (std::size_t step = 0; step < evaluated_steps.size(); ++step)
            mean("seconds", step == 0 ? "page" : "character", std::string(evaluated_steps[step]),
                 e_.seconds[step]);
    }

    static int count(const Members& members, const std::function<bool(const CharacterResult&)>& holds) {
        return static_cast<int>(
            std::count_if(members.begin(), members.end(), [&](auto* c) { return holds(*c); }));
    }

    const Evaluation& e_;
    std::map<std::string, Members> groups_;
    std::vector<Measurement> rows_;
};

} // namespace

std::vector<Measurement> measurements_of(const Evaluation& evaluation) { return Rows(evaluation).all(); }

} // namespace pantin
