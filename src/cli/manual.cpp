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
std::string heading(const CLI::Option& option) {
    if (option.get_positional()) return "\\fI" + escaped(option.get_name(true)) + "\\fR";
    std::string names;
    for (const std::string& name : option.get_snames())
        names += (names.empty() ? "" : ", ") + ("\\fB\\-" + escaped(name) + "\\fR");
    for (const std::string& name : option.get_lnames())
        names += (names.empty() ? "" : ", ") + ("\\fB\\-\\-" + escaped(name) + "\\fR");
    const std::string type = option.get_type_name(); // "INT:INT in [16 - 4096]"
    if (option.get_expected_max() > 0) names += " \\fI" + escaped(type.substr(0, type.find(':'))) + "\\fR";
    return names;
}

// What --help prints beside the name: range or choices, default, environment.
std::string facts(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    const std::size_t colon = type.find(':');
    std::vector<std::string> all;
    if (colon != std::string::npos) all.push_back(type.substr(colon + 1));
    if (!option.get_default_str().empty()) all.push_back("default: " + option.get_default_str());
    if (!option.get_envname().empty()) all.push_back("environment: " + option.get_envname());
    if (option.get_required() && !option.get_positional()) all.push_back("required");
    std::string text;
    for (const std::string& fact : all) text += (text.empty() ? " [" : "; ") + fact;
    return escaped(text.empty() ? "" : text + "]");
}

std::string synopsis(const CLI::App& command, const std::string& name) {
    std::string line = "\\fB" + escaped(name) + "\\fR";
    if (!command.get_subcommands(nullptr).empty()) return line + " \\fICOMMAND\\fR [\\fIOPTION\\fR]...";
    line += " [\\fIOPTION\\fR]...";
    for (const CLI::Option* option : command.get_options())
        if (option->get_positional())
            line += " \\fI" + escaped(option->get_name(true)) + "\\fR" +
                    (option->get_expected_max() > 1 ? "..." : "");
    return line;
}

std::string page(const CLI::App& app, const CLI::App& command, bool whole) {
    const std::string name = whole ? app.get_name() : app.get_name() + " " + command.get_name();
    std::string dashed = name, title;
    std::replace(dashed.begin(), dashed.end(), ' ', '-');
    for (const char c : dashed) title += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    std::string text = ".TH \"" + escaped(title) +
                       "\" 1 \"" PANTIN_RELEASE_DATE "\" \"pantin " PANTIN_VERSION
                       "\" \"Pantin\"\n.SH NAME\n" +
                       escaped(dashed) + " \\- " + escaped(command.get_description()) + "\n.SH SYNOPSIS\n" +
                       synopsis(command, name) + "\n";
    if (whole) {
        text += ".SH COMMANDS\n";
        for (const CLI::App* sub : app.get_subcommands(nullptr))
            text += ".TP\n\\fB" + escaped(sub->get_name()) + "\\fR\n" + escaped(sub->get_description()) +
                    "; see \\fBpantin\\-" + escaped(sub->get_name()) + "\\fR(1)\n";
    }
    text += ".SH OPTIONS\n";
    for (const CLI::Option* option : command.get_options())
        text +=
            ".TP\n" + heading(*option) + "\n" + escaped(option->get_description()) + facts(*option) + "\n";
    text += ".SH EXIT STATUS\n.nf\n" + escaped(app.get_footer()) + "\n.fi\n";
    if (!whole) text += ".SH SEE ALSO\n\\fBpantin\\fR(1)\n";
    return text;
}

} // namespace

void add_manual(CLI::App& app, Run& run) {
    const auto out = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand("manual", "write the man pages");
    command->add_option("-o,--output", *out, "folder for pantin.1 and a page for each command")->required();
    command->callback([out, &app, &run] {
        run = [out, &app] {
            create_folder(*out);
            write_file(fs::path(*out) / "pantin.1", page(app, app, true));
            for (const CLI::App* sub : app.get_subcommands(nullptr))
                write_file(fs::path(*out) / ("pantin-" + sub->get_name() + ".1"), page(app, *sub, false));
            return 0;
        };
    });
}

} // namespace pantin::cli
