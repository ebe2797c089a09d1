// SPDX-License-Identifier: MIT
// Reading a folder of drawings with truth.
#include <algorithm>
#include <sstream>

#include "core/file.hpp"
#include "core/json.hpp"
#include "core/json_reader.hpp"
#include "evaluation/dataset_files.hpp"
#include "pantin/evaluation.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

std::string text_or_empty(const JsonReader& reader, const char* key) {
    return reader.has(key) ? reader.at(key).text() : "";
}

TrueCharacter read_character(const JsonReader& reader) {
    return {{},
            text_or_empty(reader, "type"),
            text_or_empty(reader, "species"),
            text_or_empty(reader, "pose"),
            reader.has("limbs") ? static_cast<int>(reader.at("limbs").integer(0, 1000)) : -1};
}

double read_score(const JsonReader& reader) {
    return reader.has("score") ? reader.at("score").number(0, 1) : 1;
}

// A grey PNG whose values are labels or numbers.
Grid<std::uint8_t> read_values(const fs::path& file) {
    const RgbImage image = load_image(file);
    Grid<std::uint8_t> values(image.width(), image.height());
    std::transform(image.begin(), image.end(), values.begin(), [](const Rgb8& pixel) { return pixel.r; });
    return values;
}

Mask where_equal(const Grid<std::uint8_t>& values, int value) {
    Mask mask(values.width(), values.height());
    std::transform(values.begin(), values.end(), mask.begin(),
                   [&](std::uint8_t v) -> std::uint8_t { return v == value; });
    return mask;
}

} // namespace

std::vector<IndexRow> read_index(const fs::path& index) {
    std::vector<IndexRow> rows;
    std::istringstream lines(read_text(index));
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        const std::string place = index.string() + ":" + std::to_string(number);
        const Json json = parse_json(line, place);
        const JsonReader reader(json, place);
        IndexRow row{reader.at("id").text(), {}, {}};
        if (row.id.empty() || row.id.find('/') != std::string::npos || row.id.find("..") != std::string::npos)
            reader.at("id").fail("is no name of a file");
        std::vector<JsonReader> items{reader};
        if (reader.has("characters")) items = reader.at("characters").elements(0, 64);
        for (const JsonReader& item : items) {
            row.characters.push_back(read_character(item));
            row.scores.push_back(read_score(item));
        }
        rows.push_back(std::move(row));
    }
    if (rows.empty()) throw Error(ErrorKind::input, index.string() + ": lists no drawing");
    return rows;
}

PagePictures read_pictures(const fs::path& folder, const std::string& id) {
    const fs::path label = folder / "label" / (id + ".png"), instance = folder / "instance" / (id + ".png");
    PagePictures pictures;
    if (fs::exists(label)) pictures.labels = read_values(label);
    if (pictures.labels.empty() && !fs::exists(instance)) return pictures;
    const Grid<std::uint8_t> numbers =
        fs::exists(instance) ? read_values(instance) : foreground(pictures.labels);
    if (!pictures.labels.empty() &&
        (numbers.width() != pictures.labels.width() || numbers.height() != pictures.labels.height()))
        throw Error(ErrorKind::input, instance.string() + ": has another size than the label map");
    const int count = numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end());
    for (int k = 1; k <= count; ++k) pictures.masks.push_back(where_equal(numbers, k));
    return pictures;
}

Dataset::Dataset(const fs::path& folder) : folder_(folder) {
    for (IndexRow& row : read_index(folder / "index.ndjson"))
        rows_.push_back({std::move(row.id), std::move(row.characters)});
}

TruePage Dataset::page(std::size_t index) const {
    const Row& row = rows_[index];
    TruePage page{row.id, folder_ / "image" / (row.id + ".png"), {}, row.characters};
    if (!fs::exists(page.image)) page.image.replace_extension(".jpg");
    if (!fs::exists(folder_ / "label" / (row.id + ".png"))) return page;
    PagePictures pictures = read_pictures(folder_, row.id);
    page.labels = std::move(pictures.labels);
    page.characters.resize(pictures.masks.size());
    for (std::size_t k = 0; k < pictures.masks.size(); ++k)
        page.characters[k].mask = std::move(pictures.masks[k]);
    return page;
}

} // namespace pantin
