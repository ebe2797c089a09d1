// SPDX-License-Identifier: MIT
// Errors that reach the user. A step throws `Error` with one line that names the file and the fact;
// the command line prints it on stderr and turns the kind into the exit code.
#pragma once

#include <stdexcept>
#include <string>

namespace pantin {

// The value is the exit code of the command line (README.md, "Exit codes").
enum class ErrorKind {
    internal = 1,     // an invariant of ours broke
    usage = 2,        // unknown option, missing argument, bad value
    input = 3,        // an input file is missing, unreadable or invalid
    no_character = 4, // the page holds no character
    weights = 5,      // weights missing or invalid
    output = 6,       // an output cannot be written
    not_animated = 7, // characters were found, but none could be animated
    differs = 8,      // `verify`: results are not those that they are compared with
};

class Error : public std::runtime_error {
public:
    // message: one line without its end, "file: place: fact". No error of its own.
    Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
    ErrorKind kind() const { return kind_; }

private:
    ErrorKind kind_;
};

// A character that cannot go on through the pipeline although input and program are in order: a head alone,
// a blob, a scribble. The pipeline writes `step: reason` into the character's status and goes on with the
// others.
class CharacterRejected : public std::runtime_error {
public:
    // step: the command that gives up ("identify"); reason: half a line, "a blob: …".
    CharacterRejected(std::string step, const std::string& reason)
        : std::runtime_error(reason), step_(std::move(step)) {}
    const std::string& step() const { return step_; }

private:
    std::string step_;
};

} // namespace pantin
