// SPDX-License-Identifier: MIT
// Strokes and labels of their picture in, strokes with labels out (docs/modeling.md, "Drawings without
// names").
#include "pipeline/shape_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

#include "geometry/extent.hpp"
#include "modeling/svg_outlines.hpp"
#include "pantin/error.hpp"

namespace pantin {
namespace {

constexpr std::size_t most_parts = 60; // of a drawing whose shapes may be its parts
// Least share of a part's pixels with its label: of parts larger than this share of the silhouette, …
struct Purity {
    double size = 0, least = 0;
};
constexpr std::array<Purity, 2> purities = {{{0.2, 0.65}, {0.04, 0.5}}};
constexpr double agreed_share = 0.75; // … and of all parts together
constexpr double inside_share = 0.97; // of a shape lies on one below it that is …
constexpr double inside_size = 0.35;  // … so much larger: it decorates that one
constexpr double covered_share = 0.8; // of the silhouette that parts have to cover

struct Share {
    Mask area;     // all of it
    long size = 0; // pixels
    Label label = Label::background;
    double purity = 0; // of the pixels that are not hidden
    long visible = 0;
};

std::vector<Share> shares_of(const Parts& parts, const DrawingLook& look) {
    const LabelMap& labels = look.picture.labels;
    const int width = labels.width(), height = labels.height();
    std::vector<Share> shares(parts.size());
    Grid<int> owner(width, height, -1);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const PaintedShape shape{{parts[i]->stroke}, false, {}, 1, false};
        shares[i].area = opaque_pixels(paint({shape}, look.view, width, height));
        shares[i].size = pixel_count(shares[i].area);
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

// The trunk first, larger ones before smaller ones; then always a part that meets those before it, since a
// part hangs on an earlier one: a leg before its foot, though the foot may be larger or was drawn first.
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

} // namespace

Parts parts_of(const Strokes& strokes) {
    Parts parts;
    for (const ModelCall& call : strokes.calls)
        if (const auto* part = std::get_if<PartStroke>(&call)) parts.push_back(part);
    return parts;
}

Label told(const PartStroke& part) {
    return part.label != Label::background ? part.label : known_label(part.name);
}

std::vector<bool> decoration_of(const Parts& parts) {
    std::vector<bool> decorates(parts.size(), false);
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t j = 0; j < i && !decorates[i]; ++j) {
            const Label own = told(*parts[i]);
            if (decorates[j] || (own != Label::background && own != told(*parts[j]))) continue;
            decorates[i] =
                std::abs(area_of(parts[i]->stroke)) <= inside_size * std::abs(area_of(parts[j]->stroke)) &&
                share_inside(parts[i]->stroke, parts[j]->stroke) >= inside_share;
        }
    return decorates;
}

std::string decoration_line(const PartStroke& part) {
    return "part '" + part.name + "': lies on another one, which it decorates";
}

std::optional<Strokes> shapes_as_parts(const Strokes& strokes, const DrawingLook& look,
                                       const ModelOptions& options) {
    const Parts parts = parts_of(strokes);
    if (parts.empty() || parts.size() > most_parts) return {};
    std::vector<Share> shares = shares_of(parts, look);
    const std::vector<bool> decorates = decoration_of(parts);
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
        if (decorates[i]) {
            result.repairs.push_back(decoration_line(*parts[i]));
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
    if (static_cast<double>(pixel_count(covered)) < covered_share * silhouette) return {};
    for (KeptPart& k : in_modelling_order(std::move(kept), covered))
        result.calls.emplace_back(std::move(k.part));
    if (!in_one_piece(result, options)) return {};
    return result;
}

void overrule(DrawingLook& look, const Parts& parts) {
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

} // namespace pantin
