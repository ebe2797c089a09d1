// SPDX-License-Identifier: MIT
// The mesh that thesis 4.6 rejects (Fig. 4.18(b)): the Voronoi regions of the border's pixels, as far as they
// lie inside.
//
// A region reaches from its site to the skeleton, so its faces are long and thin; they tear where the weights
// of neighbours differ. It is here to show that, and as the diagram of section 4.4 used once more.
//
// Sites are the border pixels of the silhouette drawn twice as large: there no border passes a pixel twice,
// so borders are simple polygons. Consecutive sites are one step apart, and the circle over a step has no
// lattice point inside: every step is a Delaunay edge, no circumcentre lies beyond the border, and the
// regions fill the polygon exactly.
#include <algorithm>
#include <cmath>
#include <map>

#include "pantin/geometry.hpp"
#include "pantin/image.hpp"
#include "pantin/rigging.hpp"
#include "pantin/triangulation.hpp"

namespace pantin {
namespace {

// Every pixel becomes four. Where two of them touched at a corner alone, one pixel beside the corner is added
// (always above it, so that additions never touch each other at a corner).
Mask doubled(const Mask& mask) {
    Mask large(2 * mask.width(), 2 * mask.height());
    for (int y = 0; y < large.height(); ++y)
        for (int x = 0; x < large.width(); ++x) large(x, y) = mask(x / 2, y / 2) != 0;
    for (int y = 1; y < mask.height(); ++y)
        for (int x = 1; x < mask.width(); ++x) {
            const bool upper_left = mask(x - 1, y - 1), upper_right = mask(x, y - 1),
                       lower_left = mask(x - 1, y), lower_right = mask(x, y);
            if (upper_left && lower_right && !upper_right && !lower_left) large(2 * x, 2 * y - 1) = 1;
            if (upper_right && lower_left && !upper_left && !lower_right) large(2 * x - 1, 2 * y - 1) = 1;
        }
    return large;
}

class RegionMesh {
public:
    RegionMesh(const Triangulation& triangulation, int frame) : t_(triangulation), frame_(frame) {
        for (const auto& [a, b, c] : t_.triangles)
            centres_.push_back(circumcentre(t_.points[a], t_.points[b], t_.points[c]));
    }

    Mesh build() {
        for (int t = 0; t < static_cast<int>(t_.triangles.size()); ++t)
            for (int corner = 0; corner < 3; ++corner)
                if (t_.neighbours[t][(corner + 2) % 3] < 0) add_region(t, corner);
        return std::move(mesh_);
    }

private:
    // The region of a corner of t whose next edge lies on the border: middle of that edge, the circumcentres
    // of the triangles around the site, middle of the edge on which the border comes back; a fan about the
    // site.
    void add_region(int t, int corner) {
        const int site = t_.triangles[t][corner];
        std::vector<Point2d> rim = {middle(site, t_.triangles[t][(corner + 1) % 3])};
        for (;;) {
            add(rim, centres_[t]);
            const int next = t_.neighbours[t][(corner + 1) % 3], last = t_.triangles[t][(corner + 2) % 3];
            if (next < 0) {
                add(rim, middle(site, last));
                break;
            }
            t = next;
            corner = static_cast<int>(std::find(t_.triangles[t].begin(), t_.triangles[t].end(), site) -
                                      t_.triangles[t].begin());
        }
        const int hub = vertex(to_double(t_.points[site]));
        for (std::size_t i = 0; i + 1 < rim.size(); ++i) add_face(hub, vertex(rim[i]), vertex(rim[i + 1]));
    }
    static void add(std::vector<Point2d>& rim, Point2d p) {
        if (rim.back() != p) rim.push_back(p); // cocircular sites: the same bits (geometry.hpp)
    }
    void add_face(int a, int b, int c) {
        const Point2d u = mesh_.vertices[b] - mesh_.vertices[a], v = mesh_.vertices[c] - mesh_.vertices[a];
        if (cross(u, v) > 0)
            mesh_.faces.push_back({a, b, c});
        else
            mesh_.faces.push_back({a, c, b});
    }
    Point2d middle(int a, int b) const { return 0.5 * (to_double(t_.points[a]) + to_double(t_.points[b])); }
    int vertex(Point2d p) {
        const auto [it, is_new] = ids_.try_emplace({p.y, p.x}, static_cast<int>(mesh_.vertices.size()));
        if (is_new) mesh_.vertices.push_back({(p.x - 0.5) / 2 - frame_, (p.y - 0.5) / 2 - frame_});
        return it->second;
    }

    const Triangulation& t_;
    int frame_;
    std::vector<Point2d> centres_; // per triangle
    Mesh mesh_;
    std::map<std::pair<double, double>, int> ids_;
};

} // namespace

Mesh voronoi_mesh(const Mask& silhouette, double margin) {
    margin = std::max(0.0, margin);
    const int frame = static_cast<int>(std::ceil(margin)) + 1;
    const Mask grown = dilate_disc(pad(silhouette, frame), margin);
    std::vector<std::vector<Point2i>> loops;
    for (const Border& border : follow_borders(doubled(grown))) loops.push_back(border.points);
    if (loops.empty()) return {};
    return RegionMesh(constrained_delaunay(loops), frame).build();
}

} // namespace pantin
