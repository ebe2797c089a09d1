// SPDX-License-Identifier: MIT
#include "compare.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pantin/geometry.hpp"
#include "pantin/image.hpp"
#include "settings.hpp"

namespace pantin::compare {
namespace {

// CRC-32 as in zlib and PNG (polynomial 0xEDB88320), bit by bit.
std::uint32_t crc32(const std::uint8_t* bytes, std::size_t count) {
    std::uint32_t crc = 0xFFFFFFFFu;
    for (std::size_t i = 0; i < count; ++i) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) ? 0xEDB88320u : 0u);
    }
    return ~crc;
}

void exact(Report& report, const std::string& stage, double ours, double stored, const std::string& where) {
    report.add(stage, ours == stored, ours - stored, where);
}

void mask_stage(const Figure& figure, Report& report) {
    long area = 0;
    for (const auto pixel : figure.mask) area += pixel;
    exact(report, "mask area", static_cast<double>(area), figure.stored.at("mask_area"), figure.name);
    report.add("mask CRC", crc32(figure.mask.data(), figure.mask.size()) == figure.stored.at("mask_crc32_u8"),
               0, figure.name);
    report.add("nearest labels CRC",
               crc32(figure.everywhere.data(), figure.everywhere.size()) == figure.stored.at("near_crc32_u8"),
               0, figure.name);
}

void contour_stage(const Figure& figure, Report& report) {
    const std::vector<Border> borders = follow_borders(figure.mask);
    const std::vector<Point2i>& contour = borders.at(0).points;
    const auto same = [](Point2i p, const nlohmann::json& xy) { return p.x == xy[0] && p.y == xy[1]; };
    exact(report, "contour pixels", static_cast<double>(contour.size()), figure.stored.at("contour_pixels"),
          figure.name);
    report.add("contour first and second point",
               same(contour.at(0), figure.stored.at("contour_first")) &&
                   same(contour.at(1), figure.stored.at("contour_second")),
               0, figure.name);
    std::vector<std::uint8_t> bytes;
    for (const Point2i p : contour)
        for (const int v : {p.x, p.y})
            for (int shift = 0; shift < 32; shift += 8)
                bytes.push_back(static_cast<std::uint8_t>(static_cast<std::uint32_t>(v) >> shift));
    report.add("contour CRC", crc32(bytes.data(), bytes.size()) == figure.stored.at("contour_crc32_i32_xy"),
               0, figure.name);
    const double difference = closed_length(contour) - figure.stored.at("contour_length").get<double>();
    report.add("contour length", std::abs(difference) < 1e-9, difference, figure.name);
}

void whole_mask_stage(const Figure& figure, Report& report) {
    const Mask thinned = zhang_suen(figure.mask, ThinningStop::both);
    const auto& stored = figure.stored.at("zs_whole_mask");
    long count = 0;
    for (const auto pixel : thinned) count += pixel;
    exact(report, "Zhang-Suen of the whole mask, pixels", static_cast<double>(count), stored.at("count"),
          figure.name);
    report.add("Zhang-Suen of the whole mask, CRC",
               crc32(thinned.data(), thinned.size()) == stored.at("crc32_u8"), 0, figure.name);
}

Mask mask_from_pixels(const nlohmann::json& pixels, int width, int height) {
    Mask mask(width, height);
    for (const auto& xy : pixels) mask(xy[0], xy[1]) = 1;
    return mask;
}

// Number of pixels that only one of the two has.
int differing_pixels(const Mask& a, const Mask& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a.data()[i] != b.data()[i];
    return count;
}

// Number of pixels of `a` that are more than one pixel away from `b`.
int far_pixels(const Mask& a, const Mask& b) {
    const Mask near_b = dilate_square(b, 1);
    int count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a.data()[i] && !near_b.data()[i];
    return count;
}

// The same vertices in the same order (place to 1e-9, label) and the same edges; returns the largest
// displacement, or infinity where the structure differs.
double graph_difference(const SkeletonGraph& ours, const SkeletonGraph& stored) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (ours.vertices.size() != stored.vertices.size() || ours.edges.size() != stored.edges.size())
        return infinity;
    double worst = 0;
    for (std::size_t i = 0; i < ours.vertices.size(); ++i) {
        const SkeletonVertex &a = ours.vertices[i], &b = stored.vertices[i];
        if (a.label != b.label || a.end != b.end) return infinity;
        worst = std::max({worst, std::abs(a.x - b.x), std::abs(a.y - b.y)});
    }
    for (std::size_t e = 0; e < ours.edges.size(); ++e)
        if (ours.edges[e].u != stored.edges[e].u || ours.edges[e].v != stored.edges[e].v) return infinity;
    return worst;
}

void chain_stage(const std::string& stage, const SkeletonGraph& ours, const nlohmann::json& stored,
                 Report& report, const std::string& where) {
    double worst = ours.edges.size() == stored.size() ? 0 : std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e < std::min(ours.edges.size(), stored.size()); ++e)
        worst = std::max(
            worst, std::abs(static_cast<double>(ours.edges[e].pixels.size()) - stored[e].get<double>()));
    report.add(stage, worst <= 1, worst, where);
}

void graph_stage(const std::string& stage, const SkeletonGraph& ours, const nlohmann::json& stored,
                 Report& report, const std::string& where) {
    const double difference = graph_difference(ours, graph_from_json(stored, ours.width, ours.height));
    report.add(stage, difference < 1e-9, difference, where);
}

void residual_stages(const Figure& figure, Residual residual, const std::string& name, Report& report) {
    const auto& stored = figure.stored.at("residual").at(name);
    const int width = figure.mask.width(), height = figure.mask.height();
    const std::string where = figure.name + " " + name;
    const Mask vor = mask_from_pixels(stored.at("vor"), width, height);
    const Mask zs = mask_from_pixels(stored.at("zs"), width, height);
    const Mask thin = mask_from_pixels(stored.at("thin"), width, height);

    const SkeletonizationOptions options = skeleton_settings(residual);
    const Skeletonization whole = skeletonize(figure.near, options);
    const int far = far_pixels(whole.voronoi_raster, vor) + far_pixels(vor, whole.voronoi_raster);
    report.add("Voronoi raster, pixels off by more than one", far == 0, far, where);
    report.add("Voronoi raster, pixel count within 2 %",
               std::abs(stored.at("vor_count").get<double>() -
                        static_cast<double>(
                            std::count(whole.voronoi_raster.begin(), whole.voronoi_raster.end(), 1))) <=
                   0.02 * stored.at("vor_count").get<double>(),
               differing_pixels(whole.voronoi_raster, vor), where);

    const int zs_pixels = differing_pixels(zhang_suen(vor, ThinningStop::both), zs);
    report.add("Zhang-Suen of the stored raster", zs_pixels == 0, zs_pixels, where);
    const int thin_pixels = differing_pixels(remove_redundant_pixels(zs), thin);
    report.add("redundant pixels removed", thin_pixels == 0, thin_pixels, where);
    const SkeletonGraph g0 = extract_graph(thin, figure.near);
    graph_stage("raw graph (g0)", g0, stored.at("g0"), report, where);
    chain_stage("pixels per chain of g0 (to one pixel)", g0, stored.at("g0_chain_len"), report, where);
    graph_stage("after H1 (g1)", apply_h1(graph_from_json(stored.at("g0"), width, height)), stored.at("g1"),
                report, where);
    graph_stage("after H2 (g2)",
                apply_h2(graph_from_json(stored.at("g1"), width, height), options.merge_distance),
                stored.at("g2"), report, where);
    report.add("whole step: vertices and edges of g2",
               whole.graph.vertices.size() == stored.at("g2").at("xy").size() &&
                   whole.graph.edges.size() == stored.at("g2").at("edges").size(),
               static_cast<double>(whole.graph.vertices.size()) -
                   static_cast<double>(stored.at("g2").at("xy").size()),
               where);
}

} // namespace

void skeleton_stages(const std::vector<Figure>& figures, Report& report) {
    for (const Figure& figure : figures) {
        mask_stage(figure, report);
        contour_stage(figure, report);
        whole_mask_stage(figure, report);
        residual_stages(figure, Residual::arc, "arc", report);
        residual_stages(figure, Residual::chord, "chord", report);
    }
}

} // namespace pantin::compare
