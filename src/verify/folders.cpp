// SPDX-License-Identifier: MIT
// Two folders of results side by side, by the stages that made their files.
#include <algorithm>
#include <map>
#include <string_view>
#include <system_error>

#include "core/file.hpp"
#include "pantin/verify.hpp"
#include "verify/stage.hpp"

namespace pantin {

namespace {

namespace fs = std::filesystem;

constexpr const char* other_files = "other files";

// Files of `animate`, `model` and `render` that verification has no stage for: what their names begin and end
// with.
struct NamedFiles {
    std::string_view begin, end, stage;
};
constexpr NamedFiles more_files[] = {
    {"animation", ".bvh", "animate"}, {"animation", "", "render"},         {"scene", "", "render"},
    {"skeletons", "", "skeletonize"}, {"probability-", ".png", "segment"}, {"views.png", "", "unite"},
    {"model.", "", "bone heat"},
};

// The file's path without the folders above the character's own.
std::string own_name(const std::string& output) {
    return output.starts_with(character_path) ? output.substr(character_path.size()) : output;
}
bool is_path_end(const std::string& path, const std::string& end) {
    return path == end || path.ends_with("/" + end);
}

std::string stage_of(const std::string& file) {
    std::string stage;
    std::size_t longest = 0;
    for (const Stage& s : verified_stages())
        for (const std::string& output : s.outputs)
            if (const std::string name = own_name(output); is_path_end(file, name) && name.size() > longest) {
                longest = name.size();
                stage = s.name;
            }
    if (!stage.empty()) return stage;
    if (file.find("frames/") != std::string::npos) return "render";
    const std::string name = fs::path(file).filename().string();
    for (const NamedFiles& more : more_files)
        if (name.starts_with(more.begin) && name.ends_with(more.end)) return std::string(more.stage);
    return other_files;
}

std::map<std::string, fs::path> files_below(const fs::path& folder) {
    std::error_code error;
    if (!fs::is_directory(folder, error)) throw Error(ErrorKind::input, folder.string() + ": no such folder");
    std::map<std::string, fs::path> files;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        if (entry->is_regular_file(error))
            files[fs::path(entry->path()).lexically_relative(folder).generic_string()] = entry->path();
    if (error) throw Error(ErrorKind::input, folder.string() + ": cannot be read");
    if (files.empty()) throw Error(ErrorKind::input, folder.string() + ": holds no files");
    return files;
}

FileDifference one_sided(const std::string& file, bool in_first) {
    FileDifference difference;
    difference.file = file;
    difference.first = in_first ? "a file" : "missing";
    difference.second = in_first ? "missing" : "a file";
    difference.values = 1;
    return difference;
}

std::size_t rank(const std::string& stage) {
    const std::vector<Stage>& all = verified_stages();
    return static_cast<std::size_t>(
        std::find_if(all.begin(), all.end(), [&](const Stage& s) { return s.name == stage; }) - all.begin());
}

} // namespace

FolderComparison compare_folders(const fs::path& first, const fs::path& second) {
    const std::map<std::string, fs::path> a = files_below(first), b = files_below(second);
    std::map<std::string, std::string> names; // of both, with their stages
    for (const auto* files : {&a, &b})
        for (const auto& [name, path] : *files) names[name] = stage_of(name);
    FolderComparison comparison;
    comparison.files = static_cast<int>(names.size());
    std::map<std::pair<std::size_t, std::string>, std::vector<FileDifference>> by_stage;
    for (const auto& [name, stage] : names) {
        const auto in_a = a.find(name), in_b = b.find(name);
        std::optional<FileDifference> difference;
        if (in_a == a.end() || in_b == b.end())
            difference = one_sided(name, in_a != a.end());
        else
            difference = compare_files(name, read_text(in_a->second), read_text(in_b->second));
        if (difference) by_stage[{rank(stage), stage}].push_back(std::move(*difference));
    }
    for (auto& [stage, files] : by_stage) comparison.stages.push_back({stage.second, "", std::move(files)});
    return comparison;
}

} // namespace pantin
