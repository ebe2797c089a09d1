// SPDX-License-Identifier: MIT
// Gathered shapes in, strokes out (docs/modeling.md, "SVG strokes").
#include "modeling/pugixml/svg_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "geometry/extent.hpp"
#include "modeling/svg_outlines.hpp"

namespace pantin::svg {
namespace {

constexpr double ground_share = 0.95; // of the page, and of its own box, that a ground fills
constexpr double disc_share = 0.78;   // of its box, that a disc or a rounded sheet fills at least
constexpr double badge_share = 0.6;   // of the points of what is on a disc that lie inside it
constexpr double frame_share = 0.93;  // of its box, that a frame encloses …
constexpr double framed_share = 0.5;  // … and of its sides, what stands in it
constexpr double shadow_flatness = 2.5, shadow_width = 0.3, shadow_depth = 0.85; // of what casts it
constexpr int grey_spread = 40;                                                  // between the channels
constexpr double page_slack = 0.01;  // of the page's sides: so far beyond it a shape still counts as seen
constexpr double same_share = 0.004; // of the diagonal: boxes so near are those of one shape …
constexpr double same_area = 0.03;   // … when their areas differ no more

struct Extent {
    Point2d low, high;
    double width() const { return high.x - low.x; }
    double height() const { return high.y - low.y; }
    double area() const { return width() * height(); }
    bool holds(const Extent& e, double slack) const {
        return e.low.x >= low.x - slack && e.low.y >= low.y - slack && e.high.x <= high.x + slack &&
               e.high.y <= high.y + slack;
    }
    bool meets(const Extent& e) const {
        return e.low.x <= high.x && e.low.y <= high.y && e.high.x >= low.x && e.high.y >= low.y;
    }
};

void add(std::optional<Extent>& extent, const std::vector<Point2d>& points) {
    for (const Point2d p : points) {
        if (!extent) extent = {p, p};
        extent->low = {std::min(extent->low.x, p.x), std::min(extent->low.y, p.y)};
        extent->high = {std::max(extent->high.x, p.x), std::max(extent->high.y, p.y)};
    }
}

Extent extent_of(const GatheredShape& shape) {
    std::optional<Extent> extent;
    for (const PaintedShape& painted : shape.painting)
        for (const std::vector<Point2d>& outline : painted.outlines) add(extent, outline);
    return extent.value_or(Extent{});
}

class Assembler {
public:
    Assembler(std::vector<GatheredShape> shapes, std::vector<std::string> repairs, const std::string& file)
        : shapes_(std::move(shapes)), repairs_(std::move(repairs)), file_(file) {}

    Strokes strokes(const std::optional<ViewBox>& page, const Json& origin) {
        if (page) leave_out_unseen({{page->x, page->y}, {page->x + page->width, page->y + page->height}});
        leave_out_frames();
        leave_out_shadows();
        leave_out_copies();
        settle_labels();
        Painting painting;
        Json parts = Json::array();
        for (GatheredShape& shape : shapes_) {
            for (PaintedShape& painted : shape.painting) painting.push_back(std::move(painted));
            add_parts(shape, parts);
        }
        Json json;
        if (!origin.is_null()) json["origin"] = origin;
        json["parts"] = std::move(parts);
        Strokes strokes = strokes_from_json(to_compact_json_text(json), file_);
        strokes.repairs.insert(strokes.repairs.begin(), repairs_.begin(), repairs_.end());
        strokes.painting = std::move(painting);
        return strokes;
    }

private:
    std::vector<GatheredShape> shapes_;
    std::vector<std::string> repairs_;
    const std::string& file_;
    std::map<std::string, int> names_; // with the number that the latest of the name got
    std::size_t parts_ = 0;

    void leave_out(std::size_t i, const std::string& why) {
        repairs_.push_back(shapes_[i].element + ": " + why + ", left out");
        shapes_.erase(shapes_.begin() + static_cast<std::ptrdiff_t>(i));
    }

    // What lies outside the page, and a ground behind everything.
    void leave_out_unseen(const Extent& page) {
        const double slack = page_slack * std::max(page.width(), page.height());
        const bool any = std::any_of(shapes_.begin(), shapes_.end(), [&](const GatheredShape& s) {
            return page.meets(extent_of(s)) && !s.outlines.empty();
        });
        for (std::size_t i = 0; any && i < shapes_.size();)
            if (page.meets(extent_of(shapes_[i])))
                ++i;
            else
                leave_out(i, "outside the page");
        while (shapes_.size() > 1 && is_ground(page, slack)) leave_out(0, "a ground that covers the page");
        leave_out_bands(page, slack);
    }
    // Bands across the page behind everything that cover it together: sky and grass.
    void leave_out_bands(const Extent& page, double slack) {
        std::size_t bands = 0;
        double covered = 0;
        while (bands + 1 < shapes_.size() && is_band(shapes_[bands], page, slack)) {
            const Extent own = extent_of(shapes_[bands++]);
            covered += std::min(own.high.y, page.high.y) - std::max(own.low.y, page.low.y);
        }
        if (bands < 2 || covered < ground_share * page.height()) return;
        while (bands-- > 0) leave_out(0, "a ground as wide as the page");
    }
    static bool is_band(const GatheredShape& shape, const Extent& page, double slack) {
        if (!shape.filled || shape.outlines.size() != 1 || !shape.attributes.empty() || is_named(shape))
            return false;
        const Extent own = extent_of(shape);
        return own.low.x <= page.low.x + slack && own.high.x >= page.high.x - slack &&
               std::abs(area_of(shape.outlines[0])) >= ground_share * own.area();
    }
    static bool is_named(const GatheredShape& shape) {
        return known_label(shape.name) != Label::background || shape.label != Label::background;
    }
    Extent extent_without(std::size_t but) const {
        std::optional<Extent> all;
        for (std::size_t i = 0; i < shapes_.size(); ++i)
            if (i != but && !shapes_[i].outlines.empty()) {
                const Extent own = extent_of(shapes_[i]);
                add(all, {own.low, own.high});
            }
        return all.value_or(Extent{});
    }

    // Rectangles without fill, or with a hole for a fill, that stand around everything else.
    void leave_out_frames() {
        for (std::size_t i = 0; i < shapes_.size();)
            if (is_frame(i))
                leave_out(i, "a frame around everything");
            else
                ++i;
    }
    bool is_frame(std::size_t i) const {
        const GatheredShape& shape = shapes_[i];
        if (shape.outlines.size() != 1 || is_named(shape) || !shape.attributes.empty()) return false;
        const Extent own = extent_of(shape), others = extent_without(i);
        if (!(others.area() > 0) || !own.holds(others, 0)) return false;
        if (std::abs(area_of(shape.outlines[0])) < frame_share * own.area()) return false;
        if (shape.filled && !is_hollow(shape.painting.front(), others)) return false;
        return std::max(others.width() / own.width(), others.height() / own.height()) >= framed_share;
    }
    // A fill with a hole in which everything else lies.
    static bool is_hollow(const PaintedShape& fill, const Extent& others) {
        if (fill.outlines.size() != 2) return false;
        std::optional<Extent> a, b;
        add(a, fill.outlines[0]), add(b, fill.outlines[1]);
        return (a->area() < b->area() ? *a : *b).holds(others, 0);
    }

    // Flat grey or translucent ellipses below the feet, behind what stands there.
    void leave_out_shadows() {
        for (std::size_t i = 0; i + 1 < shapes_.size();)
            if (is_shadow(i))
                leave_out(i, "a shadow on the ground");
            else
                ++i;
    }
    bool is_shadow(std::size_t i) const {
        const GatheredShape& shape = shapes_[i];
        if (!shape.filled || shape.outlines.size() != 1 || is_named(shape) || !shape.attributes.empty())
            return false;
        const Extent own = extent_of(shape), others = extent_without(i);
        const PaintedShape& fill = shape.painting.front();
        const int spread = std::max({fill.colour.r, fill.colour.g, fill.colour.b}) -
                           std::min({fill.colour.r, fill.colour.g, fill.colour.b});
        const bool flat = own.width() >= shadow_flatness * own.height() &&
                          own.width() >= shadow_width * others.width() &&
                          std::abs(area_of(shape.outlines[0])) >= 0.9 * disc_share * own.area();
        const bool below = 0.5 * (own.low.y + own.high.y) >= others.low.y + shadow_depth * others.height();
        return others.area() > 0 && flat && below && (fill.opacity < 1 || spread <= grey_spread);
    }
    // Whether the first shape is a sheet or a disc as large as the page, which holds all others.
    bool is_ground(const Extent& page, double slack) const {
        const GatheredShape& first = shapes_.front();
        if (!first.filled || first.outlines.size() != 1 || !first.attributes.empty()) return false;
        const Extent own = extent_of(first);
        const double area = std::abs(area_of(first.outlines[0]));
        const Extent seen{{std::max(own.low.x, page.low.x), std::max(own.low.y, page.low.y)},
                          {std::min(own.high.x, page.high.x), std::min(own.high.y, page.high.y)}};
        if (seen.width() <= 0 || seen.height() <= 0) return false;
        const bool sheet = seen.area() >= ground_share * page.area() && area >= ground_share * own.area();
        const bool large = own.width() >= ground_share * page.width() - slack &&
                           own.height() >= ground_share * page.height() - slack;
        if (sheet) return true;
        return large && area >= disc_share * own.area() && known_label(first.name) == Label::background &&
               std::all_of(shapes_.begin() + 1, shapes_.end(), [&](const GatheredShape& s) {
                   return s.painting.empty() || lies_on(s, first.outlines[0]);
               });
    }
    // Whether most of the shape's points are inside the outline; a head may look out of its badge.
    static bool lies_on(const GatheredShape& shape, const std::vector<Point2d>& outline) {
        double inside = 0, all = 0;
        for (const PaintedShape& painted : shape.painting)
            for (const std::vector<Point2d>& points : painted.outlines) {
                const auto count = static_cast<double>(points.size());
                all += count, inside += count * share_inside(points, outline);
            }
        return inside >= badge_share * all;
    }

    // The outline of a filled shape that is drawn as a shape of its own, before or behind it.
    void leave_out_copies() {
        std::vector<std::pair<std::size_t, Measure>> fills, lines;
        for (std::size_t i = 0; i < shapes_.size(); ++i)
            if (shapes_[i].outlines.size() == 1)
                (shapes_[i].filled ? fills : lines).emplace_back(i, measure_of(shapes_[i].outlines[0]));
        for (const auto& [l, line] : lines)
            for (const auto& [f, fill] : fills) {
                GatheredShape &outline = shapes_[l], &shape = shapes_[f];
                if (shape.attributes != outline.attributes || !is_same(line, fill)) continue;
                repairs_.push_back(outline.element + ": the outline of " + shape.element +
                                   ", no part of its own");
                if (known_label(shape.name) == Label::background &&
                    known_label(outline.name) != Label::background)
                    shape.name = outline.name;
                outline.outlines.clear();
                break;
            }
    }
    struct Measure {
        Extent extent;
        double area = 0, diagonal = 0;
    };
    static Measure measure_of(const std::vector<Point2d>& outline) {
        std::optional<Extent> extent;
        add(extent, outline);
        return {*extent, std::abs(area_of(outline)), diagonal_of(outline)};
    }
    static bool is_same(const Measure& a, const Measure& b) {
        const double near = same_share * a.diagonal;
        return a.extent.holds(b.extent, near) && b.extent.holds(a.extent, near) &&
               std::abs(a.area - b.area) <= same_area * std::max(a.area, b.area);
    }

    // What classes and groups tell counts only where it tells parts apart.
    void settle_labels() {
        std::set<Label> told;
        for (const GatheredShape& shape : shapes_) {
            if (shape.outlines.empty()) continue;
            const Label own = known_label(shape.name);
            told.insert(own == Label::background ? shape.label : own);
        }
        if (told.size() > 1) return;
        for (GatheredShape& shape : shapes_) shape.label = Label::background;
    }

    static Json points_of(const std::vector<Point2d>& line) {
        Json points = Json::array();
        for (const Point2d p : line) points.push_back(Json::array({p.x, p.y}));
        return points;
    }
    void add_parts(const GatheredShape& shape, Json& parts) {
        const std::string asked = shape.name.empty() ? "" : shape.name;
        for (std::size_t i = 0; i < shape.outlines.size(); ++i) {
            Json part;
            part["name"] =
                own_name(asked.empty() ? "part-" + std::to_string(++parts_) : (++parts_, asked), i > 0);
            const std::string place = "part '" + part["name"].get<std::string>() + "'";
            if (i == 0)
                for (const std::string& note : shape.notes) repairs_.push_back(place + ": " + note);
            part["stroke"] = points_of(shape.outlines[i]);
            if (i < shape.holes.size())
                for (const std::vector<Point2d>& hole : shape.holes[i])
                    part["holes"].push_back(points_of(hole));
            if (known_label(asked) == Label::background && shape.label != Label::background)
                part["label"] = name_of(shape.label);
            for (const auto& [key, value] : shape.attributes.items()) part[key] = value;
            if (shape.colour) part["colour"] = *shape.colour;
            parts.push_back(std::move(part));
        }
    }
    // The name itself for the first that asks for it, then "name-2", "name-3", …, as far as these are free.
    std::string own_name(const std::string& asked, bool again) {
        if (names_.try_emplace(asked, 1).second) return asked;
        std::string name;
        do name = asked + "-" + std::to_string(++names_[asked]);
        while (!names_.try_emplace(name, 1).second);
        repairs_.push_back(
            "part '" + name + "': " +
            (again ? "one more outline of '" + asked + "'" : "there was a part '" + asked + "' before it"));
        return name;
    }
};

} // namespace

Strokes strokes_of(std::vector<GatheredShape> shapes, const std::optional<ViewBox>& page, const Json& origin,
                   std::vector<std::string> repairs, const std::string& file) {
    return Assembler(std::move(shapes), std::move(repairs), file).strokes(page, origin);
}

} // namespace pantin::svg
