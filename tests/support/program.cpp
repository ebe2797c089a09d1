// SPDX-License-Identifier: MIT
#include "support/program.hpp"

#include <cstdlib>
#include <stdexcept>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/folders.hpp"

namespace pantin::test {

namespace {

std::string program() {
    const char* name = std::getenv("PANTIN");
    if (!name || !*name)
        throw std::runtime_error("the environment variable PANTIN must name the program (make test)");
    return std::filesystem::absolute(name).string();
}

[[noreturn]] void become(const std::string& file, const std::vector<std::string>& arguments,
                         const Environment& environment, const std::string& in, const std::string& out,
                         const std::string& err) {
    const int to_out = open(out.c_str(), O_WRONLY | O_CREAT, 0600),
              to_err = open(err.c_str(), O_WRONLY | O_CREAT, 0600);
    const int from_in = open(in.c_str(), O_RDONLY);
    if (from_in < 0 || to_out < 0 || to_err < 0) _exit(126);
    dup2(from_in, STDIN_FILENO);
    dup2(to_out, STDOUT_FILENO);
    dup2(to_err, STDERR_FILENO);
    unsetenv("PANTIN_WEIGHTS");
    for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
    std::vector<char*> argv{const_cast<char*>(file.c_str())};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    execv(file.c_str(), argv.data());
    _exit(127);
}

Outcome run(const std::string& file, const std::vector<std::string>& arguments,
            const Environment& environment, const std::string& standard_output,
            const std::string& standard_input) {
    const TemporaryFolder folder;
    const std::string err = (folder / "err").string();
    const std::string out = standard_output.empty() ? (folder / "out").string() : standard_output;
    const std::string in = (folder / "in").string();
    write(in, standard_input);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cannot fork");
    if (child == 0) become(file, arguments, environment, in, out, err);
    int status = 0;
    if (waitpid(child, &status, 0) != child) throw std::runtime_error("the program is lost");
    Outcome outcome;
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (standard_output.empty()) outcome.out = read(out);
    outcome.err = read(err);
    return outcome;
}

} // namespace

Outcome run_pantin(const std::vector<std::string>& arguments, const Environment& environment,
                   const std::string& standard_output, const std::string& standard_input) {
    return run(program(), arguments, environment, standard_output, standard_input);
}

Outcome run_shell(const std::string& script, const std::filesystem::path& folder) {
    const std::string head = "cd '" + folder.string() + "'\npantin() { '" + program() + "' \"$@\"; }\n";
    return run("/bin/sh", {"-e", "-u", "-c", head + script}, {}, "", "");
}

} // namespace pantin::test
