// SPDX-License-Identifier: MIT
// The page and its characters to the text of page.json, and back (thesis 4.2).
#include "formats/page_file.hpp"

#include <algorithm>

#include "core/file.hpp"
#include "formats/file_names.hpp"
#include "formats/json_values.hpp"

namespace pantin {

namespace {

TypeGuess read_guess(const JsonReader& reader) {
    return {reader.at("type").text(), reader.at("confidence").number(0, 1)};
}

void write_guess(Json& json, const TypeGuess& guess) {
    json["type"] = guess.type;
    json["confidence"] = guess.confidence;
}

Warning read_warning(const JsonReader& reader) {
    const std::string name = reader.at("kind").text();
    const auto row = std::find_if(warning_table.begin(), warning_table.end(),
                                  [&](const WarningRow& r) { return r.name == name; });
    if (row == warning_table.end()) reader.at("kind").fail("there is no warning '" + name + "'");
    return {row->kind, reader.at("value").number(0, 1), reader.at("text").text()};
}

Json warning_to_json(const Warning& warning) {
    Json json;
    json["kind"] = row_of(warning.kind).name;
    json["value"] = warning.value;
    json["text"] = warning.text;
    return json;
}

PageCharacter read_page_character(const JsonReader& reader) {
    PageCharacter character;
    character.folder = reader.at("folder").text();
    // The folder is opened and its files are replaced: it must lie directly below the page's folder.
    if (character.folder.empty() || character.folder[0] == '.' ||
        character.folder.find('/') != std::string::npos)
        reader.at("folder").fail("must be the name of a folder");
    const std::vector<JsonReader> box = reader.at("box").elements(4, 4);
    character.box = {read_int(box[0], 0, max_side), read_int(box[1], 0, max_side),
                     read_int(box[2], 1, max_side), read_int(box[3], 1, max_side)};
    character.scale = reader.at("scale").number(0, 1);
    character.score = reader.at("score").number(0, 1);
    character.status = reader.at("status").text();
    if (reader.has("exact_mask")) character.exact_mask = reader.at("exact_mask").boolean();
    if (reader.has("type")) character.found = read_guess(reader);
    if (reader.has("second")) character.second = read_guess(reader.at("second"));
    if (reader.has("warnings"))
        for (const JsonReader& warning : reader.at("warnings").elements(0, warning_count))
            character.warnings.push_back(read_warning(warning));
    return character;
}

// Four points [x, y].
SheetCorners read_sheet(const JsonReader& reader) {
    SheetCorners corners;
    const std::vector<JsonReader> points = reader.elements(4, 4);
    for (std::size_t i = 0; i < 4; ++i) {
        const std::vector<JsonReader> xy = points[i].elements(2, 2);
        corners[i] = {xy[0].number(-max_side, 2 * max_side), xy[1].number(-max_side, 2 * max_side)};
    }
    return corners;
}

} // namespace

std::string page_to_json(const Page& page) {
    Json json;
    json["source"] = page.source;
    if (page.sheet)
        for (Point2d corner : *page.sheet) json["sheet"].push_back(Json::array({corner.x, corner.y}));
    if (page.rotate != 0) json["rotate"] = page.rotate;
    json["width"] = page.width;
    json["height"] = page.height;
    json["detector"] = page.detector;
    if (!page.remarks.empty()) json["remarks"] = page.remarks;
    json["characters"] = Json::array();
    for (const PageCharacter& character : page.characters) {
        Json item;
        item["folder"] = character.folder;
        item["box"] =
            Json::array({character.box.x, character.box.y, character.box.width, character.box.height});
        item["scale"] = character.scale;
        item["score"] = character.score;
        item["status"] = character.status;
        if (character.exact_mask) item["exact_mask"] = true;
        if (character.found) write_guess(item, *character.found);
        if (character.second) write_guess(item["second"], *character.second);
        for (const Warning& warning : character.warnings)
            item["warnings"].push_back(warning_to_json(warning));
        json["characters"].push_back(item);
    }
    return to_json_text(json);
}

Page page_from_json(const std::string& text, const std::string& file) {
    const Json json = parse_json(text, file);
    const JsonReader reader(json, file);
    Page page;
    page.source = reader.at("source").text();
    if (reader.has("sheet")) page.sheet = read_sheet(reader.at("sheet"));
    if (reader.has("rotate")) page.rotate = read_int(reader.at("rotate"), 0, 270);
    page.width = read_int(reader.at("width"), 1, max_side);
    page.height = read_int(reader.at("height"), 1, max_side);
    page.detector = reader.at("detector").text();
    if (reader.has("remarks"))
        for (const JsonReader& remark : reader.at("remarks").elements())
            page.remarks.push_back(remark.text());
    for (const JsonReader& item : reader.at("characters").elements())
        page.characters.push_back(read_page_character(item));
    return page;
}

void write_page(const std::filesystem::path& out, const Page& page) {
    write_file(out / file_names::page, page_to_json(page));
}

Page read_page(const std::filesystem::path& file) { return page_from_json(read_text(file), file.string()); }

} // namespace pantin
