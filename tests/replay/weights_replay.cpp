// SPDX-License-Identifier: MIT
// Algorithm 4.4 of the thesis (ERRATA 20) from the stored mesh, skeleton and mapping.
#include <algorithm>
#include <cmath>
#include <set>

#include "pantin/reference.hpp"
#include "replay/stored.hpp"

namespace pantin::test::replay {
namespace {

struct End {
    int vertex; // of the skeleton
    Point2d place;
    std::string label;
};

// The set EF: those of the mapping first, then all other ends.
std::vector<End> ends_of(const Stored& s) {
    std::vector<int> order;
    for (const auto& pair : s.mapping["pairs"]) order.push_back(pair["end"]);
    for (int v = 0; v < std::ssize(s.graph.vertices); ++v) {
        int degree = 0;
        for (const Edge& e : s.graph.edges) degree += e.u == v || e.v == v;
        if (degree == 1 && std::find(order.begin(), order.end(), v) == order.end()) order.push_back(v);
    }
    std::vector<End> ends;
    for (const int v : order)
        ends.push_back({v, {s.graph.vertices[v].x, s.graph.vertices[v].y}, s.graph.vertices[v].label});
    return ends;
}

// To multiples of one half, where mesh.obj has world units.
std::vector<Point2d> places_of(const Stored& s) {
    std::vector<Point2d> places;
    for (const Point2d& p : s.vertices) places.push_back({std::rint(2 * p.x) / 2, std::rint(2 * p.y) / 2});
    return places;
}

std::string label_at(const Stored& s, Point2d p) {
    const int x = std::clamp(static_cast<int>(std::rint(p.x)), 0, s.width - 1),
              y = std::clamp(static_cast<int>(std::rint(p.y)), 0, s.height - 1);
    return std::string(label_names[static_cast<std::size_t>(nearest_label(s.labels, x, y))]);
}

// The vertices that a flood from the one nearest to the end reaches: of its label, and of all ends of that
// label this one nearest.
std::set<int> flood(const Stored& s, const std::vector<Point2d>& places,
                    const std::vector<std::string>& labels, const std::vector<End>& ends, const End& end) {
    int seed = 0;
    for (int v = 0; v < std::ssize(places); ++v)
        if (distance(places[v], end.place) < distance(places[seed], end.place)) seed = v;
    const auto belongs = [&](int v) {
        if (labels[v] != labels[seed]) return false;
        return std::none_of(ends.begin(), ends.end(), [&](const End& other) {
            return other.label == labels[seed] &&
                   distance(places[v], other.place) < distance(places[v], end.place);
        });
    };
    std::set<int> reached = {seed};
    for (std::size_t before = 0; before != reached.size();) {
        before = reached.size();
        for (const std::vector<int>& face : s.faces)
            for (std::size_t i = 0; i < face.size(); ++i) {
                const int a = face[i], b = face[(i + 1) % face.size()];
                if (reached.count(a) && !reached.count(b) && belongs(b)) reached.insert(b);
                if (reached.count(b) && !reached.count(a) && belongs(a)) reached.insert(a);
            }
    }
    return reached;
}

// The length of the first edge at the end over the diagonal of the box.
double bone(const std::vector<Point2d>& places, const std::vector<std::pair<int, int>>& edges, int end) {
    double left = 1e300, top = 1e300, right = -1e300, bottom = -1e300;
    for (const Point2d& p : places) {
        left = std::min(left, p.x), right = std::max(right, p.x);
        top = std::min(top, p.y), bottom = std::max(bottom, p.y);
    }
    for (const auto& [u, v] : edges)
        if (u == end || v == end)
            return distance(places[u], places[v]) / std::hypot(right - left, bottom - top);
    return 0;
}

double sigma(const Stored& s, const ReferenceSkeleton& reference, int end, int reference_end) {
    std::vector<Point2d> a, b;
    std::vector<std::pair<int, int>> edges;
    for (const Vertex& v : s.graph.vertices) a.push_back({v.x, v.y});
    for (const Edge& e : s.graph.edges) edges.emplace_back(e.u, e.v);
    for (const ReferenceNode& n : reference.nodes) b.push_back({std::rint(241 * n.x), std::rint(241 * n.y)});
    const double p = bone(a, edges, end), q = bone(b, reference.edges, reference_end);
    return p > 0 && q > 0 ? std::min(p / q, q / p) : 0;
}

} // namespace

void replay_weights(const Stored& s, Tally& tally) {
    if (!s.rigged) return;
    bool sums = s.weights.size() == s.vertices.size();
    for (const auto& weights : s.weights) {
        double sum = 0;
        for (const auto& [index, weight] : weights) sum += weight;
        sums = sums && sum == 1;
    }
    tally.add("weights: sum 1", sums);
    if (!s.thesis) return; // the default's are smooth
    const auto references = load_references();
    const auto reference = std::find_if(references.begin(), references.end(), [&](const auto& r) {
        return r.name == s.identification["reference"];
    });
    const std::vector<End> ends = ends_of(s);
    const std::vector<Point2d> places = places_of(s);
    std::vector<std::string> labels;
    for (const Point2d& p : places) labels.push_back(label_at(s, p));
    std::vector<std::map<int, double>> expected(places.size(), {{0, 1.0}});
    int index = 0;
    for (const auto& pair : s.mapping["pairs"]) {
        const double share = sigma(s, *reference, pair["end"], pair["reference_end"]);
        for (const int v : flood(s, places, labels, ends, ends[index]))
            expected[v] = {{0, 1 - share}, {index + 1, share}};
        ++index;
    }
    bool same = true;
    for (std::size_t v = 0; same && v < places.size(); ++v)
        for (int b = 0; b <= index; ++b) {
            const auto of = [&](const std::map<int, double>& w) { return w.count(b) ? w.at(b) : 0.0; };
            same = same && std::abs(of(expected[v]) - of(s.weights[v])) <= 1.0 / 65536;
        }
    tally.add("weights: Algorithm 4.4", same);
}

} // namespace pantin::test::replay
