// SPDX-License-Identifier: MIT
// The one file that includes CLI11 (see arguments.hpp).
#include "cli/arguments.hpp"

#include <algorithm>
#include <cstdio>
#include <sstream>

#include <CLI/CLI.hpp>

#include "core/suggestion.hpp"
#include "pantin/error.hpp"

namespace pantin::cli {

Option Option::required() { return option_->required(), *this; }
Option Option::range(int low, int high) { return option_->check(CLI::Range(low, high)), *this; }
Option Option::one_of(std::initializer_list<const char*> values) {
    const std::vector<std::string> names(values.begin(), values.end());
    const std::string set = "{" + CLI::detail::join(names, ",") + "}";
    const auto check = [names, set](std::string& value) {
        if (std::find(names.begin(), names.end(), value) != names.end()) return std::string();
        return value + " not in " + set + did_you_mean(value, names);
    };
    return option_->check(CLI::Validator(check, set)), *this;
}
Option Option::one_of(std::initializer_list<int> values) {
    return option_->check(CLI::IsMember(std::vector<int>(values))), *this;
}
Option Option::show_default() { return option_->capture_default_str(), *this; }
Option Option::environment(const char* name) { return option_->envname(name), *this; }
Option Option::separated_by(char delimiter) { return option_->delimiter(delimiter), *this; }
Option Option::hidden() { return option_->group(""), *this; }

Command Command::subcommand(const std::string& name, const std::string& description) {
    return {app_->add_subcommand(name, description), chosen_};
}
Option Command::option(const std::string& names, std::string& value, const std::string& description) {
    return Option(app_->add_option(names, value, description));
}
Option Command::option(const std::string& names, std::filesystem::path& value,
                       const std::string& description) {
    return Option(app_->add_option(names, value, description));
}
Option Command::option(const std::string& names, int& value, const std::string& description) {
    return Option(app_->add_option(names, value, description));
}
Option Command::option(const std::string& names, double& value, const std::string& description) {
    return Option(app_->add_option(names, value, description));
}
Option Command::option(const std::string& names, std::vector<int>& values, const std::string& description) {
    return Option(app_->add_option(names, values, description)->allow_extra_args(false));
}
Option Command::option(const std::string& names, std::vector<std::string>& values,
                       const std::string& description) {
    return Option(app_->add_option(names, values, description));
}
Option Command::flag(const std::string& names, bool& value, const std::string& description) {
    return Option(app_->add_flag(names, value, description));
}
void Command::takes_anything() { app_->allow_extras()->prefix_command(); }
void Command::run(const Run& action) {
    app_->callback([action, chosen = chosen_] { *chosen = action; });
}

namespace {

OptionText text_of(const CLI::Option& option) {
    OptionText text;
    text.positional = option.get_positional();
    text.required = option.get_required();
    text.takes_value = option.get_expected_max() > 0;
    text.takes_many = option.get_expected_max() > 1;
    if (text.positional) text.name = option.get_name(true);
    text.short_names = option.get_snames();
    text.long_names = option.get_lnames();
    const std::string type = option.get_type_name(); // "INT:INT in [16 - 4096]"
    const std::size_t colon = type.find(':');
    text.type = type.substr(0, colon);
    if (colon != std::string::npos) text.allowed = type.substr(colon + 1);
    text.default_value = option.get_default_str();
    text.environment = option.get_envname();
    text.description = option.get_description();
    return text;
}

CommandText text_of(const CLI::App& app) {
    CommandText text{app.get_name(), app.get_description(), app.get_footer(), {}, {}};
    for (const CLI::Option* option : app.get_options())
        if (!option->get_group().empty()) text.options.push_back(text_of(*option));
    for (const CLI::App* command : app.get_subcommands(nullptr)) text.commands.push_back(text_of(*command));
    return text;
}

} // namespace

CommandText Command::text() const { return text_of(*app_); }

struct Program::State {
    CLI::App app;
    Run chosen;
};

Program::Program(const std::string& name, const std::string& description,
                 const std::function<std::string()>& version, const std::string& footer)
    : state_(new State{CLI::App(description, name), {}}) {
    state_->app.set_version_flag("--version", version);
    state_->app.require_subcommand(1);
    state_->app.footer(footer);
}
Program::~Program() = default;

Command Program::command() { return {&state_->app, &state_->chosen}; }

namespace {

std::vector<std::string> names_of_commands(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
    return names;
}

std::vector<std::string> names_of_options(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        if (!option->get_group().empty())
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

// The first word of a refused command line that is no command or no option, as a message; empty when all are
// known, so that something else was wrong.
std::string unknown_word(const CLI::App& app, int argc, char** argv) {
    const CLI::App* command = &app;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i], name = word.substr(0, word.find('='));
        if (word == "--") break;
        if (word.starts_with("--")) {
            if (command->get_option_no_throw(name)) continue;
            const std::string help = command == &app ? "" : command->get_name() + " ";
            return "there is no option '" + name + "'" + did_you_mean(name, names_of_options(*command)) +
                   " (pantin " + help + "--help)";
        }
        if (command != &app || word.starts_with('-')) continue;
        const std::vector<std::string> commands = names_of_commands(app);
        if (std::find(commands.begin(), commands.end(), word) == commands.end())
            return "there is no command '" + word + "'" + did_you_mean(word, commands) + " (pantin --help)";
        command = app.get_subcommand(word);
    }
    return "";
}

} // namespace

Run Program::parse(int argc, char** argv) {
    try {
        state_->app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const bool wrong = error.get_exit_code() != 0;
        if (const std::string unknown = wrong ? unknown_word(state_->app, argc, argv) : ""; !unknown.empty())
            throw Error(ErrorKind::usage, unknown);
        if (wrong) throw Error(ErrorKind::usage, std::string(error.what()) + " (pantin --help)");
        std::ostringstream out, unused; // help or version
        state_->app.exit(error, out, unused);
        return [text = out.str()] { return std::fputs(text.c_str(), stdout), 0; };
    }
    return state_->chosen;
}

} // namespace pantin::cli
