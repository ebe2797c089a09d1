// SPDX-License-Identifier: MIT
// The geometric graph distance of every candidate (thesis Eq. 4.3 to 4.7): the stored matching costs what it
// says, and a plain branch and bound finds none that costs less.
#include <algorithm>
#include <cmath>

#include "pantin/identification.hpp"
#include "pantin/reference.hpp"
#include "replay/stored.hpp"

namespace pantin::test::replay {
namespace {

struct Figure {
    std::vector<Point2d> places; // in the box of the vertices, each axis by itself to [0, 1]
    std::vector<double> values;  // of the labels (thesis ch. 5)
    std::vector<std::pair<int, int>> edges;
    double length(int edge) const { return distance(places[edges[edge].first], places[edges[edge].second]); }
};

void normalise(Figure& figure) {
    for (double Point2d::*axis : {&Point2d::x, &Point2d::y}) {
        double low = 1e300, high = -1e300;
        for (const Point2d& p : figure.places) low = std::min(low, p.*axis), high = std::max(high, p.*axis);
        for (Point2d& p : figure.places) p.*axis = high > low ? (p.*axis - low) / (high - low) : 0.5;
    }
}

double value_of(const std::string& label) {
    static const std::map<std::string, double> values = [] {
        std::map<std::string, double> result;
        for (int i = 0; i < label_count; ++i)
            result[std::string(label_names[static_cast<std::size_t>(i)])] =
                GgdOptions().label_values[static_cast<std::size_t>(i)];
        return result;
    }();
    return values.at(label);
}

Figure drawn(const Stored& s) {
    Figure figure;
    for (const Vertex& v : s.graph.vertices) {
        figure.places.push_back({v.x, v.y});
        figure.values.push_back(value_of(v.label));
    }
    for (const Edge& e : s.graph.edges) figure.edges.emplace_back(e.u, e.v);
    normalise(figure);
    return figure;
}

Figure modelled(const ReferenceSkeleton& reference, bool mirrored) {
    Figure figure;
    for (const ReferenceNode& n : reference.nodes) {
        figure.places.push_back({n.x, n.y});
        figure.values.push_back(value_of(std::string(name_of(n.label))));
    }
    figure.edges = reference.edges;
    normalise(figure);
    if (mirrored)
        for (Point2d& p : figure.places) p.x = 1 - p.x;
    return figure;
}

// K_e is 1. A matching costs all edges' lengths, plus what its vertices cost, minus for every pair of matched
// edges twice the shorter one's length (Eq. 4.7).
class Search {
public:
    Search(const Figure& a, const Figure& b, double k_v, double k_l) : a_(a), b_(b) {
        for (std::size_t e = 0; e < a.edges.size(); ++e) base_ += a.length(static_cast<int>(e));
        for (std::size_t e = 0; e < b.edges.size(); ++e) base_ += b.length(static_cast<int>(e));
        degree_.assign(a.places.size(), 0);
        for (const auto& [u, v] : a.edges) ++degree_[u], ++degree_[v];
        for (std::size_t u = 0; u < a.places.size(); ++u) {
            std::vector<double>& row = cost_.emplace_back();
            for (std::size_t v = 0; v < b.places.size(); ++v)
                row.push_back(k_v * distance(a.places[u], b.places[v]) +
                              k_l * std::abs(a.values[u] - b.values[v]));
        }
        find_order();
        for (int e = 0; e < std::ssize(a.edges); ++e) best_gain_.push_back(free_gain(e));
        image_.assign(a.places.size(), undecided);
        used_.assign(b.places.size(), false);
    }

    double cost_of(const std::vector<std::pair<int, int>>& pairs) {
        image_.assign(a_.places.size(), none);
        double cost = base_;
        for (const auto& [u, v] : pairs) image_[u] = v, cost += cost_[u][v];
        for (int e = 0; e < std::ssize(a_.edges); ++e) cost -= gain_of(e);
        image_.assign(a_.places.size(), undecided);
        return cost;
    }

    // Whether a matching costs less than the limit; 1, 0, or −1 when the search was too long.
    int any_below(double limit) {
        limit_ = limit;
        nodes_ = 0;
        const bool found = visit(0, base_);
        return found ? 1 : nodes_ >= most_nodes ? -1 : 0;
    }

private:
    static constexpr int undecided = -2, none = -1;
    static constexpr long most_nodes = 30'000'000;

    // From the busiest vertex on to those that hang together with it.
    void find_order() {
        const int n = static_cast<int>(a_.places.size());
        std::vector<bool> taken(n, false);
        while (std::ssize(order_) < n) {
            int next = -1, most = -1;
            for (int u = 0; u < n; ++u) {
                int links = 0;
                for (const auto& [p, q] : a_.edges) links += (p == u && taken[q]) || (q == u && taken[p]);
                const int rank = taken[u] ? -1 : 100 * links + degree_[u];
                if (rank > most) most = rank, next = u;
            }
            taken[next] = true;
            order_.push_back(next);
        }
    }
    // Twice the shorter length where the images of the edge's ends are joined in B.
    double gain(int e, int p, int q) const {
        for (int f = 0; f < std::ssize(b_.edges); ++f) {
            const auto [r, t] = b_.edges[f];
            if ((r == p && t == q) || (r == q && t == p)) return 2 * std::min(a_.length(e), b_.length(f));
        }
        return 0;
    }
    double gain_of(int e) const {
        const int p = image_[a_.edges[e].first], q = image_[a_.edges[e].second];
        return p >= 0 && q >= 0 ? gain(e, p, q) : 0;
    }
    double share(int u, int v) const { return cost_[u][v] / degree_[u]; }
    // The most that an edge with both ends undecided can gain; each end's cost is shared by its edges.
    double free_gain(int e) const {
        const auto [u, v] = a_.edges[e];
        double best = 0;
        for (const auto& [p, q] : b_.edges)
            best = std::max(
                {best, gain(e, p, q) - share(u, p) - share(v, q), gain(e, p, q) - share(u, q) - share(v, p)});
        return best;
    }
    double most_gain(int e) const {
        const auto [u, v] = a_.edges[e];
        if (image_[u] == undecided && image_[v] == undecided) return best_gain_[e];
        if (image_[u] != undecided && image_[v] != undecided) return 0; // counted
        const int open = image_[u] == undecided ? u : v, fixed = image_[open == u ? v : u];
        double best = 0;
        for (const auto& [p, q] : b_.edges)
            if (fixed >= 0 && (p == fixed || q == fixed)) {
                const int other = p == fixed ? q : p;
                if (!used_[other]) best = std::max(best, gain(e, p, q) - share(open, other));
            }
        return best;
    }

    bool visit(int depth, double cost) {
        if (++nodes_ >= most_nodes) return false;
        if (depth == std::ssize(order_)) return cost < limit_;
        double bound = cost;
        for (int e = 0; e < std::ssize(a_.edges); ++e) bound -= most_gain(e);
        if (bound >= limit_) return false;
        const int u = order_[depth];
        for (int v = none; v < std::ssize(b_.places); ++v) {
            if (v >= 0 && used_[v]) continue;
            image_[u] = v;
            double next = cost + (v >= 0 ? cost_[u][v] : 0);
            for (int e = 0; e < std::ssize(a_.edges); ++e)
                if (a_.edges[e].first == u || a_.edges[e].second == u) next -= gain_of(e);
            if (v >= 0) used_[v] = true;
            const bool found = visit(depth + 1, next);
            if (v >= 0) used_[v] = false;
            image_[u] = undecided;
            if (found) return true;
        }
        return false;
    }

    const Figure &a_, &b_;
    double base_ = 0, limit_ = 0;
    long nodes_ = 0;
    std::vector<int> degree_, order_, image_;
    std::vector<bool> used_;
    std::vector<std::vector<double>> cost_;
    std::vector<double> best_gain_;
};

// K_n = 0.38 in the place of K_v for what moves like a quadruped (thesis ch. 5, ERRATA 8).
double k_v_of(const ReferenceSkeleton& reference, bool thesis) {
    return thesis && (reference.name == "quadruped" || reference.like == "quadruped") ? 0.38 : 1;
}

} // namespace

void replay_distance(const Stored& s, Tally& tally) {
    if (s.identification.is_null()) return;
    const Figure a = drawn(s);
    const auto references = load_references();
    std::string nearest;
    double smallest = 1e300;
    for (const auto& candidate : s.identification["candidates"]) {
        const std::string name = candidate["reference"];
        const auto reference =
            std::find_if(references.begin(), references.end(), [&](const auto& r) { return r.name == name; });
        const Figure b = modelled(*reference, candidate["mirrored"]);
        Search search(a, b, k_v_of(*reference, s.thesis), 5);
        const double stored = candidate["distance"];
        const double cost = search.cost_of(candidate["pairs"].get<std::vector<std::pair<int, int>>>());
        tally.add("graph distance: that of its matching", std::abs(cost - stored) < 1e-9, name);
        const int less = search.any_below(stored - 1e-9);
        if (less < 0)
            tally.add("graph distance: search was too long", true);
        else
            tally.add("graph distance: none is smaller", less == 0, name);
        if (stored < smallest) smallest = stored, nearest = name;
    }
    if (s.thesis) tally.add("reference: the nearest", nearest == s.identification["reference"]);
}

} // namespace pantin::test::replay
