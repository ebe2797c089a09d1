// SPDX-License-Identifier: MIT
// Commands and their options. A thin front of CLI11, whose header takes longer to compile than a command:
// only arguments.cpp includes it.
#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace pantin::cli {

// What the user asked for; returns the exit code.
using Run = std::function<int()>;

// What --help knows, for man pages and completion.
struct OptionText {
    bool positional = false, required = false;
    bool takes_value = false, takes_many = false;
    std::string name;                                 // of a positional argument
    std::vector<std::string> short_names, long_names; // without dashes
    std::string type;                                 // "TEXT", "INT"; empty: a flag
    std::string allowed;                              // "INT in [16 - 4096]", "{png,jpg}"
    std::string default_value, environment, description;
};
struct CommandText {
    std::string name, description, footer;
    std::vector<OptionText> options;
    std::vector<CommandText> commands;
};

// A handle of an option that was just added; each call restricts or explains it.
class Option {
public:
    explicit Option(CLI::Option* option) : option_(option) {}
    Option required();
    Option range(int low, int high); // both allowed
    Option one_of(std::initializer_list<const char*> values);
    Option one_of(std::initializer_list<int> values);
    Option show_default();                // the variable's present value, in --help
    Option environment(const char* name); // the value when the option is not given
    Option separated_by(char delimiter);  // several values in one word
    Option hidden();                      // an old name, say: it works, but no help text has it

private:
    CLI::Option* option_;
};

// A handle of a command, or of the program itself. Names are CLI11's: "-o,--output"; without dashes: a
// positional argument.
class Command {
public:
    Command(CLI::App* app, Run* chosen) : app_(app), chosen_(chosen) {}
    Command subcommand(const std::string& name, const std::string& description);
    // The variables must outlive the parsing.
    Option option(const std::string& names, std::string& value, const std::string& description);
    Option option(const std::string& names, std::filesystem::path& value, const std::string& description);
    Option option(const std::string& names, int& value, const std::string& description);
    Option option(const std::string& names, double& value, const std::string& description);
    Option option(const std::string& names, std::vector<std::string>& values, const std::string& description);
    // One word a time: what follows is not taken for a further value.
    Option option(const std::string& names, std::vector<int>& values, const std::string& description);
    Option flag(const std::string& names, bool& value, const std::string& description);
    // Whatever follows the command is taken, and not looked at.
    void takes_anything();
    // What the command does when the user chose it.
    void run(const Run& action);
    CommandText text() const;

private:
    CLI::App* app_;
    Run* chosen_;
};

class Program {
public:
    // `footer` closes every help text.
    // `version` makes the text of --version when it is asked for.
    Program(const std::string& name, const std::string& description,
            const std::function<std::string()>& version, const std::string& footer);
    ~Program();
    Command command();
    // What to run: the chosen command, or one that prints help or version. Error(usage) when the command line
    // is wrong.
    Run parse(int argc, char** argv);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace pantin::cli
