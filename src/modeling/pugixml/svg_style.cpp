// SPDX-License-Identifier: MIT
// Style sheets in, declarations of an element out (CSS 2.1, chapters 4 to 6).
#include "modeling/pugixml/svg_style.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "modeling/pugixml/svg_text.hpp"

namespace pantin::svg {
namespace {

// The attributes that are properties, too (SVG 2, 6.6), as far as shapes depend on them.
constexpr auto presentation = std::to_array<const char*>(
    {"clip-path", "color", "display", "fill", "fill-opacity", "fill-rule", "mask", "opacity", "stroke",
     "stroke-linecap", "stroke-linejoin", "stroke-miterlimit", "stroke-opacity", "stroke-width",
     "transform-box", "transform-origin", "vector-effect", "visibility"});

constexpr std::size_t longest_selector = 4; // elements; so that no sheet takes for ever

std::string without_comments(std::string_view css) {
    std::string out;
    for (std::size_t at = 0; at < css.size();) {
        if (css.substr(at).starts_with("/*")) {
            at = std::min(css.find("*/", at + 2), css.size() - 2) + 2;
            out += ' ';
        } else if (css.substr(at).starts_with("<!--")) {
            at += 4;
        } else if (css.substr(at).starts_with("-->")) {
            at += 3;
        } else {
            out += css[at++];
        }
    }
    return out;
}

bool is_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || static_cast<unsigned char>(c) >= 0x80;
}

// Behind the block that begins at `open`, blocks in it included.
std::size_t behind_block(std::string_view css, std::size_t open) {
    int depth = 0;
    for (std::size_t at = open; at < css.size(); ++at) {
        if (css[at] == '{') ++depth;
        if (css[at] == '}' && --depth == 0) return at + 1;
    }
    return css.size();
}

// "@media screen", "@media all": conditions are not looked at.
bool is_for_screens(std::string_view rule) {
    const std::string text = small(one_line(rule));
    return text == "@media screen" || text == "@media all" || text == "@media only screen";
}

} // namespace

std::vector<StyleSheets::Declaration> StyleSheets::declarations_of(std::string_view block) {
    std::vector<Declaration> declarations;
    for (std::size_t from = 0; from < block.size();) {
        const std::size_t end = std::min(block.find(';', from), block.size());
        const std::string_view text = block.substr(from, end - from);
        from = end + 1;
        const std::size_t colon = text.find(':');
        if (colon == std::string_view::npos) continue;
        const std::string_view value = text.substr(colon + 1);
        const std::size_t mark = value.find('!');
        declarations.push_back(
            {small(one_line(text.substr(0, colon))), one_line(value.substr(0, mark)),
             mark != std::string_view::npos && small(one_line(value.substr(mark + 1))) == "important"});
    }
    return declarations;
}

// One selector of a list; false when there is something in it that is not known.
bool StyleSheets::read_selector(std::string_view text, Rule& rule) {
    const std::string line = one_line(text);
    bool child = false;
    for (std::size_t at = 0; at < line.size();) {
        if (line[at] == ' ') {
            ++at;
            continue;
        }
        if (line[at] == '>') {
            if (rule.selector.empty() || child) return false;
            child = true;
            ++at;
            continue;
        }
        Simple simple;
        simple.child = child;
        child = false;
        if (line.substr(at).starts_with(":root")) { // the outermost element
            simple.element = "svg";
            simple.root = true;
            at += 5;
            rule.specificity += 100;
        }
        for (bool first = !simple.root; at < line.size() && line[at] != ' ' && line[at] != '>';
             first = false) {
            const char mark = line[at];
            if (mark == '*' && first) {
                ++at;
                continue;
            }
            const bool marked = mark == '.' || mark == '#';
            if (!marked && !(first && is_name(mark))) return false;
            const std::size_t from = at + (marked ? 1 : 0);
            for (at = from; at < line.size() && is_name(line[at]);) ++at;
            if (at == from) return false;
            const std::string name = line.substr(from, at - from);
            if (mark == '.') simple.classes.push_back(name);
            if (mark == '#') simple.id = name;
            if (!marked) simple.element = name;
            rule.specificity += mark == '#' ? 10'000 : mark == '.' ? 100 : 1;
        }
        rule.selector.push_back(std::move(simple));
    }
    return !rule.selector.empty() && rule.selector.size() <= longest_selector && !child;
}

void StyleSheets::add(std::string_view given) {
    const std::string css = without_comments(given);
    for (std::size_t at = 0; at < css.size();) {
        if (css[at] == '}' || static_cast<unsigned char>(css[at]) <= ' ') {
            ++at;
            continue;
        }
        const std::size_t open = css.find('{', at);
        if (css[at] == '@') {
            const std::size_t end = css.find(';', at);
            if (open < end && is_for_screens(std::string_view(css).substr(at, open - at))) {
                const std::size_t behind = behind_block(css, open);
                add(std::string_view(css).substr(open + 1, behind - open - 2));
                at = behind;
                continue;
            }
            at = end < open ? end + 1 : open == std::string::npos ? css.size() : behind_block(css, open);
            continue;
        }
        if (open == std::string::npos) break;
        const std::size_t behind = behind_block(css, open);
        const std::string_view whole = css;
        const std::vector<Declaration> declarations =
            declarations_of(whole.substr(open + 1, behind - open - (css[behind - 1] == '}' ? 2 : 1)));
        for (std::size_t from = at; from < open;) {
            const std::size_t end = std::min(css.find(',', from), open);
            Rule rule;
            rule.declarations = declarations;
            if (read_selector(whole.substr(from, end - from), rule))
                rules_.push_back(std::move(rule));
            else
                ++passed_over_;
            from = end + 1;
        }
        at = behind;
    }
}

bool StyleSheets::matches(const Simple& simple, pugi::xml_node node) {
    if (node.type() != pugi::node_element) return false;
    if (!simple.element.empty() && simple.element != kind_of(node)) return false;
    if (simple.root && node.parent().type() != pugi::node_document) return false;
    if (!simple.id.empty() && simple.id != attribute(node, "id")) return false;
    const std::string classes = " " + attribute(node, "class") + " ";
    return std::all_of(simple.classes.begin(), simple.classes.end(), [&](const std::string& c) {
        return classes.find(" " + c + " ") != std::string::npos;
    });
}

// The first `count` of the selector, the last of them by the node itself. A chain of parents is tried from
// the inside, where the nearest one that fits is taken unless a child is asked for.
bool StyleSheets::matches(const std::vector<Simple>& selector, std::size_t count, pugi::xml_node node) {
    const Simple& last = selector[count - 1];
    if (!matches(last, node)) return false;
    if (count == 1) return true;
    if (last.child) return matches(selector, count - 1, node.parent());
    for (pugi::xml_node parent = node.parent(); parent; parent = parent.parent())
        if (matches(selector, count - 1, parent)) return true;
    return false;
}

Style StyleSheets::style_of(pugi::xml_node node) const {
    using Rank = std::tuple<bool, bool, int>; // important, of the element itself, specificity
    std::map<std::string, Rank> ranks;
    Style style;
    const auto declare = [&](const std::string& name, const std::string& value, Rank rank) {
        const auto [place, fresh] = ranks.try_emplace(name, rank);
        if (value.empty() || (!fresh && rank < place->second)) return;
        place->second = rank;
        style[name] = value;
    };
    for (const char* name : presentation)
        if (const std::string value = attribute(node, name); !value.empty())
            declare(name, value, {false, false, -1});
    for (const Rule& rule : rules_)
        if (matches(rule.selector, rule.selector.size(), node))
            for (const Declaration& d : rule.declarations)
                declare(d.name, d.value, {d.important, false, rule.specificity});
    for (const Declaration& d : declarations_of(node.attribute("style").value()))
        declare(d.name, d.value, {d.important, true, 0});
    return style;
}

} // namespace pantin::svg
