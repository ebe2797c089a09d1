// SPDX-License-Identifier: MIT
// Text, bytes and pictures in, HTML out: escapes, data URIs (RFC 2397, RFC 4648), templates (own).
#include "explain/markup.hpp"

#include <array>
#include <charconv>
#include <vector>

#include "core/json.hpp"
#include "core/resources.hpp"
#include "pantin/error.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace {

// RFC 4648, section 4.
std::string base64(std::span<const unsigned char> bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) {
            return i + k < bytes.size() ? static_cast<unsigned>(bytes[i + k]) : 0u;
        };
        const unsigned three = byte(0) << 16 | byte(1) << 8 | byte(2);
        out += digits[three >> 18];
        out += digits[three >> 12 & 63];
        out += i + 1 < bytes.size() ? digits[three >> 6 & 63] : '=';
        out += i + 2 < bytes.size() ? digits[three & 63] : '=';
    }
    return out;
}

} // namespace

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
        case '&':
            out += "&amp;";
            break;
        case '<':
            out += "&lt;";
            break;
        case '>':
            out += "&gt;";
            break;
        case '"':
            out += "&quot;";
            break;
        case '\'':
            out += "&#39;";
            break;
        default:
            out += c;
        }
    }
    return out;
}

std::string decimal(double value, int decimals) {
    std::array<char, 400> digits; // of the largest double
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals)
            .ptr;
    std::string text(digits.data(), end);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

std::string percent(double share, int decimals) { return decimal(100 * share, decimals) + " %"; }

std::string data_uri(std::string_view type, std::span<const unsigned char> bytes) {
    return "data:" + std::string(type) + ";base64," + base64(bytes);
}
std::string picture_uri(const RgbImage& image) { return data_uri("image/png", encode_png(image)); }
std::string picture_uri(const RgbaImage& image) { return data_uri("image/png", encode_png(image)); }
std::string picture_uri(const GreyImage& image) { return data_uri("image/png", encode_png(image)); }

std::string script_json(const Json& value) {
    std::string out;
    for (const char c : to_compact_json_text(value)) {
        if (c == '<')
            out += "\\u003c"; // "</script" and "<!--" would end or change the element
        else
            out += c;
    }
    return out;
}

std::string_view asset(const std::string& name) {
    const std::span<const unsigned char> bytes = find_resource("src/explain/assets/" + name);
    if (bytes.empty()) throw Error(ErrorKind::internal, "the page's part " + name + " is not compiled in");
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string filled(std::string_view text, const Values& values) {
    std::string out;
    for (std::size_t at = 0;;) {
        const std::size_t open = text.find("{{", at);
        if (open == std::string_view::npos) return out += text.substr(at);
        const std::size_t close = text.find("}}", open);
        if (close == std::string_view::npos)
            throw Error(ErrorKind::internal, "a place of a template is not closed");
        const std::string name(text.substr(open + 2, close - open - 2));
        const auto found = values.find(name);
        if (found == values.end())
            throw Error(ErrorKind::internal, "a template's place has no value: " + name);
        out += text.substr(at, open - at);
        out += found->second;
        at = close + 2;
    }
}

} // namespace pantin
