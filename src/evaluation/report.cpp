// SPDX-License-Identifier: MIT
// An evaluation as text, JSON and HTML.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>

#include "core/json.hpp"
#include "pantin/evaluation.hpp"

namespace pantin {

namespace {

// Mean of what `value` gives, −1 left out.
struct Mean {
    double sum = 0;
    int count = 0;
    void add(double value) {
        if (value >= 0) sum += value, ++count;
    }
    double value() const { return count == 0 ? std::nan("") : sum / count; }
};
using Measure = std::function<double(const CharacterResult&)>;

Mean mean_of(const std::vector<const CharacterResult*>& characters, const Measure& measure) {
    Mean mean;
    for (const CharacterResult* c : characters) mean.add(measure(*c));
    return mean;
}

struct Column {
    std::string name;
    Measure measure;
};
std::vector<Column> segmentation_columns() {
    std::vector<Column> columns = {{"mean IoU", &CharacterResult::mean_overlap}};
    for (int part = 1; part < label_count; ++part)
        columns.push_back({std::string(label_names[part]),
                           [part](const CharacterResult& c) { return c.part_overlap[part]; }});
    const auto judged = [](const CharacterResult& c) { return c.mean_overlap() >= 0; };
    columns.push_back({"pixels", [=](const auto& c) { return judged(c) ? c.pixel_accuracy : -1; }});
    columns.push_back({"silhouette", [=](const auto& c) { return judged(c) ? c.silhouette_overlap : -1; }});
    columns.push_back({"router", [](const auto& c) { return c.expert_right; }});
    columns.push_back({"pose", [](const auto& c) { return c.pose_right; }});
    return columns;
}

// "all", then every type, then every species of it.
std::map<std::string, std::vector<const CharacterResult*>> groups_of(const Evaluation& evaluation) {
    std::map<std::string, std::vector<const CharacterResult*>> groups;
    for (const CharacterResult& c : evaluation.characters) {
        if (!c.labelled) continue;
        groups["all"].push_back(&c);
        if (!c.type.empty()) groups["all, " + c.type].push_back(&c);
        if (!c.type.empty() && !c.species.empty()) groups["all, " + c.type + ", " + c.species].push_back(&c);
    }
    return groups;
}

// type → reference ("" for none) → count.
std::map<std::string, std::map<std::string, int>> confusion_of(const Evaluation& evaluation) {
    std::map<std::string, std::map<std::string, int>> confusion;
    for (const CharacterResult& c : evaluation.characters)
        if (!c.type.empty()) ++confusion[c.type][c.identified.empty() ? "none" : c.identified];
    return confusion;
}

struct Stages {
    int all = 0, detected = 0, segmented = 0, skeleton = 0, identified = 0, rigged = 0;
};
// As in tables 6.1 to 6.3 of the thesis, of labelled pages. Segmented: mean IoU of at least one half, where it
// is known; identified: as its true type.
Stages stages_of(const Evaluation& evaluation) {
    Stages s;
    for (const CharacterResult& c : evaluation.characters) {
        if (!c.labelled) continue;
        const bool skeleton = c.found && !c.identified.empty();
        ++s.all;
        s.detected += c.found;
        s.segmented += c.found && (c.mean_overlap() < 0 || c.mean_overlap() >= 0.5);
        s.skeleton += skeleton;
        s.identified += skeleton && c.identified == c.type;
        s.rigged += c.found && c.status == "ok";
    }
    return s;
}

// How many characters have a warning of each kind, in the order of the table.
std::array<int, warning_count> warnings_of(const Evaluation& evaluation) {
    std::array<int, warning_count> counts{};
    for (const CharacterResult& c : evaluation.characters)
        for (const Warning& warning : c.warnings) ++counts[static_cast<std::size_t>(warning.kind)];
    return counts;
}

std::vector<std::string_view> kinds_of(const std::vector<Warning>& warnings) {
    std::vector<std::string_view> kinds;
    for (const Warning& warning : warnings) kinds.push_back(row_of(warning.kind).name);
    return kinds;
}

int unlabelled_pages(const Evaluation& e) { return e.pages - static_cast<int>(e.labelled_pages.size()); }

int false_characters(const Evaluation& evaluation) {
    int count = 0;
    for (const FoundCharacter& f : evaluation.found) count += f.mask_overlap < 0.5;
    return count;
}

std::string line(const char* format, auto... values) {
    char text[512];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

// A number of a table: three digits, "–" for none.
std::string cell(double value) { return std::isnan(value) ? "     –" : line("%6.3f", value); }

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text)
        out += c == '<'   ? "&lt;"
               : c == '>' ? "&gt;"
               : c == '&' ? "&amp;"
               : c == '"' ? "&quot;"
                          : std::string(1, c);
    return out;
}

Json number_or_null(double value) { return std::isnan(value) ? Json(nullptr) : Json(value); }

} // namespace

std::string evaluation_to_text(const Evaluation& e) {
    const Stages s = stages_of(e);
    std::string text =
        line("%d pages, %d characters, %zu found\n", e.pages, s.all, e.found.size());
    if (const int others = unlabelled_pages(e); others > 0)
        text += line("%d without a label map: they count in the table of types alone\n", others);
    text += "\ndetection\n";
    for (const bool by_mask : {true, false})
        text += line("  %-24s AP50 %s  AP75 %s\n", by_mask ? "detector's mask" : "silhouette",
                     cell(average_precision(e, 0.5, by_mask)).c_str(),
                     cell(average_precision(e, 0.75, by_mask)).c_str());
    text += line("  missed %d, false %d\n\nsegmentation%30s", s.all - s.detected, false_characters(e), "n");
    const std::vector<Column> columns = segmentation_columns();
    for (const Column& column : columns) text += line(" %10s", column.name.c_str());
    for (const auto& [name, members] : groups_of(e)) {
        text += line("\n  %-36s %3zu ", name.c_str(), members.size());
        for (const Column& column : columns) text += "     " + cell(mean_of(members, column.measure).value());
    }
    text += "\n\nidentification (rows: true type)\n";
    for (const auto& [type, answers] : confusion_of(e)) {
        text += line("  %-12s", type.c_str());
        for (const auto& [reference, count] : answers) text += line(" %s %d", reference.c_str(), count);
        text += "\n";
    }
    text += line("\nstages: of %d characters detected %d, segmented %d, with a skeleton %d, identified %d, "
                 "rigged %d\n",
                 s.all, s.detected, s.segmented, s.skeleton, s.identified, s.rigged);
    const auto marked =
        std::count_if(e.characters.begin(), e.characters.end(), [](auto& c) { return !c.warnings.empty(); });
    text += line("warnings: %td characters", marked);
    const std::array<int, warning_count> warnings = warnings_of(e);
    for (const WarningRow& row : warning_table)
        text += line(", %s %d", std::string(row.name).c_str(), warnings[static_cast<std::size_t>(row.kind)]);
    text += "\n";
    return text;
}

std::string evaluation_to_json(const Evaluation& e) {
    const Stages s = stages_of(e);
    Json json;
    json["pages"] = e.pages;
    json["unlabelled_pages"] = unlabelled_pages(e);
    json["characters"] = s.all;
    json["detection"] = {{"found", e.found.size()},
                         {"missed", s.all - s.detected},
                         {"false", false_characters(e)},
                         {"mask_ap50", number_or_null(average_precision(e, 0.5, true))},
                         {"mask_ap75", number_or_null(average_precision(e, 0.75, true))},
                         {"silhouette_ap50", number_or_null(average_precision(e, 0.5, false))},
                         {"silhouette_ap75", number_or_null(average_precision(e, 0.75, false))}};
    json["segmentation"] = Json::object();
    for (const auto& [name, members] : groups_of(e)) {
        Json& row = json["segmentation"][name];
        row["count"] = members.size();
        for (const Column& column : segmentation_columns())
            row[column.name] = number_or_null(mean_of(members, column.measure).value());
    }
    json["identification"] = Json::object();
    for (const auto& [type, answers] : confusion_of(e))
        for (const auto& [answer, count] : answers) json["identification"][type][answer] = count;
    json["stages"] = {{"detected", s.detected},
                      {"segmented", s.segmented},
                      {"skeleton", s.skeleton},
                      {"identified", s.identified},
                      {"rigged", s.rigged}};
    json["warnings"] = Json::object();
    const std::array<int, warning_count> warnings = warnings_of(e);
    for (const WarningRow& row : warning_table)
        json["warnings"][std::string(row.name)] = warnings[static_cast<std::size_t>(row.kind)];
    json["results"] = Json::array();
    for (const CharacterResult& c : e.characters)
        json["results"].push_back(
            {{"page", c.page},
             {"type", c.type},
             {"found", c.found},
             {"mask_overlap", c.mask_overlap},
             {"silhouette_overlap", c.silhouette_overlap},
             {"mean_overlap", c.mean_overlap() < 0 ? Json(nullptr) : Json(c.mean_overlap())},
             {"identified", c.identified},
             {"confidence", c.confidence},
             {"status", c.status},
             {"warnings", kinds_of(c.warnings)}});
    return to_json_text(json);
}

std::string evaluation_to_html(const Evaluation& e) {
    std::string html =
        "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>Evaluation</title>\n"
        "<style>body{font:14px sans-serif;margin:2em}td,th{padding:2px 10px;text-align:left}"
        "img{height:90px}pre{font-size:12px}.no{color:#b00}</style>\n<h1>Evaluation</h1>\n<pre>" +
        escaped(evaluation_to_text(e)) +
        "</pre>\n<table>\n<tr><th>page<th>type<th>drawing<th>detected<th>segmented<th>identified"
        "<th>rigged</tr>\n";
    const auto mark = [](bool good, const std::string& text) {
        return std::string(good ? "<td>✓ " : "<td class=\"no\">✗ ") + escaped(text);
    };
    const auto picture = [](const CharacterResult& c) {
        return c.found ? "<img loading=\"lazy\" src=\"pages/" + escaped(c.page) + "/" + escaped(c.folder) +
                             "/drawing.png\" alt=\"\">"
                       : std::string();
    };
    for (const CharacterResult& c : e.characters) {
        const double parts = c.mean_overlap();
        html += "<tr><td>" + escaped(c.page) + "<td>" + escaped(c.type) + "<td>" + picture(c) +
                mark(c.found, c.mask_overlap > 0 ? line("%.2f", c.mask_overlap) : "") +
                mark(c.found && (parts < 0 || parts >= 0.5), parts >= 0 ? line("%.2f", parts) : "") +
                mark(c.identified == c.type && c.found, c.identified) + mark(c.status == "ok", c.status) +
                "</tr>\n";
    }
    return html + "</table>\n</html>\n";
}

} // namespace pantin
