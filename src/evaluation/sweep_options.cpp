// SPDX-License-Identifier: MIT
// The text of --sweep in, options and their values out.
#include <algorithm>

#include "core/json.hpp"
#include "core/suggestion.hpp"
#include "pantin/error.hpp"
#include "pantin/sweep.hpp"

namespace pantin {

namespace {

constexpr std::size_t most_combinations = 1000;

[[noreturn]] void refuse(const std::string& fact) { throw Error(ErrorKind::usage, "--sweep: " + fact); }

std::string small_letters(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

// The option that is meant by its name or by the end of it.
std::string option_of(const std::string& given) {
    std::vector<std::string> names, ends;
    for (const auto& [name, value] : list_options(make_preset("default"))) {
        if (name == given) return name;
        names.push_back(name);
        if (name.ends_with("." + small_letters(given))) ends.push_back(name);
    }
    if (ends.size() == 1) return ends.front();
    if (ends.size() > 1) refuse("'" + given + "' may be '" + ends[0] + "' or '" + ends[1] + "'");
    refuse("there is no option '" + given + "'" + did_you_mean(given, names));
}

// A value as a configuration has it: numbers, true and false as they are, words in quotes.
std::string value_of(const std::string& name, const std::string& given) {
    std::string json = given;
    try {
        if (parse_json(given, name).is_structured()) refuse(name + ": '" + given + "' is no single value");
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::usage) throw;
        json = to_compact_json_text(Json(given));
    }
    try {
        Options options;
        apply_config_text(options, "{\"" + name + "\":" + json + "}", "--sweep");
    } catch (const Error& error) {
        throw Error(ErrorKind::usage, error.what());
    }
    return json;
}

void add_value(SweptOption& option, const std::string& given) {
    const std::string value = value_of(option.name, given);
    if (std::find(option.values.begin(), option.values.end(), value) != option.values.end())
        refuse(option.name + ": " + value + " stands twice");
    option.values.push_back(value);
}

std::string trimmed(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(' '), end = text.find_last_not_of(' ');
    return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

} // namespace

std::vector<SweptOption> parse_sweep(const std::string& text) {
    std::vector<SweptOption> options;
    std::size_t combinations = 1;
    std::string rest = text;
    std::replace(rest.begin(), rest.end(), ';', ',');
    for (std::size_t at = 0; at <= rest.size();) {
        const std::size_t comma = std::min(rest.find(',', at), rest.size());
        const std::string word = trimmed(rest.substr(at, comma - at));
        at = comma + 1;
        const std::size_t equals = word.find('=');
        if (equals == std::string::npos && options.empty())
            refuse("'" + word + "' is not option=value,value;option=value");
        if (equals != std::string::npos) {
            const std::string name = option_of(trimmed(word.substr(0, equals)));
            for (const SweptOption& option : options)
                if (option.name == name) refuse("'" + name + "' stands twice");
            options.push_back({name, {}});
        }
        add_value(options.back(), trimmed(equals == std::string::npos ? word : word.substr(equals + 1)));
    }
    for (const SweptOption& option : options)
        if ((combinations *= option.values.size()) > most_combinations)
            refuse("more than " + std::to_string(most_combinations) + " combinations");
    return options;
}

} // namespace pantin
