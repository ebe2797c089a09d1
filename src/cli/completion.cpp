// SPDX-License-Identifier: MIT
// pantin completion SHELL: completion scripts from what --help knows.
#include <cstdio>
#include <memory>

#include "cli/command.hpp"

namespace pantin::cli {

namespace {

// All options of a command, "-o --output …".
std::vector<std::string> flags_of(const CLI::App& command) {
    std::vector<std::string> flags;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_snames()) flags.push_back("-" + name);
        for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
    }
    return flags;
}

std::string joined(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) line += (line.empty() ? "" : " ") + word;
    return line;
}

std::string command_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* sub : app.get_subcommands(nullptr)) names.push_back(sub->get_name());
    return joined(names);
}

std::string bash(const CLI::App& app) {
    std::string text =
        "# bash completion for pantin\n_pantin() {\n    local current=${COMP_WORDS[COMP_CWORD]} words=\n"
        "    if [ \"$COMP_CWORD\" = 1 ]; then\n        words='" +
        command_names(app) + " " + joined(flags_of(app)) +
        "'\n    else\n"
        "        case ${COMP_WORDS[1]} in\n";
    for (const CLI::App* sub : app.get_subcommands(nullptr))
        text += "        " + sub->get_name() + ") words='" + joined(flags_of(*sub)) + "' ;;\n";
    return text + "        esac\n        [[ $current == -* ]] || words=\n    fi\n"
                  "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n}\ncomplete -o "
                  "default -F _pantin pantin\n";
}

std::string zsh(const CLI::App& app) {
    std::string text = "#compdef pantin\nlocal -a commands\nif (( CURRENT == 2 )); then\n    commands=(" +
                       command_names(app) + " " + joined(flags_of(app)) +
                       ")\n    compadd -- $commands\n    return\nfi\ncase $words[2] in\n";
    for (const CLI::App* sub : app.get_subcommands(nullptr))
        text += sub->get_name() + ") commands=(" + joined(flags_of(*sub)) + ") ;;\n";
    return text + "esac\nif [[ $PREFIX == -* ]]; then\n    compadd -- $commands\nelse\n    _files\nfi\n";
}

std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    return out + "'";
}

// One line for each option; `where`: the condition under which it is offered.
std::string fish_options(const CLI::App& command, const std::string& where) {
    std::string text;
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_positional()) continue;
        text += "complete -c pantin -n " + where;
        for (const std::string& name : option->get_snames()) text += " -s " + name;
        for (const std::string& name : option->get_lnames()) text += " -l " + name;
        text += std::string(option->get_expected_max() > 0 ? " -r" : "") + " -d " +
                quoted(option->get_description()) + "\n";
    }
    return text;
}

std::string fish(const CLI::App& app) {
    std::string text = "# fish completion for pantin\n" + fish_options(app, "__fish_use_subcommand");
    for (const CLI::App* sub : app.get_subcommands(nullptr)) {
        text += "complete -c pantin -n __fish_use_subcommand -f -a " + sub->get_name() + " -d " +
                quoted(sub->get_description()) + "\n";
        text += fish_options(*sub, "'__fish_seen_subcommand_from " + sub->get_name() + "'");
    }
    return text;
}

} // namespace

void add_completion(CLI::App& app, Run& run) {
    const auto shell = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand("completion", "print a completion script");
    command->add_option("SHELL", *shell, "bash, zsh or fish")
        ->required()
        ->check(CLI::IsMember({"bash", "zsh", "fish"}));
    command->callback([shell, &app, &run] {
        run = [shell, &app] {
            const std::string text = *shell == "bash" ? bash(app) : *shell == "zsh" ? zsh(app) : fish(app);
            std::fputs(text.c_str(), stdout);
            return 0;
        };
    });
}

} // namespace pantin::cli
