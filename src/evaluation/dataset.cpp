// SPDX-License-Identifier: MIT
// Reading a folder of drawings with truth.
#include <algorithm>
#include <sstream>

#include "core/file.hpp"
#include "core/json.hpp"
#include "core/json_reader.hpp"
#include "pantin/evaluation.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

std::string text_or_empty(const JsonReader& reader, const char* key) {
    return reader.has(key) ? reader.at(key).text() : "";
}

TrueCharacter read_character(const JsonReader& reader) {
    return {
        {}, text_or_empty(reader, "type"), text_or_empty(reader, "species"), text_or_empty(reader, "pose")};
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

Dataset::Dataset(const fs::path& folder) : folder_(folder) {
    const fs::path index = folder / "index.ndjson";
    std::istringstream lines(read_text(index));
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        const std::string place = index.string() + ":" + std::to_string(number);
        const Json json = parse_json(line, place);
        const JsonReader reader(json, place);
        Row row{reader.at("id").text(), {}};
        if (row.id.empty() || row.id.find('/') != std::string::npos || row.id.find("..") != std::string::npos)
            reader.at("id").fail("is no name of a file");
        if (reader.has("characters"))
            for (const JsonReader& item : reader.at("characters").elements(0, 64))
                row.characters.push_back(read_character(item));
        else
            row.characters.push_back(read_character(reader));
        rows_.push_back(std::move(row));
    }
    if (rows_.empty()) throw Error(ErrorKind::input, index.string() + ": lists no drawing");
}

TruePage Dataset::page(std::size_t index) const {
    const Row& row = rows_[index];
    TruePage page{row.id, folder_ / "image" / (row.id + ".png"), {}, row.characters};
    if (!fs::exists(page.image)) page.image.replace_extension(".jpg");
    const fs::path label = folder_ / "label" / (row.id + ".png"),
                   instance = folder_ / "instance" / (row.id + ".png");
    if (!fs::exists(label)) return page;
    page.labels = read_values(label);
    const Grid<std::uint8_t> numbers = fs::exists(instance) ? read_values(instance) : foreground(page.labels);
    if (numbers.width() != page.labels.width() || numbers.height() != page.labels.height())
        throw Error(ErrorKind::input, instance.string() + ": has another size than the label map");
    const int count = numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end());
    page.characters.resize(static_cast<std::size_t>(count));
    for (int k = 1; k <= count; ++k)
        page.characters[static_cast<std::size_t>(k) - 1].mask = where_equal(numbers, k);
    return page;
}

} // namespace pantin
