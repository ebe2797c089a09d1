// SPDX-License-Identifier: MIT
// The labelled geometric graph distance by exact branch and bound.
//
// O. Cheong, J. Gudmundsson, H.-S. Kim, D. Schymura, F. Stehn: Measuring the Similarity of Geometric Graphs,
// 2009; labels as in the thesis, Eq. 4.7. A matching changes the cost of the empty one by
//     Σ_{matched u,v} (K_v |uv| + K_l lbl_dist(u, v))  −  Σ_{matched e,e'} 2 K_e min(|e|, |e'|).
// The vertices of the smaller graph ("rows") are placed one after the other, breadth first, each on a free
// vertex of the other graph ("columns") or nowhere, cheapest first. Bound: each row still to be placed saves
// at most what its best column would give it, its edges to earlier rows included; an edge between two rows
// that are both unplaced is valued by the longest edge that its column offers.
//
// Two passes make the result canonical: the first finds the optimum, the second visits everything that
// may lie within 1e-9 of it and keeps the lexicographically smallest matching.
#include <algorithm>
#include <limits>

#include "identification/labelled_graph.hpp"

namespace pantin {
namespace {

constexpr double tie = 1e-9;
constexpr int exact_vertices = 40;       // larger graphs are searched, but never called optimal …
constexpr long large_graph_divisor = 64; // … with this part of the node limit, since their nodes take longer

struct Neighbour {
    int vertex;
    double length; // of the edge
};
using Adjacency = std::vector<std::vector<Neighbour>>;
using Pairs = std::vector<std::pair<int, int>>;

Adjacency adjacency(const LabelledGraph& graph) {
    Adjacency out(graph.positions.size());
    for (const auto& e : graph.edges) {
        const double length = edge_length(graph, e);
        out[e.first].push_back({e.second, length});
        out[e.second].push_back({e.first, length});
    }
    return out;
}

// Breadth first from the vertex of the highest degree, component after component; ties by index.
std::vector<int> breadth_first(const Adjacency& graph) {
    const int n = static_cast<int>(graph.size());
    std::vector<int> order;
    std::vector<char> seen(n);
    while (static_cast<int>(order.size()) < n) {
        int start = -1;
        for (int i = 0; i < n; ++i)
            if (!seen[i] && (start < 0 || graph[i].size() > graph[start].size())) start = i;
        seen[start] = 1;
        order.push_back(start);
        for (std::size_t k = order.size() - 1; k < order.size(); ++k)
            for (const Neighbour& next : graph[order[k]])
                if (!seen[next.vertex]) {
                    seen[next.vertex] = 1;
                    order.push_back(next.vertex);
                }
    }
    return order;
}

class Search {
public:
    Search(const LabelledGraph& rows, const LabelledGraph& columns, bool swapped, const GgdOptions& options)
        : swapped_(swapped), k_e_(options.k_e), columns_(adjacency(columns)) {
        const Adjacency row_graph = adjacency(rows);
        order_ = breadth_first(row_graph);
        std::vector<int> position(order_.size());
        for (std::size_t k = 0; k < order_.size(); ++k) position[order_[k]] = static_cast<int>(k);
        for (const int row : order_) {
            std::vector<double> price;
            for (int c = 0; c < std::ssize(columns_); ++c)
                price.push_back(vertex_cost(rows, row, columns, c, options));
            price_.push_back(std::move(price));
            std::vector<Neighbour> back;
            for (const Neighbour& n : row_graph[row])
                if (position[n.vertex] < position[row]) back.push_back({position[n.vertex], n.length});
            back_.push_back(std::move(back));
        }
        for (const std::vector<Neighbour>& edges : columns_) {
            double longest = 0;
            for (const Neighbour& n : edges) longest = std::max(longest, n.length);
            longest_.push_back(longest);
        }
        placed_.assign(order_.size(), -1);
        used_.assign(columns_.size(), 0);
        const bool large = std::max(order_.size(), columns_.size()) > exact_vertices;
        limit_ = large ? options.max_nodes / large_graph_divisor : options.max_nodes;
        complete_ = !large;
    }

    // The canonical optimal matching as pairs (vertex of a, vertex of b), ascending.
    Pairs solve() {
        descend(0, 0);
        if (nodes_ > limit_) {
            complete_ = false;
            return best_pairs_;
        }
        // Optimum known: among all matchings within the tolerance keep the smallest.
        threshold_ = best_ + tie;
        collecting_ = true;
        nodes_ = 0;
        descend(0, 0);
        return best_pairs_;
    }
    bool complete() const { return complete_; }

private:
    double edge_saving(double row_edge, int column, int other) const {
        for (const Neighbour& n : columns_[column])
            if (n.vertex == other) return 2 * k_e_ * std::min(row_edge, n.length);
        return 0;
    }
    // Change of the cost when row k is put on column c and the rows before `depth` are placed. An edge to a
    // row that is still unplaced counts as if it lay on the longest edge of c.
    double change(int k, int c, int depth) const {
        double change = price_[k][c];
        for (const Neighbour& n : back_[k]) {
            if (n.vertex >= depth)
                change -= 2 * k_e_ * std::min(n.length, longest_[c]);
            else if (placed_[n.vertex] >= 0)
                change -= edge_saving(n.length, c, placed_[n.vertex]);
        }
        return change;
    }
    double bound(int depth) const {
        double sum = 0;
        for (int k = depth; k < std::ssize(order_); ++k) {
            double best = 0;
            for (int c = 0; c < std::ssize(columns_); ++c)
                if (!used_[c]) best = std::min(best, change(k, c, depth));
            sum += best;
        }
        return sum;
    }
    bool hopeless(double lower_bound) const {
        return collecting_ ? lower_bound > threshold_ : lower_bound >= best_;
    }
    void accept(double cost) {
        Pairs pairs;
        for (std::size_t k = 0; k < order_.size(); ++k)
            if (placed_[k] >= 0)
                pairs.push_back(swapped_ ? std::pair{placed_[k], order_[k]}
                                         : std::pair{order_[k], placed_[k]});
        std::sort(pairs.begin(), pairs.end());
        if (!collecting_) {
            best_ = cost;
            best_pairs_ = std::move(pairs);
        } else if (pairs < best_pairs_) {
            best_pairs_ = std::move(pairs);
        }
    }
    void descend(int depth, double cost) {
        if (++nodes_ > limit_ || hopeless(cost + bound(depth))) return;
        if (depth == std::ssize(order_)) return accept(cost);
        struct Child {
            double change;
            int column; // −1: nowhere
        };
        std::vector<Child> children = {{0, -1}};
        for (int c = 0; c < std::ssize(columns_); ++c)
            if (!used_[c]) children.push_back({change(depth, c, depth), c});
        std::stable_sort(children.begin(), children.end(),
                         [](const Child& x, const Child& y) { return x.change < y.change; });
        for (const Child& child : children) {
            placed_[depth] = child.column;
            if (child.column >= 0) used_[child.column] = 1;
            descend(depth + 1, cost + child.change);
            if (child.column >= 0) used_[child.column] = 0;
        }
        placed_[depth] = -1;
    }

    bool swapped_;
    double k_e_;
    Adjacency columns_;
    std::vector<int> order_;                   // [k] row placed k-th
    std::vector<std::vector<double>> price_;   // [k][column]
    std::vector<std::vector<Neighbour>> back_; // [k] edges to rows placed earlier
    std::vector<double> longest_;              // [column] its longest edge, 0 without one
    std::vector<int> placed_;                  // [k] column, −1 nowhere
    std::vector<char> used_;                   // [column]
    long nodes_ = 0, limit_ = 0;
    double best_ = std::numeric_limits<double>::infinity();
    double threshold_ = 0;
    bool collecting_ = false, complete_ = true;
    Pairs best_pairs_;
};

} // namespace

GgdResult geometric_graph_distance(const LabelledGraph& a, const LabelledGraph& b,
                                   const GgdOptions& options) {
    // Branch over the smaller graph, over b (the reference) when they are equal.
    const bool swapped = b.positions.size() <= a.positions.size();
    Search search(swapped ? b : a, swapped ? a : b, swapped, options);
    GgdResult result;
    result.pairs = search.solve();
    result.optimal = search.complete();
    result.base = empty_matching_cost(a, b, options);
    result.distance = matching_cost(a, b, result.pairs, options);
    return result;
}

} // namespace pantin
