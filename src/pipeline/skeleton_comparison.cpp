// SPDX-License-Identifier: MIT
// Part labels to the skeletons of all methods (thesis 3.4, 4.4), side by side in one picture.
#include "pipeline/skeleton_comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/file.hpp"
#include "core/json.hpp"
#include "formats/file_names.hpp"
#include "formats/pictures.hpp"
#include "pantin/image.hpp"
#include "pantin/pipeline.hpp"

namespace pantin {

namespace {

constexpr int zoom = 2; // pixels of the picture to one of the labels, so that lines of one pixel are seen
constexpr int gap = 8;  // between panels

constexpr Rgb8 paper{255, 255, 255}, divider{90, 90, 90};
constexpr std::array<Rgb8, label_count> pale = label_column(&LabelRow::pale);
constexpr Rgb8 ridge_colour{255, 160, 60}, dropped_colour{40, 40, 40}, edge_colour{30, 80, 220};
constexpr Rgb8 end_colour{220, 20, 40}, junction_colour{0, 140, 60};
constexpr double end_radius = 3, junction_radius = 2.5; // pixels of the labels

// A part of the picture that is addressed in pixels of the labels.
class Panel {
public:
    Panel(RgbImage& picture, int left, int width)
        : picture_(picture), left_(left), width_(width), height_(picture.height()) {}

    void paint(Point2i p, Rgb8 colour) {
        for (int y = zoom * p.y; y < zoom * (p.y + 1); ++y)
            for (int x = left_ + zoom * p.x; x < left_ + zoom * (p.x + 1); ++x) picture_(x, y) = colour;
    }
    void fill(const Mask& mask, Rgb8 colour) {
        for (int y = 0; y < mask.height(); ++y)
            for (int x = 0; x < mask.width(); ++x)
                if (mask(x, y)) paint({x, y}, colour);
    }
    // A disc, or for an end the square around it, cut off where the panel ends.
    void mark(const SkeletonVertex& vertex) {
        const double cx = zoom * (vertex.x + 0.5) - 0.5, cy = zoom * (vertex.y + 0.5) - 0.5;
        const double radius = zoom * (vertex.end ? end_radius : junction_radius);
        const auto first = [radius](double c) {
            return std::max(0, static_cast<int>(std::ceil(c - radius)));
        };
        const auto last = [radius](double c, int size) {
            return std::min(size - 1, static_cast<int>(std::floor(c + radius)));
        };
        for (int y = first(cy); y <= last(cy, height_); ++y)
            for (int x = first(cx); x <= last(cx, width_); ++x)
                if (vertex.end || (x - cx) * (x - cx) + (y - cy) * (y - cy) <= radius * radius)
                    picture_(left_ + x, y) = vertex.end ? end_colour : junction_colour;
    }

private:
    RgbImage& picture_;
    int left_, width_, height_; // in pixels of the picture
};

// The part's colour, darker where the drawing has ink: two fifths of the ink's darkness.
Rgb8 lightened(Rgb8 part, Rgb8 ink) {
    const auto mix = [](int a, int b) {
        return static_cast<std::uint8_t>(a * (255 - (255 - b) * 2 / 5) / 255);
    };
    return {mix(part.r, ink.r), mix(part.g, ink.g), mix(part.b, ink.b)};
}

void draw(Panel& panel, const ComparedSkeleton& compared) {
    const Skeletonization& s = compared.skeletonization;
    if (s.voronoi_raster != s.mask)
        panel.fill(s.voronoi_raster, ridge_colour); // thinning's ridges are the whole silhouette
    panel.fill(s.skeleton, dropped_colour);
    for (const SkeletonEdge& edge : s.graph.edges)
        for (const Point2i p : edge.pixels) panel.paint(p, edge_colour);
    for (const SkeletonVertex& vertex : s.graph.vertices) panel.mark(vertex);
}

} // namespace

std::vector<ComparedSkeleton> compare_skeletons(const LabelMap& labels, SkeletonizationOptions options) {
    constexpr std::pair<const char*, SkeletonMethod> methods[] = {{"voronoi", SkeletonMethod::voronoi},
                                                                  {"straight", SkeletonMethod::straight},
                                                                  {"thinning", SkeletonMethod::thinning},
                                                                  {"chordal", SkeletonMethod::chordal}};
    std::vector<ComparedSkeleton> result;
    for (const auto& [name, method] : methods) {
        ComparedSkeleton& compared = result.emplace_back();
        compared.name = name;
        options.method = method;
        try {
            compared.skeletonization = skeletonize(labels, options);
        } catch (const CharacterRejected& rejected) {
            compared.status = rejected.what();
        }
    }
    return result;
}

RgbImage comparison_picture(const std::vector<ComparedSkeleton>& skeletons, const LabelMap& labels,
                            const RgbImage& drawing) {
    const int width = labels.width(), height = labels.height(), panels = static_cast<int>(skeletons.size());
    const RgbImage ink = resize(drawing, width, height);
    RgbImage picture(panels * zoom * width + (panels - 1) * gap, zoom * height, divider);
    for (int i = 0; i < panels; ++i) {
        Panel panel(picture, i * (zoom * width + gap), zoom * width);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) panel.paint({x, y}, lightened(pale[labels(x, y)], ink(x, y)));
        draw(panel, skeletons[static_cast<std::size_t>(i)]);
    }
    return picture;
}

std::string comparison_to_json(const std::vector<ComparedSkeleton>& skeletons) {
    Json json;
    for (const ComparedSkeleton& compared : skeletons) {
        const SkeletonGraph& graph = compared.skeletonization.graph;
        const auto ends =
            std::count_if(graph.vertices.begin(), graph.vertices.end(), [](const auto& v) { return v.end; });
        double length = 0;
        for (const SkeletonEdge& edge : graph.edges) length += edge.length;
        json[compared.name] = {{"status", compared.status},
                               {"vertices", graph.vertices.size()},
                               {"ends", ends},
                               {"junctions", graph.vertices.size() - static_cast<std::size_t>(ends)},
                               {"edges", graph.edges.size()},
                               {"length", length}};
    }
    return to_json_text(json);
}

void compare_skeletons_folder(const std::filesystem::path& folder, const Settings& settings) {
    const LabelMap labels = read_labels(folder, read_mask(folder));
    const std::vector<ComparedSkeleton> skeletons =
        compare_skeletons(labels, settings.options.skeletonization);
    save_png(folder / file_names::skeleton_comparison_picture,
             comparison_picture(skeletons, labels, read_drawing(folder)));
    write_file(folder / file_names::skeleton_comparison, comparison_to_json(skeletons));
}

} // namespace pantin
