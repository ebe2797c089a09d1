// SPDX-License-Identifier: MIT
// pantin manual -o DIR: man pages from what --help knows, so that both always say the same.
#include <algorithm>
#include <memory>

#include "cli/command.hpp"
#include "core/file.hpp"
#include "pantin/version.hpp"

namespace pantin::cli {

namespace {

namespace fs = std::filesystem;

// Text for roff: a hyphen is a minus, a backslash and a dot at the start of a line are no commands.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n'))
            out += std::string("\\&") + c;
        else
            out += c;
    }
    return out;
}

// "-o, --output TEXT", or the name of a positional argument.
std::string heading(const OptionText& option) {
    if (option.positional) return "\\fI" + escaped(option.name) + "\\fR";
    std::string names;
    for (const std::string& name : option.short_names)
        names += (names.empty() ? "" : ", ") + ("\\fB\\-" + escaped(name) + "\\fR");
    for (const std::string& name : option.long_names)
        names += (names.empty() ? "" : ", ") + ("\\fB\\-\\-" + escaped(name) + "\\fR");
    if (option.takes_value) names += " \\fI" + escaped(option.type) + "\\fR";
    return names;
}

// What --help prints beside the name: range or choices, default, environment.
std::string facts(const OptionText& option) {
    std::vector<std::string> all;
    if (!option.allowed.empty()) all.push_back(option.allowed);
    if (!option.default_value.empty()) all.push_back("default: " + option.default_value);
    if (!option.environment.empty()) all.push_back("environment: " + option.environment);
    if (option.required && !option.positional) all.push_back("required");
    std::string text;
    for (const std::string& fact : all) text += (text.empty() ? " [" : "; ") + fact;
    return escaped(text.empty() ? "" : text + "]");
}

std::string synopsis(const CommandText& command, const std::string& name) {
    std::string line = "\\fB" + escaped(name) + "\\fR";
    if (!command.commands.empty()) return line + " \\fICOMMAND\\fR [\\fIOPTION\\fR]...";
    line += " [\\fIOPTION\\fR]...";
    for (const OptionText& option : command.options)
        if (option.positional)
            line += " \\fI" + escaped(option.name) + "\\fR" + (option.takes_many ? "..." : "");
    return line;
}

std::string page(const CommandText& app, const CommandText& command, bool whole) {
    const std::string name = whole ? app.name : app.name + " " + command.name;
    std::string dashed = name, title;
    std::replace(dashed.begin(), dashed.end(), ' ', '-');
    for (const char c : dashed) title += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    std::string text = ".TH \"" + escaped(title) +
                       "\" 1 \"" PANTIN_RELEASE_DATE "\" \"pantin " PANTIN_VERSION
                       "\" \"Pantin\"\n.SH NAME\n" +
                       escaped(dashed) + " \\- " + escaped(command.description) + "\n.SH SYNOPSIS\n" +
                       synopsis(command, name) + "\n";
    if (whole) {
        text += ".SH COMMANDS\n";
        for (const CommandText& sub : app.commands)
            text += ".TP\n\\fB" + escaped(sub.name) + "\\fR\n" + escaped(sub.description) +
                    "; see \\fBpantin\\-" + escaped(sub.name) + "\\fR(1)\n";
    }
    text += ".SH OPTIONS\n";
    for (const OptionText& option : command.options)
        text += ".TP\n" + heading(option) + "\n" + escaped(option.description) + facts(option) + "\n";
    text += ".SH EXIT STATUS\n.nf\n" + escaped(app.footer) + "\n.fi\n";
    if (!whole) text += ".SH SEE ALSO\n\\fBpantin\\fR(1)\n";
    return text;
}

} // namespace

void add_manual(Command app) {
    const auto out = std::make_shared<std::string>();
    Command command = app.subcommand("manual", "write the man pages");
    command.option("-o,--output", *out, "folder for pantin.1 and a page for each command").required();
    command.run([out, app] {
        const CommandText program = app.text();
        create_folder(*out);
        write_file(fs::path(*out) / "pantin.1", page(program, program, true));
        for (const CommandText& sub : program.commands)
            write_file(fs::path(*out) / ("pantin-" + sub.name + ".1"), page(program, sub, false));
        return 0;
    });
}

} // namespace pantin::cli
