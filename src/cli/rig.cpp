// pantin rig CHARACTER_DIR
#include "cli/command.hpp"

namespace pantin::cli {

void add_rig(CLI::App& app, Run& run) {
    add_folder_command(app, run, "rig", "step 5: mesh, bones, weights and character.glb", rig_folder);
}

} // namespace pantin::cli
