// pantin skeletonize CHARACTER_DIR
#include "cli/command.hpp"

namespace pantin::cli {

void add_skeletonize(CLI::App& app, Run& run) {
    add_folder_command(app, run, "skeletonize", "step 3: part labels to the skeleton", skeletonize_folder);
}

} // namespace pantin::cli
