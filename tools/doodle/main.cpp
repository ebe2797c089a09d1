// SPDX-License-Identifier: MIT
// doodle: writes labelled drawings for training and tests. See --help.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "doodle/doodle.hpp"
#include "pantin/error.hpp"
#include "pantin/image.hpp"

namespace {

using namespace pantin;
using Json = nlohmann::ordered_json;

struct Arguments {
    std::string folder;
    int count = 100, first = 0;
    std::uint64_t seed = 1;
    std::string type = "mixed", types, scene, format = "png";
    bool desk = false;
    int per_page = 1, size = 320, height = 0;
    doodle::DoodleOptions options;
};

std::string name_of_page(int index) {
    char text[16];
    std::snprintf(text, sizeof text, "%06d", index);
    return text;
}

Json describe(const doodle::Character& c) {
    Json json = {{"type", c.type},
                 {"species", c.species},
                 {"pose", c.pose},
                 {"box", {c.box.x, c.box.y, c.box.width, c.box.height}}};
    if (c.limbs >= 0) json["limbs"] = c.limbs;
    return json;
}

// A list of types for every page, or the one type, or the three in turn.
std::vector<std::string> types_of_page(const Arguments& a, int index) {
    std::vector<std::string> types;
    std::istringstream list(a.types);
    for (std::string type; std::getline(list, type, ',');) types.push_back(type);
    if (!types.empty()) return types;
    const std::vector<std::string>& all = doodle::character_types();
    for (int k = 0; k < a.per_page; ++k)
        types.push_back(a.type == "mixed" ? all[static_cast<std::size_t>(index + k) % all.size()] : a.type);
    return types;
}

void save_picture(const Arguments& a, const std::string& id, const RgbImage& picture) {
    const std::filesystem::path file = std::filesystem::path(a.folder) / "image" / (id + "." + a.format);
    if (a.format == "png") return save_png(file, picture);
    const std::vector<unsigned char> bytes = doodle::encode_jpeg(picture);
    std::ofstream out(file, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!out.flush()) throw Error(ErrorKind::output, file.string() + ": cannot be written");
}

// A page of one character, of several, or a scene.
doodle::Page draw(const Arguments& a, const std::vector<std::string>& types, std::uint64_t seed,
                  const doodle::DoodleOptions& options) {
    if (!a.scene.empty()) return doodle::draw_scene(a.scene, seed, options);
    if (types.size() > 1) return doodle::draw_page(types, seed, options);
    const doodle::Doodle d = doodle::draw_character(types.front(), seed, options);
    return {d.picture, d.labels, foreground(d.labels), {d}, {}};
}

Json write_page(const Arguments& a, int index) {
    const std::uint64_t seed = a.seed * 1'000'003u + static_cast<std::uint64_t>(index);
    const std::vector<std::string> types = types_of_page(a, index);
    const std::filesystem::path folder = a.folder;
    const std::string id = name_of_page(index);
    Json row = {{"id", id}, {"seed", seed}, {"width", a.options.width}, {"height", a.options.height}};
    doodle::Page page = draw(a, types, seed, a.desk ? doodle::sheet_options(a.options) : a.options);
    if (a.desk) {
        save_png(folder / "flat" / (id + ".png"), page.picture);
        doodle::DeskPhoto photo = doodle::on_desk(page, seed, a.options.width, a.options.height);
        page = std::move(photo.page);
        for (const Point2d& corner : photo.corners) row["corners"].push_back({corner.x, corner.y});
    }
    save_picture(a, id, page.picture);
    save_png(folder / "label" / (id + ".png"), page.labels);
    if (types.size() == 1 && a.scene.empty()) {
        row.update(describe(page.characters.front()));
        return row;
    }
    save_png(folder / "instance" / (id + ".png"), page.instances);
    row["characters"] = Json::array();
    for (const doodle::Character& c : page.characters) row["characters"].push_back(describe(c));
    for (const doodle::Character& c : page.things) row["things"].push_back(describe(c));
    return row;
}

void run(const Arguments& a) {
    const std::filesystem::path folder = a.folder;
    for (const char* part : {"image", "label"}) std::filesystem::create_directories(folder / part);
    if (a.per_page > 1 || !a.types.empty() || !a.scene.empty())
        std::filesystem::create_directories(folder / "instance");
    if (a.desk) std::filesystem::create_directories(folder / "flat");
    std::ofstream index(folder / "index.ndjson", std::ios::binary);
    for (int i = a.first; i < a.first + a.count; ++i) index << write_page(a, i).dump() << '\n';
    index.flush();
    if (!index) throw Error(ErrorKind::output, (folder / "index.ndjson").string() + ": cannot be written");
}

} // namespace

int main(int argc, char** argv) {
    Arguments a;
    CLI::App app{"Draws labelled characters: OUT/image, OUT/label (value = part), OUT/instance (several on a "
                 "page), OUT/index.ndjson"};
    app.add_option("out", a.folder, "folder to write")->required();
    app.add_option("--count", a.count, "drawings")->check(CLI::Range(1, 1'000'000));
    app.add_option("--first", a.first, "number of the first drawing")->check(CLI::Range(0, 100'000'000));
    app.add_option("--seed", a.seed, "everything follows from it");
    app.add_option("--type", a.type,
                   "humanoid, quadruped, flying, mixed, other, head, blob, scribble or thing")
        ->check(CLI::IsMember(
            {"humanoid", "quadruped", "flying", "mixed", "other", "head", "blob", "scribble", "thing"}));
    app.add_option("--variety", a.options.variety,
                   "share of drawings of the species and in the manners of quick sketches")
        ->check(CLI::Range(0.0, 1.0));
    app.add_option("--species", a.options.species, "what exactly, e.g. dog");
    app.add_option("--per-page", a.per_page, "characters on one page")->check(CLI::Range(1, 64));
    app.add_option("--types", a.types, "what is on every page, e.g. humanoid,quadruped:dog,head");
    app.add_option("--scene", a.scene,
                   "a page as children draw it: family or animals, with things around them")
        ->check(CLI::IsMember(doodle::scene_kinds()));
    app.add_flag("--desk", a.desk,
                 "photographs of sheets on a desk; the sheet itself in OUT/flat, its corners in the index");
    app.add_option("--look", a.options.look,
                   "crayon, no-outline, tinted, grid, chalk or kraft; default: a pen on white")
        ->check(CLI::IsMember(doodle::looks()));
    app.add_option("--format", a.format, "of the pictures: png or jpg")->check(CLI::IsMember({"png", "jpg"}));
    app.add_option("--paper", a.options.paper, "share of the others that are on tinted or ruled paper")
        ->check(CLI::Range(0.0, 1.0));
    app.add_option("--tilt", a.options.tilt, "how much figures are turned (0: upright)")
        ->check(CLI::Range(0.0, 2.0));
    app.add_option("--size", a.size, "width in pixels, and height unless given")->check(CLI::Range(64, 4096));
    app.add_option("--height", a.height, "height in pixels")->check(CLI::Range(64, 4096));
    app.add_option("--photo", a.options.photo, "share of drawings that look photographed")
        ->check(CLI::Range(0.0, 1.0));
    app.add_option("--colour", a.options.colour, "share of drawings that are coloured in")
        ->check(CLI::Range(0.0, 1.0));
    app.add_option("--pen", a.options.pen, "pen width in pixels (0: random)")->check(CLI::Range(0.0, 64.0));
    app.add_option("--fill", a.options.fill, "size of the character in its area (0: random)")
        ->check(CLI::Range(0.0, 1.0));
    app.add_option("--gaps", a.options.gaps, "how much outlines are interrupted")
        ->check(CLI::Range(0.0, 2.0));
    CLI11_PARSE(app, argc, argv);
    a.options.width = a.size;
    a.options.height = a.height > 0 ? a.height : a.size;
    try {
        run(a);
    } catch (const Error& error) {
        std::cerr << "doodle: " << error.what() << '\n';
        return static_cast<int>(error.kind());
    } catch (const std::exception& error) {
        std::cerr << "doodle: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
