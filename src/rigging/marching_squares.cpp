// SPDX-License-Identifier: MIT
// This work is based on:
// Thorsten Korpitsch, Semantic-aware animation of hand-drawn characters, 2023, section 4.6, Fig. 4.17;
// Carsten Maple, Geometric design and space planning using the marching squares and marching cube algorithms,
// 2003. Departures (ERRATA 21): positions on voxel edges interpolate the signed exact Euclidean distance,
// unless the midpoint is asked for; the silhouette may be grown first; the cell shrinks until no limb splits
// and no ring closes. Voxel corners that the border passes closely are moved onto it, so that no sliver is
// cut off, after: F. Labelle, J. R. Shewchuk, Isosurface stuffing, 2007, section 3.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "pantin/image.hpp"
#include "pantin/rigging.hpp"
#include "rigging/mesh_topology.hpp"

namespace pantin {
namespace {

constexpr int min_cell = 2;                // of the automatic choice
constexpr std::size_t max_vertices = 4000; // beyond it the automatic choice takes no smaller cell

// Signed distance (positive inside) to the nearest pixel centre of the other side, plus the margin. The frame
// around the silhouette is wide enough that no voxel which the border crosses sees its edge.
class DistanceField {
public:
    DistanceField(const Mask& silhouette, int frame, double margin) : frame_(frame) {
        Mask inside(silhouette.width() + 2 * frame, silhouette.height() + 2 * frame), outside = inside;
        for (int y = 0; y < silhouette.height(); ++y)
            for (int x = 0; x < silhouette.width(); ++x) inside(x + frame, y + frame) = silhouette(x, y) != 0;
        for (std::size_t i = 0; i < inside.size(); ++i) outside.data()[i] = inside.data()[i] == 0;
        const Grid<int> in = squared_distance_transform(inside), out = squared_distance_transform(outside);
        values_ = Grid<double>(inside.width(), inside.height());
        for (std::size_t i = 0; i < values_.size(); ++i)
            values_.data()[i] = std::sqrt(static_cast<double>(in.data()[i])) -
                                std::sqrt(static_cast<double>(out.data()[i])) + margin;
        // A crossing at (or almost at) a voxel corner would put two vertices into one place.
        for (double& value : values_)
            if (std::abs(value) < 0.25) value = value > 0 ? 0.25 : -0.25;
        // The transform takes what lies beyond the frame for the silhouette: not so.
        const int rim = static_cast<int>(margin) + 2;
        for (int y = 0; y < values_.height(); ++y)
            for (int x = 0; x < values_.width(); ++x)
                if (std::min({x, y, values_.width() - 1 - x, values_.height() - 1 - y}) < rim)
                    values_(x, y) = -rim;
    }
    double operator()(int x, int y) const { return values_.value_or(x + frame_, y + frame_, -1e9); }

    // The grown silhouette, frame included.
    Mask grown() const {
        Mask mask(values_.width(), values_.height());
        for (std::size_t i = 0; i < mask.size(); ++i) mask.data()[i] = values_.data()[i] > 0;
        return mask;
    }

private:
    int frame_;
    Grid<double> values_;
};

double cosine_at(Point2d corner, Point2d a, Point2d b) {
    const Point2d u = a - corner, v = b - corner;
    return dot(u, v) / std::max(1e-12, length(u) * length(v));
}

// The sharpest corner of the triangles into which a face falls, as a fan from its first vertex: cosine.
double sharpest_of_fan(const std::vector<int>& face, const std::vector<Point2d>& vertices) {
    double sharpest = -1;
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
        const Point2d a = vertices[face[0]], b = vertices[face[i]], c = vertices[face[i + 1]];
        sharpest = std::max({sharpest, cosine_at(a, b, c), cosine_at(b, c, a), cosine_at(c, a, b)});
    }
    return sharpest;
}

// Turns the face so that its fan has the least sharp triangles.
void choose_fan(std::vector<int>& face, const std::vector<Point2d>& vertices) {
    std::vector<int> turned = face;
    double best = sharpest_of_fan(face, vertices);
    for (std::size_t k = 1; k < turned.size(); ++k) {
        std::rotate(turned.begin(), turned.begin() + 1, turned.end());
        const double sharpest = sharpest_of_fan(turned, vertices);
        if (sharpest < best - 1e-9) best = sharpest, face = turned;
    }
}

// Walks over the voxels; vertices are numbered in the order in which the voxels (row by row, corners
// clockwise from the top left) first touch them.
class MeshBuilder {
public:
    MeshBuilder(const DistanceField& field, int cell, const MeshOptions& options)
        : field_(field), cell_(cell), interpolate_(options.interpolate_distance),
          snap_(options.interpolate_distance ? options.snap : 0) {}

    Mesh build(int left, int top, int right, int bottom) {
        for (int y = top; y < bottom; y += cell_)
            for (int x = left; x < right; x += cell_) add_voxel(x, y);
        if (snap_ > 0)
            for (std::vector<int>& face : mesh_.faces) choose_fan(face, mesh_.vertices);
        return std::move(mesh_);
    }

private:
    struct Corner {
        int vertex = 0;
        bool on_edge = false; // lies on a voxel edge, not on a voxel corner
    };

    int vertex(Point2i a, Point2i b, Point2d position) {
        const auto [it, is_new] =
            ids_.try_emplace({a.y, a.x, b.y, b.x}, static_cast<int>(mesh_.vertices.size()));
        if (is_new) mesh_.vertices.push_back(position);
        return it->second;
    }

    // A voxel corner: inside, outside, or moved onto the border.
    struct Node {
        Point2i corner;
        int side = 0; // 1, −1, 0
        Point2d place;
    };
    // The border's nearest crossing of an edge at the corner, if it is close and the silhouette, or the
    // background, goes on at the corner's other side: a thin limb stays, and so does a thin gap.
    Node node_at(Point2i p) const {
        const double v = field_(p.x, p.y);
        Node node{p, v > 0 ? 1 : -1, to_double(p)};
        double nearest = snap_;
        for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
            const double across = field_(p.x + dx * cell_, p.y + dy * cell_),
                         behind = field_(p.x - dx * cell_, p.y - dy * cell_);
            if ((across > 0) == (v > 0) || (behind > 0) != (v > 0)) continue;
            const double t = v / (v - across);
            if (t >= nearest) continue;
            nearest = t;
            node.side = 0;
            node.place = {p.x + t * dx * cell_, p.y + t * dy * cell_};
        }
        return node;
    }
    int corner_vertex(const Node& node) { return vertex(node.corner, node.corner, node.place); }

    // The border's crossing of the voxel edge a–b, computed from the left or upper end whichever voxel asks.
    int edge_vertex(Point2i a, Point2i b) {
        if (a.y > b.y || (a.y == b.y && a.x > b.x)) std::swap(a, b);
        const double va = field_(a.x, a.y), vb = field_(b.x, b.y);
        const double t = interpolate_ ? va / (va - vb) : 0.5;
        return vertex(a, b, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }

    // In the ambiguous case (two opposite corners inside) the value inside the voxel decides; a voxel of one
    // pixel has none, and the foreground is 8-connected.
    bool joined(int x, int y) const { return cell_ == 1 || field_(x + cell_ / 2, y + cell_ / 2) > 0; }

    void add_voxel(int x, int y) {
        const std::array<Node, 4> nodes = {node_at({x, y}), node_at({x + cell_, y}),
                                           node_at({x + cell_, y + cell_}), node_at({x, y + cell_})};
        if (std::none_of(nodes.begin(), nodes.end(), [](const Node& n) { return n.side > 0; })) return;
        std::vector<Corner> polygon;
        for (int i = 0; i < 4; ++i) {
            const Node &node = nodes[i], &next = nodes[(i + 1) % 4], &last = nodes[(i + 3) % 4];
            const bool beyond =
                node.side == 0 && next.side < 0 && last.side < 0; // of a border that turns away
            if (node.side >= 0 && !beyond) polygon.push_back({corner_vertex(node), false});
            if (node.side * next.side < 0) polygon.push_back({edge_vertex(node.corner, next.corner), true});
        }
        if (polygon.size() < 3) return;
        std::uint8_t inside = 0;
        for (int i = 0; i < 4; ++i)
            inside |= static_cast<std::uint8_t>((field_(nodes[i].corner.x, nodes[i].corner.y) > 0) << i);
        const bool ambiguous = nodes[0].side == nodes[2].side && nodes[1].side == nodes[3].side &&
                               nodes[0].side * nodes[1].side < 0;
        if (ambiguous && !joined(x, y))
            add_two_triangles(polygon, inside);
        else
            add_face(polygon, inside);
    }
    void add_face(const std::vector<Corner>& polygon, std::uint8_t inside) {
        mesh_.cases.push_back(inside);
        std::vector<int>& face = mesh_.faces.emplace_back();
        for (const Corner& corner : polygon) face.push_back(corner.vertex);
    }
    void add_two_triangles(const std::vector<Corner>& polygon, std::uint8_t inside) {
        const int n = static_cast<int>(polygon.size());
        for (int i = 0; i < n; ++i)
            if (!polygon[i].on_edge)
                add_face({polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n]}, inside);
    }

    const DistanceField& field_;
    int cell_;
    bool interpolate_;
    double snap_;
    Mesh mesh_;
    std::map<std::array<int, 4>, int> ids_; // (end, end) of the voxel edge, or twice the voxel corner
};

int floor_to(int value, int cell) {
    return (value >= 0 ? value / cell : -((-value + cell - 1) / cell)) * cell;
}

Mesh mesh_of(const DistanceField& field, const Mask& silhouette, int cell, int reach,
             const MeshOptions& options) {
    const int start = floor_to(-reach - cell, cell);
    return MeshBuilder(field, cell, options)
        .build(start, start, silhouette.width() + reach, silhouette.height() + reach);
}

// As many pieces, and all holes of more than four voxels; smaller ones may be closed.
bool same_topology(const Mesh& mesh, const Mask& mask, int cell) {
    const Topology ours = topology_of(mesh), all = topology_of(mask);
    if (ours.pieces != all.pieces || ours.holes > all.holes) return false;
    return ours == all || ours.holes >= topology_of(fill_holes(mask, 4L * cell * cell)).holes;
}

} // namespace

double ink_margin(int width, int height) { return std::max(2.0, 0.012 * std::max(width, height)); }

Mesh marching_squares(const Mask& silhouette, const MeshOptions& options) {
    const double margin = std::max(0.0, options.margin);
    const int reach = static_cast<int>(std::ceil(margin)) + 1;
    int cell = options.cell;
    if (cell <= 0) cell = std::max(2 * min_cell, std::max(silhouette.width(), silhouette.height()) / 64);
    const DistanceField field(silhouette, 3 * cell + 2 * reach, margin);
    Mesh mesh = mesh_of(field, silhouette, cell, reach, options);
    if (options.cell > 0) return mesh;
    const Mask grown = field.grown();
    while (cell > min_cell && mesh.vertices.size() <= max_vertices && !same_topology(mesh, grown, cell)) {
        cell = std::max(min_cell, cell * 3 / 4);
        mesh = mesh_of(field, silhouette, cell, reach, options);
    }
    return mesh;
}

} // namespace pantin
