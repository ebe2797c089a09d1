// SPDX-License-Identifier: MIT
// What style sheets, the attribute `style` and presentation attributes say about an element (Cascading Style
// Sheets Level 2, W3C 2011, chapters 5 and 6; SVG 2, chapter 6).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

namespace pantin::svg {

// Property → value, in one line, names in small letters.
using Style = std::map<std::string, std::string>;

class StyleSheets {
public:
    // Rules of one sheet after those that are there. Selectors: elements, classes, ids, `*`, lists,
    // descendants and children. Others and at-rules are passed over. No error.
    void add(std::string_view css);
    // The declarations that hold for the element itself, by importance, specificity and order; without what
    // it inherits. No error.
    Style style_of(pugi::xml_node node) const;
    // Selectors that were not understood.
    std::size_t passed_over() const { return passed_over_; }

private:
    struct Simple {
        std::string element, id;
        std::vector<std::string> classes;
        bool root = false;  // the outermost element
        bool child = false; // of the element of the selector before it; else anywhere inside
    };
    struct Declaration {
        std::string name, value;
        bool important = false;
    };
    struct Rule {
        std::vector<Simple> selector;
        int specificity = 0;
        std::vector<Declaration> declarations;
    };
    static std::vector<Declaration> declarations_of(std::string_view block);
    static bool read_selector(std::string_view text, Rule& rule);
    static bool matches(const Simple& simple, pugi::xml_node node);
    static bool matches(const std::vector<Simple>& selector, std::size_t count, pugi::xml_node node);

    std::vector<Rule> rules_;
    std::size_t passed_over_ = 0;
};

} // namespace pantin::svg
