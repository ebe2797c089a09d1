// SPDX-License-Identifier: MIT
// In come the moving polygon and a reflex corner, out goes the edge whose line it reaches next. Felkel &
// Obdržálek 1998 look at all edges when a corner is made; here the edges are found by a tree of moving boxes
// (edge_index.hpp), a few at a time.
#include "geometry/split_search.hpp"

#include <algorithm>

namespace pantin::wavefront {
namespace {

// Of the diagonal: how far pieces of edges may be from where the index has them, and how much farther than
// they should they may reach, each time.
constexpr double index_margin = 1e-6, reach_tolerance = index_margin / 64;
// An index is made anew when no more corners than this share are left, and the searches have examined this
// many pieces for each.
constexpr double reindex_share = 0.9, reindex_pieces = 32;

// When the corner reaches the line of the edge; false when it never does.
bool reaches_line(const MovingPolygon& polygon, const Corner& corner, int edge, double& time) {
    const Line& line = polygon.lines[edge];
    const double height = dot(line.normal, corner.origin) - line.offset - corner.time;
    const double closing = 1 - dot(line.normal, corner.velocity);
    if (closing <= parallel || height < -polygon.small || edge == corner.left || edge == corner.right)
        return false;
    time = corner.time + std::max(0.0, height) / closing;
    return true;
}

} // namespace

// Whether the piece, with an allowance, begins before the place; whether it ends after it.
bool SplitSearch::begins_before(const MovingPolygon& polygon, const Piece& piece, Point2d place, double time,
                                double allowance) const {
    const double s = dot(polygon.lines[piece.edge].direction, place) + allowance * polygon.diagonal;
    return s >= piece.begin - (time - index_time_) * piece.before;
}
bool SplitSearch::ends_after(const MovingPolygon& polygon, const Piece& piece, Point2d place, double time,
                             double allowance) const {
    const double s = dot(polygon.lines[piece.edge].direction, place) - allowance * polygon.diagonal;
    return s <= piece.end + (time - index_time_) * piece.after;
}

// No piece will ever reach farther than the corners at its ends would take it, were they to go on: an edge
// only vanishes where the corners at its ends turn left by more than right, and so the one that takes their
// place turns left; and where reflex corners meet, the new ones are less sharp than they were.
void SplitSearch::make_index(MovingPolygon& polygon) {
    check_reaches(polygon);
    index_time_ = polygon.now;
    indexed_ = polygon.alive;
    examined_ = 0;
    unindexed_pieces_.clear();
    std::vector<MovingEdge> edges;
    for (const Corner& from : polygon.corners) {
        if (!from.alive) continue;
        Piece& piece = polygon.pieces[from.piece];
        if (unindexed_.contains(piece.edge)) {
            piece.begin = -never, piece.end = never, piece.before = piece.after = 0;
            unindexed_pieces_.push_back(from.piece);
            continue;
        }
        const Corner& to = polygon.corners[from.next];
        const Point2d normal = polygon.lines[piece.edge].normal, along = polygon.lines[piece.edge].direction;
        const Point2d begin = polygon.place_at(from, polygon.now), end = polygon.place_at(to, polygon.now);
        piece.begin = dot(along, begin);
        piece.end = dot(along, end);
        piece.before = std::min(piece.before, std::max(0.0, -dot(along, from.velocity)));
        piece.after = std::min(piece.after, std::max(0.0, dot(along, to.velocity)));
        edges.push_back(
            {from.piece, begin, end, normal - piece.before * along, normal + piece.after * along});
    }
    index_ = EdgeIndex(std::move(edges), polygon.now, index_margin * polygon.diagonal);
}

bool SplitSearch::is_outdated(const MovingPolygon& polygon) const {
    return polygon.alive < reindex_share * indexed_ && examined_ > reindex_pieces * polygon.alive;
}

// Finds the corner's next candidates whose edges can be there.
void SplitSearch::search(const MovingPolygon& polygon, const Corner& corner, Progress& progress) {
    const double from = std::max(progress.last.time, corner.time);
    const double end = std::min(corner.vanishes, polygon.corners[corner.previous].vanishes);
    const double until =
        end > from ? end : never; // most corners end with one of their edges: no need to look farther
    std::vector<Candidate> found; // a heap of the earliest ones, the latest of them on top
    Candidate limit{until, no_edge};
    const auto examine = [&](int number) {
        ++examined_;
        const Piece& piece = polygon.pieces[number];
        Candidate c{0, piece.edge};
        if (!reaches_line(polygon, corner, piece.edge, c.time) || !(c < limit) || !(progress.last < c))
            return limit.time;
        const Point2d place = polygon.place_at(corner, c.time);
        if (!begins_before(polygon, piece, place, c.time, index_margin) ||
            !ends_after(polygon, piece, place, c.time, index_margin))
            return limit.time;
        found.push_back(c);
        std::push_heap(found.begin(), found.end());
        if (found.size() > progress.batch) {
            std::pop_heap(found.begin(), found.end());
            found.pop_back();
        }
        if (found.size() == progress.batch) limit = found.front();
        return limit.time;
    };
    for (const int piece : unindexed_pieces_) examine(piece);
    index_.search({corner.origin, corner.velocity, corner.time}, from, limit.time, examine);
    std::sort_heap(found.begin(), found.end());
    if (found.size() == progress.batch)
        progress.batch *= 4; // most corners need no more, but those that do may need many
    else if (until < never)
        found.push_back({until, no_edge});
    progress.candidates.assign(found.rbegin(), found.rend());
}

std::optional<Candidate> SplitSearch::next(const MovingPolygon& polygon, int corner) {
    if (progress_.size() < polygon.corners.size()) progress_.resize(polygon.corners.size());
    Progress& progress = progress_[corner];
    for (;;) {
        if (progress.candidates.empty()) search(polygon, polygon.corners[corner], progress);
        if (progress.candidates.empty()) return std::nullopt;
        const Candidate candidate = progress.candidates.back();
        progress.candidates.pop_back();
        if (!(progress.last < candidate)) continue; // the same edge again, by another piece
        return progress.last = candidate;
    }
}

void SplitSearch::check_reach(const MovingPolygon& polygon, int corner) {
    const Corner& c = polygon.corners[corner];
    const Piece &left = polygon.pieces[polygon.corners[c.previous].piece], &right = polygon.pieces[c.piece];
    for (const double time : {std::max(c.time, index_time_), polygon.now}) {
        const Point2d place = polygon.place_at(c, time);
        if (!begins_before(polygon, right, place, time, reach_tolerance)) unindexed_.insert(right.edge);
        if (!ends_after(polygon, left, place, time, reach_tolerance)) unindexed_.insert(left.edge);
    }
}

void SplitSearch::check_reaches(const MovingPolygon& polygon) {
    if (indexed_ == 0) return; // there is no index yet
    for (int c = 0; c < std::ssize(polygon.corners); ++c)
        if (polygon.corners[c].alive) check_reach(polygon, c);
}

} // namespace pantin::wavefront
