// SPDX-License-Identifier: MIT
// An evaluation as JSON, CSV and HTML.
#include <algorithm>
#include <cmath>

#include "core/csv.hpp"
#include "core/decimal.hpp"
#include "core/json.hpp"
#include "evaluation/cells.hpp"
#include "pantin/evaluation.hpp"

namespace pantin {

namespace {

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
Json hits_or_null(const Measurement& m) { return m.hits ? Json(*m.hits) : Json(nullptr); }
std::string number_or_nothing(double value) { return std::isnan(value) ? "" : to_decimal(value); }
// −1: not known.
std::string known(double value) { return value < 0 ? "" : to_decimal(value); }
std::string yes_or_no(bool value) { return value ? "true" : "false"; }

std::vector<std::string_view> kinds_of(const std::vector<Warning>& warnings) {
    std::vector<std::string_view> kinds;
    for (const Warning& warning : warnings) kinds.push_back(row_of(warning.kind).name);
    return kinds;
}

// "mask AP50" → "mask_ap50"
std::string key_of(std::string measure) {
    for (char& c : measure) c = c == ' ' ? '_' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return measure;
}

void add_tables(Json& json, const std::vector<Measurement>& rows) {
    for (const char* table : {"segmentation", "identification", "stages", "warnings"})
        json[table] = Json::object();
    for (const Measurement& m : rows) {
        if (m.table == "detection" && m.measure.find("AP") != std::string::npos)
            json["detection"][key_of(m.measure)] = number_or_null(m.value);
        else if (m.table == "detection" || m.table == "stages")
            json[m.table][m.measure] = hits_or_null(m);
        else if (m.table == "segmentation")
            json["segmentation"][m.group][m.measure == "characters" ? "count" : m.measure] =
                m.measure == "characters" ? Json(m.count) : number_or_null(m.value);
        else if (m.table == "identification" && m.group != "all")
            json["identification"][m.group][m.measure] = hits_or_null(m);
        else if (m.table == "warnings" && m.measure != "any")
            json["warnings"][m.measure] = hits_or_null(m);
    }
}

Json measurements_to_json(const std::vector<Measurement>& rows) {
    Json list = Json::array();
    for (const Measurement& m : rows)
        list.push_back({{"table", m.table},
                        {"group", m.group},
                        {"measure", m.measure},
                        {"value", number_or_null(m.value)},
                        {"low", number_or_null(m.interval.low)},
                        {"high", number_or_null(m.interval.high)},
                        {"count", m.count},
                        {"hits", hits_or_null(m)}});
    return list;
}

} // namespace

std::string evaluation_to_json(const Evaluation& e) {
    const std::vector<Measurement> rows = measurements_of(e);
    Json json;
    json["pages"] = e.pages;
    json["unlabelled_pages"] = unlabelled_pages(e);
    json["unanswered_pages"] = e.unanswered_pages;
    json["characters"] = labelled_characters(e);
    json["detection"] = {{"found", e.found.size()}};
    add_tables(json, rows);
    json["measurements"] = measurements_to_json(rows);
    json["results"] = Json::array();
    for (const CharacterResult& c : e.characters)
        json["results"].push_back(
            {{"page", c.page},
             {"type", c.type},
             {"found", c.found},
             {"mask_overlap", c.mask_overlap},
             {"silhouette_overlap", c.silhouette_overlap},
             {"mean_overlap", c.mean_overlap() < 0 ? Json(nullptr) : Json(c.mean_overlap())},
             {"parts", c.ends.parts},
             {"parts_with_end", c.ends.reached},
             {"limbs_known", c.ends.limbs_known},
             {"identified", c.identified},
             {"confidence", c.confidence},
             {"status", c.status},
             {"warnings", kinds_of(c.warnings)}});
    return to_json_text(json);
}

std::string measurements_to_csv(const std::vector<Measurement>& rows) {
    std::string text = csv_line({"table", "group", "measure", "value", "low", "high", "count", "hits"});
    for (const Measurement& m : rows)
        text += csv_line({m.table, m.group, m.measure, number_or_nothing(m.value),
                          number_or_nothing(m.interval.low), number_or_nothing(m.interval.high),
                          std::to_string(m.count), m.hits ? std::to_string(*m.hits) : ""});
    return text;
}

std::string characters_to_csv(const Evaluation& e) {
    std::vector<std::string> heads = {
        "page", "type", "species", "labelled", "found", "mask_overlap", "silhouette_overlap", "mean_overlap"};
    for (int part = 1; part < label_count; ++part) heads.emplace_back(label_names[part]);
    for (const char* head : {"pixels", "router", "pose", "parts", "parts_with_end", "limbs_known",
                             "identified", "confidence", "status", "warnings"})
        heads.emplace_back(head);
    std::string text = csv_line(heads);
    for (const CharacterResult& c : e.characters) {
        std::vector<std::string> cells = {c.page,
                                          c.type,
                                          c.species,
                                          yes_or_no(c.labelled),
                                          yes_or_no(c.found),
                                          to_decimal(c.mask_overlap),
                                          to_decimal(c.silhouette_overlap),
                                          known(c.mean_overlap())};
        for (int part = 1; part < label_count; ++part) cells.push_back(known(c.part_overlap[part]));
        std::string kinds;
        for (const std::string_view kind : kinds_of(c.warnings))
            kinds += (kinds.empty() ? "" : " ") + std::string(kind);
        for (const std::string& cell :
             {to_decimal(c.pixel_accuracy), known(c.expert_right), known(c.pose_right),
              std::to_string(c.ends.parts), std::to_string(c.ends.reached), yes_or_no(c.ends.limbs_known),
              c.identified, to_decimal(c.confidence), c.status, kinds})
            cells.push_back(cell);
        text += csv_line(cells);
    }
    return text;
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
        return c.found && !c.folder.empty() ? "<img loading=\"lazy\" src=\"pages/" + escaped(c.page) + "/" +
                                                  escaped(c.folder) + "/drawing.png\" alt=\"\">"
                                            : std::string();
    };
    for (const CharacterResult& c : e.characters) {
        const double parts = c.mean_overlap();
        html += "<tr><td>" + escaped(c.page) + "<td>" + escaped(c.type) + "<td>" + picture(c) +
                mark(c.found, c.mask_overlap > 0 ? printed("%.2f", c.mask_overlap) : "") +
                mark(c.found && (parts < 0 || parts >= 0.5), parts >= 0 ? printed("%.2f", parts) : "") +
                mark(c.identified == c.type && c.found, c.identified) + mark(c.status == "ok", c.status) +
                "</tr>\n";
    }
    return html + "</table>\n</html>\n";
}

} // namespace pantin
