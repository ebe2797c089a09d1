// SPDX-License-Identifier: MIT
// In come limbs and side branches as paths, the silhouette and its labels; out goes the limb to which each
// pixel belongs, and where along it. Our own: in the thesis (Algorithm 4.4) mesh vertices are flooded, each
// from its end-effector.
#include "rigging/ownership.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "image/nearest_pixel.hpp"
#include "pantin/image.hpp"

namespace pantin {
namespace {

// Dijkstra over pixels with a bucket for each cost (Dial 1969); ties by the pixel's index, so the result
// depends on the input alone. Every step costs at least 5: a bucket is complete when its turn comes.
class Flood {
public:
    Flood(const Mask& silhouette, const LabelMap& labels)
        : silhouette_(silhouette), labels_(labels), owners_(silhouette.width(), silhouette.height()),
          cost_(silhouette.width(), silhouette.height(), -1),
          settled_(silhouette.width(), silhouette.height()) {}

    // The first owner of a pixel stays.
    void seed(Point2d point, Owner owner) {
        const Point2i p = nearest_pixel(silhouette_, point);
        if (cost_(p.x, p.y) >= 0) return;
        owners_(p.x, p.y) = owner;
        cost_(p.x, p.y) = 0;
        enqueue(0, index(p.x, p.y));
    }

    // With `keep_label` a pixel is reached through pixels of one label only. Without, the flood goes on from
    // everything reached so far, whose owners stay.
    void run(bool keep_label) {
        if (!keep_label)
            for (int i = 0; i < static_cast<int>(cost_.size()); ++i)
                if (cost_.data()[i] >= 0) {
                    enqueue(cost_.data()[i], i);
                    settled_.data()[i] = 1;
                }
        for (std::size_t cost = 0; cost < buckets_.size(); ++cost) {
            std::vector<int> bucket = std::move(buckets_[cost]); // spreading may move the buckets
            std::sort(bucket.begin(), bucket.end());
            for (const int i : bucket) {
                const int x = i % cost_.width(), y = i / cost_.width();
                if (static_cast<int>(cost) == cost_(x, y)) spread(x, y, cost_(x, y), keep_label);
            }
        }
        buckets_.clear();
    }

    // What lies outside the silhouette, or in a piece of it without skeleton.
    Grid<Owner> finish() {
        Mask reached(cost_.width(), cost_.height());
        for (std::size_t i = 0; i < cost_.size(); ++i) reached.data()[i] = cost_.data()[i] >= 0;
        const Grid<int> nearest = nearest_seed(reached);
        for (std::size_t i = 0; i < cost_.size(); ++i)
            if (!reached.data()[i] && nearest.data()[i] >= 0)
                owners_.data()[i] = owners_.data()[nearest.data()[i]];
        return std::move(owners_);
    }

private:
    void enqueue(int cost, int pixel) {
        const auto c = static_cast<std::size_t>(cost);
        if (c >= buckets_.size()) buckets_.resize(c + 1);
        buckets_[c].push_back(pixel);
    }
    int index(int x, int y) const { return y * cost_.width() + x; }

    void spread(int x, int y, int cost, bool keep_label) {
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const int nx = x + dx, ny = y + dy;
                if ((dx == 0 && dy == 0) || !silhouette_.value_or(nx, ny, 0) || settled_(nx, ny)) continue;
                if (keep_label && labels_(nx, ny) != labels_(x, y)) continue;
                const int next = cost + (dx != 0 && dy != 0 ? 7 : 5);
                int& known = cost_(nx, ny);
                if (known >= 0 && known <= next) continue;
                known = next;
                owners_(nx, ny) = owners_(x, y);
                enqueue(next, index(nx, ny));
            }
    }

    const Mask& silhouette_;
    const LabelMap& labels_;
    Grid<Owner> owners_;
    Grid<int> cost_;
    Mask settled_;
    std::vector<std::vector<int>> buckets_; // pixels by cost
};

} // namespace

Grid<Owner> pixel_owners(const Limbs& limbs, const std::vector<Point2d>& skeleton, const Mask& silhouette,
                         const LabelMap& labels) {
    Flood flood(silhouette, labels);
    for (std::size_t l = 0; l < limbs.limbs.size(); ++l) {
        const Limb& limb = limbs.limbs[l];
        for (std::size_t i = limb.path.size(); i-- > 0;)
            flood.seed(limb.path[i], {static_cast<int>(l), limb.position[i]});
    }
    for (const SideBranch& side : limbs.side_branches)
        for (const Point2d& p : side.path) flood.seed(p, {side.limb, side.position});
    flood.seed(limbs.root, {});
    for (const Point2d& p : skeleton) flood.seed(p, {});
    flood.run(true);
    flood.run(false);
    return flood.finish();
}

std::vector<double> contact_shares(const Limbs& limbs, const Grid<Owner>& owners, const Mask& silhouette) {
    std::vector<double> contact(limbs.limbs.size(), 0), free(limbs.limbs.size(), 0);
    for (int y = 0; y < silhouette.height(); ++y)
        for (int x = 0; x < silhouette.width(); ++x) {
            const int l = owners(x, y).limb;
            if (!silhouette(x, y) || l < 0) continue;
            for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                if (!silhouette.value_or(x + dx, y + dy, 0))
                    ++free[l];
                else if (owners(x + dx, y + dy).limb == limbs.limbs[l].parent)
                    ++contact[l];
            }
        }
    for (std::size_t l = 0; l < contact.size(); ++l)
        if (contact[l] > 0) contact[l] /= contact[l] + free[l];
    return contact;
}

std::vector<Point2d> skeleton_points(const SkeletonGraph& graph) {
    std::vector<Point2d> points;
    for (const SkeletonVertex& v : graph.vertices) points.push_back({v.x, v.y});
    for (const SkeletonEdge& edge : graph.edges)
        for (const Point2i& pixel : edge.pixels) points.push_back(to_double(pixel));
    return points;
}

} // namespace pantin
