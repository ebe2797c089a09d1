// SPDX-License-Identifier: MIT
// What a model is made of (Ma et al., RealSkel, 2021): the outlines of its parts in modelling order, and
// calls that change it.
//
// Strokes are drawn on one canvas, x to the right, y down, in any unit. The canvas shows the model from one
// of three sides; `origin` is the point of the canvas where the model's origin is seen, from each side. The
// model's own frame is right-handed: x to the right, y up, z towards the viewer in front. A canvas point
// (u, v), measured from the origin, at depth d lies at
//   front: ( u, −v,  d)   seen from +z
//   side:  ( d, −v, −u)   seen from +x
//   top:   ( u,  d,  v)   seen from +y
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/label.hpp"
#include "pantin/painting.hpp"
#include "pantin/point.hpp"

namespace pantin {

enum class Viewpoint { front, side, top };
enum class Symmetry {
    none,
    x,
    y,
    z
}; // normal of the plane through the model's origin in which a copy is mirrored

struct PartStroke {
    std::string name;            // not empty, of one part only
    std::vector<Point2d> stroke; // canvas; closed on its own; at least three points
    double depth = 0;            // canvas units, towards the viewer
    Viewpoint view = Viewpoint::front;
    Symmetry symmetry = Symmetry::none;
    std::string parent;              // a part that comes before; empty: found by intersection
    double height = 1;               // thickness; a long part of height 1 is round
    Label label = Label::background; // background: from the name
    std::optional<Rgb8> colour;
    std::vector<std::vector<Point2d>> holes{}; // canvas; each as a stroke, inside it
    // Of two parts that overlap on one canvas the one of the higher layer is pushed in front of the other,
    // or the one of the lower, negative layer behind it, by the other's half thickness there.
    int layer = 0;
    bool bones = true; // otherwise it moves with the part that it hangs on, as an eye does
    bool operator==(const PartStroke&) const = default;
};

// --- calls -------------------------------------------------------------------------------------------------

// In this order: scaled, then turned about the axis of the model's frame, both about the part's own centre,
// then moved.
struct MovePart {
    std::string part;
    Vec3 translate;     // model's frame, canvas units
    char axis = 'z';    // 'x', 'y' or 'z'
    double degrees = 0; // counter-clockwise seen from the axis' positive end
    double scale = 1;   // > 0
    bool operator==(const MovePart&) const = default;
};
struct SetSymmetry {
    std::string part;
    Symmetry symmetry = Symmetry::none;
    bool operator==(const SetSymmetry&) const = default;
};
// Section 3.3. Without a part: the whole model; with a part and a branch ≥ 0: that branch alone, which knows
// `simplify` only. What is not given stays. Shares of the model's diagonal
// (with `per_part` of the part's: of its stroke's bounding box).
struct RefineSkeleton {
    std::string part;
    int branch = -1;
    std::optional<double> simplify, prune, merge, collapse;
    bool operator==(const RefineSkeleton&) const = default;
};
// A part's thickness. Section 4.1.
struct SetHeight {
    std::string part;
    double height = 1; // > 0
    bool operator==(const SetHeight&) const = default;
};
// Another outline for a part that stands.
struct RedrawPart {
    std::string part;
    std::vector<Point2d> stroke;
    std::vector<std::vector<Point2d>> holes{};
    bool operator==(const RedrawPart&) const = default;
};
struct RemovePart {
    std::string part;
    bool operator==(const RemovePart&) const = default;
};
using ModelCall = std::variant<PartStroke, MovePart, SetSymmetry, RefineSkeleton, RemovePart, SetHeight,
                               RedrawPart>; // PartStroke: adds the part

struct Strokes {
    Point2d origin;
    std::vector<ModelCall> calls;     // parts in modelling order, then what else was asked for
    std::vector<std::string> repairs; // what was wrong and what was done about it, one line each
    // Of an SVG: all that it shows, decoration too; of JSON nothing.
    Painting painting;
};

// Strokes of a JSON text (docs/modeling.md, "strokes.json"), canvas units. `file` stands in messages.
// Error(input) names it, the place and the fact. Own format.
Strokes strokes_from_json(const std::string& text, const std::string& file);
// The text that reads back to the same strokes, to the bit. No error. Own.
std::string strokes_to_json(const Strokes& strokes);
// The strokes with the calls of another text, {"calls": […]}, after their own. Errors as strokes_from_json().
// Own.
Strokes with_calls(Strokes strokes, const std::string& text, const std::string& file);
// Every shape of an SVG that is painted is a part, in painting order, and so is each outline of a path
// (docs/modeling.md, "SVG strokes"); canvas units are the SVG's user units. What is left out is a line of
// `repairs`. Error(input) names `file` and what is wrong; Error(usage) in a build without pugixml. Own, by
// SVG 2 (W3C 2018).
Strokes strokes_from_svg(const std::string& text, const std::string& file);
// Whether this build has strokes_from_svg(). No error. Own.
bool svg_available();

// What a single word in small letters says: "ears", "leftwing"; `background` when it is not known. No error.
// Own.
Label label_of_word(std::string_view word);
// The label that a part's name asks for: "left_wing" wing, "ear" head, "body" body, "claw" limb; limb when no
// word of it is known. No error. Own.
Label label_of_part(const std::string& name);
// The same, but background when no word of it is known. No error. Own.
Label known_label(const std::string& name);

} // namespace pantin
