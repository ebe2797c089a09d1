// SPDX-License-Identifier: MIT
// pantin options [PREFIX]: every option with its value in both presets.
#include <algorithm>
#include <cstdio>
#include <memory>

#include "cli/command.hpp"
#include "core/csv.hpp"
#include "core/json.hpp"
#include "core/suggestion.hpp"

namespace pantin::cli {

namespace {

struct Arguments {
    std::string prefix;
    bool csv = false, json = false;
};

struct Row {
    std::string name, ours, thesis; // values as JSON
    bool differs() const { return ours != thesis; }
};

std::vector<Row> rows_of(const std::string& prefix) {
    const auto ours = list_options(make_preset("default")), thesis = list_options(make_preset("thesis"));
    std::vector<Row> rows;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        names.push_back(ours[i].first);
        if (const std::string group = names.back().substr(0, names.back().find('.'));
            std::find(names.begin(), names.end(), group) == names.end())
            names.push_back(group);
        if (ours[i].first.starts_with(prefix))
            rows.push_back({ours[i].first, ours[i].second, thesis[i].second});
    }
    if (rows.empty())
        throw Error(ErrorKind::usage,
                    "there is no option that begins with '" + prefix + "'" + did_you_mean(prefix, names));
    return rows;
}

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(width, text.size()), ' ');
    return text;
}

std::string text_of(const std::vector<Row>& rows) {
    std::size_t name = 6, ours = 7; // of the headings
    for (const Row& row : rows)
        name = std::max(name, row.name.size()), ours = std::max(ours, row.ours.size());
    std::string text = "  " + padded("option", name) + "  " + padded("default", ours) + "  thesis\n";
    for (const Row& row : rows)
        text += std::string(row.differs() ? "* " : "  ") + padded(row.name, name) + "  " +
                padded(row.ours, ours) + "  " + row.thesis + "\n";
    const auto differing = std::count_if(rows.begin(), rows.end(), [](auto& row) { return row.differs(); });
    return text + "\n* differs: " + std::to_string(differing) + " of " + std::to_string(rows.size()) + "\n";
}

// A value without the quotes that JSON needs around words.
std::string plain(const std::string& value) {
    return value.starts_with('"') ? value.substr(1, value.size() - 2) : value;
}

std::string csv_of(const std::vector<Row>& rows) {
    std::string text = csv_line({"option", "default", "thesis", "differs"});
    for (const Row& row : rows)
        text += csv_line({row.name, plain(row.ours), plain(row.thesis), row.differs() ? "true" : "false"});
    return text;
}

std::string json_of(const std::vector<Row>& rows) {
    Json json = Json::object();
    for (const Row& row : rows)
        json[row.name] = {{"default", parse_json(row.ours, row.name)},
                          {"thesis", parse_json(row.thesis, row.name)},
                          {"differs", row.differs()}};
    return to_json_text(json);
}

int run_options(const Arguments& arguments) {
    if (arguments.csv && arguments.json) throw Error(ErrorKind::usage, "--csv excludes --json");
    const std::vector<Row> rows = rows_of(arguments.prefix);
    const std::string text = arguments.csv ? csv_of(rows) : arguments.json ? json_of(rows) : text_of(rows);
    std::fputs(text.c_str(), stdout);
    return 0;
}

} // namespace

void add_options(Command app) {
    const auto arguments = std::make_shared<Arguments>();
    Command command = app.subcommand("options", "every option of --config with its value in both presets");
    command.option("PREFIX", arguments->prefix, "only those that begin so, e.g. identification");
    command.flag("--csv", arguments->csv, "as comma-separated values");
    command.flag("--json", arguments->json, "as JSON");
    command.run([arguments] { return run_options(*arguments); });
}

} // namespace pantin::cli
