// SPDX-License-Identifier: MIT
// Edges that move and grow steadily, in a tree of boxes that move and grow with them: finds those that a
// moving point may meet (Šaltenis et al., Indexing the positions of continuously moving objects, 2000; here
// in memory, and built once).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "pantin/point.hpp"

namespace pantin {

struct MovingPoint {
    Point2d place, velocity;
    double time = 0; // when it is at the place
};

struct MovingEdge {
    int number = 0; // what it is called
    Point2d from, to, from_velocity, to_velocity;
};

class EdgeIndex {
public:
    EdgeIndex() = default;
    // The edges as they are at the time. margin: how far beside an edge points still count as being on it.
    EdgeIndex(std::vector<MovingEdge> edges, double time, double margin);

    // Calls visit(number) for every edge that the point can meet between the two times, and for some others,
    // roughly in the order of the meetings. It returns the time after which meetings do not matter any more.
    template <class Visit>
    void search(const MovingPoint& point, double from, double until, Visit visit) const {
        std::array<std::pair<double, int>, 64>
            waiting; // nodes, each with a time before which the point is not inside
        std::size_t count = 0;
        const auto wait = [&](int node) {
            double entry = from;
            if (enters(nodes_[node], point, entry) && entry <= until) waiting[count++] = {entry, node};
        };
        if (!nodes_.empty()) wait(0);
        while (count > 0) {
            const auto [entry, node] = waiting[--count];
            if (entry > until) continue;
            const Node& n = nodes_[node];
            if (n.second > 0) {
                const std::size_t before = count;
                wait(node + 1);
                wait(n.second);
                if (count == before + 2 &&
                    waiting[count - 1].first > waiting[before].first) // the earlier one goes first
                    std::swap(waiting[count - 1], waiting[before]);
            } else {
                for (int i = n.begin; i < n.end; ++i) until = visit(numbers_[i]);
            }
        }
    }

private:
    struct Node {
        Point2d axis{1, 0};          // a side of its box
        Point2d low, high;           // the box at the index's time
        Point2d low_rate, high_rate; // how its sides move
        int begin = 0, end = 0;      // of a leaf: its range of numbers_
        int second = 0;              // of others: the second half; the first half is the node that follows
    };

    void build(std::span<MovingEdge> edges);
    Node node_around(std::span<const MovingEdge> edges) const;
    static Point2d dividing_direction(std::span<const MovingEdge> edges, const Node& node);
    bool enters(const Node& node, const MovingPoint& point, double& time) const;

    double time_ = 0, margin_ = 0;
    std::vector<Node> nodes_;
    std::vector<int> numbers_; // of the edges, those of a leaf next to each other
};

} // namespace pantin
