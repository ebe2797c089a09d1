// SPDX-License-Identifier: MIT
// A model as a picture with part labels and a skeleton in the plane (include/pantin/model_view.hpp).
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/reference_scale.hpp"
#include "modeling/chains.hpp"
#include "pantin/model_view.hpp"

namespace pantin {
namespace {

constexpr double margin = 0.03;         // of the longer side, around the model
constexpr Point2d cabinet{-0.35, -0.2}; // shear of models with depth
constexpr int drawing_scale = 2;        // pixels of the drawing to one of the labels
constexpr double shortest_limb =
    0.1; // of the picture's diagonal: shorter branches (eyes, toes) are no end-effectors
constexpr double merge_distance =
    5.0 / reference_side; // of the longer side: junctions so close become one, as in skeletonization
constexpr Rgb8 paper{255, 255, 255};

// Which part is seen at each pixel, and how near.
struct DepthPicture {
    Grid<int> part;
    Grid<double> depth;
};

void rasterise(DepthPicture& picture, const std::array<Vec3, 3>& corners, int part) {
    const Point2d a{corners[0].x, corners[0].y}, u = Point2d{corners[1].x, corners[1].y} - a,
                                                 v = Point2d{corners[2].x, corners[2].y} - a;
    const double twice = cross(u, v);
    if (twice == 0) return;
    const auto bounds = [](double p, double q, double r, int size) {
        return std::pair{std::max(0, static_cast<int>(std::ceil(std::min({p, q, r})))),
                         std::min(size - 1, static_cast<int>(std::floor(std::max({p, q, r}))))};
    };
    const auto [x0, x1] = bounds(corners[0].x, corners[1].x, corners[2].x, picture.part.width());
    const auto [y0, y1] = bounds(corners[0].y, corners[1].y, corners[2].y, picture.part.height());
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
            const Point2d d = Point2d{static_cast<double>(x), static_cast<double>(y)} - a;
            const double s = cross(d, v) / twice, t = cross(u, d) / twice;
            if (s < 0 || t < 0 || s + t > 1) continue;
            const double z = (1 - s - t) * corners[0].z + s * corners[1].z + t * corners[2].z;
            if (z <= picture.depth(x, y)) continue;
            picture.depth(x, y) = z;
            picture.part(x, y) = part;
        }
}

// The pixels along an edge: what is thinner than one may have no pixel's centre in it.
void trace(DepthPicture& picture, Vec3 from, Vec3 to, int part) {
    const int steps = static_cast<int>(std::ceil(2 * length(Point2d{to.x - from.x, to.y - from.y})));
    for (int i = 0; i <= steps; ++i) {
        const Vec3 p = from + (steps > 0 ? static_cast<double>(i) / steps : 0) * (to - from);
        const int x = static_cast<int>(std::floor(p.x + 0.5)), y = static_cast<int>(std::floor(p.y + 0.5));
        if (!picture.part.contains(x, y) || p.z <= picture.depth(x, y)) continue;
        picture.depth(x, y) = p.z;
        picture.part(x, y) = part;
    }
}

// `finer` pixels to one of the view's, which the same centres share.
DepthPicture picture_of(Model& model, const ModelView& view, int finer) {
    const std::vector<InflatedPart> inflated = model.inflated();
    DepthPicture picture{
        Grid<int>(view.width * finer, view.height * finer, -1),
        Grid<double>(view.width * finer, view.height * finer, -std::numeric_limits<double>::infinity())};
    const auto place = [&](Vec3 p) {
        const Point2d q = project(view, p);
        return Vec3{(q.x + 0.5) * finer - 0.5, (q.y + 0.5) * finer - 0.5, p.z};
    };
    for (int part = 0; part < std::ssize(model.parts()); ++part) {
        const SolidMesh mesh = model.surface(part);
        for (const auto& [a, b, c] : mesh.triangles)
            rasterise(picture, {place(mesh.vertices[a]), place(mesh.vertices[b]), place(mesh.vertices[c])},
                      part);
        if (inflated[part].inflation->half_width * length(inflated[part].frame.right) * view.scale * finer >=
            1)
            continue;
        for (const auto& [a, b, c] : mesh.triangles) {
            trace(picture, place(mesh.vertices[a]), place(mesh.vertices[b]), part);
            trace(picture, place(mesh.vertices[b]), place(mesh.vertices[c]), part);
        }
    }
    return picture;
}

// Pixels of a straight way, ends included, 8-connected (Bresenham 1965).
void draw_line(Point2i from, Point2i to, std::vector<Point2i>& pixels) {
    const int dx = std::abs(to.x - from.x), dy = -std::abs(to.y - from.y);
    const int sx = from.x < to.x ? 1 : -1, sy = from.y < to.y ? 1 : -1;
    for (int error = dx + dy;;) {
        if (pixels.empty() || !(pixels.back() == from)) pixels.push_back(from);
        if (from == to) return;
        const int twice = 2 * error;
        if (twice >= dy) error += dy, from.x += sx;
        if (twice <= dx) error += dx, from.y += sy;
    }
}

double steps_length(const std::vector<Point2i>& pixels) {
    double sum = 0;
    for (std::size_t i = 1; i < pixels.size(); ++i)
        sum += distance(to_double(pixels[i - 1]), to_double(pixels[i]));
    return sum;
}

// All trees as one: every root but the first gets a bone to the nearest joint that is already reached.
std::vector<std::vector<int>> joined_neighbours(const ModelSkeleton& skeleton) {
    std::vector<std::vector<int>> neighbours(skeleton.joints.size());
    for (int j = 0; j < std::ssize(skeleton.joints); ++j) {
        int parent = skeleton.joints[j].parent;
        if (j == 0) continue;
        if (parent < 0)
            for (int other = parent = 0; other < j; ++other)
                if (distance(skeleton.joints[j].place, skeleton.joints[other].place) <
                    distance(skeleton.joints[j].place, skeleton.joints[parent].place))
                    parent = other;
        neighbours[j].push_back(parent);
        neighbours[parent].push_back(j);
    }
    return neighbours;
}

// Takes away the shortest branch that ends, again and again, while it is short. Pixels are those of the
// joints.
void prune_short(std::vector<std::vector<int>>& neighbours, const std::vector<Point2i>& pixels,
                 double limit) {
    for (;;) {
        std::vector<int> shortest;
        double least = limit;
        for (const std::vector<int>& chain : chains_of(neighbours)) {
            const bool front = neighbours[chain.front()].size() == 1,
                       back = neighbours[chain.back()].size() == 1;
            if (front == back) continue;
            double size = 0;
            for (std::size_t i = 1; i < chain.size(); ++i)
                size += distance(to_double(pixels[chain[i - 1]]), to_double(pixels[chain[i]]));
            if (size >= least) continue;
            least = size;
            shortest = chain;
            if (front) std::reverse(shortest.begin(), shortest.end());
        }
        if (shortest.empty()) return;
        std::erase(neighbours[shortest[0]], shortest[1]);
        for (std::size_t i = 1; i < shortest.size(); ++i) neighbours[shortest[i]].clear();
    }
}

} // namespace

Label label_of(const ModelPart& part) {
    return part.stroke.label != Label::background ? part.stroke.label : label_of_part(part.stroke.name);
}

Rgb8 colour_of(const ModelPart& part) { return part.stroke.colour.value_or(row_of(label_of(part)).solid); }

Point2d project(const ModelView& view, Vec3 p) {
    return view.offset + view.scale * Point2d{p.x + view.shear.x * p.z, -(p.y + view.shear.y * p.z)};
}

ModelView view_of(const Model& model, const SolidMesh& mesh, int size) {
    ModelView view;
    for (const ModelPart& part : model.parts())
        if (part.stroke.view != Viewpoint::front || part.stroke.depth != 0 ||
            part.stroke.symmetry == Symmetry::z)
            view.shear = cabinet;
    Point2d low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()},
        high = -1 * low;
    for (const Vec3& v : mesh.vertices) {
        const Point2d p = project(view, v);
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const Point2d extent = high - low;
    const double longer = std::max(extent.x, extent.y);
    view.scale = size * (1 - 2 * margin) / longer;
    const double pad = size * margin;
    view.width = static_cast<int>(std::ceil(extent.x * view.scale + 2 * pad));
    view.height = static_cast<int>(std::ceil(extent.y * view.scale + 2 * pad));
    view.offset = Point2d{pad, pad} - view.scale * low;
    return view;
}

ModelPicture draw(Model& model, const ModelView& view) {
    const DepthPicture coarse = picture_of(model, view, 1), fine = picture_of(model, view, drawing_scale);
    ModelPicture picture{RgbImage(fine.part.width(), fine.part.height(), paper),
                         LabelMap(view.width, view.height)};
    const std::vector<ModelPart>& parts = model.parts();
    for (std::size_t i = 0; i < coarse.part.size(); ++i)
        if (const int part = coarse.part.data()[i]; part >= 0)
            picture.labels.data()[i] = static_cast<std::uint8_t>(label_of(parts[part]));
    for (std::size_t i = 0; i < fine.part.size(); ++i)
        if (const int part = fine.part.data()[i]; part >= 0)
            picture.drawing.data()[i] = colour_of(parts[part]);
    return picture;
}

Grid<int> seen_parts(Model& model, const ModelView& view) { return picture_of(model, view, 1).part; }

SkeletonGraph project_skeleton(const Model& model, const ModelView& view) {
    const ModelSkeleton& skeleton = model.skeleton();
    std::vector<Point2i> pixels;
    for (const ModelSkeleton::Joint& joint : skeleton.joints) {
        const Point2d p = project(view, joint.place);
        pixels.push_back({std::clamp(static_cast<int>(std::floor(p.x + 0.5)), 0, view.width - 1),
                          std::clamp(static_cast<int>(std::floor(p.y + 0.5)), 0, view.height - 1)});
    }
    std::vector<std::vector<int>> neighbours = joined_neighbours(skeleton);
    prune_short(neighbours, pixels, shortest_limb * length(Point2d{1.0 * view.width, 1.0 * view.height}));
    SkeletonGraph graph;
    graph.width = view.width;
    graph.height = view.height;
    std::vector<int> vertex(skeleton.joints.size(), -1);
    for (int j = 0; j < std::ssize(neighbours); ++j) {
        if (neighbours[j].empty() || neighbours[j].size() == 2) continue;
        vertex[j] = static_cast<int>(graph.vertices.size());
        graph.vertices.push_back({1.0 * pixels[j].x, 1.0 * pixels[j].y,
                                  label_of(model.parts()[skeleton.joints[j].part]),
                                  neighbours[j].size() == 1});
    }
    for (const std::vector<int>& chain : chains_of(neighbours)) {
        SkeletonEdge edge{vertex[chain.front()], vertex[chain.back()], 0, {}};
        for (std::size_t i = 1; i < chain.size(); ++i)
            draw_line(pixels[chain[i - 1]], pixels[chain[i]], edge.pixels);
        if (edge.u > edge.v) {
            std::swap(edge.u, edge.v);
            std::reverse(edge.pixels.begin(), edge.pixels.end());
        }
        edge.length = steps_length(edge.pixels);
        graph.edges.push_back(std::move(edge));
    }
    return apply_h2(graph, merge_distance * std::max(view.width, view.height));
}

} // namespace pantin
