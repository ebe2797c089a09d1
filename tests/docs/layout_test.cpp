// SPDX-License-Identifier: MIT
// The source layout is what README says: every module of src stands in the line of the flow, and no file
// includes from a module that comes later.
#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include "core/file.hpp"

using namespace pantin;

namespace {

namespace fs = std::filesystem;

std::vector<std::string> modules_of(const std::string& readme) {
    static const std::regex line("`(core → [^`]*)`");
    std::smatch found;
    REQUIRE(std::regex_search(readme, found, line));
    std::vector<std::string> modules;
    static const std::regex word("[a-z]+");
    const std::string flow = found[1];
    for (std::sregex_iterator i(flow.begin(), flow.end(), word), end; i != end; ++i)
        modules.push_back(i->str());
    return modules;
}

// The module of a path below `src`, or of what an #include names; empty for a library's header.
std::string module_of(const std::string& path) { return path.substr(0, path.find('/')); }

// "file: header" for each #include "module/…" of the text whose module comes after the file's.
std::vector<std::string> upward_includes(const std::string& file, const std::string& text,
                                         const std::vector<std::string>& modules) {
    const auto place = [&](const std::string& module) {
        return std::find(modules.begin(), modules.end(), module) - modules.begin();
    };
    static const std::regex include("(^|\n)#include \"([^\"]+)\"");
    std::vector<std::string> found;
    for (std::sregex_iterator i(text.begin(), text.end(), include), end; i != end; ++i) {
        const std::string header = (*i)[2], module = module_of(header);
        const bool is_module = std::find(modules.begin(), modules.end(), module) != modules.end();
        if (is_module && place(module) > place(module_of(file))) found.push_back(file + ": " + header);
    }
    return found;
}

} // namespace

TEST_CASE("No module includes a later one, and README names every module", "[docs]") {
    const std::vector<std::string> modules = modules_of(read_text("README.md"));
    std::set<std::string> folders;
    for (const auto& entry : fs::directory_iterator("src"))
        if (entry.is_directory()) folders.insert(entry.path().filename().string());
    CHECK(folders == std::set<std::string>(modules.begin(), modules.end()));
    for (const auto& entry : fs::recursive_directory_iterator("src")) {
        const std::string file = fs::relative(entry.path(), "src").generic_string();
        if (!file.ends_with(".cpp") && !file.ends_with(".hpp")) continue;
        CHECK(upward_includes(file, read_text(entry.path().string()), modules) == std::vector<std::string>{});
    }
}

TEST_CASE("An upward include is seen", "[docs]") {
    const std::string text = "#include <string>\n#include \"core/json.hpp\"\n#include \"rigging/rig.hpp\"\n";
    CHECK(upward_includes("image/a.cpp", text, {"core", "image", "rigging"}) ==
          std::vector<std::string>{"image/a.cpp: rigging/rig.hpp"});
    CHECK(upward_includes("rigging/a.cpp", text, {"core", "image", "rigging"}).empty());
}
