// From ink to characters. Thesis 4.2 names the problem: with gaps one character has many contours, and the
// more is dilated, the more neighbours merge. So nothing is dilated; pieces of ink are joined by rules on
// gaps and sizes:
// 1. Pieces are the 8-connected components of the ink. Dust, paper edges, ruled lines and frames are dropped.
// 2. What lies inside a piece's outer border (Suzuki & Abe 1985) belongs to it.
// 3. Neighbouring pieces (whose Voronoi cells touch) are joined in the order of their gaps, shortest first,
// when the
//    gap is small relative to the sizes reached so far (see `belong_together`).
// 4. Groups that are small beside the largest are dropped.
#include "detection/grouping.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "pantin/geometry.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace {

double diagonal_of(const Box& box) { return length({1.0 * box.width, 1.0 * box.height}); }

Box united(const Box& a, const Box& b) {
    const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
    return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

// Length of the common part of [a, a + n) and [b, b + m), negative for the gap between them.
int overlap(int a, int n, int b, int m) { return std::min(a + n, b + m) - std::max(a, b); }

// --- what is no piece of a character
// -----------------------------------------------------------------------------

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

// Marks whose both sides are below 1 % of the page: dust, paper grain (and eyes, which the silhouette covers
// anyway).
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

// --- joining
// -----------------------------------------------------------------------------------------------------

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
    Box box;
    double filled = 0; // sum of the pieces' filled areas
    // A closed shape, not an open line: it fills much of its box.
    bool solid() const { return filled > 0.25 * box.width * box.height; }
};

// Whether two groups with that gap are parts of one character; a is the larger one.
bool belong_together(const Group& a, const Group& b, double gap, const DetectionOptions& options) {
    const double large = diagonal_of(a.box), small = diagonal_of(b.box);
    // A small mark beside a character: a hand, a hat, a foot.
    if (small <= options.mark_size * large) return gap <= options.mark_gap * large;
    // Pieces of one height side by side that are closed shapes: two characters.
    if (a.solid() && b.solid()) return gap <= options.solid_gap * small;
    // A head above a body: their columns overlap, their rows hardly.
    const bool stacked =
        overlap(a.box.x, a.box.width, b.box.x, b.box.width) > 0.6 * std::min(a.box.width, b.box.width);
    return gap <= (stacked ? options.stacked_gap : options.open_gap) * small;
}

class Joiner {
public:
    Joiner(const std::vector<Piece>& pieces) : parent_(pieces.size()) {
        std::iota(parent_.begin(), parent_.end(), 0);
        for (const Piece& piece : pieces) groups_.push_back({piece.box, piece.filled});
    }
    int find(int i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    const Group& group(int root) const { return groups_[root]; }
    void unite(int a, int b, bool inside) {
        a = find(a), b = find(b);
        if (a == b) return;
        const int low = std::min(a, b), high = std::max(a, b);
        const double filled = inside ? std::max(groups_[low].filled, groups_[high].filled)
                                     : groups_[low].filled + groups_[high].filled;
        groups_[low] = {united(groups_[low].box, groups_[high].box), filled};
        parent_[high] = low;
    }

private:
    std::vector<int> parent_;
    std::vector<Group> groups_;
};

// Rule 2, and the area within each piece's outer border.
std::vector<std::pair<int, int>> nest_pieces(const Components& components, const Mask& ink,
                                             std::vector<Piece>& pieces) {
    std::vector<std::pair<int, int>> nested;
    const std::vector<Border> borders = follow_borders(ink);
    const auto piece_of = [&](const Border& border) {
        return components.ids(border.points.front().x, border.points.front().y) - 1;
    };
    for (const Border& border : borders) {
        if (!border.outer) continue;
        const int piece = piece_of(border);
        std::int64_t twice = 0; // shoelace
        for (std::size_t i = 0; i < border.points.size(); ++i) {
            const Point2i p = border.points[i], q = border.points[(i + 1) % border.points.size()];
            twice += std::int64_t{p.x} * q.y - std::int64_t{q.x} * p.y;
        }
        pieces[piece].filled =
            std::max<double>(pieces[piece].ink, 0.5 * static_cast<double>(std::abs(twice)));
        // The parent of an outer border is the border of the hole that it lies in (−1: the page).
        if (border.parent >= 0) nested.push_back({piece, piece_of(borders[border.parent])});
    }
    return nested;
}

} // namespace

Grouping group_ink(const Mask& ink, const DetectionOptions& options) {
    const int w = ink.width(), h = ink.height();
    const Components components = connected_components(ink);
    std::vector<Piece> pieces = measure_pieces(components);
    for (Piece& piece : pieces)
        piece.dropped = is_dust(piece, w, h) || is_page_edge(piece, w, h) || is_ruled_line(piece, w, h) ||
                        is_frame(piece, pieces, w, h);
    const std::vector<std::pair<int, int>> nested = nest_pieces(components, ink, pieces);
    Joiner joiner(pieces);
    for (const auto& [inner, outer] : nested)
        if (!pieces[inner].dropped && !pieces[outer].dropped) joiner.unite(inner, outer, true);
    for (const Gap& gap : gaps_between(components, pieces)) {
        int a = joiner.find(gap.a), b = joiner.find(gap.b);
        if (a == b) continue;
        if (diagonal_of(joiner.group(a).box) < diagonal_of(joiner.group(b).box)) std::swap(a, b);
        if (belong_together(joiner.group(a), joiner.group(b), gap.width, options)) joiner.unite(a, b, false);
    }

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
