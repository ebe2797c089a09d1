// SPDX-License-Identifier: MIT
// From the detector's mask and the network's foreground to the silhouette. Ours: neither the thesis nor
// SketchParse combines the two.
#include "segmentation/final_silhouette.hpp"

#include <algorithm>
#include <cmath>

#include "pantin/image.hpp"

namespace pantin::segmentation {
namespace {

template <class Condition> Mask where(const Mask& like, const Condition& condition) {
    Mask out(like.width(), like.height());
    for (int y = 0; y < like.height(); ++y)
        for (int x = 0; x < like.width(); ++x) out(x, y) = condition(x, y) ? 1 : 0;
    return out;
}

long area(const Mask& mask) { return std::count(mask.begin(), mask.end(), 1); }

// The share of a component's border (pairs of 4-neighbours, one in, one out) that lies along the mask.
double share_along(const Components& components, const Component& component, const Mask& mask) {
    constexpr int dx[] = {1, 0, -1, 0}, dy[] = {0, 1, 0, -1};
    long border = 0, along = 0;
    const Box& box = component.box;
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) {
            if (components.ids(x, y) != component.id) continue;
            for (int i = 0; i < 4; ++i) {
                if (components.ids.value_or(x + dx[i], y + dy[i], 0) == component.id) continue;
                ++border;
                along += mask.value_or(x + dx[i], y + dy[i], 0);
            }
        }
    return static_cast<double>(along) / static_cast<double>(border);
}

// --- cut -------------------------------------------------------------------------------------------------

double mean(const Components& components, const Component& component, const Grid<float>& values) {
    double sum = 0;
    const Box& box = component.box;
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x)
            if (components.ids(x, y) == component.id) sum += values(x, y);
    return sum / component.area;
}

Mask cut_bridged_gaps(const Mask& mask, const Grid<float>& foreground, const Mask& inked,
                      const SilhouetteOptions& options, double radius) {
    const Mask doubtful = where(mask, [&](int x, int y) {
        return mask(x, y) && !inked(x, y) && foreground(x, y) < options.keep_probability;
    });
    // What survives the opening decides, but the whole region goes.
    const Components regions = connected_components(doubtful);
    const Mask thick = open_disc(doubtful, radius);
    const auto whole = static_cast<double>(area(mask));
    std::vector<char> cut(regions.list.size() + 1, 0);
    for (std::size_t i = 0; i < thick.size(); ++i)
        if (thick.data()[i]) cut[static_cast<std::size_t>(regions.ids.data()[i])] = 1;
    for (const Component& region : regions.list) {
        char& decision = cut[static_cast<std::size_t>(region.id)];
        if (!decision || 1 - share_along(regions, region, mask) >= options.open_share) continue;
        decision = region.area <= options.hole_cut_share * whole &&
                   mean(regions, region, foreground) < options.hole_probability;
    }
    return where(
        mask, [&](int x, int y) { return mask(x, y) && !cut[static_cast<std::size_t>(regions.ids(x, y))]; });
}

// Narrow regions between strokes that the network takes for paper as a whole: between two legs.
Mask narrow_paper(const Mask& mask, const Grid<float>& foreground, const Mask& inked,
                  const SilhouetteOptions& options, double radius) {
    const Mask empty = where(mask, [&](int x, int y) { return mask(x, y) && !inked(x, y); });
    const Components regions = connected_components(empty);
    const Mask thick = open_disc(empty, radius);
    std::vector<char> paper(regions.list.size() + 1, 1);
    for (std::size_t i = 0; i < thick.size(); ++i)
        if (thick.data()[i]) paper[static_cast<std::size_t>(regions.ids.data()[i])] = 0;
    paper[0] = 0;
    const double least = options.region_share * static_cast<double>(area(mask));
    for (const Component& region : regions.list) {
        char& decision = paper[static_cast<std::size_t>(region.id)];
        decision = decision && region.area >= least &&
                   share_along(regions, region, inked) >= options.region_ink_share &&
                   mean(regions, region, foreground) < options.region_probability;
    }
    return where(mask, [&](int x, int y) { return paper[static_cast<std::size_t>(regions.ids(x, y))] != 0; });
}

Mask without(const Mask& mask, const Mask& removed) {
    return where(mask, [&](int x, int y) { return mask(x, y) && !removed(x, y); });
}

// --- fill ------------------------------------------------------------------------------------------------

// The mask with the regions that are at least that enclosed, and gaps between strokes.
Mask fill_enclosed(const Mask& mask, const Mask& likely, const Components& regions,
                   const std::vector<double>& shares, double least, double radius) {
    const Mask filled = where(mask, [&](int x, int y) {
        return mask(x, y) ||
               (regions.ids(x, y) && shares[static_cast<std::size_t>(regions.ids(x, y)) - 1] >= least);
    });
    const Mask closed = close_disc(filled, radius);
    return where(mask, [&](int x, int y) { return filled(x, y) || (closed(x, y) && likely(x, y)); });
}

Mask fill_open_outlines(const Mask& mask, const Grid<float>& foreground, const SilhouetteOptions& options,
                        double radius) {
    const Mask likely =
        where(mask, [&](int x, int y) { return foreground(x, y) >= options.fill_probability; });
    const Mask all = where(mask, [&](int x, int y) { return likely(x, y) || mask(x, y); });
    const Mask missing = where(mask, [&](int x, int y) { return likely(x, y) && !mask(x, y); });
    const Components regions = connected_components(open_disc(missing, radius));
    const Mask near = dilate_disc(mask, radius); // the opening rounds off the region's corners
    std::vector<double> shares;
    for (const Component& region : regions.list) shares.push_back(share_along(regions, region, near));

    const double expected = options.hollow_share * static_cast<double>(area(all));
    for (const double least : {options.enclosed_share, options.enclosed_share / 2}) {
        const Mask filled = fill_enclosed(mask, likely, regions, shares, least, radius);
        if (static_cast<double>(area(filled)) >= expected) return filled;
    }
    return fill_enclosed(mask, likely, regions, shares, 0, radius);
}

// --- one piece -------------------------------------------------------------------------------------------

void paint_disc(Mask& mask, double cx, double cy, double radius) {
    const int reach = static_cast<int>(std::ceil(radius));
    const int x0 = static_cast<int>(std::rint(cx)), y0 = static_cast<int>(std::rint(cy));
    for (int y = y0 - reach; y <= y0 + reach; ++y)
        for (int x = x0 - reach; x <= x0 + reach; ++x)
            if (mask.contains(x, y) && (x - cx) * (x - cx) + (y - cy) * (y - cy) <= radius * radius)
                mask(x, y) = 1;
}

struct Gap {
    long squared = -1; // length, −1: none
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

// The shortest way from a component to the mask: the first pixel in raster order among equals.
Gap shortest_gap(const Components& pieces, const Component& piece, const Grid<int>& nearest) {
    Gap best;
    const Box& box = piece.box;
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) {
            if (pieces.ids(x, y) != piece.id) continue;
            const int seed = nearest(x, y), sx = seed % nearest.width(), sy = seed / nearest.width();
            const long squared = static_cast<long>(x - sx) * (x - sx) + static_cast<long>(y - sy) * (y - sy);
            if (best.squared < 0 || squared < best.squared) best = {squared, x, y, sx, sy};
        }
    return best;
}

// Grows the largest component by the nearest piece that is large and near enough, until there is none.
Mask join_pieces(const Mask& mask, const SilhouetteOptions& options, double longer_side, double radius) {
    Mask whole = largest_component(mask);
    const double least = options.piece_share * static_cast<double>(area(mask));
    const double longest = options.bridge_length * longer_side;
    Mask rest = where(mask, [&](int x, int y) { return mask(x, y) && !whole(x, y); });
    while (true) {
        const Components pieces = connected_components(rest);
        if (std::none_of(pieces.list.begin(), pieces.list.end(),
                         [&](const Component& p) { return p.area >= least; }))
            return whole;
        const Grid<int> nearest = nearest_seed(whole);
        Gap best;
        int chosen = 0;
        for (const Component& piece : pieces.list) {
            if (piece.area < least) continue;
            const Gap gap = shortest_gap(pieces, piece, nearest);
            if (static_cast<double>(gap.squared) > longest * longest) continue;
            if (chosen == 0 || gap.squared < best.squared) best = gap, chosen = piece.id;
        }
        if (chosen == 0) return whole;
        const int steps = 2 * static_cast<int>(std::sqrt(static_cast<double>(best.squared))) + 2;
        for (int i = 0; i <= steps; ++i) {
            const double t = static_cast<double>(i) / steps;
            paint_disc(whole, best.x0 + t * (best.x1 - best.x0), best.y0 + t * (best.y1 - best.y0), radius);
        }
        for (std::size_t i = 0; i < rest.size(); ++i)
            if (pieces.ids.data()[i] == chosen) whole.data()[i] = 1;
        rest = where(mask, [&](int x, int y) { return mask(x, y) && !whole(x, y); });
    }
}

// --- outline ---------------------------------------------------------------------------------------------

// 3×3 majority; a pixel that an opening by a disc of 1.5 would lose belongs to something thin and stays.
Mask smooth(const Mask& mask) {
    const Mask bulk = open_disc(mask, 1.5);
    return where(mask, [&](int x, int y) {
        if (mask(x, y) && !bulk(x, y)) return true;
        int count = 0;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) count += mask.value_or(x + dx, y + dy, 0);
        return count >= 5;
    });
}

// The pen's outer half, where the network sees background. What an opening by twice the rim would lose is
// thin.
Mask trim_rim(const Mask& mask, const Grid<float>& foreground, const SilhouetteOptions& options,
              double longer_side) {
    const double rim = options.rim * longer_side;
    const Mask bulk = open_disc(mask, 2 * rim);
    const Grid<int> squared = squared_distance_transform(pad(mask, 1));
    return where(mask, [&](int x, int y) {
        const bool trimmed =
            bulk(x, y) && squared(x + 1, y + 1) <= rim * rim && foreground(x, y) < options.rim_probability;
        return mask(x, y) && !trimmed;
    });
}

} // namespace

Mask decide_silhouette(const Mask& detected, const Grid<float>& foreground, const Grid<float>& ink,
                       const SilhouetteOptions& options) {
    const double longer_side = std::max(detected.width(), detected.height());
    const double radius = std::max(1.0, options.tolerance * longer_side);
    const Mask inked = where(detected, [&](int x, int y) { return ink(x, y) >= options.ink_darkness; });
    const Mask paper = narrow_paper(detected, foreground, inked, options, radius);
    Mask mask = without(cut_bridged_gaps(detected, foreground, inked, options, radius), paper);
    mask = fill_open_outlines(mask, foreground, options, radius);
    mask = join_pieces(mask, options, longer_side, radius);
    mask = fill_holes(mask, static_cast<long>(options.hole_share * static_cast<double>(area(mask))));
    // What fills small holes and rounds the outline does not close the way between two legs.
    return largest_component(trim_rim(without(smooth(mask), paper), foreground, options, longer_side));
}

} // namespace pantin::segmentation
