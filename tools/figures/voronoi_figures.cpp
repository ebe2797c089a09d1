// SPDX-License-Identifier: MIT
// Voronoi diagrams and the residual that prunes them (thesis 3.4).
#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "core/reference_scale.hpp"
#include "figures/figures.hpp"
#include "figures/palette.hpp"
#include "figures/panel.hpp"
#include "pantin/geometry.hpp"
#include "pantin/image.hpp"
#include "skeletonization/voronoi_skeleton.hpp"

namespace pantin::figures {
namespace {

using Segments = std::vector<std::pair<Point2d, Point2d>>;

// (a): a few points. Sites far outside make every edge that can be seen finite.
void draw_points(Sheet& sheet) {
    constexpr int side = 300, reach = 20000;
    Random random(3);
    std::vector<Point2i> points;
    while (points.size() < 18) {
        const Point2i p{random.integer(18, side - 18), random.integer(18, side - 18)};
        const auto near = [p](Point2i q) { return distance(to_double(p), to_double(q)) < 38; };
        if (std::none_of(points.begin(), points.end(), near)) points.push_back(p);
    }
    const std::vector<Point2i> sites = points;
    for (const Point2i far : {Point2i{-reach, 0}, {0, -reach}, {reach, 0}, {0, reach}}) points.push_back(far);
    Panel panel(sheet.svg(), sheet[0], {0, 0, side, side});
    Segments edges;
    for (const VoronoiEdge& edge : voronoi_edges(points, delaunay(points)))
        edges.emplace_back(edge.from, edge.to);
    sheet.svg().begin_clip(panel.frame());
    panel.segments(edges, stroked(ink, 1.4));
    sheet.svg().end_clip();
    for (const Point2i p : sites) sheet.svg().circle(panel.at(to_double(p)), 4, filled(second));
    panel.border();
    panel.caption("(a) points (blue), and the cells nearest to each");
}

// (b): every few pixels of a contour.
void draw_contour(Sheet& sheet, const Skeletonization& skeleton) {
    constexpr int step = 9;
    std::vector<Point2i> sites;
    const std::vector<Point2i>& border = skeleton.contour.front().points;
    const std::size_t count = border.size() / step;
    for (std::size_t i = 0; i < count; ++i) {
        const Point2i p = border[i * border.size() / count];
        if (std::find(sites.begin(), sites.end(), p) == sites.end()) sites.push_back(p);
    }
    Panel panel(sheet.svg(), sheet[1], skeleton.mask.width(), skeleton.mask.height());
    panel.mask(skeleton.mask, {232, 234, 238});
    Segments ridges, others;
    const int last = static_cast<int>(sites.size()) - 1;
    for (const VoronoiEdge& edge : voronoi_edges(sites, delaunay(sites))) {
        const int apart = std::abs(edge.site_a - edge.site_b);
        const bool ridge = apart != 1 && apart != last && edge_inside(edge, skeleton.mask);
        (ridge ? ridges : others).emplace_back(edge.from, edge.to);
    }
    sheet.svg().begin_clip(panel.frame());
    panel.segments(others, stroked(muted, 0.6));
    sheet.svg().end_clip();
    panel.segments(ridges, stroked(accent, 2.4));
    for (const Point2i p : sites) sheet.svg().circle(panel.at(to_double(p)), 1.8, filled(second));
    panel.caption("(b) points on a contour; red: inner edges of sites that are not neighbours");
}

Figure diagram_figure(Gallery& gallery) {
    Sheet sheet(2, 1, 420, 420);
    draw_points(sheet);
    draw_contour(sheet, gallery.run("person.png").skeleton);
    return {"fig-3.13-voronoi-diagram.svg",
            sheet.svg().document("Voronoi diagrams of points and of a contour")};
}

// --- the residual
// ----------------------------------------------------------------------------------------------

// The shorter way along the border from one site to the other.
std::vector<Point2i> arc_between(const std::vector<Point2i>& border, Point2i a, Point2i b) {
    const auto ia = std::find(border.begin(), border.end(), a) - border.begin(),
               ib = std::find(border.begin(), border.end(), b) - border.begin();
    const auto n = std::ssize(border);
    std::vector<Point2i> forth, back;
    for (auto i = ia;; i = (i + 1) % n) {
        forth.push_back(border[static_cast<std::size_t>(i)]);
        if (i == ib) break;
    }
    for (auto i = ia;; i = (i + n - 1) % n) {
        back.push_back(border[static_cast<std::size_t>(i)]);
        if (i == ib) break;
    }
    return forth.size() <= back.size() ? forth : back;
}

// The edge nearest to a place whose residual is nearly the wanted one.
std::size_t edge_near(const Skeletonization& s, Point2d place, double residual) {
    std::size_t best = 0;
    double nearest = 1e9;
    for (std::size_t e = 0; e < s.voronoi.size(); ++e) {
        const double away = distance(s.voronoi[e].from, place);
        if (std::abs(s.residuals[e] - residual) < 1 && away < nearest) nearest = away, best = e;
    }
    return best;
}

// The first end-effector that is a limb's.
Point2d limb_end(const SkeletonGraph& graph) {
    const auto end = std::find_if(graph.vertices.begin(), graph.vertices.end(),
                                  [](const SkeletonVertex& v) { return v.end && v.label == Label::limb; });
    return {end->x, end->y};
}

void draw_sites(Panel& panel, const Skeletonization& s, const Box& window) {
    const auto seen = [&](Point2d p) {
        return p.x > window.x - 1 && p.y > window.y - 1 && p.x < window.x + window.width &&
               p.y < window.y + window.height;
    };
    std::vector<Point2i> border;
    for (const Point2i p : s.contour.front().points)
        if (seen(to_double(p))) border.push_back(p);
    panel.pixels(border, faint);
    Segments edges;
    for (const VoronoiEdge& edge : s.voronoi)
        if (seen(edge.from) || seen(edge.to)) edges.emplace_back(edge.from, edge.to);
    panel.segments(edges, stroked(ink, 0.7));
}

void draw_residual(Panel& panel, const Skeletonization& s, std::size_t e) {
    Svg& svg = panel.svg();
    const BorderSites sites = border_sites(s.contour, s.mask.width(), s.mask.height());
    const VoronoiEdge& edge = s.voronoi[e];
    const Point2i a = sites.points[edge.site_a], b = sites.points[edge.site_b];
    const std::vector<Point2i> arc = arc_between(s.contour.front().points, a, b);
    panel.pixels(arc, pale(accent));
    svg.polyline(panel.at(arc), stroked(accent, 2.2));
    svg.line(panel.at(to_double(a)), panel.at(to_double(b)),
             {.stroke = css(second), .width = 1.8, .dash = "5 4"});
    const Point2d m = 0.5 * (edge.from + edge.to);
    for (const Point2i site : {a, b}) svg.line(panel.at(m), panel.at(to_double(site)), stroked(third, 1.4));
    for (const Point2i site : {a, b}) svg.circle(panel.at(to_double(site)), 4.5, filled(accent));
    svg.circle(panel.at(m), 4.5, filled(third));
    const auto label = [&](Point2d p, Point2d away, const char* text, Rgb8 colour) {
        const Point2d q = panel.at(p) + (20 / std::max(1e-9, length(away))) * away;
        svg.text({q.x, q.y + 5}, text, {.size = 16, .fill = colour, .bold = true});
    };
    label(to_double(a), to_double(a) - m, "pA", accent);
    label(to_double(b), to_double(b) - m, "pB", accent);
    label(m, m - 0.5 * (to_double(a) + to_double(b)), "m", third);
    const double arc_length = border_arc(sites, edge.site_a, edge.site_b),
                 chord = distance(to_double(a), to_double(b));
    const Rectangle f = panel.frame();
    const auto line = [&](int row, const std::string& text, Rgb8 colour) {
        svg.text({f.x + f.width + 24, f.y + 40 + 26 * row}, text,
                 {.size = 14, .anchor = Anchor::start, .fill = colour});
    };
    line(0, "border from pA to pB: " + shown(arc_length, 1) + " px", accent);
    line(1, "chord pA pB: " + shown(chord, 1) + " px", second);
    line(3, "residual of the thesis (arc): " + shown(arc_length, 1), ink);
    line(4,
         "chord residual (default): " + shown(arc_length, 1) + " − " + shown(chord, 1) + " = " +
             shown(s.residuals[e], 1),
         ink);
    line(6, "Edges whose residual is below the", muted);
    line(7, "threshold are pruned: 30 at 321 px,", muted);
    line(8,
         shown(30 * reference_scale(s.mask.width(), s.mask.height()), 1) + " for this drawing of " +
             std::to_string(std::max(s.mask.width(), s.mask.height())) + " px.",
         muted);
}

Figure residual_figure(Gallery& gallery) {
    const Skeletonization& s = gallery.run("humanoid.png").skeleton;
    const std::size_t e = edge_near(s, limb_end(s.graph), 30);
    const Point2d m = 0.5 * (s.voronoi[e].from + s.voronoi[e].to);
    const Box window{static_cast<int>(m.x) - 26, static_cast<int>(m.y) - 26, 52, 52};
    Svg svg(820, 500);
    Panel panel(svg, {margin, margin, 470, 470},
                {window.x - 0.5, window.y - 0.5, window.width + 0.0, window.height + 0.0});
    svg.begin_clip(panel.frame());
    draw_sites(panel, s, window);
    svg.end_clip();
    panel.border();
    draw_residual(panel, s, e);
    return {"fig-3.14-residual.svg",
            svg.document("The residual of a Voronoi edge: border and chord between its two sites")};
}

} // namespace

std::vector<Figure> voronoi_figures(Gallery& gallery) {
    return {diagram_figure(gallery), residual_figure(gallery)};
}

} // namespace pantin::figures
