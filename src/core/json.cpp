// SPDX-License-Identifier: MIT
// JSON values to text and back, with the layout and the decimals of docs/formats.md (own).
#include "core/json.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/decimal.hpp"
#include "pantin/error.hpp"

namespace pantin {

namespace {

using Json = nlohmann::ordered_json;

// The library's own number printing is only nearly shortest, so numbers are printed here; strings by the
// library.
std::string scalar_text(const Json& value) {
    if (!value.is_number_float()) return value.dump(-1, ' ', false, Json::error_handler_t::replace);
    const double number = value.get<double>();
    if (!std::isfinite(number))
        throw Error(ErrorKind::internal, "a number without a JSON form reached a file");
    return to_decimal(number);
}

bool is_flat(const Json& array) {
    return std::none_of(array.begin(), array.end(), [](const Json& v) { return v.is_structured(); });
}

class Writer {
public:
    explicit Writer(bool compact) : compact_(compact) {}
    std::string text;

    void write(const Json& value, int depth) {
        if (value.is_object())
            write_object(value, depth);
        else if (value.is_array())
            write_array(value, depth);
        else
            text += scalar_text(value);
    }

private:
    bool compact_;

    void new_line(int depth) {
        if (!compact_) text += '\n' + std::string(2 * static_cast<std::size_t>(depth), ' ');
    }
    void write_object(const Json& object, int depth) {
        text += '{';
        bool first = true;
        for (const auto& [key, value] : object.items()) {
            if (!first) text += ',';
            first = false;
            new_line(depth + 1);
            text += scalar_text(Json(key)) + (compact_ ? ":" : ": ");
            write(value, depth + 1);
        }
        if (!first) new_line(depth);
        text += '}';
    }
    void write_array(const Json& array, int depth) {
        const bool one_line = is_flat(array);
        text += '[';
        bool first = true;
        for (const Json& value : array) {
            if (!first) text += one_line && !compact_ ? ", " : ",";
            first = false;
            if (!one_line) new_line(depth + 1);
            write(value, depth + 1);
        }
        if (!one_line) new_line(depth);
        text += ']';
    }
};

} // namespace

std::string to_json_text(const Json& value) {
    Writer writer(false);
    writer.write(value, 0);
    return writer.text + '\n';
}

std::string to_compact_json_text(const Json& value) {
    Writer writer(true);
    writer.write(value, 0);
    return writer.text;
}

Json parse_json(const std::string& text, const std::string& source) {
    try {
        return Json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
        const auto end = text.begin() + static_cast<long>(std::min(error.byte, text.size()));
        const auto line = 1 + std::count(text.begin(), end, '\n');
        throw Error(ErrorKind::input, source + ": not valid JSON (line " + std::to_string(line) + ")");
    } catch (const nlohmann::json::exception&) {
        throw Error(ErrorKind::input, source + ": not valid JSON");
    }
}

} // namespace pantin
