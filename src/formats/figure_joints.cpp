// SPDX-License-Identifier: MIT
// char_cfg.yaml in, joints or the reason why there are none out (Smith et al. 2023, AnimatedDrawings).
#include "formats/figure_joints.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>

#include "core/file.hpp"
#include "core/json_reader.hpp"
#include "core/yaml.hpp"
#include "formats/animated_drawings.hpp"
#include "formats/file_names.hpp"
#include "pantin/error.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 20;
constexpr std::size_t most_joints = 256; // each costs time at every pixel

// The number that the text of a scalar is: 12, 012, +3.5, 1e3.
std::optional<double> number_of(const std::string& text) {
    const char *begin = text.data() + (text.starts_with('+') ? 1 : 0), *end = text.data() + text.size();
    double number = 0;
    const auto [last, error] = std::from_chars(begin, end, number);
    return error == std::errc() && last == end ? std::optional(number) : std::nullopt;
}

// The elements of the file's list; Error(input) when it has none.
Json skeleton_of(const fs::path& file) {
    Json config = parse_yaml(read_text(file, most_bytes), file.string());
    if (!config.contains("skeleton") || !config["skeleton"].is_array())
        throw Error(ErrorKind::input, file.string() + ": has no list \"skeleton\"");
    if (config["skeleton"].empty())
        throw Error(ErrorKind::input, file.string() + ": its list \"skeleton\" is empty");
    return config["skeleton"];
}

Point2d place_of(const JsonReader& joint, const std::string& name, int width, int height) {
    const auto fail = [&](const std::string& fact) {
        throw Error(ErrorKind::input, joint.file() + ": joint '" + name + "' " + fact);
    };
    const bool has_two =
        joint.has("loc") && joint.at("loc").value().is_array() && joint.at("loc").value().size() == 2;
    if (!has_two) fail("has no place of two numbers");
    double xy[2] = {0, 0};
    for (std::size_t k = 0; k < 2; ++k) {
        const Json& value = joint.at("loc").value()[k];
        const std::optional<double> number =
            value.is_string() ? number_of(value.get<std::string>()) : std::nullopt;
        if (!number) fail("has no place of two numbers");
        xy[k] = *number;
    }
    // A joint may lie a little outside of the picture.
    if (!(std::abs(xy[0]) <= 2.0 * width && std::abs(xy[1]) <= 2.0 * height))
        fail("lies far outside of texture.png");
    return {xy[0], xy[1]};
}

// Names stand in messages of one line.
std::string first_line(const std::string& text) { return text.substr(0, text.find_first_of("\r\n")); }

std::string name_of_joint(const JsonReader& joint) { return first_line(joint.at("name").text()); }

std::string parent_of(const JsonReader& joint) {
    if (!joint.has("parent") || !joint.at("parent").value().is_string()) return "";
    const std::string name = first_line(joint.at("parent").text());
    return name == "None" || name == "none" ? "" : name; // as Python writes it
}

// Parents by name; those that make no tree are taken away, and the first of them is remarked.
class Parents {
public:
    Parents(FigureJoints& figure, const std::string& file) : figure_(figure), file_(file) {}

    void find(const std::vector<std::string>& names) {
        for (std::size_t j = 0; j < names.size(); ++j) {
            const auto same = [&](const FigureJoint& other) { return other.name == names[j]; };
            if (names[j].empty()) continue;
            const auto found = std::find_if(figure_.joints.begin(), figure_.joints.end(), same);
            if (found == figure_.joints.end())
                remark(j, "hangs on '" + names[j] + "', which is not there");
            else
                figure_.joints[j].parent = static_cast<int>(found - figure_.joints.begin());
        }
        cut_cycles();
        std::set<std::string> seen;
        for (std::size_t j = 0; j < figure_.joints.size(); ++j)
            if (!seen.insert(figure_.joints[j].name).second) remark(j, "is given twice");
    }

private:
    void cut_cycles() {
        for (std::size_t j = 0; j < figure_.joints.size(); ++j) {
            int at = figure_.joints[j].parent;
            for (std::size_t steps = 0; at >= 0 && at != static_cast<int>(j) && steps < most_joints; ++steps)
                at = figure_.joints[static_cast<std::size_t>(at)].parent;
            if (at != static_cast<int>(j)) continue;
            figure_.joints[j].parent = -1;
            remark(j, "hangs on itself or on its own child");
        }
    }
    void remark(std::size_t joint, const std::string& fact) {
        if (figure_.remark.empty())
            figure_.remark = file_ + ": joint '" + figure_.joints[joint].name + "' " + fact;
    }

    FigureJoints& figure_;
    const std::string& file_;
};

} // namespace

fs::path joints_file(const fs::path& folder) {
    std::error_code ignored;
    const fs::path file = folder / file_names::animated_drawings_config;
    const fs::path other = folder / file_names::animated_drawings_config_short;
    return !fs::exists(file, ignored) && fs::exists(other, ignored) ? other : file;
}

FigureJoints read_joints(const fs::path& folder, int width, int height) {
    const fs::path file = joints_file(folder);
    FigureJoints figure;
    try {
        const Json skeleton = skeleton_of(file);
        std::vector<std::string> parents;
        for (const JsonReader& joint :
             JsonReader(skeleton, file.string(), "skeleton").elements(0, most_joints)) {
            const std::string name = name_of_joint(joint);
            parents.push_back(parent_of(joint));
            figure.joints.push_back({name, place_of(joint, name, width, height), -1});
        }
        Parents(figure, file.string()).find(parents);
    } catch (const Error& error) {
        return {{}, error.what()};
    }
    return figure;
}

bool names_humanoid(const fs::path& folder) {
    std::set<std::string> names;
    try {
        const fs::path file = joints_file(folder);
        const Json skeleton = skeleton_of(file);
        for (const JsonReader& joint :
             JsonReader(skeleton, file.string(), "skeleton").elements(0, most_joints))
            names.insert(name_of_joint(joint));
    } catch (const Error&) {
        return false; // read_joints() says why
    }
    return std::all_of(animated_drawings_joints.begin(), animated_drawings_joints.end(),
                       [&](const AnimatedDrawingsJoint& joint) { return names.count(joint.name) > 0; });
}

} // namespace pantin
