// SPDX-License-Identifier: MIT
// Strokes drawn in a vector program (docs/formats.md, "SVG strokes"). A drawing is read as the strokes.json
// that it stands for, so that one set of rules holds for both. Scalable Vector Graphics (SVG) 2, W3C 2018:
// chapters 5, 9 and 10.
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <string_view>
#include <utility>

#include <pugixml.hpp>

#include "core/decimal.hpp"
#include "core/json.hpp"
#include "geometry/extent.hpp"
#include "modeling/svg_path.hpp"
#include "pantin/error.hpp"
#include "pantin/strokes.hpp"

namespace pantin {
namespace {

constexpr int deepest = 200;        // groups in groups
constexpr double same_place = 1e-9; // share of the diagonal: a path that ends so near its beginning is closed
constexpr std::size_t most_shown = 40; // characters of a value in a message

[[noreturn]] void fail(const std::string& where, const std::string& fact) {
    throw Error(ErrorKind::input, where + ": " + fact);
}

bool among(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

// --- text --------------------------------------------------------------------------------------------------

// One line without white space around it or doubled.
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

// Without the prefix that some programs write before SVG's own elements.
std::string_view kind_of(pugi::xml_node node) {
    const std::string_view name = node.name();
    return name.starts_with("svg:") ? name.substr(4) : name;
}

// The last declaration of a property in `style`.
std::string style_property(pugi::xml_node node, std::string_view name) {
    const std::string_view style = node.attribute("style").value();
    std::string value;
    for (std::size_t from = 0; from < style.size();) {
        const std::size_t end = std::min(style.find(';', from), style.size());
        const std::string_view declaration = style.substr(from, end - from);
        const std::size_t colon = declaration.find(':');
        if (colon != std::string_view::npos && small(one_line(declaration.substr(0, colon))) == name)
            value = one_line(declaration.substr(colon + 1, declaration.find('!') - colon - 1));
        from = end + 1;
    }
    return value;
}

// A presentation attribute, which `style` outweighs.
std::string property(pugi::xml_node node, const char* name) {
    const std::string value = style_property(node, name);
    return value.empty() ? attribute(node, name) : value;
}

// --- colours -----------------------------------------------------------------------------------------------

struct NamedColour {
    std::string_view name, hex;
};
// The sixteen of HTML 4, then the more usual ones of CSS.
constexpr auto named_colours = std::to_array<NamedColour>({
    {"black", "#000000"},       {"silver", "#c0c0c0"},      {"gray", "#808080"},
    {"white", "#ffffff"},       {"maroon", "#800000"},      {"red", "#ff0000"},
    {"purple", "#800080"},      {"fuchsia", "#ff00ff"},     {"green", "#008000"},
    {"lime", "#00ff00"},        {"olive", "#808000"},       {"yellow", "#ffff00"},
    {"navy", "#000080"},        {"blue", "#0000ff"},        {"teal", "#008080"},
    {"aqua", "#00ffff"},        {"grey", "#808080"},        {"cyan", "#00ffff"},
    {"magenta", "#ff00ff"},     {"orange", "#ffa500"},      {"pink", "#ffc0cb"},
    {"hotpink", "#ff69b4"},     {"brown", "#a52a2a"},       {"gold", "#ffd700"},
    {"beige", "#f5f5dc"},       {"tan", "#d2b48c"},         {"khaki", "#f0e68c"},
    {"ivory", "#fffff0"},       {"coral", "#ff7f50"},       {"salmon", "#fa8072"},
    {"tomato", "#ff6347"},      {"crimson", "#dc143c"},     {"violet", "#ee82ee"},
    {"indigo", "#4b0082"},      {"orchid", "#da70d6"},      {"plum", "#dda0dd"},
    {"turquoise", "#40e0d0"},   {"skyblue", "#87ceeb"},     {"steelblue", "#4682b4"},
    {"royalblue", "#4169e1"},   {"chocolate", "#d2691e"},   {"sienna", "#a0522d"},
    {"peru", "#cd853f"},        {"saddlebrown", "#8b4513"}, {"wheat", "#f5deb3"},
    {"lightgray", "#d3d3d3"},   {"lightgrey", "#d3d3d3"},   {"darkgray", "#a9a9a9"},
    {"darkgrey", "#a9a9a9"},    {"dimgray", "#696969"},     {"dimgrey", "#696969"},
    {"lightblue", "#add8e6"},   {"lightgreen", "#90ee90"},  {"darkblue", "#00008b"},
    {"darkgreen", "#006400"},   {"darkred", "#8b0000"},     {"darkorange", "#ff8c00"},
    {"forestgreen", "#228b22"}, {"seagreen", "#2e8b57"},    {"slategray", "#708090"},
});

std::string hex_of(const std::array<int, 3>& bytes) {
    std::string text = "#";
    for (const int byte : bytes) {
        text += "0123456789abcdef"[byte / 16];
        text += "0123456789abcdef"[byte % 16];
    }
    return text;
}

// "#rgb", "#rgba", "#rrggbb" or "#rrggbbaa" as "#rrggbb"; empty for anything else.
std::string colour_of_hex(const std::string& text) {
    if (text.find_first_not_of("0123456789abcdef", 1) != std::string::npos) return {};
    if (text.size() == 7 || text.size() == 9) return text.substr(0, 7);
    if (text.size() != 4 && text.size() != 5) return {};
    return {'#', text[1], text[1], text[2], text[2], text[3], text[3]};
}

// "rgb(1, 2, 3)", "rgb(10% 20% 30%)", "rgba(…)"; the opacity is left out. Empty for anything else.
std::string colour_of_rgb(const std::string& text) {
    const std::size_t open = text.find('('), close = text.find(')');
    if (open == std::string::npos || close != text.size() - 1) return {};
    std::string inside = text.substr(open + 1, close - open - 1);
    const double most = inside.find('%') == std::string::npos ? 255 : 100;
    for (char& c : inside)
        if (c == '%' || c == '/') c = ' ';
    std::vector<double> numbers;
    try {
        numbers = svg_numbers(inside, "");
    } catch (const Error&) { // a colour is no reason to give up on a drawing
        return {};
    }
    if (numbers.size() != 3 && numbers.size() != 4) return {};
    std::array<int, 3> bytes{};
    for (std::size_t i = 0; i < 3; ++i)
        bytes[i] = static_cast<int>(std::floor(std::clamp(numbers[i] * 255 / most, 0.0, 255.0) + 0.5));
    return hex_of(bytes);
}

std::string colour_of(const std::string& paint) {
    if (paint.starts_with('#')) return colour_of_hex(paint);
    if (paint.starts_with("rgb")) return colour_of_rgb(paint);
    const auto found = std::find_if(named_colours.begin(), named_colours.end(),
                                    [&](const NamedColour& c) { return c.name == paint; });
    return found == named_colours.end() ? "" : std::string(found->hex);
}

// --- shapes ------------------------------------------------------------------------------------------------

// A length that is not there is 0, or `missing`.
double length_of(pugi::xml_node node, const char* name, const std::string& where, double missing = 0) {
    const std::string text = attribute(node, name);
    if (text.empty() || text == "auto") return missing;
    return svg_length(text, where + ": " + name);
}

double extent_of(pugi::xml_node node, const char* name, const std::string& where, double missing = 0) {
    const double x = length_of(node, name, where, missing);
    if (x < 0 && x != missing) fail(where, std::string(name) + " must not be negative");
    return x;
}

class PathText {
public:
    std::string text;
    PathText& add(const char* command, std::initializer_list<double> numbers) {
        text += command;
        for (const double x : numbers) text += " " + to_decimal(x);
        return *this;
    }
};

// The path that SVG takes for the same shape (section 10.2), from the end of the upper left corner clockwise.
std::string path_of_rect(pugi::xml_node node, const std::string& where) {
    const double x = length_of(node, "x", where), y = length_of(node, "y", where);
    const double width = extent_of(node, "width", where), height = extent_of(node, "height", where);
    double rx = extent_of(node, "rx", where, -1), ry = extent_of(node, "ry", where, -1);
    if (width == 0 || height == 0) return {};
    if (rx < 0) rx = std::max(ry, 0.0); // of two radii one may be left out
    if (ry < 0) ry = rx;
    rx = std::min(rx, width / 2);
    ry = std::min(ry, height / 2);
    PathText path;
    const double right = x + width, bottom = y + height;
    if (rx == 0 || ry == 0)
        return path.add("M", {x, y}).add("H", {right}).add("V", {bottom}).add("H", {x}).add("Z", {}).text;
    path.add("M", {x + rx, y}).add("H", {right - rx}).add("A", {rx, ry, 0, 0, 1, right, y + ry});
    path.add("V", {bottom - ry}).add("A", {rx, ry, 0, 0, 1, right - rx, bottom});
    path.add("H", {x + rx}).add("A", {rx, ry, 0, 0, 1, x, bottom - ry});
    return path.add("V", {y + ry}).add("A", {rx, ry, 0, 0, 1, x + rx, y}).add("Z", {}).text;
}

// Section 10.3: four quarters, from the right end clockwise.
std::string path_of_ellipse(pugi::xml_node node, const std::string& where) {
    const bool circle = kind_of(node) == "circle";
    const double x = length_of(node, "cx", where), y = length_of(node, "cy", where);
    double rx = extent_of(node, circle ? "r" : "rx", where, circle ? 0 : -1);
    double ry = circle ? rx : extent_of(node, "ry", where, -1);
    if (rx < 0) rx = std::max(ry, 0.0);
    if (ry < 0) ry = rx;
    if (rx == 0 || ry == 0) return {};
    PathText path;
    path.add("M", {x + rx, y}).add("A", {rx, ry, 0, 0, 1, x, y + ry}).add("A", {rx, ry, 0, 0, 1, x - rx, y});
    return path.add("A", {rx, ry, 0, 0, 1, x, y - ry})
        .add("A", {rx, ry, 0, 0, 1, x + rx, y})
        .add("Z", {})
        .text;
}

std::vector<Subpath> subpaths_of_points(pugi::xml_node node, const Affine& transform,
                                        const std::string& where) {
    const std::vector<double> numbers = svg_numbers(node.attribute("points").value(), where + ": points");
    if (numbers.size() % 2) fail(where, "points: the last one has no y");
    if (numbers.empty()) return {};
    Subpath subpath{{}, kind_of(node) == "polygon"};
    for (std::size_t i = 0; i < numbers.size(); i += 2)
        subpath.points.push_back(transform * Point2d{numbers[i], numbers[i + 1]});
    return {subpath};
}

std::vector<Subpath> subpaths_of(pugi::xml_node node, const Affine& transform, const std::string& where) {
    const std::string_view kind = kind_of(node);
    if (kind == "path") return svg_path(node.attribute("d").value(), transform, where + ": d");
    if (kind == "polygon" || kind == "polyline") return subpaths_of_points(node, transform, where);
    return svg_path(kind == "rect" ? path_of_rect(node, where) : path_of_ellipse(node, where), transform,
                    where);
}

// --- the drawing -------------------------------------------------------------------------------------------

// What an element has from the groups around it.
struct Surroundings {
    Affine transform;
    std::string fill, stroke;
    int depth = 0;
};

class SvgReader {
public:
    explicit SvgReader(const std::string& file) : file_(file) {}

    Strokes read(pugi::xml_node root) {
        visit(root, {});
        if (parts_.empty()) fail(file_, "holds no path, polygon, polyline, rect, circle or ellipse");
        Json json;
        if (root.attribute("data-origin")) json["origin"] = read_origin(root);
        json["parts"] = std::move(parts_);
        Strokes strokes = strokes_from_json(to_compact_json_text(json), file_);
        strokes.repairs.insert(strokes.repairs.begin(), repairs_.begin(), repairs_.end());
        return strokes;
    }

private:
    std::string file_;
    Json parts_ = Json::array();
    std::map<std::string, int> names_; // with the number that the latest of the name got
    std::vector<std::string> repairs_;

    Json read_origin(pugi::xml_node root) const {
        const std::vector<double> xy =
            svg_numbers(root.attribute("data-origin").value(), file_ + ": data-origin");
        if (xy.size() != 2) fail(file_, "data-origin must be two numbers");
        return xy;
    }

    void visit(pugi::xml_node node, const Surroundings& outer) {
        const std::string_view kind = kind_of(node);
        if (small(property(node, "display")) == "none") return;
        if (among(kind, {"svg", "g", "a", "switch"}))
            visit_group(node, outer);
        else if (among(kind, {"path", "polygon", "polyline", "rect", "circle", "ellipse"}))
            read_part(node, outer);
        else if (among(kind, {"line", "text", "image", "use", "foreignObject"}))
            repairs_.push_back(described(node, attribute(node, "id")) +
                               ": not a shape with an inside, left out");
        else if (kind == "style" && !one_line(node.text().get()).empty())
            repairs_.push_back("style sheets are not followed");
    }

    void visit_group(pugi::xml_node node, const Surroundings& outer) {
        const std::string where = file_ + ": " + described(node, attribute(node, "id"));
        Surroundings inner = surroundings(node, outer, where);
        if (++inner.depth > deepest) fail(file_, "groups are nested too deeply");
        if (kind_of(node) == "svg" && outer.depth > 0) {
            const Affine shift = {1, 0, 0, 1, length_of(node, "x", where), length_of(node, "y", where)};
            inner.transform = moderate(inner.transform * shift, where);
            if (node.attribute("viewBox"))
                repairs_.push_back(described(node, attribute(node, "id")) +
                                   ": an inner viewBox is not followed");
        }
        for (const pugi::xml_node child : node.children()) visit(child, inner);
    }

    Surroundings surroundings(pugi::xml_node node, const Surroundings& outer, const std::string& where) {
        Surroundings inner = outer;
        if (const pugi::xml_attribute transform = node.attribute("transform"))
            inner.transform =
                moderate(outer.transform * svg_transform(transform.value(), where + ": transform"), where);
        if (!style_property(node, "transform").empty())
            repairs_.push_back(described(node, attribute(node, "id")) +
                               ": a transform in style is not followed");
        const auto inherit = [&](const char* name, std::string& value) {
            const std::string own = small(property(node, name));
            if (!own.empty() && own != "inherit") value = own;
        };
        inherit("fill", inner.fill);
        inherit("stroke", inner.stroke);
        return inner;
    }
    static Affine moderate(const Affine& transform, const std::string& where) {
        if (!is_moderate(transform)) fail(where, "the transforms together are out of range");
        return transform;
    }

    static std::string described(pugi::xml_node node, const std::string& name) {
        const std::string kind = one_line(kind_of(node));
        return name.empty() ? kind : kind + " '" + name + "'";
    }

    // --- parts ---------------------------------------------------------------------------------------------

    void read_part(pugi::xml_node node, const Surroundings& outer) {
        const std::string asked = asked_name(node), id = attribute(node, "id");
        const std::string element =
            described(node, asked) + (id.empty() || id == asked ? "" : " (id '" + id + "')");
        const std::string where = file_ + ": " + element;
        const Surroundings own = surroundings(node, outer, where);
        std::vector<Subpath> subpaths = subpaths_of(node, own.transform, where);
        if (subpaths.empty()) {
            repairs_.push_back(element + ": empty, left out");
            return;
        }
        Json part;
        part["name"] = own_name(asked);
        const std::string place = "part '" + part["name"].get<std::string>() + "'";
        part["stroke"] = Json::array();
        for (const Point2d p : stroke_of(std::move(subpaths), place))
            part["stroke"].push_back(Json::array({p.x, p.y}));
        read_attributes(node, where, part);
        const std::string colour = colour_of_part(own, place);
        if (!colour.empty()) part["colour"] = colour;
        parts_.push_back(std::move(part));
    }

    std::string asked_name(pugi::xml_node node) const {
        for (const char* name : {"inkscape:label", "id"})
            if (std::string text = attribute(node, name); !text.empty()) return text;
        for (const pugi::xml_node child : node.children())
            if (kind_of(child) == "title")
                if (std::string text = one_line(child.text().get()); !text.empty()) return text;
        return "part-" + std::to_string(parts_.size() + 1);
    }
    // The name itself for the first that asks for it, then "name-2", "name-3", …, as far as these are free.
    std::string own_name(const std::string& asked) {
        if (names_.try_emplace(asked, 1).second) return asked;
        std::string name;
        do name = asked + "-" + std::to_string(++names_[asked]);
        while (!names_.try_emplace(name, 1).second);
        repairs_.push_back("part '" + name + "': there was a part '" + asked + "' before it");
        return name;
    }

    // The largest subpath, without its first point once more at the end.
    std::vector<Point2d> stroke_of(std::vector<Subpath> subpaths, const std::string& place) {
        // A moveto that nothing follows draws nothing.
        const auto is_dot = [](const Subpath& s) { return s.points.size() == 1; };
        if (!std::all_of(subpaths.begin(), subpaths.end(), is_dot)) std::erase_if(subpaths, is_dot);
        const auto area = [](const Subpath& s) { return std::abs(area_of(s.points)); };
        const auto largest =
            std::max_element(subpaths.begin(), subpaths.end(),
                             [&](const Subpath& a, const Subpath& b) { return area(a) < area(b); });
        if (const std::size_t dropped = subpaths.size() - 1)
            repairs_.push_back(place + ": the largest subpath was kept, " + std::to_string(dropped) +
                               (dropped == 1 ? " other" : " others") + " dropped");
        std::vector<Point2d> stroke = std::move(largest->points);
        const double gap = distance(stroke.front(), stroke.back());
        const bool back = stroke.size() > 1 && gap <= same_place * diagonal_of(stroke);
        if (back)
            stroke.pop_back();
        else if (!largest->closed)
            repairs_.push_back(place + ": the open path was closed");
        return stroke;
    }

    static void read_attributes(pugi::xml_node node, const std::string& where, Json& part) {
        const auto number = [&](const char* name, const char* key) {
            if (!node.attribute(name)) return;
            const std::vector<double> numbers =
                svg_numbers(node.attribute(name).value(), where + ": " + name);
            if (numbers.size() != 1) fail(where, std::string(name) + " must be a number");
            part[key] = numbers[0];
        };
        const auto text = [&](const char* name, const char* key) {
            if (node.attribute(name)) part[key] = attribute(node, name);
        };
        number("data-depth", "depth");
        text("data-view", "view");
        text("data-symmetric", "symmetric");
        if (part.contains("symmetric") && part["symmetric"] == "true") part["symmetric"] = true;
        if (part.contains("symmetric") && part["symmetric"] == "false") part["symmetric"] = false;
        text("data-parent", "parent");
        number("data-height", "height");
        text("data-label", "label");
    }

    // Of the fill, else of the outline; empty without either.
    std::string colour_of_part(const Surroundings& own, const std::string& place) {
        for (const std::string& paint : {own.fill, own.stroke}) {
            if (paint.empty() || paint == "none" || paint == "transparent") continue;
            if (const std::string colour = colour_of(paint); !colour.empty()) return colour;
            repairs_.push_back(place + ": '" + paint.substr(0, most_shown) +
                               "' is no plain colour, left out");
        }
        return {};
    }
};

} // namespace

bool svg_available() { return true; }

Strokes strokes_from_svg(const std::string& text, const std::string& file) {
    pugi::xml_document document;
    const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
    if (!result) {
        const std::size_t at =
            std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)), text.size());
        const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        fail(file, "not valid XML (line " + std::to_string(line) + "): " + small(result.description()));
    }
    const pugi::xml_node root = document.document_element();
    if (kind_of(root) != "svg")
        fail(file, "not an SVG file, its root is <" + one_line(root.name()).substr(0, most_shown) + ">");
    return SvgReader(file).read(root);
}

} // namespace pantin
