// pantin rig CHARACTER_DIR
#include <memory>

#include "cli/command.hpp"

namespace pantin::cli {

void add_rig(CLI::App& app, Run& run) {
    const auto mapping = std::make_shared<std::string>();
    CLI::App* command = add_folder_command(app, run, "rig", "step 5: mesh, bones, weights and character.glb",
                                           [mapping](const std::filesystem::path& folder, Settings settings) {
                                               settings.mapping = *mapping;
                                               rig_folder(folder, settings);
                                           });
    command->add_option("--mapping", *mapping,
                        "mapping.json with the pairs of end-effectors to use instead of matching");
}

} // namespace pantin::cli
