// SPDX-License-Identifier: MIT
// Strokes drawn in a vector program (docs/modeling.md, "SVG strokes"). A drawing is read as the strokes.json
// that it stands for, so that one set of rules holds for both. Scalable Vector Graphics (SVG) 2, W3C 2018:
// chapters 5, 8, 9, 10 and 13.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "core/plural.hpp"
#include "modeling/pugixml/svg_geometry.hpp"
#include "modeling/pugixml/svg_paint.hpp"
#include "modeling/pugixml/svg_parts.hpp"
#include "modeling/pugixml/svg_shapes.hpp"
#include "modeling/pugixml/svg_style.hpp"
#include "modeling/pugixml/svg_text.hpp"
#include "pantin/error.hpp"

namespace pantin {
namespace svg {
namespace {

constexpr int deepest = 200;                   // groups in groups
constexpr std::size_t most_elements = 100'000; // that are met, those of `use` each time
constexpr std::size_t most_shown = 40;         // characters of a value in a message

[[noreturn]] void fail(const std::string& where, const std::string& fact) {
    throw Error(ErrorKind::input, where + ": " + fact);
}

// What ends the whole drawing, not one element of it.
struct DrawingError : Error {
    DrawingError(const std::string& file, const std::string& fact)
        : Error(ErrorKind::input, file + ": " + fact) {}
};

// What an element has from those around it.
struct Surroundings {
    Affine transform;
    Look look;
    Viewport viewport;
    Label label = Label::background; // that the innermost group tells
    std::vector<std::string> uses;   // ids that are followed just now
    pugi::xml_node use;              // whose name and data a shape gets
    int depth = 0;
};

class SvgReader {
public:
    explicit SvgReader(const std::string& file) : file_(file) {}

    Strokes read(pugi::xml_node root) {
        prepare(root, 0);
        if (sheets_.passed_over() > 0)
            repairs_.push_back(count_of(static_cast<long>(sheets_.passed_over()), "selector") +
                               " of the style sheets not understood");
        Surroundings outer;
        const std::optional<ViewBox> page = page_of(root, outer.viewport);
        visit_group(root, outer);
        if (clipped_) repairs_.push_back("clip paths and masks are not applied");
        if (!any_outline()) take_thin_lines();
        if (!any_outline()) refuse();
        const Json origin = root.attribute("data-origin") ? read_origin(root) : Json();
        return strokes_of(std::move(shapes_), page, origin, std::move(repairs_), file_);
    }

private:
    const std::string& file_;
    StyleSheets sheets_;
    Identified identified_;
    std::vector<GatheredShape> shapes_;
    std::vector<std::vector<std::vector<Point2d>>> thin_; // lines of each shape that are too thin for a part
    std::vector<std::string> repairs_;
    std::string first_unused_; // why the first shape is no part
    std::string first_error_;  // of an element that cannot be read
    std::size_t met_ = 0;
    bool clipped_ = false;
    bool attributes_ = false; // are being read

    // Style sheets and ids of the whole document.
    void prepare(pugi::xml_node node, int depth) {
        if (depth > deepest) fail(file_, "groups are nested too deeply");
        if (const std::string id = attribute(node, "id"); !id.empty()) identified_.try_emplace(id, node);
        if (kind_of(node) == "style") sheets_.add(text_of(node));
        for (const pugi::xml_node child : node.children())
            if (child.type() == pugi::node_element) prepare(child, depth + 1);
    }

    // What is seen of the drawing, and what its percentages are of.
    std::optional<ViewBox> page_of(pugi::xml_node root, Viewport& viewport) const {
        const auto side = [&](const char* name) {
            const std::string text = attribute(root, name);
            if (text.empty() || text.ends_with('%') || text == "auto") return 0.0;
            return std::max(0.0, svg_length(text, file_ + ": " + name, 0));
        };
        std::optional<ViewBox> page;
        if (root.attribute("viewBox")) page = svg_view_box(root.attribute("viewBox").value(), file_);
        if (!page) {
            const double width = side("width"), height = side("height");
            if (width > 0 && height > 0) page = {0, 0, width, height};
        }
        if (page) viewport = {page->width, page->height};
        // A drawing that is itself moved has its page moved, too; then nothing is said about it.
        return root.attribute("transform") ? std::nullopt : page;
    }

    Json read_origin(pugi::xml_node root) const {
        const std::vector<double> xy =
            svg_numbers(root.attribute("data-origin").value(), file_ + ": data-origin");
        if (xy.size() != 2) fail(file_, "data-origin must be two numbers");
        return xy;
    }

    bool any_outline() const {
        return std::any_of(shapes_.begin(), shapes_.end(),
                           [](const GatheredShape& s) { return !s.outlines.empty(); });
    }
    // A drawing of thin lines alone has nothing else.
    void take_thin_lines() {
        for (std::size_t i = 0; i < shapes_.size(); ++i) shapes_[i].outlines = std::move(thin_[i]);
    }
    [[noreturn]] void refuse() const {
        if (!first_error_.empty()) fail(file_, first_error_);
        if (first_unused_.empty())
            fail(file_, "holds no path, polygon, polyline, rect, circle, ellipse or line");
        fail(file_, "no shape can be a part; " + first_unused_);
    }
    void leave_out(const std::string& element, const std::string& why) {
        repairs_.push_back(element + ": " + why + ", left out");
        if (first_unused_.empty()) first_unused_ = element + ": " + why;
    }

    // --- elements ------------------------------------------------------------------------------------------

    // An element that cannot be read is left out, and with a group what is in it.
    void visit(pugi::xml_node node, const Surroundings& outer) {
        try {
            visit_any(node, outer);
        } catch (const DrawingError&) {
            throw;
        } catch (const Error& error) {
            if (attributes_) throw;
            std::string fact = error.what();
            const std::string element = described(node, attribute(node, "id"));
            if (fact.starts_with(file_ + ": ")) fact.erase(0, file_.size() + 2);
            // It names the element itself, by its label.
            const std::size_t place = fact.starts_with(std::string(kind_of(node))) ? fact.find(": ") : 0;
            const bool own = place != 0 && place != std::string::npos;
            if (first_error_.empty()) first_error_ = own ? fact : element + ": " + fact;
            if (own)
                leave_out(fact.substr(0, place), fact.substr(place + 2));
            else
                leave_out(element, fact);
        }
    }
    void visit_any(pugi::xml_node node, const Surroundings& outer) {
        const std::string_view kind = kind_of(node);
        if (among(kind, {"svg", "g", "a"}))
            visit_group(node, outer);
        else if (kind == "switch")
            visit_switch(node, outer);
        else if (kind == "use")
            visit_use(node, outer);
        else if (is_shape(node))
            read_shape(node, outer);
        else if (among(kind, {"text", "image", "foreignObject"}))
            repairs_.push_back(described(node, attribute(node, "id")) + ": not a shape, left out");
    }
    static bool holds_shape(pugi::xml_node node) {
        if (is_shape(node) || kind_of(node) == "use") return true;
        const auto children = node.children();
        return std::any_of(children.begin(), children.end(), holds_shape);
    }

    // Nothing when the element is not displayed.
    std::optional<Surroundings> enter(pugi::xml_node node, const Surroundings& outer,
                                      const std::string& element) {
        if (++met_ > most_elements)
            throw DrawingError(file_, "more than " + std::to_string(most_elements) + " elements");
        const std::string where = file_ + ": " + element;
        Surroundings inner = outer;
        if (++inner.depth > deepest) throw DrawingError(file_, "groups are nested too deeply");
        const Style style = sheets_.style_of(node);
        inner.look = outer.look.inside(style);
        if (!inner.look.displayed()) {
            if (holds_shape(node)) leave_out(element, "not displayed");
            return {};
        }
        clipped_ = clipped_ || inner.look.clipped();
        const std::string own = one_line(node.attribute("transform").value());
        const auto styled = style.find("transform");
        const bool from_style = styled != style.end();
        if (from_style || !own.empty()) {
            Affine step = transform_of(from_style ? styled->second : own, from_style, element, where);
            if (const auto origin = style.find("transform-origin"); origin != style.end())
                step = about(origin_of(origin->second, style, outer.viewport, element, where), step);
            inner.transform = moderate(outer.transform * step, where);
        }
        return inner;
    }
    static Affine about(Point2d o, const Affine& step) {
        return Affine{1, 0, 0, 1, o.x, o.y} * step * Affine{1, 0, 0, 1, -o.x, -o.y};
    }
    // Two lengths, shares of the viewport, or words (CSS Transforms 1, 6 and 8); of the shape's own box only
    // the origin 0 0 is known.
    Point2d origin_of(const std::string& text, const Style& style, const Viewport& port,
                      const std::string& element, const std::string& where) {
        const auto box = style.find("transform-box");
        if (box != style.end() && box->second != "view-box") {
            repairs_.push_back(element + ": transform-box is not followed");
            return {};
        }
        std::istringstream words(text);
        std::vector<double> xy;
        for (std::string word; words >> word && xy.size() < 2;) {
            const double whole = xy.empty() ? port.width : port.height;
            if (word == "left" || word == "top") word = "0";
            if (word == "center") word = "50%";
            if (word == "right" || word == "bottom") word = "100%";
            xy.push_back(svg_length(word, where + ": transform-origin", whole));
        }
        if (xy.empty()) return {};
        return {xy[0], xy.size() > 1 ? xy[1] : 0.5 * port.height};
    }
    // CSS writes units: "translate(3px, 4px) rotate(30deg)". What goes beyond the attribute's language is
    // said and not followed.
    Affine transform_of(std::string text, bool from_style, const std::string& element,
                        const std::string& where) {
        if (!from_style) return svg_transform(text, where + ": transform");
        for (const std::string_view unit : {"px", "deg"})
            for (std::size_t at; (at = text.find(unit)) != std::string::npos;) text.erase(at, unit.size());
        try {
            return svg_transform(text, where + ": transform");
        } catch (const Error&) {
            repairs_.push_back(element + ": the transform in style is not followed");
            return {};
        }
    }
    static Affine moderate(const Affine& transform, const std::string& where) {
        if (!is_moderate(transform)) fail(where, "the transforms together are out of range");
        return transform;
    }

    void visit_group(pugi::xml_node node, const Surroundings& outer) {
        const std::string element = described(node, attribute(node, "id")), where = file_ + ": " + element;
        std::optional<Surroundings> inner = enter(node, outer, element);
        if (!inner) return;
        if (const Label label = told_label(node); label != Label::background && outer.depth > 0)
            inner->label = label;
        if (kind_of(node) == "svg" && outer.depth > 0) enter_viewport(node, {}, *inner, where);
        for (const pugi::xml_node child : node.children()) visit(child, *inner);
    }
    // The units inside an inner `svg`, or a `symbol` that a `use` shows, whose size then counts.
    void enter_viewport(pugi::xml_node node, pugi::xml_node use, Surroundings& inner,
                        const std::string& where) {
        const Viewport port = inner.viewport;
        const auto side = [&](const char* name, double whole) {
            const pugi::xml_node teller = use && use.attribute(name) ? use : node;
            return extent_of(teller, name, whole, where, whole);
        };
        const bool symbol = kind_of(node) == "symbol";
        const ViewBox place = {symbol ? 0 : svg::length_of(node, "x", port.width, where),
                               symbol ? 0 : svg::length_of(node, "y", port.height, where),
                               side("width", port.width), side("height", port.height)};
        std::optional<ViewBox> box;
        if (node.attribute("viewBox")) box = svg_view_box(node.attribute("viewBox").value(), where);
        const Affine step = box ? svg_viewport(*box, place, attribute(node, "preserveAspectRatio"))
                                : Affine{1, 0, 0, 1, place.x, place.y};
        inner.transform = moderate(inner.transform * step, where);
        inner.viewport = box ? Viewport{box->width, box->height} : Viewport{place.width, place.height};
    }

    // The first child that needs nothing special.
    void visit_switch(pugi::xml_node node, const Surroundings& outer) {
        const std::optional<Surroundings> inner = enter(node, outer, described(node, attribute(node, "id")));
        if (!inner) return;
        for (const pugi::xml_node child : node.children()) {
            if (child.type() != pugi::node_element || kind_of(child) == "foreignObject") continue;
            if (child.attribute("requiredExtensions")) continue;
            const std::string language = attribute(child, "systemLanguage");
            if (!language.empty() && language.find("en") == std::string::npos) continue;
            return visit(child, *inner);
        }
    }

    void visit_use(pugi::xml_node node, const Surroundings& outer) {
        const std::string element = described(node, attribute(node, "id")), where = file_ + ": " + element;
        const std::string href = reference(node);
        std::optional<Surroundings> inner = enter(node, outer, element);
        if (!inner) return;
        if (!href.starts_with('#'))
            return leave_out(element, href.empty() ? "refers to nothing" : "refers to another file");
        const std::string id = href.substr(1);
        const auto found = identified_.find(id);
        if (found == identified_.end())
            return leave_out(element, "refers to '" + id.substr(0, most_shown) + "', which is not there");
        const pugi::xml_node target = found->second;
        bool inside = std::find(inner->uses.begin(), inner->uses.end(), id) != inner->uses.end();
        for (pugi::xml_node around = node; around; around = around.parent())
            inside = inside || around == target;
        if (inside) return leave_out(element, "refers to itself");
        inner->uses.push_back(id);
        if (const Label label = told_label(node); label != Label::background) inner->label = label;
        const Affine shift = {1,
                              0,
                              0,
                              1,
                              svg::length_of(node, "x", outer.viewport.width, where),
                              svg::length_of(node, "y", outer.viewport.height, where)};
        inner->transform = moderate(inner->transform * shift, where);
        inner->use = is_shape(target) ? node : pugi::xml_node();
        if (kind_of(target) == "symbol" || kind_of(target) == "svg")
            return show_viewport(target, node, *inner);
        visit(target, *inner);
    }
    void show_viewport(pugi::xml_node target, pugi::xml_node use, const Surroundings& outer) {
        const std::string element = described(target, attribute(target, "id"));
        std::optional<Surroundings> inner = enter(target, outer, element);
        if (!inner) return;
        enter_viewport(target, use, *inner, file_ + ": " + element);
        for (const pugi::xml_node child : target.children()) visit(child, *inner);
    }

    // --- names ---------------------------------------------------------------------------------------------

    static std::string name_told(pugi::xml_node node) {
        for (const char* name : {"inkscape:label", "id"})
            if (std::string text = attribute(node, name); !text.empty()) return text;
        for (const pugi::xml_node child : node.children())
            if (kind_of(child) == "title")
                if (std::string text = one_line(text_of(child)); !text.empty()) return text;
        return {};
    }
    // By its names or its classes.
    static Label told_label(pugi::xml_node node) {
        for (const char* name : {"inkscape:label", "id", "class"})
            if (const Label label = known_label(attribute(node, name)); label != Label::background)
                return label;
        return known_label(name_told(node));
    }

    // --- shapes --------------------------------------------------------------------------------------------

    void read_shape(pugi::xml_node node, const Surroundings& outer) {
        const bool by_use = static_cast<bool>(outer.use);
        std::string name = by_use ? name_told(outer.use) : "";
        if (name.empty()) name = name_told(node);
        const std::string id = attribute(node, "id");
        const std::string element =
            described(node, name) + (id.empty() || id == name ? "" : " (id '" + id + "')");
        const std::string where = file_ + ": " + element;
        const std::optional<Surroundings> own = enter(node, outer, element);
        if (!own) return;
        GatheredShape shape;
        shape.element = element;
        shape.name = name;
        shape.label = told_label(node);
        if (shape.label == Label::background) shape.label = own->label;
        const Paint fill = own->look.fill(sheets_, identified_),
                    stroke = own->look.stroke(sheets_, identified_);
        if (!own->look.visible()) return leave_out(element, "not visible");
        if (!fill.seen() && !stroke.seen()) return leave_out(element, "not painted");
        const ShapeOutlines made =
            add_outlines(shape, node, {own->transform, own->viewport, own->look, fill, stroke, where});
        if (made.empty) return leave_out(element, "empty");
        attributes_ = true; // our own: a mistake in them is the user's, and told as one
        add_attributes(node, where, shape.attributes);
        if (by_use) add_attributes(outer.use, where, shape.attributes);
        attributes_ = false;
        if (shape.outlines.empty()) leave_out(element, made.thin.empty() ? "has no area" : "a thin line");
        if (shape.painting.empty()) return;
        shapes_.push_back(std::move(shape));
        thin_.push_back(made.thin);
    }
};

} // namespace
} // namespace svg

bool svg_available() { return true; }

Strokes strokes_from_svg(const std::string& text, const std::string& file) {
    pugi::xml_document document;
    svg::load(document, text, file);
    const pugi::xml_node root = document.document_element();
    if (svg::kind_of(root) != "svg")
        throw Error(ErrorKind::input, file + ": not an SVG file, its root is <" +
                                          svg::one_line(root.name()).substr(0, svg::most_shown) + ">");
    return svg::SvgReader(file).read(root);
}

} // namespace pantin
