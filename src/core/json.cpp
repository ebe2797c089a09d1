// SPDX-License-Identifier: MIT
// JSON values, their text, and parsing (by nlohmann::json, which this file alone includes).
#include "core/json.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/decimal.hpp"
#include "pantin/error.hpp"

namespace pantin {

// --- values
// ----------------------------------------------------------------------------------------------------------------------

struct Json::Content {
    std::string text;
    std::vector<std::string> keys; // of an object's values
    std::vector<Json> values;
};

namespace {

[[noreturn]] void wrong(const std::string& fact) { throw Error(ErrorKind::internal, "JSON: " + fact); }

bool is_member(const Json& value) { return value.is_array() && value.size() == 2 && value[0].is_string(); }

} // namespace

Json::Json(const char* text) : Json(std::string(text)) {}
Json::Json(const std::string& text) {
    become(Kind::string);
    content_->text = text;
}
Json::Json(std::initializer_list<Json> values) {
    if (std::all_of(values.begin(), values.end(), is_member)) {
        become(Kind::object);
        for (const Json& member : values) (*this)[member[0].text()] = member[1];
    } else {
        *this = array(values);
    }
}
Json Json::array(std::initializer_list<Json> values) {
    Json list;
    list.become(Kind::list);
    list.content_->values = values;
    return list;
}
Json Json::object() {
    Json object;
    object.become(Kind::object);
    return object;
}

Json::Json(const Json& other) : kind_(other.kind_), scalar_(other.scalar_) {
    if (other.content_) content_.reset(new Content(*other.content_));
}
Json::Json(Json&& other) noexcept
    : kind_(std::exchange(other.kind_, Kind::null)), scalar_(other.scalar_),
      content_(std::move(other.content_)) {}
Json& Json::operator=(Json other) noexcept {
    std::swap(kind_, other.kind_);
    std::swap(scalar_, other.scalar_);
    std::swap(content_, other.content_);
    return *this;
}
Json::~Json() = default;
void Json::Release::operator()(Content* content) const { delete content; }

void Json::become(Kind kind) {
    if (kind_ != Kind::null) wrong("not null, so it cannot become a list or an object");
    kind_ = kind;
    content_.reset(new Content());
}

const std::string& Json::text() const {
    return is_string() ? content_->text : (wrong("not a string"), content_->text);
}
bool Json::boolean() const { return is_boolean() ? scalar_.boolean : (wrong("not true or false"), false); }
double Json::real() const { return is_number_float() ? scalar_.real : (wrong("not a number"), 0.0); }

std::size_t Json::size() const { return content_ ? content_->values.size() : 0; }
const Json* Json::begin() const { return content_ ? content_->values.data() : nullptr; }
Json* Json::begin() { return content_ ? content_->values.data() : nullptr; }

const Json& Json::at(std::size_t index) const {
    if (index >= size()) wrong("no element " + std::to_string(index));
    return content_->values[index];
}
Json& Json::operator[](std::size_t index) {
    if (index >= size()) wrong("no element " + std::to_string(index));
    return content_->values[index];
}
void Json::push_back(Json value) {
    if (is_null()) become(Kind::list);
    if (!is_array()) wrong("not a list");
    content_->values.push_back(std::move(value));
}

const Json* Json::find(const std::string& key) const {
    if (!is_object()) return end();
    const auto& keys = content_->keys;
    return begin() + (std::find(keys.begin(), keys.end(), key) - keys.begin());
}
const Json& Json::at(const std::string& key) const {
    const Json* found = find(key);
    if (found == end()) wrong("no member '" + key + "'");
    return *found;
}
Json& Json::operator[](const std::string& key) {
    if (is_null()) become(Kind::object);
    if (!is_object()) wrong("not an object");
    const auto at = static_cast<std::size_t>(find(key) - begin());
    if (at == size()) {
        content_->keys.push_back(key);
        content_->values.emplace_back();
    }
    return content_->values[at];
}
Json Json::value(const std::string& key, const Json& otherwise) const {
    const Json* found = find(key);
    return found == end() ? otherwise : *found;
}

Json::Items::Iterator Json::Items::begin() const {
    return {json_.is_object() ? json_.content_->keys.data() : nullptr,
            json_.is_object() ? json_.begin() : nullptr};
}
Json::Items::Iterator Json::Items::end() const {
    return {nullptr, json_.is_object() ? json_.end() : nullptr};
}

bool Json::operator==(const Json& other) const {
    if (is_number() && other.is_number()) {
        if (kind_ == Kind::real || other.kind_ == Kind::real) return get<double>() == other.get<double>();
        const bool negative = kind_ == Kind::integer && scalar_.integer < 0;
        const bool other_negative = other.kind_ == Kind::integer && other.scalar_.integer < 0;
        return negative == other_negative && get<std::uint64_t>() == other.get<std::uint64_t>();
    }
    if (kind_ != other.kind_) return false;
    if (kind_ == Kind::boolean) return scalar_.boolean == other.scalar_.boolean;
    if (!content_) return true;
    return content_->text == other.content_->text && content_->keys == other.content_->keys &&
           content_->values == other.content_->values;
}

// --- text
// ------------------------------------------------------------------------------------------------------------------------

namespace {

// In quotes, with the escapes that RFC 8259 asks for; what is no UTF-8 is replaced.
std::string quoted(const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

bool is_flat(const Json& list) {
    return std::none_of(list.begin(), list.end(), [](const Json& v) { return v.is_structured(); });
}

// The shortest decimals that read back as the same number.
std::string number_text(double number) {
    if (!std::isfinite(number))
        throw Error(ErrorKind::internal, "a number without a JSON form reached a file");
    return to_decimal(number);
}

std::string scalar_text(const Json& value) {
    switch (value.kind()) {
    case Json::Kind::boolean:
        return value.get<bool>() ? "true" : "false";
    case Json::Kind::integer:
        return std::to_string(value.get<std::int64_t>());
    case Json::Kind::natural:
        return std::to_string(value.get<std::uint64_t>());
    case Json::Kind::real:
        return number_text(value.get<double>());
    case Json::Kind::string:
        return quoted(value.get<std::string>());
    default:
        return "null";
    }
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
            text += quoted(key) + (compact_ ? ":" : ": ");
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

// --- parsing
// ---------------------------------------------------------------------------------------------------------------------

namespace {

constexpr std::size_t deepest = 500; // values in values: ours lie no deeper than 10, and readers recurse

// Builds the value of the events of nlohmann's parser (its SAX interface; true: go on).
class Builder {
public:
    Builder(const std::string& source, Twice twice) : source_(source), twice_(twice) {}
    Json root;
    std::size_t error_at = 0; // byte

    bool null() { return add(Json()); }
    bool boolean(bool value) { return add(value); }
    bool number_integer(std::int64_t value) { return add(value); }
    bool number_unsigned(std::uint64_t value) { return add(value); }
    bool number_float(double value, const std::string&) { return add(value); }
    bool string(std::string& value) { return add(value); }
    bool binary(nlohmann::json::binary_t&) { return false; }
    bool start_object(std::size_t) { return open(Json::object()); }
    bool start_array(std::size_t) { return open(Json::array()); }
    bool end_object() { return open_.pop_back(), true; }
    bool end_array() { return open_.pop_back(), true; }
    bool key(std::string& name) {
        if (twice_ == Twice::is_an_error && open_.back()->contains(name))
            throw Error(ErrorKind::input, source_ + ": '" + name + "' occurs twice");
        key_ = name;
        return true;
    }
    bool parse_error(std::size_t at, const std::string&, const nlohmann::json::exception&) {
        return error_at = at, false;
    }

private:
    const std::string& source_;
    Twice twice_;
    std::vector<Json*> open_; // lists and objects, innermost last
    std::string key_;

    Json* place(Json value) {
        if (open_.empty()) return &(root = std::move(value));
        Json& parent = *open_.back();
        if (parent.is_object()) return &(parent[key_] = std::move(value));
        parent.push_back(std::move(value));
        return parent.end() - 1;
    }
    bool add(Json value) { return place(std::move(value)), true; }
    bool open(Json value) {
        if (open_.size() >= deepest) throw Error(ErrorKind::input, source_ + ": nested too deeply");
        open_.push_back(place(std::move(value)));
        return true;
    }
};

} // namespace

Json parse_json(const std::string& text, const std::string& source, Twice twice) {
    Builder builder(source, twice);
    if (nlohmann::json::sax_parse(text, &builder)) return std::move(builder.root);
    const auto end = text.begin() + static_cast<long>(std::min(builder.error_at, text.size()));
    const auto line = 1 + std::count(text.begin(), end, '\n');
    throw Error(ErrorKind::input, source + ": not valid JSON (line " + std::to_string(line) + ")");
}

bool is_utf8(const std::string& text) {
    try {
        nlohmann::json(text).dump();
        return true;
    } catch (const nlohmann::json::exception&) {
        return false;
    }
}

} // namespace pantin
