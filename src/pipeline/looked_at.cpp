// SPDX-License-Identifier: MIT
// Strokes in, strokes with labels out (docs/modeling.md, "Drawings without names").
#include "pipeline/looked_at.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

#include "core/plural.hpp"
#include "image/label_map.hpp"
#include "pantin/detection.hpp"
#include "pantin/error.hpp"
#include "pantin/image.hpp"
#include "pipeline/page_picture.hpp"

namespace pantin {
namespace {

constexpr int picture_side = 1000;      // pixels of the drawing that the network sees
constexpr double margin = 0.06;         // of its longer side, on each side
constexpr double found_share = 0.7;     // of what is drawn, that a detected character has at least
constexpr std::size_t most_parts = 60;  // of a drawing whose shapes may be its parts
// Least share of a part's pixels with its label: of parts larger than this share of the silhouette, …
struct Purity {
    double size = 0, least = 0;
};
constexpr std::array<Purity, 2> purities = {{{0.2, 0.65}, {0.04, 0.5}}};
constexpr double agreed_share = 0.75; // … and of all parts together
constexpr double inside_share = 0.97;   // of a shape lies on one below it that is …
constexpr double inside_size = 0.35;    // … so much larger: it decorates that one
constexpr double covered_share = 0.8;   // of the silhouette that parts have to cover
constexpr double line_share = 0.5;      // of a hole's border is lines when the hole is the inside of an outline

using Parts = std::vector<const PartStroke*>;

Parts parts_of(const Strokes& strokes) {
    Parts parts;
    for (const ModelCall& call : strokes.calls)
        if (const auto* part = std::get_if<PartStroke>(&call)) parts.push_back(part);
    return parts;
}

Label told(const PartStroke& part) {
    return part.label != Label::background ? part.label : known_label(part.name);
}

// Everything in the plane of the canvas, seen from the front, as any drawing is.
bool is_flat(const Strokes& strokes) {
    return std::all_of(strokes.calls.begin(), strokes.calls.end(), [](const ModelCall& call) {
        const auto* part = std::get_if<PartStroke>(&call);
        return part && part->view == Viewpoint::front && part->depth == 0 &&
               part->symmetry == Symmetry::none && part->parent.empty() && part->height == 1;
    });
}

// --- the picture -------------------------------------------------------------------------------------------

// Of strokes alone: areas with a thin dark outline.
Painting painting_of(const Strokes& strokes) {
    if (!strokes.painting.empty()) return strokes.painting;
    Painting painting;
    for (const PartStroke* part : parts_of(strokes)) {
        const Rgb8 colour = part->colour.value_or(row_of(label_of_part(part->name)).solid);
        painting.push_back({{part->stroke}, false, colour, 1, false});
    }
    return painting;
}

struct Frame2 {
    CanvasView view;
    int width = 0, height = 0;
};
Frame2 frame_for(const Painting& painting, const std::string& name) {
    Point2d low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
    for (const PaintedShape& shape : painting)
        for (const std::vector<Point2d>& outline : shape.outlines)
            for (const Point2d p : outline) {
                low = {std::min(low.x, p.x), std::min(low.y, p.y)};
                high = {std::max(high.x, p.x), std::max(high.y, p.y)};
            }
    const double longer = std::max(high.x - low.x, high.y - low.y);
    if (!(longer > 0) || !std::isfinite(longer))
        throw Error(ErrorKind::input, name + ": there is nothing to be seen");
    Frame2 frame;
    frame.view.scale = picture_side * (1 - 2 * margin) / longer;
    const double pad = picture_side * margin;
    frame.view.offset = Point2d{pad, pad} - frame.view.scale * low;
    frame.width = static_cast<int>(std::ceil((high.x - low.x) * frame.view.scale + 2 * pad));
    frame.height = static_cast<int>(std::ceil((high.y - low.y) * frame.view.scale + 2 * pad));
    return frame;
}

long count_of_pixels(const Mask& mask) { return std::count(mask.begin(), mask.end(), 1); }

Mask opaque_pixels(const RgbaImage& image) {
    Mask mask(image.width(), image.height());
    std::transform(image.begin(), image.end(), mask.begin(),
                   [](Rgba8 p) -> std::uint8_t { return is_opaque(p); });
    return mask;
}

// The character of the picture: as detection finds it in a picture that was cut out, or else all that is drawn.
DetectedCharacter character_in(const PagePicture& page, const Mask& opaque, Context& context) {
    const DetectionOptions& options = context.options().detection;
    const long drawn = count_of_pixels(opaque);
    try {
        const CharacterFinder* finder = options.detector == Detector::mask_rcnn ? &context.finder() : nullptr;
        Detection detection = detect(page.picture, page.ink, options, finder);
        DetectedCharacter* best = nullptr;
        for (DetectedCharacter& c : detection.characters)
            if (!best || static_cast<long>(c.box.width) * c.box.height >
                             static_cast<long>(best->box.width) * best->box.height)
                best = &c;
        long inside = 0;
        for (int y = 0; best && y < best->box.height; ++y)
            for (int x = 0; x < best->box.width; ++x)
                inside += opaque(best->box.x + x, best->box.y + y) &&
                          best->mask.value_or(static_cast<int>(x * best->scale),
                                              static_cast<int>(y * best->scale), 0);
        if (best && static_cast<double>(inside) >= found_share * static_cast<double>(drawn))
            return std::move(*best);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::no_character) throw;
    }
    return character_of(page.picture, page.ink, fill_holes(opaque), options);
}

// The inside of outlines that are drawn as lines alone is white, as it is on paper; a hole in an area stays one.
void fill_outlines(RgbaImage& figure, const Painting& painting, const CanvasView& view) {
    Painting kinds = painting;
    for (PaintedShape& shape : kinds) shape.colour = shape.line ? Rgb8{255, 255, 255} : Rgb8{0, 0, 0};
    const RgbaImage lines = paint(kinds, view, figure.width(), figure.height());
    const Components regions = background_components(opaque_pixels(figure));
    std::vector<long> border(regions.list.size() + 1, 0), lined = border;
    constexpr int dx[] = {1, 0, -1, 0}, dy[] = {0, 1, 0, -1};
    for (int y = 0; y < figure.height(); ++y)
        for (int x = 0; x < figure.width(); ++x)
            for (int k = 0; k < 4; ++k) {
                const int id = regions.ids(x, y), u = x + dx[k], v = y + dy[k];
                if (id == 0 || !figure.contains(u, v) || regions.ids(u, v) == id) continue;
                ++border[static_cast<std::size_t>(id)];
                lined[static_cast<std::size_t>(id)] += lines(u, v).r >= 128;
            }
    for (int y = 0; y < figure.height(); ++y)
        for (int x = 0; x < figure.width(); ++x) {
            const int id = regions.ids(x, y);
            if (id == 0 || touches_border(regions.list[static_cast<std::size_t>(id) - 1], figure.width(),
                                          figure.height()))
                continue;
            const auto at = static_cast<std::size_t>(id);
            if (static_cast<double>(lined[at]) >= line_share * static_cast<double>(border[at]))
                figure(x, y) = {255, 255, 255, 255};
        }
}

// What the network saw, and where.
struct Look {
    ModelPicture picture;
    CanvasView view; // of the labels' pixels
};
Look look_at(const Painting& painting, const std::string& name, Context& context) {
    const Frame2 frame = frame_for(painting, name);
    RgbaImage figure = paint(painting, frame.view, frame.width, frame.height);
    fill_outlines(figure, painting, frame.view);
    const Mask opaque = opaque_pixels(figure);
    if (count_of_pixels(opaque) == 0)
        throw Error(ErrorKind::input, name + ": there is nothing to be seen");
    const PagePicture page = cut_out_picture(figure);
    DetectedCharacter character = character_in(page, opaque, context);
    const Segmentation seen = context.segmenter().segment(character.ink, character.mask,
                                                          context.options().segmentation, character.exact_mask);
    const Point2d corner = to_double(Point2i{character.box.x, character.box.y});
    // Pixel centres: page pixel p is at (p + ½ − corner) · scale − ½ of the labels.
    CanvasView view;
    view.scale = character.scale * frame.view.scale;
    view.offset = character.scale * (frame.view.offset + Point2d{0.5, 0.5} - corner) - Point2d{0.5, 0.5};
    return {{std::move(character.drawing), seen.labels}, view};
}

// --- shapes as parts ---------------------------------------------------------------------------------------

struct Share {
    Mask area;     // all of it
    long size = 0; // pixels
    Label label = Label::background;
    double purity = 0; // of the pixels that are not hidden
    long visible = 0;
    bool decoration = false;
};

std::vector<Share> shares_of(const Parts& parts, const Look& look) {
    const LabelMap& labels = look.picture.labels;
    const int width = labels.width(), height = labels.height();
    std::vector<Share> shares(parts.size());
    Grid<int> owner(width, height, -1);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const PaintedShape shape{{parts[i]->stroke}, false, {}, 1, false};
        shares[i].area = opaque_pixels(paint({shape}, look.view, width, height));
        shares[i].size = count_of_pixels(shares[i].area);
        for (std::size_t k = 0; k < owner.size(); ++k)
            if (shares[i].area.data()[k]) owner.data()[k] = static_cast<int>(i);
    }
    std::vector<std::array<long, label_count>> votes(parts.size());
    for (std::size_t k = 0; k < owner.size(); ++k)
        if (owner.data()[k] >= 0) ++votes[static_cast<std::size_t>(owner.data()[k])][labels.data()[k]];
    for (std::size_t i = 0; i < parts.size(); ++i) {
        long labelled = 0, most = 0;
        for (const Label label : part_labels) {
            const long count = votes[i][static_cast<std::size_t>(label)];
            labelled += count;
            if (count > most) most = count, shares[i].label = label;
        }
        shares[i].visible = labelled;
        if (labelled > 0) shares[i].purity = static_cast<double>(most) / static_cast<double>(labelled);
    }
    return shares;
}

// Small shapes on larger ones below them, without a name that says otherwise.
void find_decoration(std::vector<Share>& shares, const Parts& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t j = 0; j < i && !shares[i].decoration; ++j) {
            if (told(*parts[i]) != Label::background || shares[j].decoration) continue;
            if (static_cast<double>(shares[i].size) > inside_size * static_cast<double>(shares[j].size))
                continue;
            long inside = 0;
            for (std::size_t k = 0; k < shares[i].area.size(); ++k)
                inside += shares[i].area.data()[k] && shares[j].area.data()[k];
            shares[i].decoration =
                static_cast<double>(inside) >= inside_share * static_cast<double>(shares[i].size);
        }
}

// Whether the parts are one skeleton.
bool in_one_piece(const Strokes& strokes, const ModelOptions& options) {
    try {
        const Model model(strokes, options);
        const auto& attachments = model.connection().attachments;
        return std::count_if(attachments.begin(), attachments.end(),
                             [](const Attachment& a) { return a.parent < 0; }) == 1;
    } catch (const Error&) { // a shape that no skeleton is made of is no part
        return false;
    }
}

// Whether the network sees one part where one shape is.
bool is_pure(const Share& share, double silhouette) {
    const double size = static_cast<double>(share.size) / silhouette;
    return std::all_of(purities.begin(), purities.end(),
                       [&](const Purity& p) { return size < p.size || share.purity >= p.least; });
}

struct KeptPart {
    PartStroke part;
    const Share* share = nullptr;
};

// The trunk first, larger ones before smaller ones; then always a part that meets those before it, since a part
// hangs on an earlier one: a leg before its foot, though the foot may be larger or was drawn first.
std::vector<KeptPart> in_modelling_order(std::vector<KeptPart> parts, Mask reached) {
    const auto rank = [](const KeptPart& p) {
        const Label label = told(p.part);
        return std::tuple(role_of(label) != PartRole::trunk, label, -p.share->size);
    };
    std::stable_sort(parts.begin(), parts.end(),
                     [&](const KeptPart& a, const KeptPart& b) { return rank(a) < rank(b); });
    std::fill(reached.begin(), reached.end(), std::uint8_t{0});
    std::vector<KeptPart> ordered;
    while (!parts.empty()) {
        const auto meets = [&](const KeptPart& p) {
            for (std::size_t k = 0; k < reached.size(); ++k)
                if (reached.data()[k] && p.share->area.data()[k]) return true;
            return false;
        };
        auto next = std::find_if(parts.begin(), parts.end(), meets);
        if (next == parts.end()) next = parts.begin();
        for (std::size_t k = 0; k < reached.size(); ++k) reached.data()[k] |= next->share->area.data()[k];
        ordered.push_back(std::move(*next));
        parts.erase(next);
    }
    return ordered;
}

// The strokes with a label for each, when the shapes are parts; else nothing.
std::optional<Strokes> shapes_as_parts(const Strokes& strokes, const Look& look, const ModelOptions& options) {
    const Parts parts = parts_of(strokes);
    if (parts.empty() || parts.size() > most_parts) return {};
    std::vector<Share> shares = shares_of(parts, look);
    find_decoration(shares, parts);
    const LabelMap& seen = look.picture.labels;
    const auto silhouette =
        static_cast<double>(static_cast<long>(seen.size()) - std::count(seen.begin(), seen.end(), 0));
    Strokes result;
    result.origin = strokes.origin;
    result.repairs = strokes.repairs;
    result.painting = strokes.painting;
    Mask covered(seen.width(), seen.height());
    std::set<Label> labels;
    std::vector<KeptPart> kept;
    int others = 0;
    double agreed = 0, visible = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Share& share = shares[i];
        if (share.decoration) {
            result.repairs.push_back("part '" + parts[i]->name + "': lies on another one, which it decorates");
            continue;
        }
        PartStroke part = *parts[i];
        if (told(part) == Label::background) {
            if (share.label == Label::background) continue; // hidden
            if (!is_pure(share, silhouette)) return {};
            agreed += share.purity * static_cast<double>(share.visible);
            visible += static_cast<double>(share.visible);
            part.label = share.label;
        }
        labels.insert(told(part));
        others += role_of(told(part)) != PartRole::trunk;
        for (std::size_t k = 0; k < covered.size(); ++k) covered.data()[k] |= share.area.data()[k];
        kept.push_back({std::move(part), &share});
    }
    if (agreed < agreed_share * visible || !labels.contains(Label::body) || others < 2) return {};
    if (static_cast<double>(count_of_pixels(covered)) < covered_share * silhouette) return {};
    for (KeptPart& k : in_modelling_order(std::move(kept), covered)) result.calls.emplace_back(std::move(k.part));
    if (!in_one_piece(result, options)) return {};
    return result;
}

// Where a part that is told lies uppermost, it is what it is told to be.
void overrule(Look& look, const Parts& parts) {
    LabelMap& labels = look.picture.labels;
    Grid<std::uint8_t> own(labels.width(), labels.height());
    bool several = false;
    for (const PartStroke* part : parts) {
        several = several || told(*part) != told(*parts.front());
        const PaintedShape shape{{part->stroke}, false, {}, 1, false};
        const Mask area = opaque_pixels(paint({shape}, look.view, labels.width(), labels.height()));
        for (std::size_t k = 0; k < own.size(); ++k)
            if (area.data()[k]) own.data()[k] = static_cast<std::uint8_t>(told(*part));
    }
    if (!several) return; // one label of all tells nothing
    for (std::size_t k = 0; k < own.size(); ++k)
        if (own.data()[k] != 0 && labels.data()[k] != 0) labels.data()[k] = own.data()[k];
}

// --- parts in space ----------------------------------------------------------------------------------------

// Parts that are drawn from several sides, at depths or in pairs: each has the label of most of what is seen of
// it.
Strokes labelled_in_view(Strokes strokes, const std::string& name, Context& context) {
    Model model(strokes, context.options().modeling);
    const SolidMesh mesh = model.united();
    const ModelView view = view_of(model, mesh, picture_side / 2);
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
    const Segmentation look = context.segmenter().segment(character.ink, character.mask,
                                                          context.options().segmentation, character.exact_mask);
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
    strokes.repairs.push_back(name + ": labels of parts without a known name are the part network's");
    return strokes;
}

} // namespace

bool needs_a_look(const Strokes& strokes) {
    std::set<Label> labels;
    for (const PartStroke* part : parts_of(strokes)) labels.insert(told(*part));
    return labels.contains(Label::background) || (labels.size() == 1 && is_flat(strokes));
}

LabelledStrokes labelled_by_look(const Strokes& strokes, const std::string& name, Context& context) {
    LabelledStrokes result;
    if (!is_flat(strokes)) {
        result.strokes = labelled_in_view(strokes, name, context);
        return result;
    }
    Look look = look_at(painting_of(strokes), name, context);
    if (std::optional<Strokes> parts = shapes_as_parts(strokes, look, context.options().modeling)) {
        result.strokes = std::move(*parts);
        result.strokes.repairs.emplace_back("labels of parts without a known name are the part network's");
        result.painted = !strokes.painting.empty();
        return result;
    }
    overrule(look, parts_of(strokes));
    result.strokes = strokes_from_labels(look.picture.labels);
    result.strokes.repairs = strokes.repairs;
    result.strokes.repairs.emplace_back("no names tell the parts: cut out of the whole by the part network");
    result.picture = std::move(look.picture);
    return result;
}

} // namespace pantin
