// SPDX-License-Identifier: MIT
// Where the thesis (4.6) has one bone per end-effector, between the end and its neighbour in the graph, the
// limbs here run along the skeleton's pixels from where they leave the body, so that bones can follow bent
// limbs and weights can be measured along them. Unmatched end-effectors become side branches of a limb, or
// followers of their nearest mapped neighbour of the same label.
#include "rigging/limbs.hpp"

#include <algorithm>
#include <cmath>

#include "pantin/image.hpp"
#include "rigging/inward_paths.hpp"
#include "rigging/part_components.hpp"

namespace pantin {
namespace {

// An unmatched branch shorter than this share of the limb beyond the fork, or of the whole limb, is a side
// branch.
constexpr double twig_share = 0.6, twig_share_of_limb = 0.4;
// A stem shared by two limbs and shorter than this share of both branches counts as body.
constexpr double stub_share = 0.35;
// A part without end-effector is a limb from this share of the silhouette on, if this share of its border
// meets the background (a folded wing inside the body does not move).
constexpr double part_share = 0.005, free_border = 0.35;

enum class Kind { head, body, appendage };
Kind kind_of(Label label) {
    if (label == Label::head) return Kind::head;
    return label == Label::body || label == Label::background ? Kind::body : Kind::appendage;
}

// A path that may become a limb: the first `extent` points of an inward path.
struct Branch {
    const InwardPath* path = nullptr;
    int extent = 0;
    Label label = Label::limb;
    int reference_end = -1; // as the mapping says
    bool matched = false;   // … and the labels agree
    double length = 0;
};

class LimbFinder {
public:
    LimbFinder(const SkeletonGraph& graph, const LabelMap& labels, const Grid<float>& depth,
               const ReferenceSkeleton& reference, const Mapping& mapping)
        : graph_(graph), labels_(labels), depth_(depth), reference_(reference), mapping_(mapping),
          paths_(skeleton_paths(graph, labels, depth)), degree_(graph.vertices.size(), 0) {
        for (const SkeletonEdge& edge : graph.edges) {
            ++degree_[edge.u];
            ++degree_[edge.v];
        }
        noise_ = std::max(3.0, 0.015 * std::max(labels.width(), labels.height()));
    }

    Limbs find() {
        result_.root = paths_.root;
        std::vector<Branch> candidates;
        for (const InwardPath& path : paths_.paths) {
            const Branch candidate = candidate_of(path);
            if (candidate.extent >= 3) candidates.push_back(candidate);
        }
        std::stable_sort(candidates.begin(), candidates.end(), [](const Branch& a, const Branch& b) {
            return a.matched != b.matched ? a.matched : a.length > b.length;
        });
        for (const Branch& candidate : candidates) add(candidate);
        add_parts_without_end();
        give_references();
        for (Limb& limb : result_.limbs) measure(limb);
        hang_on_heads();
        drop_unreferenced_and_sort();
        return std::move(result_);
    }

private:
    template <class T> T sample(const Grid<T>& grid, Point2d p) const {
        return grid(std::clamp(static_cast<int>(std::rint(p.x)), 0, grid.width() - 1),
                    std::clamp(static_cast<int>(std::rint(p.y)), 0, grid.height() - 1));
    }
    Label label_at(Point2d p) const { return static_cast<Label>(sample(labels_, p)); }

    static double arc_length(const InwardPath& path, int from, int to) {
        double sum = 0;
        for (int i = from; i < to; ++i) sum += distance(path.points[i], path.points[i + 1]);
        return sum;
    }

    Branch candidate_of(const InwardPath& path) const {
        Branch candidate{&path, 0, graph_.vertices[path.end].label, -1, false, 0};
        for (const EndPair& pair : mapping_.pairs)
            if (pair.end == path.end) candidate.reference_end = pair.reference_end;
        const bool mapped = candidate.reference_end >= 0;
        const Label wanted = mapped ? reference_.nodes[candidate.reference_end].label : Label::background;
        if (kind_of(candidate.label) != Kind::body)
            candidate.extent = extent_by_label(path, kind_of(candidate.label));
        if (candidate.extent < 3 && mapped && kind_of(wanted) != Kind::body) {
            // The segmentation saw no part here, the mapping did: the part is the branch up to the body's
            // flesh.
            candidate.extent = extent_by_junction(path);
            candidate.label = wanted;
        }
        candidate.matched = mapped && wanted == candidate.label;
        candidate.length = arc_length(path, 0, std::max(0, candidate.extent - 1));
        return candidate;
    }

    // Points from the end-effector until the label changes its kind for longer than noise does.
    int extent_by_label(const InwardPath& path, Kind kind) const {
        const int n = static_cast<int>(path.points.size());
        int own = 0; // points up to and with the last one of the kind
        double foreign = 0;
        for (int i = 0; i < n; ++i) {
            if (kind_of(label_at(path.points[i])) == kind) {
                own = i + 1;
                foreign = 0;
            } else {
                foreign += i > 0 ? distance(path.points[i - 1], path.points[i]) : 1;
                if (foreign >= noise_) break;
            }
        }
        if (own < n) return own;
        return kind == Kind::head ? 0 : static_cast<int>(0.8 * n); // the root lies in the part itself
    }

    int extent_by_junction(const InwardPath& path) const {
        const int n = static_cast<int>(path.points.size());
        int junction = n - 1;
        for (int i = n - 1; i > 0; --i)
            if (path.vertex[i] >= 0 && degree_[path.vertex[i]] >= 3) junction = i;
        const double flesh = sample(depth_, path.points[junction]);
        int extent = junction + 1;
        while (extent > 0 && distance(path.points[extent - 1], path.points[junction]) < flesh) --extent;
        return std::max(extent, (junction + 1) / 2);
    }

    // First point of the candidate that is a vertex of an accepted limb: (point index, limb), or (−1, −1).
    std::pair<int, int> meeting(const Branch& candidate) const {
        for (int i = 1; i < candidate.extent; ++i) {
            const int vertex = candidate.path->vertex[i];
            if (vertex < 0) continue;
            for (std::size_t d = 0; d < result_.limbs.size(); ++d)
                for (int j = 0; j < accepted_[d].extent; ++j)
                    if (accepted_[d].path->vertex[j] == vertex) return {i, static_cast<int>(d)};
        }
        return {-1, -1};
    }

    void add(Branch candidate) {
        const auto [here, other] = meeting(candidate);
        int parent = -1;
        double parent_position = 0;
        if (other >= 0) {
            Branch& d = accepted_[other];
            int there = 0;
            while (d.path->vertex[there] != candidate.path->vertex[here]) ++there;
            const double branch = arc_length(*candidate.path, 0, here), outer = arc_length(*d.path, 0, there);
            const double stem = arc_length(*d.path, there, d.extent - 1);
            const bool is_short = branch < twig_share * outer || branch < twig_share_of_limb * (outer + stem);
            if (!candidate.matched && (is_short || candidate.label == Label::head)) {
                add_twig(candidate, here, other, stem);
                return;
            }
            candidate.extent = here + 1;
            parent = other, parent_position = stem;
            if (stem < stub_share * std::min(branch, outer)) {
                trim(other, there, stem);
                parent = result_.limbs[other].parent, parent_position = result_.limbs[other].parent_position;
            }
        }
        Limb limb;
        limb.end = candidate.path->end;
        limb.reference_end = candidate.reference_end;
        limb.matched = candidate.matched;
        limb.label = candidate.label;
        limb.parent = parent;
        limb.parent_position = parent_position;
        result_.limbs.push_back(limb);
        accepted_.push_back(candidate);
        set_path(result_.limbs.back(), candidate);
    }

    void set_path(Limb& limb, const Branch& candidate) const {
        limb.path.assign(candidate.path->points.begin(), candidate.path->points.begin() + candidate.extent);
        std::reverse(limb.path.begin(), limb.path.end());
        set_positions(limb);
    }
    static void set_positions(Limb& limb) {
        limb.position.assign(1, 0);
        for (std::size_t i = 1; i < limb.path.size(); ++i)
            limb.position.push_back(limb.position.back() + distance(limb.path[i - 1], limb.path[i]));
    }

    // Moves a limb's attachment outward to its point `there`; the stem becomes body.
    void trim(int index, int there, double stem) {
        accepted_[index].extent = there + 1;
        set_path(result_.limbs[index], accepted_[index]);
        for (Limb& limb : result_.limbs)
            if (limb.parent == index) limb.parent_position = std::max(0.0, limb.parent_position - stem);
        for (Twig& twig : result_.twigs)
            if (twig.limb == index) twig.position = std::max(0.0, twig.position - stem);
    }

    void add_twig(const Branch& candidate, int here, int limb, double position) {
        const auto& points = candidate.path->points;
        result_.twigs.push_back({limb, position, {points.begin(), points.begin() + here + 1}});
    }

    // Parts that segmentation sees and the skeleton does not (a short leg, a stub of a tail): pruning took
    // their end-effector. They move as well, along a path of their own.
    void add_parts_without_end() {
        const auto area = std::count_if(depth_.begin(), depth_.end(), [](float d) { return d > 0; });
        const int min_area = std::max(30, static_cast<int>(part_share * static_cast<double>(area)));
        for (PartComponent& part : part_components(labels_, depth_, min_area)) {
            if (part.free_share < free_border || part.path.size() < 3 || is_covered(part)) continue;
            const bool has_head = std::any_of(result_.limbs.begin(), result_.limbs.end(),
                                              [](const Limb& limb) { return limb.label == Label::head; });
            if (part.label == Label::head && has_head) continue;
            Limb limb;
            limb.end =
                static_cast<int>(graph_.vertices.size() + result_.limbs.size()); // no vertex; keeps the order
            limb.label = part.label;
            limb.path = std::move(part.path);
            set_positions(limb);
            result_.limbs.push_back(std::move(limb));
            accepted_.push_back({});
        }
    }

    // Whether a limb or a side branch of one runs through the part, or the body's root lies in it.
    bool is_covered(const PartComponent& part) const {
        const auto inside = [&](Point2d p) {
            const Point2i pixel{static_cast<int>(std::rint(p.x)), static_cast<int>(std::rint(p.y))};
            return std::binary_search(
                part.pixels.begin(), part.pixels.end(), pixel,
                [](Point2i a, Point2i b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
        };
        const auto runs_through = [&](const std::vector<Point2d>& path) {
            return std::count_if(path.begin(), path.end(), inside) >= 3;
        };
        for (const Limb& limb : result_.limbs)
            if (runs_through(limb.path)) return true;
        for (const Twig& twig : result_.twigs)
            if (runs_through(twig.path)) return true;
        return inside(result_.root);
    }

    // Position of an end-effector inside the box of all of them, for comparison with the reference's nodes.
    Point2d normalised(Point2d p) const {
        double left = p.x, right = p.x, top = p.y, bottom = p.y;
        for (const SkeletonVertex& v : graph_.vertices) {
            left = std::min(left, v.x), right = std::max(right, v.x);
            top = std::min(top, v.y), bottom = std::max(bottom, v.y);
        }
        return {(p.x - left) / std::max(1.0, right - left), (p.y - top) / std::max(1.0, bottom - top)};
    }

    std::vector<int> free_reference_ends(Label label) const {
        std::vector<int> degree(reference_.nodes.size(), 0), ends;
        for (const auto& [u, v] : reference_.edges) ++degree[u], ++degree[v];
        for (std::size_t n = 0; n < reference_.nodes.size(); ++n) {
            if (degree[n] > 1 || reference_.nodes[n].label != label) continue;
            const bool taken = std::any_of(result_.limbs.begin(), result_.limbs.end(), [&](const Limb& limb) {
                return limb.matched && limb.reference_end == static_cast<int>(n);
            });
            if (!taken) ends.push_back(static_cast<int>(n));
        }
        return ends;
    }

    // Limbs that the mapping left out, or paired with a part of another label: a reference end of their label
    // that is still free (the nearest in normalised position), else they follow the nearest limb of their
    // label.
    void give_references() {
        for (Limb& limb : result_.limbs) {
            if (limb.matched) continue;
            const Point2d at = normalised(limb.path.back());
            int best = -1;
            double best_distance = 0;
            for (int node : free_reference_ends(limb.label)) {
                const double d = distance(at, {reference_.nodes[node].x, reference_.nodes[node].y});
                if (best < 0 || d < best_distance) best = node, best_distance = d;
            }
            if (best >= 0)
                limb.reference_end = best, limb.matched = true;
            else
                follow_nearest(limb);
        }
    }

    void follow_nearest(Limb& limb) {
        const Limb* nearest = nullptr;
        for (const Limb& other : result_.limbs) {
            if (!other.matched || other.label != limb.label || &other == &limb) continue;
            if (!nearest || distance(other.path.back(), limb.path.back()) <
                                distance(nearest->path.back(), limb.path.back()))
                nearest = &other;
        }
        if (!nearest) return; // what the mapping said, if anything
        limb.reference_end = nearest->reference_end;
        limb.phase_shift = row_of(limb.label).alternates ? 0.5 : 0; // legs do, wings beat together
    }

    void measure(Limb& limb) const {
        double sum = 0;
        for (const Point2d& p : limb.path) sum += sample(depth_, p);
        limb.width = 2 * sum / static_cast<double>(limb.path.size());
    }

    // An arm that leaves the head (a figure without a neck, a face with legs) hangs on the head's limb.
    void hang_on_heads() {
        for (std::size_t i = 0; i < result_.limbs.size(); ++i) {
            Limb& limb = result_.limbs[i];
            const Branch& c = accepted_[i];
            if (limb.parent >= 0 || limb.label == Label::head || !c.path) continue;
            if (c.extent >= static_cast<int>(c.path->points.size())) continue;
            if (label_at(c.path->points[c.extent]) != Label::head) continue;
            for (std::size_t h = 0; h < result_.limbs.size() && limb.parent < 0; ++h)
                if (result_.limbs[h].label == Label::head && result_.limbs[h].parent < 0) {
                    limb.parent = static_cast<int>(h);
                    limb.parent_position = result_.limbs[h].length();
                }
        }
    }

    // Limbs that nothing drives are body again; parents first, otherwise in the order of the end-effectors.
    void drop_unreferenced_and_sort() {
        std::vector<int> order, place(result_.limbs.size(), -1);
        const auto drives = [&](int i) { return result_.limbs[i].reference_end >= 0; };
        const auto parent_of = [&](int i) {
            int p = result_.limbs[i].parent;
            while (p >= 0 && !drives(p)) p = result_.limbs[p].parent;
            return p;
        };
        std::vector<int> waiting;
        for (int i = 0; i < static_cast<int>(result_.limbs.size()); ++i)
            if (drives(i)) waiting.push_back(i);
        std::sort(waiting.begin(), waiting.end(),
                  [&](int a, int b) { return result_.limbs[a].end < result_.limbs[b].end; });
        while (order.size() < waiting.size()) // a tree has a limb whose parent is placed
            for (int i : waiting)
                if (place[i] < 0 && (parent_of(i) < 0 || place[parent_of(i)] >= 0)) {
                    place[i] = static_cast<int>(order.size());
                    order.push_back(i);
                }
        std::vector<Limb> sorted;
        for (int i : order) {
            Limb limb = result_.limbs[i];
            limb.parent = parent_of(i) < 0 ? -1 : place[parent_of(i)];
            sorted.push_back(std::move(limb));
        }
        std::vector<Twig> twigs;
        for (Twig& twig : result_.twigs)
            if (place[twig.limb] >= 0)
                twigs.push_back({place[twig.limb], twig.position, std::move(twig.path)});
        result_.limbs = std::move(sorted);
        result_.twigs = std::move(twigs);
    }

    const SkeletonGraph& graph_;
    const LabelMap& labels_;
    const Grid<float>& depth_;
    const ReferenceSkeleton& reference_;
    const Mapping& mapping_;
    SkeletonPaths paths_;
    std::vector<int> degree_;
    double noise_ = 3; // working pixels: shorter runs of another label do not end a limb
    Limbs result_;
    std::vector<Branch> accepted_; // parallel to result_.limbs until they are sorted
};

} // namespace

Point2d Limb::at(double s) const {
    if (s <= 0) return path.front();
    for (std::size_t i = 1; i < path.size(); ++i)
        if (position[i] >= s) {
            const double step = position[i] - position[i - 1];
            const double t = step > 0 ? (s - position[i - 1]) / step : 0;
            return path[i - 1] + t * (path[i] - path[i - 1]);
        }
    return path.back();
}

Limbs find_limbs(const SkeletonGraph& graph, const LabelMap& labels, const Grid<float>& depth,
                 const ReferenceSkeleton& reference, const Mapping& mapping) {
    return LimbFinder(graph, labels, depth, reference, mapping).find();
}

LabelMap nearest_labels(const LabelMap& labels) {
    const Grid<int> nearest = nearest_seed(foreground(labels));
    LabelMap filled = labels;
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (nearest.data()[i] >= 0) filled.data()[i] = labels.data()[nearest.data()[i]];
    return filled;
}

} // namespace pantin
