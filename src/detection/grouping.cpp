// SPDX-License-Identifier: MIT
// From ink to characters. Thesis 4.2 names the problem: with gaps one character has many contours, and the
// more is dilated, the more neighbours merge. So nothing is dilated; pieces of ink are joined by rules on
// gaps and sizes:
// 1. Pieces are the 8-connected components of the ink. Dust, the edges of the sheet, ruled lines and frames
// are dropped.
// 2. What lies inside a piece's outer border (Suzuki & Abe 1985) belongs to it.
// 3. Open lines that enclose a region together (enclosed_regions.hpp) are one outline.
// 4. Neighbouring pieces (whose Voronoi cells touch) are joined in the order of their gaps, shortest first,
//    when the gap is small relative to the sizes reached so far (`belong_together`): marks by their distance,
//    arcs of one outline because they enclose a region together (enclosed_regions.hpp), closed shapes side by
//    side never.
// 5. Groups that are small beside the largest are dropped.
#include "detection/grouping.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/disjoint_sets.hpp"
#include "detection/enclosed_regions.hpp"
#include "pantin/geometry.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace {

double diagonal_of(const Box& box) { return length(Point2d{1.0 * box.width, 1.0 * box.height}); }

Box united(const Box& a, const Box& b) {
    const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
    return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

// Length of the common part of [a, a + n) and [b, b + m), negative for the gap between them.
int overlap(int a, int n, int b, int m) { return std::min(a + n, b + m) - std::max(a, b); }

// --- what is no piece of a character -----------------------------------------------------------------------

struct Piece {
    Box box;
    int ink = 0;       // pixels
    double filled = 0; // area within the outer border
    int border = 0;    // pixels on the page's border
    int rim = 0;       // pixels near the piece's own box border
    int page_rim = 0;  // pixels near the page's border
    bool dropped = false;
};

std::vector<Piece> measure_pieces(const Components& components) {
    const int w = components.ids.width(), h = components.ids.height();
    std::vector<Piece> pieces;
    for (const Component& c : components.list) pieces.push_back({c.box, c.area});
    const int page_margin = std::max(2, std::min(w, h) / 25);
    for (int y = 0; y < h; ++y) {
        for (int x = 0; x < w; ++x) {
            const int id = components.ids(x, y);
            if (id == 0) continue;
            Piece& piece = pieces[id - 1];
            const Box& box = piece.box;
            const int margin = std::max(2, std::min(box.width, box.height) / 25);
            piece.border += x == 0 || y == 0 || x == w - 1 || y == h - 1;
            piece.rim += std::min({x - box.x, y - box.y, box.x + box.width - 1 - x,
                                   box.y + box.height - 1 - y}) < margin;
            piece.page_rim += std::min({x, y, w - 1 - x, h - 1 - y}) < page_margin;
        }
    }
    return pieces;
}

// Marks whose both sides are below 1 % of the page: dust, grain of the sheet (and eyes, which the silhouette
// covers anyway).
bool is_dust(const Piece& piece, int w, int h) {
    return std::max(piece.box.width, piece.box.height) < std::max(3.0, 0.01 * std::max(w, h));
}
// The edge of the sheet or the table around it: all ink near the page's border, or much of the border
// covered, or three sides of the page touched.
bool is_page_edge(const Piece& piece, int w, int h) {
    return piece.page_rim >= 0.95 * piece.ink || piece.border > 0.1 * 2 * (w + h);
}
// A ruled line: flat, and across most of the page.
bool is_ruled_line(const Piece& piece, int w, int h) {
    const Box& box = piece.box;
    return (box.width > 0.6 * w && box.height < 0.03 * box.width) ||
           (box.height > 0.6 * h && box.width < 0.03 * box.height);
}
// A rectangle around other pieces: large, and all ink at its own box's border.
bool is_frame(const Piece& piece, const std::vector<Piece>& pieces, int w, int h) {
    const Box& box = piece.box;
    if (box.width < 0.4 * w || box.height < 0.4 * h || piece.rim < 0.95 * piece.ink) return false;
    return std::any_of(pieces.begin(), pieces.end(), [&](const Piece& other) {
        return &other != &piece &&
               overlap(box.x, box.width, other.box.x, other.box.width) == other.box.width &&
               overlap(box.y, box.height, other.box.y, other.box.height) == other.box.height &&
               diagonal_of(other.box) > 0.25 * diagonal_of(box);
    });
}

// --- joining -----------------------------------------------------------------------------------------------

struct Gap {
    int a = 0, b = 0; // pieces
    double width = 0;
};

// Shortest gap between every two pieces whose Voronoi cells touch, ascending, ties by piece.
std::vector<Gap> gaps_between(const Components& components, const std::vector<Piece>& pieces) {
    const int w = components.ids.width(), h = components.ids.height();
    Mask kept(w, h);
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const int id = components.ids.data()[i];
        kept.data()[i] = id != 0 && !pieces[id - 1].dropped;
    }
    const Grid<int> nearest = nearest_seed(kept);
    std::map<std::pair<int, int>, std::int64_t> shortest;
    const auto meet = [&](int p, int q) {
        const int a = components.ids.data()[p] - 1, b = components.ids.data()[q] - 1;
        if (a == b) return;
        const std::int64_t dx = p % w - q % w, dy = p / w - q / w, squared = dx * dx + dy * dy;
        const auto [at, fresh] = shortest.try_emplace({std::min(a, b), std::max(a, b)}, squared);
        if (!fresh) at->second = std::min(at->second, squared);
    };
    for (int y = 0; y < h; ++y) {
        for (int x = 0; x < w; ++x) {
            if (nearest(x, y) < 0) continue;
            if (x + 1 < w) meet(nearest(x, y), nearest(x + 1, y));
            if (y + 1 < h) meet(nearest(x, y), nearest(x, y + 1));
        }
    }
    std::vector<Gap> gaps;
    for (const auto& [pair, squared] : shortest)
        gaps.push_back({pair.first, pair.second, std::sqrt(static_cast<double>(squared)) - 1});
    std::stable_sort(gaps.begin(), gaps.end(), [](const Gap& p, const Gap& q) { return p.width < q.width; });
    return gaps;
}

struct Group {
    std::vector<int> pieces;
    Box box;
    double enclosed = 0; // area that its ink encloses (enclosed_regions.hpp) or colours in
    // A figure that could stand alone, not an open line: a body, or the head of a stick figure with its
    // lines.
    bool closed(const DetectionOptions& options) const {
        return enclosed > options.closed_share * diagonal_of(box) * diagonal_of(box);
    }
};

class Joiner {
public:
    Joiner(const Components& components, const std::vector<Piece>& pieces, const DetectionOptions& options)
        : components_(components), options_(options), sets_(pieces.size()) {
        const double page = diagonal_of({0, 0, components.ids.width(), components.ids.height()});
        for (int i = 0; i < static_cast<int>(pieces.size()); ++i) {
            groups_.push_back({{i}, pieces[i].box});
            // What small pieces enclose decides nothing.
            if (!pieces[i].dropped && diagonal_of(pieces[i].box) > 0.03 * page)
                groups_[i].enclosed = enclosed_area(groups_[i]);
        }
    }
    int find(int i) { return sets_.find(i); }
    const Group& group(int root) const { return groups_[root]; }

    void unite_nested(int inner, int outer) {
        inner = find(inner), outer = find(outer);
        if (inner != outer) unite(inner, outer, std::max(groups_[inner].enclosed, groups_[outer].enclosed));
    }
    // Open lines around one region are one outline.
    void unite_around(const std::vector<int>& pieces) {
        int first = -1;
        for (int piece : pieces) {
            const int root = find(piece);
            if (groups_[root].closed(options_) && root != first) continue;
            if (first < 0)
                first = root;
            else if (root != first)
                unite(first, root, groups_[first].enclosed + groups_[root].enclosed), first = find(root);
        }
        if (first >= 0) groups_[first].enclosed = enclosed_area(groups_[first]);
    }
    void unite_across(const Gap& gap) {
        int a = find(gap.a), b = find(gap.b);
        if (a == b) return;
        if (diagonal_of(groups_[a].box) < diagonal_of(groups_[b].box)) std::swap(a, b);
        if (belong_together(groups_[a], groups_[b], gap.width))
            unite(a, b, groups_[a].enclosed + groups_[b].enclosed);
    }

private:
    // Whether two groups with that gap are parts of one character; a is the larger one.
    bool belong_together(const Group& a, const Group& b, double gap) const {
        const double large = diagonal_of(a.box), small = diagonal_of(b.box);
        // A small mark beside a character: a hand, a hat, a foot.
        if (small <= options_.mark_size * large) return gap <= options_.mark_gap * large;
        if (gap <= options_.touching_gap * small) return true;
        const int columns = overlap(a.box.x, a.box.width, b.box.x, b.box.width);
        const int rows = overlap(a.box.y, a.box.height, b.box.y, b.box.height);
        const bool stacked = columns > 0.6 * std::min(a.box.width, b.box.width);
        if (gap > (stacked ? options_.stacked_gap : options_.open_gap) * small) return false;
        // Two closed figures: a head on its body, else two characters.
        if (a.closed(options_) && b.closed(options_))
            return gap <= options_.head_gap * small &&
                   small <= (stacked ? options_.stacked_head_size : options_.head_size) * large;
        if (encloses_more(a, b)) return true;
        // Side by side without enclosing anything together.
        const bool side_by_side = rows > 0.6 * std::min(a.box.height, b.box.height) &&
                                  columns <= 0.1 * std::min(a.box.width, b.box.width);
        return !side_by_side;
    }

    // Two arcs of one outline enclose together what neither encloses alone.
    bool encloses_more(const Group& a, const Group& b) const {
        Group both{a.pieces, united(a.box, b.box)};
        both.pieces.insert(both.pieces.end(), b.pieces.begin(), b.pieces.end());
        const double together = enclosed_area(both);
        return together - a.enclosed - b.enclosed > options_.enclosed_gain * together;
    }

    double enclosed_area(const Group& group) const {
        const Box& box = group.box;
        Mask ink(box.width, box.height);
        for (int y = 0; y < box.height; ++y) {
            for (int x = 0; x < box.width; ++x) {
                const int piece = components_.ids(box.x + x, box.y + y) - 1;
                ink(x, y) = std::find(group.pieces.begin(), group.pieces.end(), piece) != group.pieces.end();
            }
        }
        const Mask regions = find_enclosed_regions(ink);
        const double enclosed = static_cast<double>(std::count(regions.begin(), regions.end(), 1));
        // A figure that is coloured in has ink where a line drawing encloses background: what lies deeper
        // than any pen.
        const Grid<int> depth = squared_distance_transform(ink);
        const double pen = options_.deepest_pen * diagonal_of(box);
        return enclosed + static_cast<double>(std::count_if(
                              depth.begin(), depth.end(), [&](int squared) { return squared > pen * pen; }));
    }

    void unite(int a, int b, double enclosed) {
        const int low = std::min(a, b), high = std::max(a, b);
        Group& to = groups_[low];
        to.pieces.insert(to.pieces.end(), groups_[high].pieces.begin(), groups_[high].pieces.end());
        to.box = united(to.box, groups_[high].box);
        to.enclosed = enclosed;
        groups_[high].pieces.clear();
        sets_.unite(low, high);
    }

    const Components& components_;
    const DetectionOptions& options_;
    DisjointSets sets_;
    std::vector<Group> groups_;
};

// Pieces that lie in a hole of another (rule 2): {inner, outer}.
std::vector<std::pair<int, int>> nested_pieces(const Components& components, const Mask& ink) {
    std::vector<std::pair<int, int>> nested;
    const std::vector<Border> borders = follow_borders(ink);
    const auto piece_of = [&](const Border& border) {
        return components.ids(border.points.front().x, border.points.front().y) - 1;
    };
    // The parent of an outer border is the border of the hole that it lies in (−1: the page).
    for (const Border& border : borders)
        if (border.outer && border.parent >= 0)
            nested.push_back({piece_of(border), piece_of(borders[border.parent])});
    return nested;
}

// For every region that all kept ink of the page encloses together: the pieces around it, each with a fair
// share of the region's border.
std::vector<std::vector<int>> pieces_around_regions(const Components& components,
                                                    const std::vector<Piece>& pieces,
                                                    const DetectionOptions& options) {
    const int w = components.ids.width(), h = components.ids.height();
    Mask kept(w, h);
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const int id = components.ids.data()[i];
        kept.data()[i] = id != 0 && !pieces[id - 1].dropped;
    }
    EnclosedRegionOptions region_options;
    region_options.small_ratio = region_options.large_ratio; // shares of the page's hull mean nothing
    const Components regions = connected_components(find_enclosed_regions(kept, region_options));
    std::vector<std::map<int, int>> contacts(regions.list.size()); // piece → pixels of it beside the region
    for (int y = 0; y < h; ++y) {
        for (int x = 0; x < w; ++x) {
            const int piece = kept(x, y) ? components.ids(x, y) - 1 : -1;
            if (piece < 0) continue;
            for (Point2i n : {Point2i{x, y - 1}, {x - 1, y}, {x + 1, y}, {x, y + 1}})
                if (const int region = regions.ids.value_or(n.x, n.y, 0)) ++contacts[region - 1][piece];
        }
    }
    std::vector<std::vector<int>> around;
    for (const auto& contact : contacts) {
        int total = 0;
        for (const auto& [piece, pixels] : contact) total += pixels;
        std::vector<int> sharing;
        for (const auto& [piece, pixels] : contact)
            if (pixels >= options.contact_share * total) sharing.push_back(piece);
        if (sharing.size() > 1) around.push_back(sharing);
    }
    return around;
}

} // namespace

Grouping group_ink(const Mask& ink, const DetectionOptions& options) {
    const int w = ink.width(), h = ink.height();
    const Components components = connected_components(ink);
    std::vector<Piece> pieces = measure_pieces(components);
    for (Piece& piece : pieces)
        piece.dropped = is_dust(piece, w, h) || is_page_edge(piece, w, h) || is_ruled_line(piece, w, h) ||
                        is_frame(piece, pieces, w, h);
    Joiner joiner(components, pieces, options);
    for (const auto& [inner, outer] : nested_pieces(components, ink))
        if (!pieces[inner].dropped && !pieces[outer].dropped) joiner.unite_nested(inner, outer);
    for (const std::vector<int>& around : pieces_around_regions(components, pieces, options))
        joiner.unite_around(around);
    for (const Gap& gap : gaps_between(components, pieces)) joiner.unite_across(gap);

    double largest = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (!pieces[i].dropped)
            largest = std::max(largest, diagonal_of(joiner.group(joiner.find(static_cast<int>(i))).box));
    Grouping result;
    result.groups = Grid<int>(w, h, 0);
    std::vector<int> number(pieces.size(), 0); // of the group with that root
    std::vector<int> group_of(pieces.size(), 0);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const int root = joiner.find(static_cast<int>(i));
        if (pieces[i].dropped || diagonal_of(joiner.group(root).box) < options.min_share * largest) continue;
        if (number[root] == 0) {
            result.boxes.push_back(joiner.group(root).box);
            number[root] = static_cast<int>(result.boxes.size());
        }
        group_of[i] = number[root];
    }
    for (std::size_t i = 0; i < result.groups.size(); ++i) {
        const int id = components.ids.data()[i];
        if (id != 0) result.groups.data()[i] = group_of[id - 1];
    }
    return result;
}

} // namespace pantin
