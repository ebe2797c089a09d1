// SPDX-License-Identifier: MIT
// The one file that includes CLI11 (see arguments.hpp).
#include "cli/arguments.hpp"

#include <cstdio>
#include <sstream>

#include <CLI/CLI.hpp>

#include "pantin/error.hpp"

namespace pantin::cli {

Option Option::required() { return option_->required(), *this; }
Option Option::range(int low, int high) { return option_->check(CLI::Range(low, high)), *this; }
Option Option::one_of(std::initializer_list<const char*> values) {
    return option_->check(CLI::IsMember(std::vector<std::string>(values.begin(), values.end()))), *this;
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

Program::Program(const std::string& name, const std::string& description, const std::string& version,
                 const std::string& footer)
    : state_(new State{CLI::App(description, name), {}}) {
    state_->app.set_version_flag("--version", version);
    state_->app.require_subcommand(1);
    state_->app.footer(footer);
}
Program::~Program() = default;

Command Program::command() { return {&state_->app, &state_->chosen}; }

Run Program::parse(int argc, char** argv) {
    try {
        state_->app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0)
            throw Error(ErrorKind::usage, std::string(error.what()) + " (pantin --help)");
        std::ostringstream out, unused; // help or version
        state_->app.exit(error, out, unused);
        return [text = out.str()] { return std::fputs(text.c_str(), stdout), 0; };
    }
    return state_->chosen;
}

} // namespace pantin::cli
