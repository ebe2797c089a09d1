// SPDX-License-Identifier: MIT
// From path distances to the mapping of end-effectors (thesis 4.6, Eq. 4.11 to 4.14, Fig. 4.16).
#include <algorithm>
#include <cmath>

#include "figures/figures.hpp"
#include "figures/mapping_picture.hpp"
#include "figures/palette.hpp"
#include "figures/panel.hpp"

namespace pantin::figures {
namespace {

using Matrix = std::vector<std::vector<double>>;
using Cells = std::vector<std::pair<int, int>>;

constexpr double cell_width = 46, cell_height = 26;

// Values as shades of grey, the cells of `marked` framed. Returns the lower right corner.
Point2d draw_matrix(Svg& svg, Point2d at, const Matrix& matrix, const std::vector<std::string>& rows,
                    const std::vector<std::string>& columns, const Cells& marked) {
    double most = 0;
    for (const auto& row : matrix) most = std::max(most, *std::max_element(row.begin(), row.end()));
    for (std::size_t j = 0; j < columns.size(); ++j)
        svg.text({at.x + cell_width * (static_cast<double>(j) + 0.5), at.y - 7}, columns[j],
                 {.size = 12, .fill = fourth, .bold = true});
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        const double y = at.y + cell_height * static_cast<double>(i);
        svg.text({at.x - 8, y + 17}, rows[i],
                 {.size = 12, .anchor = Anchor::end, .fill = second, .bold = true});
        for (std::size_t j = 0; j < matrix[i].size(); ++j) {
            const double x = at.x + cell_width * static_cast<double>(j);
            svg.rectangle({x, y, cell_width, cell_height},
                          outlined(mixed(paper, {150, 156, 168}, matrix[i][j] / most), faint, 0.8));
            svg.text({x + cell_width / 2, y + 17}, shown(matrix[i][j], 2, true), {.size = 12});
        }
    }
    for (const auto& [i, j] : marked)
        svg.rectangle(
            {at.x + cell_width * j + 1, at.y + cell_height * i + 1, cell_width - 2, cell_height - 2},
            stroked(highlight, 2.4));
    return {at.x + cell_width * static_cast<double>(columns.size()),
            at.y + cell_height * static_cast<double>(rows.size())};
}

// u0, u1, … in the order of the ends.
std::vector<std::string> numbered(const std::string& letter, std::size_t count,
                                  const std::string& after = "") {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < count; ++i) names.push_back(letter + std::to_string(i) + after);
    return names;
}

// A shape with its end-effectors numbered.
void draw_numbered(Svg& svg, Rectangle place, const pantin::Figure& figure, const std::vector<int>& ends,
                   const std::string& letter, const std::string& after, Rgb8 colour,
                   const std::string& caption) {
    const Mask shape = shape_of(figure);
    Panel panel(svg, place, {-24, -24, shape.width() + 48.0, shape.height() + 48.0});
    panel.mask(shape, {228, 231, 236});
    panel.graph(figure.graph, stroked(muted, 1.4), 3.5);
    const Point2d middle{shape.width() / 2.0, shape.height() / 2.0};
    const auto apart = [](Point2d d) { return Point2d{1.6 * d.x, d.y}; }; // labels are wider than high
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const SkeletonVertex& v = figure.graph.vertices[ends[i]];
        const Point2d away = apart(Point2d{v.x, v.y} - middle),
                      p = panel.at(v.x, v.y) + (17 / std::max(1.0, length(away))) * away;
        svg.text({p.x, p.y + 5}, letter + std::to_string(i) + after,
                 {.size = 13, .fill = colour, .bold = true});
    }
    panel.caption(caption);
}

// Both shapes beside each other, above the matrices.
void draw_both(Svg& svg, const Run& run) {
    draw_numbered(svg, {margin, margin, 300, 190}, character_figure(run), run.rig.mapping.ends, "u", "",
                  second, "end-effectors of the drawing, clockwise");
    draw_numbered(svg, {margin + 340, margin, 260, 190}, reference_figure(run),
                  run.rig.mapping.reference_ends, "u", "′", fourth,
                  "end-effectors of the reference, clockwise");
}

// The names of the ends after the i-th, cyclically.
std::vector<std::string> others(const std::vector<std::string>& names, std::size_t i) {
    std::vector<std::string> result;
    for (std::size_t k = 1; k < names.size(); ++k) result.push_back(names[(i + k) % names.size()]);
    return result;
}

// κ of Eq. 4.13: what a skipped row costs.
double jump_cost(const Matrix& distances) {
    std::vector<double> least;
    double mean = 0, variance = 0;
    for (const auto& row : distances) least.push_back(*std::min_element(row.begin(), row.end()));
    for (const double d : least) mean += d / static_cast<double>(least.size());
    for (const double d : least) variance += (d - mean) * (d - mean) / static_cast<double>(least.size());
    return mean + std::sqrt(variance);
}

Figure bijection_figure(Gallery& gallery) {
    const Run& run = gallery.run("dog.png");
    const Mapping& mapping = run.rig.mapping;
    const EndPair pair = mapping.pairs.front();
    const auto i = static_cast<std::size_t>(std::find(mapping.ends.begin(), mapping.ends.end(), pair.end) -
                                            mapping.ends.begin());
    const auto j = static_cast<std::size_t>(
        std::find(mapping.reference_ends.begin(), mapping.reference_ends.end(), pair.reference_end) -
        mapping.reference_ends.begin());
    const EndComparison& comparison = mapping.comparisons[i][j];
    const auto rows = others(numbered("u", mapping.ends.size()), i),
               columns = others(numbered("u", mapping.reference_ends.size(), "′"), j);
    Svg svg(640, margin + 300 + cell_height * static_cast<double>(rows.size()) + 10);
    draw_both(svg, run);
    const std::string u = "u" + std::to_string(i), v = "u" + std::to_string(j) + "′";
    svg.text({margin, 262},
             "d(" + u + ", " + v + "): path distances from " + u + " to each other end (rows), from " + v +
                 " to each other end (columns)",
             {.size = 12.5, .anchor = Anchor::start});
    const Point2d corner =
        draw_matrix(svg, {margin + 60, 298}, comparison.distances, rows, columns, comparison.osb.path);
    const auto skipped = rows.size() - comparison.osb.path.size();
    svg.text({corner.x + 24, 316}, "pink: the optimal subsequence bijection",
             {.size = 12.5, .anchor = Anchor::start, .fill = highlight});
    double sum = 0;
    for (const auto& [row, column] : comparison.osb.path)
        sum += comparison.distances[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    const std::string lines[] = {"its cells: " + shown(sum, 2, true),
                                 "rows skipped: " + std::to_string(skipped) +
                                     ", each costs κ = " + shown(jump_cost(comparison.distances), 2, true),
                                 "together: c(" + u + ", " + v +
                                     ") = " + shown(comparison.osb.cost, 2, true)};
    for (int k = 0; k < 3; ++k)
        svg.text({corner.x + 24, 336.0 + 20 * k}, lines[k], {.size = 12.5, .anchor = Anchor::start});
    return {"eq-4.12-subsequence-bijection.svg",
            svg.document("Path distances from two end-effectors and the optimal subsequence bijection")};
}

Cells assigned(const std::vector<int>& columns) {
    Cells cells;
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (columns[i] >= 0) cells.emplace_back(static_cast<int>(i), columns[i]);
    return cells;
}

Figure assignment_figure(Gallery& gallery) {
    const Run& run = gallery.run("flying.png");
    const Mapping& mapping = run.rig.mapping;
    Matrix similarity;
    for (const auto& row : mapping.comparisons) {
        similarity.emplace_back();
        for (const EndComparison& c : row) similarity.back().push_back(c.osb.cost);
    }
    const auto rows = numbered("u", mapping.ends.size()),
               columns = numbered("u", mapping.reference_ends.size(), "′");
    const double second_left = 2 * margin + 110 + cell_width * static_cast<double>(columns.size());
    Svg svg(std::max(640.0, second_left + 40 + cell_width * static_cast<double>(columns.size()) + margin),
            310 + cell_height * static_cast<double>(rows.size()) + 40);
    draw_both(svg, run);
    svg.text({margin, 262}, "(a) costs of the thesis: c(u, u′) of Eq. 4.12",
             {.size = 12.5, .anchor = Anchor::start});
    const Point2d corner =
        draw_matrix(svg, {margin + 40, 298}, similarity, rows, columns, assigned(hungarian(similarity)));
    svg.text({second_left, 262}, "(b) default: with labels and places, too",
             {.size = 12.5, .anchor = Anchor::start});
    draw_matrix(svg, {second_left + 40, 298}, mapping.costs, rows, columns,
                assigned(hungarian(mapping.costs)));
    svg.text({second_left + 40, corner.y + 24}, "from 12 on a pair is not allowed",
             {.size = 12.5, .anchor = Anchor::start, .fill = muted});
    svg.text({margin + 40, corner.y + 24}, "pink: assignment of least sum (Hungarian method)",
             {.size = 12.5, .anchor = Anchor::start, .fill = highlight});
    return {"eq-4.14-assignment.svg",
            svg.document("Costs of matching end-effectors, and the assignment of least cost")};
}

Figure mapping_figure(Gallery& gallery) {
    const char* files[] = {"dog.png", "humanoid.png", "flying.png"};
    Svg svg(640, margin + 3 * 292);
    for (int i = 0; i < 3; ++i) {
        const Run& run = gallery.run(files[i]);
        const Rectangle place{margin, margin + 292.0 * i, 616, 254};
        draw_mapping(svg, place, run, 5);
        caption(svg, place,
                std::string("(") + "abc"[i] + ") " + run.identification.reference +
                    ": reference left, drawing right");
    }
    return {"fig-4.16-mapping.svg",
            svg.document("End-effectors of the reference mapped to those of a drawing")};
}

} // namespace

std::vector<Figure> mapping_figures(Gallery& gallery) {
    return {bijection_figure(gallery), assignment_figure(gallery), mapping_figure(gallery)};
}

} // namespace pantin::figures
