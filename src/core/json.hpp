// SPDX-License-Identifier: MIT
// JSON (RFC 8259) in our files: keys in the order of insertion, two-space indent, shortest round-trip
// decimals. A small value type of our own, because the header of nlohmann::json takes longer to compile than
// most of our files; json.cpp alone includes it, to parse.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/json.hpp"

namespace pantin {

// Null, true or false, a number, a string, a list or an object. Whatever asks a value for what it is not, or
// for an element that is not there, gets Error(internal): readers of files ask through JsonReader.
class Json {
public:
    enum class Kind : std::uint8_t { null, boolean, integer, natural, real, string, list, object };

    Json(std::nullptr_t = nullptr) {}
    template <std::same_as<bool> T> Json(T value) : kind_(Kind::boolean) { scalar_.boolean = value; }
    template <std::signed_integral T> Json(T value) : kind_(Kind::integer) { scalar_.integer = value; }
    template <std::unsigned_integral T>
    requires(!std::same_as<T, bool>) Json(T value) : kind_(Kind::natural) { scalar_.natural = value; }
    template <std::floating_point T> Json(T value) : kind_(Kind::real) { scalar_.real = value; }
    Json(const char* text);
    Json(const std::string& text);
    Json(std::string_view text) : Json(std::string(text)) {}
    template <class A, class B>
    Json(const std::pair<A, B>& values) : Json(array({values.first, values.second})) {}
    template <class T> Json(const std::vector<T>& values) : Json(list_of(values)) {}
    template <class T, std::size_t n> Json(const std::array<T, n>& values) : Json(list_of(values)) {}
    // {{"key", value}, ...} is an object, everything else in braces a list.
    Json(std::initializer_list<Json> values);
    static Json array(std::initializer_list<Json> values = {});
    static Json object();

    Json(const Json& other);
    Json(Json&& other) noexcept;
    Json& operator=(Json other) noexcept;
    ~Json();

    Kind kind() const { return kind_; }
    bool is_null() const { return kind_ == Kind::null; }
    bool is_boolean() const { return kind_ == Kind::boolean; }
    bool is_number() const { return is_whole() || kind_ == Kind::real; }
    bool is_number_float() const { return kind_ == Kind::real; }
    bool is_number_unsigned() const { return kind_ == Kind::natural; }
    bool is_string() const { return kind_ == Kind::string; }
    bool is_array() const { return kind_ == Kind::list; }
    bool is_object() const { return kind_ == Kind::object; }
    bool is_structured() const { return is_array() || is_object(); }

    // A number as any arithmetic type, converted as static_cast does.
    template <class T> T get() const {
        if constexpr (std::same_as<T, std::string>)
            return text();
        else if constexpr (std::same_as<T, bool>)
            return boolean();
        else
            return kind_ == Kind::integer   ? static_cast<T>(scalar_.integer)
                   : kind_ == Kind::natural ? static_cast<T>(scalar_.natural)
                                            : static_cast<T>(real());
    }

    // Elements of a list or members of an object; 0 for everything else. Iteration is over their values.
    std::size_t size() const;
    bool empty() const { return size() == 0; }
    const Json* begin() const;
    const Json* end() const { return begin() + size(); }
    Json* begin();
    Json* end() { return begin() + size(); }
    const Json& front() const { return at(0); }
    const Json& back() const { return at(size() - 1); }
    Json& back() { return (*this)[size() - 1]; }

    // An element of a list.
    const Json& at(std::size_t index) const;
    const Json& operator[](std::size_t index) const { return at(index); }
    const Json& operator[](int index) const { return at(static_cast<std::size_t>(index)); }
    Json& operator[](std::size_t index);
    Json& operator[](int index) { return (*this)[static_cast<std::size_t>(index)]; }
    // Null becomes a list.
    void push_back(Json value);

    // A member of an object. The non-const operator makes it, null, when it is missing, and an object of
    // null.
    const Json& at(const std::string& key) const;
    const Json& operator[](const std::string& key) const { return at(key); }
    const Json& operator[](const char* key) const { return at(std::string(key)); }
    Json& operator[](const std::string& key);
    Json& operator[](const char* key) { return (*this)[std::string(key)]; }
    const Json* find(const std::string& key) const; // end() when it is missing
    bool contains(const std::string& key) const { return find(key) != end(); }
    // The member, or `otherwise` when it is missing.
    Json value(const std::string& key, const Json& otherwise) const;

    // for (const auto& [key, value] : json.items()); nothing for what is no object.
    struct Item {
        const std::string& key;
        const Json& value;
    };
    class Items {
    public:
        struct Iterator {
            const std::string* key;
            const Json* value;
            Item operator*() const { return {*key, *value}; }
            Iterator& operator++() { return ++key, ++value, *this; }
            bool operator!=(const Iterator& other) const { return value != other.value; }
        };
        explicit Items(const Json& json) : json_(json) {}
        Iterator begin() const;
        Iterator end() const;

    private:
        const Json& json_;
    };
    Items items() const { return Items(*this); }

    // Numbers by value, whole or not; objects by their members in order.
    bool operator==(const Json& other) const;

private:
    struct Content; // of a string, a list or an object
    Kind kind_ = Kind::null;
    union {
        bool boolean;
        std::int64_t integer;
        std::uint64_t natural;
        double real;
    } scalar_{};
    struct Release {
        void operator()(Content* content) const;
    };
    std::unique_ptr<Content, Release> content_;

    bool is_whole() const { return kind_ == Kind::integer || kind_ == Kind::natural; }
    const std::string& text() const;
    bool boolean() const;
    double real() const;
    void become(Kind kind); // null only
    template <class List> static Json list_of(const List& values) {
        Json list = array();
        for (const auto& value : values) list.push_back(Json(value));
        return list;
    }
};

// Text of a value. An array that holds no object and no array is written in one line, so that a list of
// points stays readable; everything else has one element a line. Ends with a line feed.
std::string to_json_text(const Json& value);
// The same without any white space (for glTF).
std::string to_compact_json_text(const Json& value);

// What parse_json makes of a key that an object has twice.
enum class Twice { last_wins, is_an_error };
// Parses the text of a file. Error(input) names `source` and the place; values in more than 500 others are an
// error.
Json parse_json(const std::string& text, const std::string& source, Twice twice = Twice::last_wins);

// Whether a text is valid UTF-8, as a JSON string must be.
bool is_utf8(const std::string& text);

} // namespace pantin
