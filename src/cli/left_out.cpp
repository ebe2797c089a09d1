// SPDX-License-Identifier: MIT
// Commands that a build for a small device leaves out (README, "Small builds").
#include "cli/command.hpp"

namespace pantin::cli {

void add_left_out(Command app, const std::string& name, const std::string& made_with) {
    Command command = app.subcommand(name, "left out of this build (" + made_with + ")");
    command.takes_anything();
    command.run([=]() -> int {
        throw Error(ErrorKind::usage,
                    name + ": left out of this build of the program, which was made with " + made_with);
    });
}

} // namespace pantin::cli
