// SPDX-License-Identifier: MIT
// Strokes in, strokes with labels out (docs/modeling.md, "Drawings without names").
#include "pipeline/looked_at.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "geometry/extent.hpp"
#include "pantin/detection.hpp"
#include "pantin/image.hpp"
#include "pipeline/drawing_look.hpp"
#include "pipeline/page_picture.hpp"
#include "pipeline/shape_parts.hpp"

namespace pantin {
namespace {

constexpr double least_trunk = 0.8; // share of the trunk's pieces that the largest one has
constexpr int view_side = 500;      // pixels of the view in which parts in space are looked at

bool has_holes(const Strokes& strokes) {
    const auto parts = parts_of(strokes);
    return std::any_of(parts.begin(), parts.end(), [](const PartStroke* p) { return !p->holes.empty(); });
}

// Everything in the plane of the canvas, seen from the front, as any drawing is. Holes that were asked for
// would be lost in what the network cuts.
bool is_flat(const Strokes& strokes) {
    if (strokes.painting.empty() && has_holes(strokes)) return false;
    return std::all_of(strokes.calls.begin(), strokes.calls.end(), [](const ModelCall& call) {
        const auto* part = std::get_if<PartStroke>(&call);
        return part && part->view == Viewpoint::front && part->depth == 0 &&
               part->symmetry == Symmetry::none && part->parent.empty() && part->height == 1 &&
               part->layer == 0 && part->bones;
    });
}

// Of strokes alone: their areas.
Painting painting_of(const Strokes& strokes) {
    if (!strokes.painting.empty()) return strokes.painting;
    Painting painting;
    for (const PartStroke* part : parts_of(strokes)) {
        const Rgb8 colour = part->colour.value_or(row_of(label_of_part(part->name)).solid);
        painting.push_back({{part->stroke}, false, colour, 1, false});
    }
    return painting;
}

// Parts that are drawn from several sides, at depths or in pairs: each has the label of most of what is seen
// of it.
Strokes labelled_in_view(Strokes strokes, Context& context) {
    Model model(strokes, context.options().modeling);
    const SolidMesh mesh = model.united();
    const ModelView view = view_of(model, mesh, view_side);
    const Grid<int> seen = seen_parts(model, view);
    RgbaImage figure(view.width, view.height);
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const int part = seen(x, y);
            if (part < 0) continue;
            const bool edge = seen.value_or(x + 1, y, -1) != part || seen.value_or(x, y + 1, -1) != part;
            const Rgb8 colour = edge ? Rgb8{} : colour_of(model.parts()[static_cast<std::size_t>(part)]);
            figure(x, y) = {colour.r, colour.g, colour.b, 255};
        }
    const PagePicture page = cut_out_picture(figure);
    const Mask opaque = opaque_pixels(figure);
    DetectedCharacter character =
        character_of(page.picture, page.ink, fill_holes(opaque), context.options().detection);
    const Segmentation look = context.segmenter().segment(
        character.ink, character.mask, context.options().segmentation, character.exact_mask);
    std::vector<std::array<long, label_count>> votes(model.parts().size());
    for (int y = 0; y < character.box.height; ++y)
        for (int x = 0; x < character.box.width; ++x) {
            const int part = seen.value_or(character.box.x + x, character.box.y + y, -1);
            const int label = look.labels.value_or(static_cast<int>(x * character.scale),
                                                   static_cast<int>(y * character.scale), 0);
            if (part >= 0) ++votes[static_cast<std::size_t>(part)][static_cast<std::size_t>(label)];
        }
    for (ModelCall& call : strokes.calls) {
        auto* part = std::get_if<PartStroke>(&call);
        if (!part || told(*part) != Label::background) continue;
        long most = 0;
        for (std::size_t p = 0; p < model.parts().size(); ++p) {
            if (model.parts()[p].stroke.name != part->name) continue;
            for (const Label label : part_labels)
                if (const long count = votes[p][static_cast<std::size_t>(label)]; count > most)
                    most = count, part->label = label;
        }
    }
    strokes.repairs.emplace_back("labels of parts without a known name are the part network's");
    return strokes;
}

// A cut that makes scraps of the trunk is no way to see parts in the drawing (a heart, a plain square).
bool holds_together(const Strokes& cut) {
    double largest = 0, all = 0;
    for (const PartStroke* part : parts_of(cut))
        if (part->label == Label::body) {
            const double area = std::abs(area_of(part->stroke));
            largest = std::max(largest, area);
            all += area;
        }
    return largest >= least_trunk * all;
}

} // namespace

bool needs_a_look(const Strokes& strokes) {
    std::set<Label> labels;
    for (const PartStroke* part : parts_of(strokes)) labels.insert(told(*part));
    const bool open = labels.erase(Label::background) > 0;
    // Strokes that were drawn as parts are parts, be it one alone; a painting's paths may be anything.
    if (!open && strokes.painting.empty()) return false;
    return labels.size() < 2 ? open || is_flat(strokes) : open && is_flat(strokes);
}

std::optional<LabelledStrokes> with_decoration(const Strokes& strokes) {
    if (strokes.painting.empty() || !is_flat(strokes)) return {};
    const std::vector<bool> decorates = decoration_of(parts_of(strokes));
    if (std::find(decorates.begin(), decorates.end(), true) == decorates.end()) return {};
    LabelledStrokes result{strokes, {}, true};
    result.strokes.calls.clear();
    std::size_t part = 0;
    for (const ModelCall& call : strokes.calls) {
        const auto* stroke = std::get_if<PartStroke>(&call);
        if (stroke && decorates[part++])
            result.strokes.repairs.push_back(decoration_line(*stroke));
        else
            result.strokes.calls.push_back(call);
    }
    return result;
}

LabelledStrokes labelled_by_look(const Strokes& strokes, const std::string& name, Context& context) {
    LabelledStrokes result;
    if (!is_flat(strokes)) {
        result.strokes = labelled_in_view(strokes, context);
        return result;
    }
    DrawingLook look = look_at(painting_of(strokes), name, context);
    if (std::optional<Strokes> parts = shapes_as_parts(strokes, look, context.options().modeling)) {
        result.strokes = std::move(*parts);
        result.strokes.repairs.emplace_back("labels of parts without a known name are the part network's");
        result.painted = !strokes.painting.empty();
        return result;
    }
    overrule(look, parts_of(strokes));
    result.strokes = strokes_from_labels(look.picture.labels);
    if (parts_of(strokes).size() == 1 && !holds_together(result.strokes)) {
        result.strokes = strokes;
        auto& whole = std::get<PartStroke>(result.strokes.calls.front());
        if (told(whole) == Label::background) whole.label = Label::body;
        result.strokes.repairs.emplace_back("the part network sees no parts that hold together: left whole");
        result.painted = !strokes.painting.empty();
        return result;
    }
    result.strokes.repairs = strokes.repairs;
    result.strokes.repairs.emplace_back("no names tell the parts: cut out of the whole by the part network");
    if (has_holes(strokes)) result.strokes.repairs.emplace_back("holes are filled: the cut parts have none");
    result.picture = std::move(look.picture);
    return result;
}

} // namespace pantin
