// SPDX-License-Identifier: MIT
// pantin completion SHELL: completion scripts from what --help knows.
#include <cstdio>
#include <memory>

#include "cli/command.hpp"

namespace pantin::cli {

namespace {

// All options of a command, "-o --output …".
std::vector<std::string> flags_of(const CommandText& command) {
    std::vector<std::string> flags;
    for (const OptionText& option : command.options) {
        for (const std::string& name : option.short_names) flags.push_back("-" + name);
        for (const std::string& name : option.long_names) flags.push_back("--" + name);
    }
    return flags;
}

std::string joined(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) line += (line.empty() ? "" : " ") + word;
    return line;
}

std::string command_names(const CommandText& app) {
    std::vector<std::string> names;
    for (const CommandText& sub : app.commands) names.push_back(sub.name);
    return joined(names);
}

std::string bash(const CommandText& app) {
    std::string text =
        "# bash completion for pantin\n_pantin() {\n    local current=${COMP_WORDS[COMP_CWORD]} words=\n"
        "    if [ \"$COMP_CWORD\" = 1 ]; then\n        words='" +
        command_names(app) + " " + joined(flags_of(app)) +
        "'\n    else\n"
        "        case ${COMP_WORDS[1]} in\n";
    for (const CommandText& sub : app.commands)
        text += "        " + sub.name + ") words='" + joined(flags_of(sub)) + "' ;;\n";
    return text + "        esac\n        [[ $current == -* ]] || words=\n    fi\n"
                  "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n}\ncomplete -o "
                  "default -F _pantin pantin\n";
}

std::string zsh(const CommandText& app) {
    std::string text = "#compdef pantin\nlocal -a commands\nif (( CURRENT == 2 )); then\n    commands=(" +
                       command_names(app) + " " + joined(flags_of(app)) +
                       ")\n    compadd -- $commands\n    return\nfi\ncase $words[2] in\n";
    for (const CommandText& sub : app.commands)
        text += sub.name + ") commands=(" + joined(flags_of(sub)) + ") ;;\n";
    return text + "esac\nif [[ $PREFIX == -* ]]; then\n    compadd -- $commands\nelse\n    _files\nfi\n";
}

std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    return out + "'";
}

// One line for each option; `where`: the condition under which it is offered.
std::string fish_options(const CommandText& command, const std::string& where) {
    std::string text;
    for (const OptionText& option : command.options) {
        if (option.positional) continue;
        text += "complete -c pantin -n " + where;
        for (const std::string& name : option.short_names) text += " -s " + name;
        for (const std::string& name : option.long_names) text += " -l " + name;
        text += std::string(option.takes_value ? " -r" : "") + " -d " + quoted(option.description) + "\n";
    }
    return text;
}

std::string fish(const CommandText& app) {
    std::string text = "# fish completion for pantin\n" + fish_options(app, "__fish_use_subcommand");
    for (const CommandText& sub : app.commands) {
        text += "complete -c pantin -n __fish_use_subcommand -f -a " + sub.name + " -d " +
                quoted(sub.description) + "\n";
        text += fish_options(sub, "'__fish_seen_subcommand_from " + sub.name + "'");
    }
    return text;
}

} // namespace

void add_completion(Command app) {
    const auto shell = std::make_shared<std::string>();
    Command command = app.subcommand("completion", "print a completion script");
    command.option("SHELL", *shell, "bash, zsh or fish").required().one_of({"bash", "zsh", "fish"});
    command.run([shell, app] {
        const CommandText program = app.text();
        const std::string text = *shell == "bash"  ? bash(program)
                                 : *shell == "zsh" ? zsh(program)
                                                   : fish(program);
        std::fputs(text.c_str(), stdout);
        return 0;
    });
}

} // namespace pantin::cli
