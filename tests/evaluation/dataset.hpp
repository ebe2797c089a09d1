// SPDX-License-Identifier: MIT
// Pages of the generator as a dataset, as tools/doodle writes them.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

#include "doodle/doodle.hpp"
#include "pantin/image.hpp"

namespace pantin::test {

inline void write_dataset(const std::filesystem::path& folder, int pages = 2) {
    doodle::DoodleOptions options;
    options.width = 400;
    options.height = 300;
    options.photo = options.paper = options.colour = 0;
    for (const char* part : {"image", "label", "instance"})
        std::filesystem::create_directories(folder / part);
    std::ofstream index(folder / "index.ndjson");
    for (int number = 1; number <= pages; ++number) {
        const std::string id = "page-" + std::to_string(number);
        const doodle::Page page = doodle::draw_page({"humanoid", "quadruped"}, 40 + number, options);
        save_png(folder / "image" / (id + ".png"), page.picture);
        save_png(folder / "label" / (id + ".png"), page.labels);
        save_png(folder / "instance" / (id + ".png"), page.instances);
        nlohmann::json row = {{"id", id}, {"characters", nlohmann::json::array()}};
        for (const doodle::Character& c : page.characters)
            row["characters"].push_back(
                {{"type", c.type}, {"species", c.species}, {"pose", c.pose}, {"limbs", c.limbs}});
        index << row.dump() << "\n";
    }
}

} // namespace pantin::test
