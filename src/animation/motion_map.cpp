// SPDX-License-Identifier: MIT
// Names of joints given by hand (docs/formats.md, "Motions").
#include <algorithm>

#include "core/json_reader.hpp"
#include "core/suggestion.hpp"
#include "pantin/motion.hpp"

namespace pantin {

JointMap parse_motion_map(const std::string& text, const std::string& file) {
    const Json json = parse_json(text, file);
    const JsonReader reader(json, file);
    if (!json.is_object()) reader.fail("is no object of parts and joints");
    const std::vector<std::string> parts = motion_parts();
    JointMap map;
    for (const auto& [part, joint] : reader.entries()) {
        if (std::find(parts.begin(), parts.end(), part) == parts.end())
            reader.fail("'" + part + "' is no part of a body" + did_you_mean(part, parts));
        const std::string name = joint.text();
        if (part == "body" &&
            std::find(body_plan_names.begin(), body_plan_names.end(), name) == body_plan_names.end())
            joint.fail("must be humanoid, quadruped or bird");
        map.emplace_back(part, name);
    }
    return map;
}

} // namespace pantin
