// SPDX-License-Identifier: MIT
// Which edges a reflex corner of the moving polygon may split, in the order in which it reaches their lines,
// by an index of the moving edges that is made anew as corners go.
#pragma once

#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "geometry/edge_index.hpp"
#include "geometry/moving_polygon.hpp"

namespace pantin::wavefront {

inline constexpr int no_edge = std::numeric_limits<int>::max(); // a corner is to search on

struct Candidate { // for a split: when a reflex corner reaches the line of an edge, or no_edge
    double time = -1;
    int edge = -1;
    bool operator<(const Candidate& c) const { return std::tie(time, edge) < std::tie(c.time, c.edge); }
};

class SplitSearch {
public:
    // unindexed: edges that the index does not have, so that every corner looks at them.
    explicit SplitSearch(std::set<int> unindexed) : unindexed_(std::move(unindexed)) {}

    // Makes the index, of all pieces as they are now.
    void make_index(MovingPolygon& polygon);
    // Whether so many corners have gone and so many pieces were examined that a new index is worth its time.
    bool is_outdated(const MovingPolygon& polygon) const;

    // The reflex corner's next candidate; none when it reaches no line any more.
    std::optional<Candidate> next(const MovingPolygon& polygon, int corner);

    // That no piece reaches farther than the index has it is a theorem about simple polygons and exact
    // numbers. Edges for which it is not true are found out here, by the whole way of every corner: what
    // holds at two times holds between them. Of one corner before it ends; of all.
    void check_reach(const MovingPolygon& polygon, int corner);
    void check_reaches(const MovingPolygon& polygon);
    // Those that were given, and those that the checks have found.
    const std::set<int>& unindexed() const { return unindexed_; }

private:
    // Of a reflex corner: the last candidate that was handed out, the next ones, latest first, and how many
    // the next search keeps.
    struct Progress {
        Candidate last;
        std::vector<Candidate> candidates;
        std::size_t batch = 1;
    };
    void search(const MovingPolygon& polygon, const Corner& corner, Progress& progress);
    bool begins_before(const MovingPolygon& polygon, const Piece& piece, Point2d place, double time,
                       double allowance) const;
    bool ends_after(const MovingPolygon& polygon, const Piece& piece, Point2d place, double time,
                    double allowance) const;

    EdgeIndex index_;
    double index_time_ = 0;             // when it was made
    int indexed_ = 0;                   // corners then; 0: there is no index yet
    double examined_ = 0;               // pieces since then
    std::set<int> unindexed_;           // edges
    std::vector<int> unindexed_pieces_; // of those edges
    std::vector<Progress> progress_;    // per corner
};

} // namespace pantin::wavefront
