// SPDX-License-Identifier: MIT
// strokes.json (docs/formats.md). Parts and calls are read in order, as they will be played: a call knows the
// parts that stand then.
#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "core/json.hpp"
#include "core/json_reader.hpp"
#include "modeling/svg_outlines.hpp"
#include "modeling/thick_line.hpp"
#include "pantin/strokes.hpp"

namespace pantin {
namespace {

constexpr double huge = 1e15;
constexpr double most_degrees = 1e6; // sine and cosine are exact to the last bit up to here
constexpr double most_scale = 1e6, most_share = 10;
constexpr long most_branches = 1'000'000, most_layers = 1000, most_undone = 1'000'000;
constexpr std::size_t most_points = 200'000, thinned_points = 20'000;
constexpr std::array<std::string_view, 3> view_names = {"front", "side", "top"};
constexpr std::array<std::string_view, 4> symmetry_names = {"none", "x", "y", "z"};

// Messages are one line, whatever a file calls its parts.
std::string in_quotes(const std::string& text) {
    std::string line = "'";
    for (const char c : text) line += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    return line + "'";
}

void check_keys(const JsonReader& reader, std::initializer_list<std::string_view> known) {
    if (!reader.value().is_object()) reader.fail("must be an object");
    for (const auto& [key, value] : reader.value().items())
        if (std::find(known.begin(), known.end(), key) == known.end())
            reader.fail("unknown key " + in_quotes(key));
}

// --- values ------------------------------------------------------------------------------------------------

Point2d read_point(const JsonReader& reader) {
    const std::vector<JsonReader> xy = reader.elements(2, 2);
    return {xy[0].number(-huge, huge), xy[1].number(-huge, huge)};
}

double read_positive(const JsonReader& owner, const char* key, double most) {
    const double x = owner.at(key).number(-huge, most);
    if (!(x > 0)) owner.fail(std::string(key) + " must be greater than 0");
    return x;
}

Viewpoint read_view(const JsonReader& reader) {
    const auto found = std::find(view_names.begin(), view_names.end(), reader.text());
    if (found == view_names.end()) reader.fail("must be front, side or top");
    return static_cast<Viewpoint>(found - view_names.begin());
}

// What `true` asks for: a part off the model's middle gets its copy on the other side of it, along the
// direction in which it is seen; one in the middle gets it beside itself on the canvas.
Symmetry usual_symmetry(const PartStroke& part) {
    const bool off = part.depth != 0;
    switch (part.view) {
    case Viewpoint::front:
        return off ? Symmetry::z : Symmetry::x;
    case Viewpoint::side:
        return off ? Symmetry::x : Symmetry::z;
    case Viewpoint::top:
        break;
    }
    return off ? Symmetry::y : Symmetry::x;
}

Symmetry read_symmetry(const JsonReader& reader, const PartStroke& part) {
    if (reader.value().is_boolean()) return reader.boolean() ? usual_symmetry(part) : Symmetry::none;
    const auto first = symmetry_names.begin() + 1; // "none" is written as false
    const auto found = reader.value().is_string() ? std::find(first, symmetry_names.end(), reader.text())
                                                  : symmetry_names.end();
    if (found == symmetry_names.end()) reader.fail("must be true, false, x, y or z");
    return static_cast<Symmetry>(found - symmetry_names.begin());
}

Rgb8 read_colour(const JsonReader& reader) {
    const std::string text = reader.text();
    std::array<int, 6> digits{};
    bool right = text.size() == 7 && text[0] == '#';
    for (std::size_t i = 0; i < 6 && right; ++i) {
        const char c = text[i + 1];
        digits[i] = c >= '0' && c <= '9'   ? c - '0'
                    : c >= 'a' && c <= 'f' ? c - 'a' + 10
                    : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                           : -1;
        right = digits[i] >= 0;
    }
    if (!right) reader.fail("must be a colour, #rrggbb");
    const auto byte = [&](int i) { return static_cast<std::uint8_t>(16 * digits[i] + digits[i + 1]); };
    return {byte(0), byte(2), byte(4)};
}

// --- parts -------------------------------------------------------------------------------------------------

bool has_three_points(const std::vector<Point2d>& points) {
    const auto second =
        std::find_if(points.begin(), points.end(), [&](Point2d p) { return p != points.front(); });
    return std::any_of(second, points.end(), [&](Point2d p) { return p != points.front() && p != *second; });
}

void drop_repeated(std::vector<Point2d>& stroke) {
    stroke.erase(std::unique(stroke.begin(), stroke.end()), stroke.end());
}

// `place` names the part.
void tidy_line(std::vector<Point2d>& stroke, const std::string& place, std::vector<std::string>& repairs) {
    const std::size_t given = stroke.size();
    drop_repeated(stroke);
    if (const std::size_t gone = given - stroke.size())
        repairs.push_back(place + ": " + std::to_string(gone) + " repeated point" + (gone == 1 ? "" : "s") +
                          " dropped");
    if (const std::size_t many = stroke.size(); many > most_points) {
        for (std::size_t i = 0; i < thinned_points; ++i) stroke[i] = stroke[i * many / thinned_points];
        stroke.resize(thinned_points);
        drop_repeated(stroke);
        repairs.push_back(place + ": " + std::to_string(many) + " points thinned to " +
                          std::to_string(stroke.size()));
    }
}
void tidy_stroke(std::vector<Point2d>& stroke, const JsonReader& reader, const std::string& place,
                 std::vector<std::string>& repairs) {
    tidy_line(stroke, place, repairs);
    // A stroke that ends where it began says once more what holds of every stroke.
    if (stroke.size() > 1 && stroke.front() == stroke.back()) stroke.pop_back();
    if (!has_three_points(stroke)) reader.fail("a stroke needs at least three points");
}

// Whether most of the line's points, or of some of them, lie in the stroke.
bool lies_in(const std::vector<Point2d>& line, const std::vector<Point2d>& stroke) {
    constexpr std::size_t probes = 64;
    std::vector<Point2d> some;
    const std::size_t n = std::min(probes, line.size());
    for (std::size_t i = 0; i < n; ++i) some.push_back(line[i * line.size() / n]);
    return share_inside(some, stroke) > 0.5;
}

class StrokesReader {
public:
    explicit StrokesReader(const JsonReader& root) : root_(root) {}

    Strokes read() {
        check_keys(root_, {"origin", "parts", "calls"});
        if (root_.has("parts"))
            for (const JsonReader& item : root_.at("parts").elements()) {
                if (item.has("hole") && item.at("hole").boolean())
                    read_hole(item);
                else
                    read_part(item);
            }
        if (root_.has("calls"))
            for (const JsonReader& item : root_.at("calls").elements()) read_call(item);
        if (!first_part_) root_.fail("holds no part");
        strokes_.origin = root_.has("origin") ? read_point(root_.at("origin")) : *first_part_;
        return std::move(strokes_);
    }

    // The calls of another file, after those of `strokes`.
    Strokes append_to(Strokes strokes) {
        check_keys(root_, {"calls"});
        strokes_ = std::move(strokes);
        know_all();
        first_part_ = strokes_.origin;
        for (const JsonReader& item : root_.at("calls").elements()) read_call(item);
        return std::move(strokes_);
    }

private:
    const JsonReader& root_;
    Strokes strokes_;
    std::map<std::string, PartStroke> parts_; // that stand now, without their strokes
    std::optional<Point2d> first_part_;       // the middle of its bounding box

    void read_part(const JsonReader& item) {
        PartStroke part;
        part.name = item.at("name").text();
        if (part.name.empty()) item.at("name").fail("must not be empty");
        // From here on the part is known by its name, which says more than its number and is all that there
        // is in an SVG.
        const std::string place = "part " + in_quotes(part.name);
        const JsonReader reader(item.value(), item.file(), place);
        check_keys(reader, {"name", "stroke", "closed", "width", "holes", "hole", "depth", "view",
                            "symmetric", "parent", "height", "label", "colour", "layer", "bones"});
        if (reader.has("hole") && reader.at("hole").boolean())
            reader.fail("a hole stands among `parts`, or in the `holes` of its part");
        if (parts_.contains(part.name)) reader.fail("there are two parts of this name");
        read_shape(reader, place, part);
        read_attributes(reader, part);
        if (!first_part_) first_part_ = middle_of(part.stroke);
        know(part);
        strokes_.calls.emplace_back(std::move(part));
    }
    // Of a part, or of a call that draws one anew.
    template <class Shape> void read_shape(const JsonReader& reader, const std::string& place, Shape& shape) {
        const bool open = reader.has("closed") && !reader.at("closed").boolean();
        if (!open && reader.has("width")) reader.fail("only an open stroke (`closed`: false) has a width");
        shape.stroke = open ? read_tube(reader, place) : read_stroke(reader.at("stroke"), reader, place);
        if (reader.has("holes"))
            for (const JsonReader& hole : reader.at("holes").elements())
                shape.holes.push_back(read_stroke(hole, reader, place + ", a hole"));
    }
    std::vector<Point2d> read_stroke(const JsonReader& points, const JsonReader& reader,
                                     const std::string& place) {
        std::vector<Point2d> stroke;
        for (const JsonReader& pair : points.elements()) stroke.push_back(read_point(pair));
        tidy_stroke(stroke, reader, place, strokes_.repairs);
        return stroke;
    }
    // The border of an open stroke of some width, with round ends.
    std::vector<Point2d> read_tube(const JsonReader& reader, const std::string& place) {
        if (!reader.has("width")) reader.fail("an open stroke needs a `width`");
        if (reader.has("holes")) reader.fail("an open stroke has no holes");
        std::vector<Point2d> line;
        for (const JsonReader& pair : reader.at("stroke").elements()) line.push_back(read_point(pair));
        tidy_line(line, place, strokes_.repairs);
        if (line.size() < 2) reader.fail("an open stroke needs at least two points");
        LineStyle style;
        style.width = read_positive(reader, "width", huge);
        style.cap = LineCap::round;
        style.join = LineJoin::round;
        return thick_line(line, style);
    }
    // Of the latest part before it that is seen from the same side and holds it.
    void read_hole(const JsonReader& item) {
        const std::string place = item.has("name") ? "hole " + in_quotes(item.at("name").text()) : "a hole";
        const JsonReader reader(item.value(), item.file(), place);
        check_keys(reader, {"name", "stroke", "hole", "view"});
        const Viewpoint view = reader.has("view") ? read_view(reader.at("view")) : Viewpoint::front;
        std::vector<Point2d> stroke = read_stroke(reader.at("stroke"), reader, place);
        for (auto call = strokes_.calls.rbegin(); call != strokes_.calls.rend(); ++call)
            if (auto* part = std::get_if<PartStroke>(&*call);
                part && part->view == view && lies_in(stroke, part->stroke)) {
                part->holes.push_back(std::move(stroke));
                return;
            }
        reader.fail("lies in no part before it");
    }
    void know_all() {
        parts_.clear();
        for (const ModelCall& call : strokes_.calls) {
            if (const auto* part = std::get_if<PartStroke>(&call)) know(*part);
            if (const auto* gone = std::get_if<RemovePart>(&call)) parts_.erase(gone->part);
        }
    }
    void know(const PartStroke& part) {
        PartStroke& known = parts_[part.name];
        known.depth = part.depth;
        known.view = part.view;
    }
    void read_attributes(const JsonReader& reader, PartStroke& part) const {
        if (reader.has("depth")) part.depth = reader.at("depth").number(-huge, huge);
        if (reader.has("view")) part.view = read_view(reader.at("view"));
        if (reader.has("symmetric")) part.symmetry = read_symmetry(reader.at("symmetric"), part);
        if (reader.has("parent")) part.parent = reader.at("parent").text();
        if (part.parent == part.name) reader.fail("is its own parent");
        if (!part.parent.empty() && !parts_.contains(part.parent))
            reader.fail("the parent " + in_quotes(part.parent) + " does not come before it");
        if (reader.has("height")) part.height = read_positive(reader, "height", huge);
        if (reader.has("label")) {
            part.label = label_from_name(reader.at("label").text());
            if (part.label == Label::background) reader.at("label").fail("must be " + listed_parts());
        }
        if (reader.has("colour")) part.colour = read_colour(reader.at("colour"));
        if (reader.has("layer"))
            part.layer = static_cast<int>(reader.at("layer").integer(-most_layers, most_layers));
        if (reader.has("bones")) part.bones = reader.at("bones").boolean();
    }
    static Point2d middle_of(const std::vector<Point2d>& stroke) {
        Point2d low = stroke.front(), high = low;
        for (const Point2d p : stroke) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
        return 0.5 * (low + high);
    }

    void read_call(const JsonReader& item) {
        if (!item.value().is_object() || item.value().size() != 1)
            item.fail("must be an object with one key, the call");
        const auto [name, reader] = item.entries().front();
        if (name == "add_part")
            read_part(reader);
        else if (name == "move_part")
            strokes_.calls.emplace_back(read_move(reader));
        else if (name == "set_symmetry")
            strokes_.calls.emplace_back(read_set_symmetry(reader));
        else if (name == "refine")
            strokes_.calls.emplace_back(read_refine(reader));
        else if (name == "remove_part")
            read_remove(reader);
        else if (name == "set_height")
            strokes_.calls.emplace_back(read_set_height(reader));
        else if (name == "redraw_part")
            strokes_.calls.emplace_back(read_redraw(reader));
        else if (name == "undo")
            undo(reader);
        else
            item.fail("there is no call " + in_quotes(name));
    }
    std::string known_part(const JsonReader& reader) const {
        const std::string name = reader.text();
        if (!parts_.contains(name)) reader.fail("there is no part " + in_quotes(name) + " here");
        return name;
    }
    MovePart read_move(const JsonReader& reader) const {
        check_keys(reader, {"part", "translate", "rotate", "scale"});
        MovePart move;
        move.part = known_part(reader.at("part"));
        if (reader.has("translate")) {
            const std::vector<JsonReader> xyz = reader.at("translate").elements(3, 3);
            move.translate = {xyz[0].number(-huge, huge), xyz[1].number(-huge, huge),
                              xyz[2].number(-huge, huge)};
        }
        if (reader.has("rotate")) {
            const JsonReader rotate = reader.at("rotate");
            check_keys(rotate, {"axis", "degrees"});
            const std::string axis = rotate.at("axis").text();
            if (axis != "x" && axis != "y" && axis != "z") rotate.at("axis").fail("must be x, y or z");
            move.axis = axis[0];
            move.degrees = rotate.at("degrees").number(-most_degrees, most_degrees);
        }
        const JsonReader named(reader.value(), reader.file(), "move_part of " + in_quotes(move.part));
        if (named.has("scale")) move.scale = read_positive(named, "scale", most_scale);
        return move;
    }
    SetSymmetry read_set_symmetry(const JsonReader& reader) const {
        check_keys(reader, {"part", "symmetric"});
        const std::string part = known_part(reader.at("part"));
        return {part, read_symmetry(reader.at("symmetric"), parts_.at(part))};
    }
    SetHeight read_set_height(const JsonReader& reader) const {
        check_keys(reader, {"part", "height"});
        return {known_part(reader.at("part")), read_positive(reader, "height", huge)};
    }
    RedrawPart read_redraw(const JsonReader& item) {
        RedrawPart redraw;
        redraw.part = known_part(item.at("part"));
        const std::string place = "redraw_part of " + in_quotes(redraw.part);
        const JsonReader reader(item.value(), item.file(), place);
        check_keys(reader, {"part", "stroke", "closed", "width", "holes"});
        read_shape(reader, place, redraw);
        return redraw;
    }
    // Parts count as calls; what is taken back leaves no trace.
    void undo(const JsonReader& reader) {
        const auto count = static_cast<std::size_t>(reader.integer(1, most_undone));
        if (count > strokes_.calls.size()) reader.fail("there are not so many calls to take back");
        strokes_.calls.resize(strokes_.calls.size() - count);
        know_all();
    }
    RefineSkeleton read_refine(const JsonReader& reader) const {
        check_keys(reader, {"part", "branch", "simplify", "prune", "merge", "collapse"});
        RefineSkeleton refine;
        if (reader.has("part")) refine.part = known_part(reader.at("part"));
        if (reader.has("branch")) {
            refine.branch = static_cast<int>(reader.at("branch").integer(0, most_branches));
            if (refine.part.empty()) reader.fail("a branch needs a part");
            if (reader.has("prune") || reader.has("merge") || reader.has("collapse"))
                reader.fail("a branch alone knows simplify only");
        }
        const auto share = [&](const char* key, std::optional<double>& value) {
            if (reader.has(key)) value = reader.at(key).number(0, most_share);
        };
        share("simplify", refine.simplify);
        share("prune", refine.prune);
        share("merge", refine.merge);
        share("collapse", refine.collapse);
        return refine;
    }
    void read_remove(const JsonReader& reader) {
        const std::string part = known_part(reader);
        parts_.erase(part);
        strokes_.calls.emplace_back(RemovePart{part});
    }
};

// --- writing -----------------------------------------------------------------------------------------------

Json json_of(Symmetry symmetry) {
    if (symmetry == Symmetry::none) return false;
    return std::string(symmetry_names[static_cast<std::size_t>(symmetry)]);
}

std::string text_of(Rgb8 colour) {
    std::string text = "#";
    for (const int byte : {colour.r, colour.g, colour.b}) {
        text += "0123456789abcdef"[byte / 16];
        text += "0123456789abcdef"[byte % 16];
    }
    return text;
}

Json json_of(const std::vector<Point2d>& line) {
    Json points = Json::array();
    for (const Point2d p : line) points.push_back(Json::array({p.x, p.y}));
    return points;
}

Json json_of(const PartStroke& part) {
    Json item;
    item["name"] = part.name;
    item["stroke"] = json_of(part.stroke);
    for (const std::vector<Point2d>& hole : part.holes) item["holes"].push_back(json_of(hole));
    if (part.depth != 0) item["depth"] = part.depth;
    if (part.view != Viewpoint::front)
        item["view"] = std::string(view_names[static_cast<std::size_t>(part.view)]);
    if (part.symmetry != Symmetry::none) item["symmetric"] = json_of(part.symmetry);
    if (!part.parent.empty()) item["parent"] = part.parent;
    if (part.height != 1) item["height"] = part.height;
    if (part.label != Label::background) item["label"] = std::string(name_of(part.label));
    if (part.colour) item["colour"] = text_of(*part.colour);
    if (part.layer != 0) item["layer"] = part.layer;
    if (!part.bones) item["bones"] = false;
    return item;
}

Json call(const char* name, Json value) {
    Json json;
    json[name] = std::move(value);
    return json;
}

struct CallWriter {
    Json operator()(const PartStroke& part) const { return call("add_part", json_of(part)); }
    Json operator()(const MovePart& move) const {
        Json item;
        item["part"] = move.part;
        const Vec3 t = move.translate;
        if (t != Vec3{}) item["translate"] = Json::array({t.x, t.y, t.z});
        if (move.degrees != 0 || move.axis != 'z') {
            item["rotate"]["axis"] = std::string(1, move.axis);
            item["rotate"]["degrees"] = move.degrees;
        }
        if (move.scale != 1) item["scale"] = move.scale;
        return call("move_part", item);
    }
    Json operator()(const SetSymmetry& set) const {
        Json item;
        item["part"] = set.part;
        item["symmetric"] = json_of(set.symmetry);
        return call("set_symmetry", item);
    }
    Json operator()(const RefineSkeleton& refine) const {
        Json item = Json::object();
        if (!refine.part.empty()) item["part"] = refine.part;
        if (refine.branch >= 0) item["branch"] = refine.branch;
        if (refine.simplify) item["simplify"] = *refine.simplify;
        if (refine.prune) item["prune"] = *refine.prune;
        if (refine.merge) item["merge"] = *refine.merge;
        if (refine.collapse) item["collapse"] = *refine.collapse;
        return call("refine", item);
    }
    Json operator()(const SetHeight& set) const {
        Json item;
        item["part"] = set.part;
        item["height"] = set.height;
        return call("set_height", item);
    }
    Json operator()(const RedrawPart& redraw) const {
        Json item;
        item["part"] = redraw.part;
        item["stroke"] = json_of(redraw.stroke);
        for (const std::vector<Point2d>& hole : redraw.holes) item["holes"].push_back(json_of(hole));
        return call("redraw_part", item);
    }
    Json operator()(const RemovePart& remove) const { return call("remove_part", remove.part); }
};

} // namespace

Strokes strokes_from_json(const std::string& text, const std::string& file) {
    const Json json = parse_json(text, file);
    const JsonReader root(json, file);
    return StrokesReader(root).read();
}

Strokes with_calls(Strokes strokes, const std::string& text, const std::string& file) {
    const Json json = parse_json(text, file);
    const JsonReader root(json, file);
    return StrokesReader(root).append_to(std::move(strokes));
}

std::string strokes_to_json(const Strokes& strokes) {
    Json json;
    json["origin"] = Json::array({strokes.origin.x, strokes.origin.y});
    auto call = strokes.calls.begin();
    for (; call != strokes.calls.end() && std::holds_alternative<PartStroke>(*call); ++call)
        json["parts"].push_back(json_of(std::get<PartStroke>(*call)));
    for (; call != strokes.calls.end(); ++call) json["calls"].push_back(std::visit(CallWriter{}, *call));
    return to_json_text(json);
}

} // namespace pantin
