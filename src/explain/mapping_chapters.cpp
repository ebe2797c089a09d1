// SPDX-License-Identifier: MIT
// Step 5, first half: paths between ends, their distances, the subsequence bijection, the assignment.
#include <algorithm>

#include "core/json.hpp"
#include "core/plural.hpp"
#include "explain/chapters.hpp"
#include "explain/palette.hpp"
#include "explain/svg.hpp"
#include "rigging/path_distance.hpp"
#include "rigging/reference_shape.hpp"

namespace pantin {

namespace {

constexpr int way_points = 40; // of a path that is drawn
constexpr double chart_width = 360, chart_height = 150;

std::string letter(std::size_t i) {
    return i < 26 ? std::string(1, static_cast<char>('A' + i)) : "Z" + std::to_string(i - 25);
}

double rounded(double value, double unit) { return std::rint(value * unit) / unit; }

// Every path between two ends as it runs over the picture, in the mapping's order.
Json ways(const SkeletonGraph& graph, const std::vector<int>& ends) {
    Json all = Json::array();
    for (std::size_t i = 0; i < ends.size(); ++i) {
        Json from = Json::array();
        for (std::size_t k = 1; k < ends.size(); ++k) {
            const std::vector<Point2d> path = shortest_path(graph, ends[i], ends[(i + k) % ends.size()]);
            from.push_back(path.size() < 2 ? "" : path_text(resample(path, way_points), false));
        }
        all.push_back(std::move(from));
    }
    return all;
}

Json radii(const std::vector<std::vector<PathSamples>>& paths) {
    Json all = Json::array();
    for (const auto& from : paths) {
        Json rows = Json::array();
        for (const PathSamples& path : from) {
            Json values = Json::array();
            for (const double r : path.radii) values.push_back(rounded(r, 1000));
            rows.push_back({{"radii", std::move(values)}, {"length", rounded(path.length, 1000)}});
        }
        all.push_back(std::move(rows));
    }
    return all;
}

Json comparisons(const Mapping& mapping) {
    Json all = Json::array();
    for (const auto& row : mapping.comparisons) {
        Json cells = Json::array();
        for (const EndComparison& c : row) {
            Json distances = Json::array();
            for (const auto& line : c.distances) {
                Json values = Json::array();
                for (const double d : line) values.push_back(rounded(d, 1000));
                distances.push_back(std::move(values));
            }
            cells.push_back({{"distances", std::move(distances)},
                             {"path", c.osb.path},
                             {"cost", rounded(c.osb.cost, 1000)}});
        }
        all.push_back(std::move(cells));
    }
    return all;
}

// A skeleton with the names of its ends, and a place for the path that is looked at.
std::string figure(Svg svg, const SkeletonGraph& graph, const std::vector<int>& ends, bool letters,
                   double scale, const std::string& colour) {
    svg.graph(graph, scale)
        .raw("<path class=\"track\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" +
             decimal(4 * scale, 1) + "\" stroke-linecap=\"round\" opacity=\".75\"/>");
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const SkeletonVertex& v = graph.vertices[ends[i]];
        const double size = 15 * scale;
        const Point2d at = {std::clamp(v.x + 5 * scale, 0.0, graph.width - size),
                            std::clamp(v.y - 4 * scale, size, graph.height - 2.0)};
        svg.text(at, letters ? letter(i) : std::to_string(i + 1), size);
    }
    return svg.str();
}

std::string reference_figure(const Figure& drawn, const Mapping& mapping, const std::string& name) {
    Svg svg(reference_side, reference_side, "The reference " + name + " with its ends lettered clockwise");
    RgbaImage shape(drawn.squared_distance.width(), drawn.squared_distance.height());
    for (std::size_t i = 0; i < shape.size(); ++i)
        if (drawn.squared_distance.data()[i] > 0) shape.data()[i] = {150, 160, 175, 120};
    svg.image(picture_uri(shape), shape.width(), shape.height());
    return figure(std::move(svg), drawn.graph, mapping.reference_ends, true, 1, "#d66000");
}

// A table of numbers; `mark` says the class of a cell.
template <class Name, class Column, class Mark>
std::string matrix(const std::vector<std::vector<double>>& values, const std::string& corner, Name row_name,
                   Column column_name, Mark mark) {
    if (values.empty()) return "";
    std::string text = "<table class=\"matrix\"><thead><tr><th>" + corner + "</th>";
    for (std::size_t j = 0; j < values[0].size(); ++j)
        text += "<th scope=\"col\">" + column_name(j) + "</th>";
    text += "</tr></thead><tbody>";
    for (std::size_t i = 0; i < values.size(); ++i) {
        text += "<tr><th scope=\"row\">" + row_name(i) + "</th>";
        for (std::size_t j = 0; j < values[i].size(); ++j)
            text += "<td class=\"" + std::string(mark(i, j)) + "\" data-i=\"" + std::to_string(i) +
                    "\" data-j=\"" + std::to_string(j) + "\">" + decimal(values[i][j], 2) + "</td>";
        text += "</tr>";
    }
    return text + "</tbody></table>";
}

std::vector<std::vector<double>> similarity(const Mapping& mapping) {
    std::vector<std::vector<double>> costs;
    for (const auto& row : mapping.comparisons) {
        costs.emplace_back();
        for (const EndComparison& c : row) costs.back().push_back(c.osb.cost);
    }
    return costs;
}

struct Chosen {
    std::size_t i = 0, j = 0;
};
Chosen first_pair(const Mapping& mapping) {
    if (mapping.pairs.empty()) return {};
    const auto index = [](const std::vector<int>& all, int v) {
        return static_cast<std::size_t>(std::find(all.begin(), all.end(), v) - all.begin());
    };
    return {index(mapping.ends, mapping.pairs[0].end),
            index(mapping.reference_ends, mapping.pairs[0].reference_end)};
}

std::vector<Point2d> curve(const PathSamples& path, double most) {
    std::vector<Point2d> points;
    for (std::size_t i = 0; i < path.radii.size(); ++i)
        points.push_back({chart_width * static_cast<double>(i) /
                              static_cast<double>(std::max<std::size_t>(1, path.radii.size() - 1)),
                          chart_height * (1 - path.radii[i] / most)});
    return points;
}

double largest_radius(const Mapping& mapping) {
    double most = 0.001;
    for (const auto* paths : {&mapping.paths, &mapping.reference_paths})
        for (const auto& from : *paths)
            for (const PathSamples& path : from)
                most = std::max(most, *std::max_element(path.radii.begin(), path.radii.end()));
    return most;
}

std::string curves(const Mapping& mapping, Chosen at, double most) {
    Svg chart(chart_width, chart_height, "Radii along two paths, from one end to the other", 16);
    chart.text({4, -4}, "thickness, " + decimal(most) + " means", 9, "#444")
        .text({chart_width - 86, chart_height + 12}, "way from end to end", 9, "#444");
    chart.line({0, chart_height}, {chart_width, chart_height}, "#999", 1)
        .line({0, 0}, {0, chart_height}, "#999", 1);
    const EndComparison& c = mapping.comparisons[at.i][at.j];
    const std::size_t k = c.osb.path.empty() ? 0 : static_cast<std::size_t>(c.osb.path[0].first),
                      l = c.osb.path.empty() ? 0 : static_cast<std::size_t>(c.osb.path[0].second);
    chart.raw("<g class=\"curves\">")
        .polyline(curve(mapping.paths[at.i][k], most), "#2662d6", 2)
        .polyline(curve(mapping.reference_paths[at.j][l], most), "#d66000", 2)
        .raw("</g>");
    return chart.str("chart");
}

std::string bijection(const Mapping& mapping, Chosen at) {
    const EndComparison& c = mapping.comparisons[at.i][at.j];
    const std::size_t n = mapping.ends.size(), m = mapping.reference_ends.size();
    return matrix(
        c.distances, "paths",
        [&](std::size_t k) {
            return std::to_string(at.i + 1) + " → " + std::to_string((at.i + 1 + k) % n + 1);
        },
        [&](std::size_t l) { return letter(at.j) + " → " + letter((at.j + 1 + l) % m); },
        [&](std::size_t k, std::size_t l) {
            return std::count(c.osb.path.begin(), c.osb.path.end(),
                              std::pair<int, int>{static_cast<int>(k), static_cast<int>(l)})
                       ? "chosen"
                       : "";
        });
}

std::string end_name(const ChapterInput& input, const Mapping& mapping, std::size_t i) {
    return std::to_string(i + 1) + " " +
           std::string(name_of(input.character.skeletonization.graph.vertices[mapping.ends[i]].label));
}

std::string column_name(const ChapterInput& input, const Mapping& mapping, std::size_t j) {
    return letter(j) + " " + escaped(input.character.reference.nodes[mapping.reference_ends[j]].name);
}

} // namespace

Values paths_chapter(const ChapterInput& input) {
    const Mapping& mapping = input.character.rig.mapping;
    const ReferenceSkeleton& reference = input.character.reference;
    const SkeletonGraph& graph = input.character.skeletonization.graph;
    const Figure drawn = draw_reference(reference, is_mirrored(input.character.identification));
    if (mapping.comparisons.empty() || mapping.ends.size() < 2 || mapping.reference_ends.size() < 2)
        return {{"content", "<p>There is but one end, so there is no path to compare.</p>"},
                {"data", "null"}};
    const Chosen at = first_pair(mapping);
    const double most = largest_radius(mapping);
    Svg picture(graph.width, graph.height, "The character's skeleton with its ends numbered clockwise");
    picture.underlay(input.drawing(), 0.3);
    Json data;
    data["start"] = {at.i, at.j};
    data["most"] = most;
    data["chart"] = {chart_width, chart_height};
    data["paths"] = radii(mapping.paths);
    data["reference_paths"] = radii(mapping.reference_paths);
    data["ways"] = ways(graph, mapping.ends);
    data["reference_ways"] = ways(drawn.graph, mapping.reference_ends);
    data["comparisons"] = comparisons(mapping);
    const std::string content = filled(
        asset("chapters/paths-content.html"),
        {{"character", figure(std::move(picture), graph, mapping.ends, false, input.line(), "#2662d6")},
         {"reference", reference_figure(drawn, mapping, reference.name)},
         {"name", escaped(reference.name)},
         {"similarity",
          matrix(
              similarity(mapping), "cost", [&](std::size_t i) { return end_name(input, mapping, i); },
              [&](std::size_t j) { return column_name(input, mapping, j); },
              [&](std::size_t i, std::size_t j) { return i == at.i && j == at.j ? "chosen" : ""; })},
         {"pair", std::to_string(at.i + 1) + " and " + letter(at.j)},
         {"bijection", bijection(mapping, at)},
         {"curves", curves(mapping, at, most)}});
    return {{"content", content}, {"data", script_json(data)}};
}

Values assignment_chapter(const ChapterInput& input) {
    const Mapping& mapping = input.character.rig.mapping;
    const auto paired = [&](std::size_t i, std::size_t j) {
        return std::any_of(mapping.pairs.begin(), mapping.pairs.end(), [&](const EndPair& p) {
            return p.end == mapping.ends[i] && p.reference_end == mapping.reference_ends[j];
        });
    };
    const MappingOptions& options = input.context.options().rigging.mapping;
    std::string list;
    for (std::size_t i = 0; i < mapping.ends.size(); ++i) {
        std::string partner = "no partner";
        for (std::size_t j = 0; j < mapping.reference_ends.size(); ++j)
            if (paired(i, j)) partner = column_name(input, mapping, j);
        list += "<li>" + end_name(input, mapping, i) + " — " + partner + "</li>";
    }
    return {{"matrix", matrix(
                           mapping.costs, "cost", [&](std::size_t i) { return end_name(input, mapping, i); },
                           [&](std::size_t j) { return column_name(input, mapping, j); },
                           [&](std::size_t i, std::size_t j) {
                               if (paired(i, j)) return "chosen";
                               return options.label_aware && mapping.costs[i][j] >= options.unmatched_cost
                                          ? "never"
                                          : "";
                           })},
            {"pairs", list},
            {"count", count_of(static_cast<long>(mapping.pairs.size()), "pair")}};
}

} // namespace pantin
