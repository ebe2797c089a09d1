// SPDX-License-Identifier: MIT
// Built without yaml-cpp (`make YAML=0`): YAML files cannot be read.
#include "core/json.hpp"
#include "core/yaml.hpp"

#include "pantin/error.hpp"

namespace pantin {

bool yaml_available() { return false; }

Json parse_yaml(const std::string&, const std::string& source) {
    throw Error(ErrorKind::input, source + ": this pantin was built without YAML (make YAML=1)");
}

} // namespace pantin
