// pantin segment CHARACTER_DIR
#include "cli/command.hpp"

namespace pantin::cli {

void add_segment(CLI::App& app, Run& run) {
    add_folder_command(app, run, "segment", "step 2: the character to part labels", segment_folder);
}

} // namespace pantin::cli
