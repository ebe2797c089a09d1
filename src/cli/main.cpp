// SPDX-License-Identifier: MIT
// The program: parses the command line, runs one subcommand, turns errors into one line and an exit code.
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "cli/command.hpp"

namespace {

using namespace pantin;

constexpr int exit_internal = static_cast<int>(ErrorKind::internal);
constexpr int exit_output = static_cast<int>(ErrorKind::output);

constexpr const char* exit_codes =
    "Exit codes: 0 done, 1 internal error, 2 usage, 3 input unreadable or invalid,\n"
    "4 no character found, 5 weights missing or invalid, 6 output cannot be written,\n"
    "7 characters found but none could be animated, 8 results differ (verify).";

int run_command_line(int argc, char** argv) {
    cli::Program program("pantin",
                         "pantin: a drawing of a character goes in, an animated character comes out",
                         cli::version_text, exit_codes);
    const cli::Command app = program.command();
    cli::add_animate(app);
    cli::add_steps(app);
    cli::add_explain(app);
    cli::add_model(app);
    cli::add_manual(app);
    cli::add_completion(app);
    cli::add_evaluate(app);
    cli::add_options(app);
    cli::add_batch(app);
    cli::add_verify(app);
    return program.parse(argc, argv)();
}

int run_and_report(int argc, char** argv) {
    try {
        return run_command_line(argc, argv);
    } catch (const Error& error) {
        cli::print_error(error.what());
        return static_cast<int>(error.kind());
    } catch (const CharacterRejected& rejected) {
        cli::print_error(rejected.step() + ": " + rejected.what());
        return static_cast<int>(ErrorKind::not_animated);
    } catch (const std::bad_alloc&) {
        cli::print_error("out of memory");
        return exit_internal;
    } catch (const std::exception& error) {
        cli::print_error(std::string("internal error: ") + error.what());
        return exit_internal;
    }
}

} // namespace

int main(int argc, char** argv) {
    // A reader that goes away (`pantin --help | head -1`) is no error, and no reason to stop before the files
    // are done.
    std::signal(SIGPIPE, SIG_IGN);
#ifdef __GLIBC__
    // Large blocks go back to the system when they are freed. By default the limit rises with each one, and a
    // full-size network's tensors leave holes in the heap (432 instead of 520 MB).
    mallopt(M_MMAP_THRESHOLD, 4 << 20);
    // Smaller ones stay: the steps take and free them all the time, and new pages cost more than their work.
    mallopt(M_TRIM_THRESHOLD, 64 << 20);
    mallopt(M_TOP_PAD, 4 << 20);
#endif
    const int code = run_and_report(argc, argv);
    errno = 0;
    if (std::fflush(stdout) == 0 || errno == EPIPE || code != 0) return code;
    cli::print_error("standard output: cannot be written");
    return exit_output;
}
