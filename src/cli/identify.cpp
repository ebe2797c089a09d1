// pantin identify CHARACTER_DIR
#include "cli/command.hpp"

namespace pantin::cli {

void add_identify(CLI::App& app, Run& run) {
    add_folder_command(app, run, "identify", "step 4: the skeleton to the reference that it moves like",
                       identify_folder);
}

} // namespace pantin::cli
