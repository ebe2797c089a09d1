// SPDX-License-Identifier: MIT
// A file's text to a document, and a document's nodes to text (Extensible Markup Language 1.0, W3C 2008).
#include "modeling/pugixml/svg_text.hpp"

#include <map>
#include <vector>

#include "pantin/error.hpp"

namespace pantin::svg {
namespace {

constexpr std::size_t most_entities = 1000, longest_entity = 10'000, longest_text = 100'000'000;

// <!ENTITY name "value"> of the document's own declarations. Values with references of their own are left
// alone, so that nothing multiplies.
std::map<std::string, std::string> entities_of(const std::string& text) {
    std::map<std::string, std::string> entities;
    const std::size_t begin = text.find("<!DOCTYPE");
    if (begin == std::string::npos) return entities;
    const std::size_t end = std::min(text.find("]>", begin), text.size());
    for (std::size_t at = text.find("<!ENTITY", begin); at < end; at = text.find("<!ENTITY", at + 1)) {
        const std::size_t quote = text.find_first_of("\"'>", at);
        if (quote >= end || text[quote] == '>') continue;
        const std::size_t close = text.find(text[quote], quote + 1);
        if (close >= end) break;
        const std::string name = one_line(text.substr(at + 8, quote - at - 8));
        const std::string value = text.substr(quote + 1, close - quote - 1);
        if (name.empty() || value.find_first_of("&<") != std::string::npos) continue;
        if (value.size() > longest_entity || entities.size() >= most_entities) continue;
        entities.try_emplace(name, value);
    }
    return entities;
}

std::string with_entities(const std::string& text) {
    const std::map<std::string, std::string> entities = entities_of(text);
    if (entities.empty()) return text;
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t mark = std::min(text.find('&', at), text.size());
        out.append(text, at, mark - at);
        at = mark;
        if (at == text.size()) break;
        const std::size_t end = text.find(';', at);
        const auto found =
            end == std::string::npos ? entities.end() : entities.find(text.substr(at + 1, end - at - 1));
        if (found == entities.end() || out.size() > longest_text) {
            out += text[at++];
            continue;
        }
        out += found->second;
        at = end + 1;
    }
    return out;
}

} // namespace

bool among(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

std::string one_line(std::string_view text) {
    std::string line;
    for (const char c : text) {
        const bool gap = static_cast<unsigned char>(c) <= 0x20 || c == 0x7f;
        if (!gap)
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    }
    if (!line.empty() && line.back() == ' ') line.pop_back();
    return line;
}

std::string small(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

std::string attribute(pugi::xml_node node, const char* name) {
    return one_line(node.attribute(name).value());
}

std::string reference(pugi::xml_node node) {
    const std::string href = attribute(node, "href");
    return href.empty() ? attribute(node, "xlink:href") : href;
}

std::string_view kind_of(pugi::xml_node node) {
    const std::string_view name = node.name();
    return name.starts_with("svg:") ? name.substr(4) : name;
}

std::string text_of(pugi::xml_node node) {
    std::string text;
    for (const pugi::xml_node child : node.children())
        if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) text += child.value();
    return text;
}

std::string described(pugi::xml_node node, const std::string& name) {
    const std::string kind = one_line(kind_of(node));
    return name.empty() ? kind : kind + " '" + name + "'";
}

bool is_shape(pugi::xml_node node) {
    return among(kind_of(node), {"path", "polygon", "polyline", "rect", "circle", "ellipse", "line"});
}

void load(pugi::xml_document& document, const std::string& given, const std::string& file) {
    const std::string text = with_entities(given);
    const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
    if (result) return;
    const std::size_t at =
        std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)), text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    throw Error(ErrorKind::input,
                file + ": not valid XML (line " + std::to_string(line) + "): " + small(result.description()));
}

} // namespace pantin::svg
