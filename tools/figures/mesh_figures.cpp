// SPDX-License-Identifier: MIT
// Marching squares and the mesh of Voronoi regions (thesis 4.6, Fig. 4.17 and 4.18).
#include <algorithm>
#include <bit>
#include <functional>
#include <set>

#include "figures/figures.hpp"
#include "figures/palette.hpp"
#include "figures/panel.hpp"
#include "figures/rendering.hpp"
#include "pantin/image.hpp"
#include "rigging/mesh_topology.hpp"

namespace pantin::figures {
namespace {

constexpr int voxel = 8;

// As the thesis does it: midpoints, nothing moved, nothing grown.
MeshOptions as_in_thesis(int cell) {
    MeshOptions options;
    options.cell = cell;
    options.margin = 0;
    options.interpolate_distance = false;
    options.snap = 0;
    return options;
}

void draw_sign(Svg& svg, Point2d p, bool inside) {
    svg.circle(p, 8, outlined(inside ? silhouette_colour : paper, silhouette_colour, 1.2));
    svg.text({p.x, p.y + 4.5}, inside ? "+" : "−", {.size = 13, .fill = inside ? paper : ink, .bold = true});
}

// The voxel with corners (0, 0) … (8, 8) of a mask, as marching squares meshes it.
void draw_case(Sheet& sheet, int index, const std::function<bool(int, int)>& inside,
               const std::string& caption) {
    Mask mask(voxel + 1, voxel + 1);
    for (int y = 0; y <= voxel; ++y)
        for (int x = 0; x <= voxel; ++x) mask(x, y) = inside(x, y);
    const Mesh mesh = marching_squares(mask, as_in_thesis(voxel));
    Svg& svg = sheet.svg();
    Panel panel(svg, sheet[index], {-1.5, -1.5, voxel + 3.0, voxel + 3.0});
    const auto within = [](Point2d p) { return p.x >= 0 && p.y >= 0 && p.x <= voxel && p.y <= voxel; };
    const auto on_corner = [](Point2d p) { return (p.x == 0 || p.x == voxel) && (p.y == 0 || p.y == voxel); };
    std::vector<std::pair<Point2d, Point2d>> new_edges;
    for (const std::vector<int>& face : mesh.faces) {
        if (!std::all_of(face.begin(), face.end(), [&](int v) { return within(mesh.vertices[v]); })) continue;
        std::vector<Point2d> corners;
        for (const int v : face) corners.push_back(mesh.vertices[v]);
        svg.polyline(panel.at(corners), outlined(pale(third), ink, 1.2), true);
        for (std::size_t i = 0; i < corners.size(); ++i)
            if (const Point2d a = corners[i], b = corners[(i + 1) % corners.size()];
                !on_corner(a) && !on_corner(b))
                new_edges.emplace_back(a, b);
    }
    const Point2d corner = panel.at(0, 0);
    svg.rectangle({corner.x, corner.y, voxel * panel.scale(), voxel * panel.scale()},
                  {.stroke = css(muted), .dash = "3 3"});
    panel.segments(new_edges, stroked(accent, 3));
    for (const auto& [a, b] : new_edges)
        for (const Point2d p : {a, b}) svg.circle(panel.at(p), 4, filled(accent));
    for (const Point2i p : {Point2i{0, 0}, {voxel, 0}, {voxel, voxel}, {0, voxel}})
        draw_sign(svg, panel.at(to_double(p)), mask(p.x, p.y));
    panel.caption(caption);
}

// 0 all corners inside, 1 three, 2 two side by side, 3 one, 4 two opposite.
int kind_of(std::uint8_t corners) {
    const int count = std::popcount(corners);
    if (count == 2 && (corners == 5 || corners == 10)) return 4;
    return 4 - count;
}
constexpr Rgb8 kind_colours[] = {
    {206, 210, 218}, {120, 180, 240}, {120, 205, 130}, {250, 190, 90}, {230, 80, 160}};
constexpr const char* kind_names[] = {"case 1", "case 2", "case 3", "one corner", "case 4"};

void draw_cases(Svg& svg, Rectangle place, const Mesh& mesh, const Mask& mask, Rectangle window) {
    Panel panel(svg, place, window);
    svg.begin_clip(panel.frame());
    panel.mask(mask, {240, 241, 244});
    for (int kind = 0; kind < 5; ++kind) {
        Mesh part{mesh.vertices, {}};
        for (std::size_t f = 0; f < mesh.faces.size(); ++f)
            if (kind_of(mesh.cases[f]) == kind) part.faces.push_back(mesh.faces[f]);
        if (!part.faces.empty()) panel.mesh(part, outlined(kind_colours[kind], {70, 74, 82}, 0.6));
    }
    svg.end_clip();
}

Figure cases_figure(Gallery& gallery) {
    const auto disc = [](int x, int y, int r) { return x * x + y * y <= r * r; };
    const Mask& mask = gallery.run("dog.png").skeleton.mask;
    const SkeletonGraph& graph = gallery.run("dog.png").skeleton.graph;
    Sheet sheet(6, 1, 124, 124);
    draw_case(
        sheet, 0, [](int, int) { return true; }, "case 1: all inside");
    draw_case(
        sheet, 1, [&](int x, int y) { return !disc(x, y, 4); }, "case 2: all but one");
    draw_case(
        sheet, 2, [&](int x, int y) { return disc(x, y, 4); }, "one corner alone");
    draw_case(
        sheet, 3, [](int, int y) { return y <= 4; }, "case 3: two");
    draw_case(
        sheet, 4, [](int x, int y) { return x - y <= 4 && y - x <= 4; }, "case 4, middle inside");
    draw_case(
        sheet, 5, [](int x, int y) { return x + y < 4 || x + y > 12; }, "case 4, outside");
    const double top = sheet.svg().height();
    Svg svg(sheet.svg().width(), top + 320);
    svg.append(sheet.svg());
    const Mesh mesh = marching_squares(mask, as_in_thesis(voxel));
    const SkeletonVertex& tail =
        *std::find_if(graph.vertices.begin(), graph.vertices.end(),
                      [](const SkeletonVertex& v) { return v.end && v.label == Label::tail; });
    const Rectangle near{tail.x - 30, tail.y - 50, 132, 155};
    draw_cases(svg, {margin, top + 6, 520, 280}, mesh, mask,
               {-6, -6, mask.width() + 12.0, mask.height() + 12.0});
    draw_cases(svg, {2 * margin + 528, top + 6, 264, 280}, mesh, mask, near);
    std::vector<std::pair<std::string, Rgb8>> entries;
    for (int kind = 0; kind < 5; ++kind) entries.emplace_back(kind_names[kind], kind_colours[kind]);
    legend(svg, {margin + 120, top + 308}, entries);
    return {"fig-4.17-marching-squares.svg",
            svg.document("The cases of marching squares, and where they occur in a mesh")};
}

// --- Fig. 4.18
// ----------------------------------------------------------------------------------------------------

// The edges of the mesh with an end in the window.
void draw_edges(Panel& panel, const Mesh& mesh, Rectangle window, double width) {
    const auto seen = [&](Point2d p) {
        return p.x >= window.x && p.y >= window.y && p.x <= window.x + window.width &&
               p.y <= window.y + window.height;
    };
    std::vector<std::pair<Point2d, Point2d>> edges;
    for (const auto& [u, v] : edges_of(mesh))
        if (seen(mesh.vertices[u]) || seen(mesh.vertices[v]))
            edges.emplace_back(mesh.vertices[u], mesh.vertices[v]);
    panel.segments(edges, stroked(ink, width));
}

// The character at one moment of its first clip, on either mesh at full size.
void draw_posed(Svg& svg, Rectangle place, Run run, const std::vector<ReferenceSkeleton>& references,
                MeshMethod method, const std::string& caption) {
    RigOptions options;
    options.mesh.method = method;
    run.rig = rig(run.skeleton.graph, run.labels(), run.identification, references, options);
    draw_film(svg, place, run, run.reference->clips.front().name, 1, 0.08);
    figures::caption(svg, place, caption);
}

Figure meshes_figure(Gallery& gallery) {
    const Run& run = gallery.run("dog.png");
    const Mask& full = run.skeleton.mask;
    const Mask mask = resize_mask(full, full.width() / 4, full.height() / 4);
    const Mesh regions = voronoi_mesh(mask), squares = marching_squares(mask, as_in_thesis(2));
    Sheet sheet(3, 3, 330, 200);
    Svg& svg = sheet.svg();
    const Rectangle whole{-2, -2, mask.width() + 4.0, mask.height() + 4.0}, leg{14, 24, 36, 25};
    const auto draw = [&](int index, Rectangle window, const Mesh* mesh, const std::string& caption) {
        Panel panel(svg, sheet[index], window);
        svg.begin_clip(panel.frame());
        panel.mask(mask, {228, 234, 246});
        if (mesh)
            draw_edges(panel, *mesh, window, index < 3 ? 0.25 : 0.6);
        else
            for (const Border& border : follow_borders(mask))
                svg.polyline(panel.at(border.points), stroked(accent, 2), true);
        svg.end_clip();
        panel.border();
        panel.caption(caption);
    };
    draw(0, whole, nullptr, "(a) contour");
    draw(1, whole, &regions, "(b) Voronoi regions: " + std::to_string(regions.faces.size()) + " faces");
    draw(2, whole, &squares, "(c) marching squares: " + std::to_string(squares.faces.size()) + " faces");
    draw(3, leg, nullptr, "a part of it, larger");
    draw(4, leg, &regions, "long and thin faces");
    draw(5, leg, &squares, "uniform faces");
    Panel drawing(svg, sheet[6], full.width(), full.height());
    drawing.picture(run.detected.drawing, full.width(), full.height());
    drawing.caption("the drawing");
    draw_posed(svg, sheet[7], run, gallery.references(), MeshMethod::voronoi_regions,
               "animated: torn where the legs begin");
    draw_posed(svg, sheet[8], run, gallery.references(), MeshMethod::marching_squares, "animated");
    return {"fig-4.18-meshes.svg",
            svg.document("Contour, mesh of Voronoi regions, mesh of marching squares")};
}

} // namespace

std::vector<Figure> mesh_figures(Gallery& gallery) { return {cases_figure(gallery), meshes_figure(gallery)}; }

} // namespace pantin::figures
