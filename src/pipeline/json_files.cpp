// SPDX-License-Identifier: MIT
#include "pipeline/json_files.hpp"

#include <algorithm>
#include <cmath>

#include "core/json.hpp"
#include "core/json_reader.hpp"

namespace pantin {

namespace {

constexpr long max_side = 16384;
constexpr double huge = 1e15;

Json point_list(const std::vector<Point2i>& points) {
    Json list = Json::array();
    for (const Point2i p : points) list.push_back(Json::array({p.x, p.y}));
    return list;
}

std::vector<Point2i> read_points(const JsonReader& reader, int width, int height) {
    std::vector<Point2i> points;
    for (const JsonReader& pair : reader.elements()) {
        const std::vector<JsonReader> xy = pair.elements(2, 2);
        points.push_back(
            {static_cast<int>(xy[0].integer(0, width - 1)), static_cast<int>(xy[1].integer(0, height - 1))});
    }
    return points;
}

int read_int(const JsonReader& reader, long low, long high) {
    return static_cast<int>(reader.integer(low, high));
}

// --- page.json ---------------------------------------------------------------------------------------------

PageCharacter read_page_character(const JsonReader& reader) {
    PageCharacter character;
    character.folder = reader.at("folder").text();
    // The folder is opened and its files are replaced: it must lie directly below the page's folder.
    if (character.folder.empty() || character.folder[0] == '.' ||
        character.folder.find('/') != std::string::npos)
        reader.at("folder").fail("must be the name of a folder");
    const std::vector<JsonReader> box = reader.at("box").elements(4, 4);
    character.box = {read_int(box[0], 0, max_side), read_int(box[1], 0, max_side),
                     read_int(box[2], 1, max_side), read_int(box[3], 1, max_side)};
    character.scale = reader.at("scale").number(0, 1);
    character.score = reader.at("score").number(0, 1);
    character.status = reader.at("status").text();
    return character;
}

// --- skeleton.json -----------------------------------------------------------------------------------------

SkeletonVertex read_vertex(const JsonReader& reader, std::size_t id, int width, int height) {
    SkeletonVertex vertex;
    if (reader.at("id").integer(0, 1'000'000) != static_cast<long>(id))
        reader.at("id").fail("ids count up from 0");
    vertex.x = reader.at("x").number(-1, width);
    vertex.y = reader.at("y").number(-1, height);
    vertex.label = label_from_name(reader.at("label").text());
    if (vertex.label == Label::background) reader.at("label").fail("must be head, body, limb, tail or wing");
    const std::string kind = reader.at("kind").text();
    if (kind != "end" && kind != "junction") reader.at("kind").fail("must be end or junction");
    vertex.end = kind == "end";
    return vertex;
}

SkeletonEdge read_edge(const JsonReader& reader, long vertices, int width, int height) {
    SkeletonEdge edge;
    edge.u = read_int(reader.at("u"), 0, vertices - 1);
    edge.v = read_int(reader.at("v"), 0, vertices - 1);
    if (edge.u >= edge.v) reader.fail("u must be smaller than v");
    edge.length = reader.at("length").number(0, huge);
    edge.pixels = read_points(reader.at("pixels"), width, height);
    return edge;
}

// --- identification.json -----------------------------------------------------------------------------------

Json candidate_to_json(const Candidate& candidate) {
    Json evidence = Json::object();
    for (const auto& [name, value] : candidate.evidence) evidence[name] = value;
    Json pairs = Json::array();
    for (const auto& [vertex, node] : candidate.pairs) pairs.push_back(Json::array({vertex, node}));
    Json json;
    json["reference"] = candidate.reference;
    json["mirrored"] = candidate.mirrored;
    json["distance"] = candidate.distance;
    json["score"] = candidate.score;
    json["evidence"] = evidence;
    json["optimal"] = candidate.optimal;
    json["pairs"] = pairs;
    return json;
}

Candidate read_candidate(const JsonReader& reader, const SkeletonGraph& graph,
                         const std::vector<ReferenceSkeleton>& references) {
    Candidate candidate;
    candidate.reference = reader.at("reference").text();
    const auto reference =
        std::find_if(references.begin(), references.end(),
                     [&](const ReferenceSkeleton& r) { return r.name == candidate.reference; });
    if (reference == references.end())
        reader.at("reference").fail("there is no reference '" + candidate.reference + "'");
    candidate.mirrored = reader.at("mirrored").boolean();
    candidate.distance = reader.at("distance").number(-huge, huge);
    candidate.score = reader.at("score").number(-huge, huge);
    for (const auto& [name, value] : reader.at("evidence").entries())
        candidate.evidence.emplace_back(name, value.number(-huge, huge));
    candidate.optimal = reader.at("optimal").boolean();
    const long vertices = static_cast<long>(graph.vertices.size()),
               nodes = static_cast<long>(reference->nodes.size());
    for (const JsonReader& pair : reader.at("pairs").elements()) {
        const std::vector<JsonReader> both = pair.elements(2, 2);
        candidate.pairs.emplace_back(read_int(both[0], 0, vertices - 1), read_int(both[1], 0, nodes - 1));
    }
    return candidate;
}

} // namespace

std::string page_to_json(const Page& page) {
    Json json;
    json["source"] = page.source;
    if (page.rotate != 0) json["rotate"] = page.rotate;
    json["width"] = page.width;
    json["height"] = page.height;
    json["detector"] = page.detector;
    json["characters"] = Json::array();
    for (const PageCharacter& character : page.characters) {
        Json item;
        item["folder"] = character.folder;
        item["box"] =
            Json::array({character.box.x, character.box.y, character.box.width, character.box.height});
        item["scale"] = character.scale;
        item["score"] = character.score;
        item["status"] = character.status;
        json["characters"].push_back(item);
    }
    return to_json_text(json);
}

Page page_from_json(const std::string& text, const std::string& file) {
    const Json json = parse_json(text, file);
    const JsonReader reader(json, file);
    Page page;
    page.source = reader.at("source").text();
    if (reader.has("rotate")) page.rotate = read_int(reader.at("rotate"), 0, 270);
    page.width = read_int(reader.at("width"), 1, max_side);
    page.height = read_int(reader.at("height"), 1, max_side);
    page.detector = reader.at("detector").text();
    for (const JsonReader& item : reader.at("characters").elements())
        page.characters.push_back(read_page_character(item));
    return page;
}

std::string segmentation_to_json(const Segmentation& segmentation) {
    Json json;
    json["expert"] = segmentation.expert;
    json["router"] = Json::object();
    for (const auto& [expert, probability] : segmentation.router) json["router"][expert] = probability;
    json["sureness"] = segmentation.sureness;
    json["stroke_ratio"] = segmentation.stroke_ratio;
    json["pose"] = Json::object();
    for (std::size_t i = 0; i < pose_names.size(); ++i) json["pose"][pose_names[i]] = segmentation.pose[i];
    std::array<long, label_count> areas{};
    for (const std::uint8_t label : segmentation.labels)
        if (label < label_count) ++areas[label];
    json["areas"] = Json::object();
    for (std::size_t i = 0; i < areas.size(); ++i) json["areas"][std::string(label_names[i])] = areas[i];
    return to_json_text(json);
}

std::string contour_to_json(const std::vector<Border>& contour) {
    Json borders = Json::array();
    for (const Border& border : contour) {
        Json item;
        item["outer"] = border.outer;
        item["parent"] = border.parent;
        item["points"] = point_list(border.points);
        borders.push_back(item);
    }
    Json json;
    json["borders"] = borders;
    return to_json_text(json);
}

std::string skeleton_to_json(const SkeletonGraph& graph) {
    Json json;
    json["width"] = graph.width;
    json["height"] = graph.height;
    json["vertices"] = Json::array();
    for (std::size_t id = 0; id < graph.vertices.size(); ++id) {
        const SkeletonVertex& vertex = graph.vertices[id];
        Json item;
        item["id"] = id;
        item["x"] = vertex.x;
        item["y"] = vertex.y;
        item["label"] = std::string(name_of(vertex.label));
        item["kind"] = vertex.end ? "end" : "junction";
        json["vertices"].push_back(item);
    }
    json["edges"] = Json::array();
    for (const SkeletonEdge& edge : graph.edges) {
        Json item;
        item["u"] = edge.u;
        item["v"] = edge.v;
        item["length"] = edge.length;
        item["pixels"] = point_list(edge.pixels);
        json["edges"].push_back(item);
    }
    return to_json_text(json);
}

SkeletonGraph skeleton_from_json(const std::string& text, const std::string& file) {
    const Json json = parse_json(text, file);
    const JsonReader reader(json, file);
    SkeletonGraph graph;
    graph.width = read_int(reader.at("width"), 1, max_side);
    graph.height = read_int(reader.at("height"), 1, max_side);
    for (const JsonReader& item : reader.at("vertices").elements(1, 100'000))
        graph.vertices.push_back(read_vertex(item, graph.vertices.size(), graph.width, graph.height));
    const long count = static_cast<long>(graph.vertices.size());
    for (const JsonReader& item : reader.at("edges").elements(0, 100'000))
        graph.edges.push_back(read_edge(item, count, graph.width, graph.height));
    return graph;
}

std::string identification_to_json(const Identification& identification) {
    Json json;
    json["reference"] = identification.reference;
    json["type"] = identification.type;
    json["confidence"] = identification.confidence;
    json["candidates"] = Json::array();
    for (const Candidate& candidate : identification.candidates)
        json["candidates"].push_back(candidate_to_json(candidate));
    return to_json_text(json);
}

Identification identification_from_json(const std::string& text, const std::string& file,
                                        const SkeletonGraph& graph,
                                        const std::vector<ReferenceSkeleton>& references) {
    const Json json = parse_json(text, file);
    const JsonReader reader(json, file);
    Identification identification;
    identification.reference = reader.at("reference").text();
    if (reader.has("type")) identification.type = reader.at("type").text();
    identification.confidence = reader.at("confidence").number(0, 1);
    for (const JsonReader& item : reader.at("candidates").elements(1, 1000))
        identification.candidates.push_back(read_candidate(item, graph, references));
    // The reference may be changed by hand to another candidate.
    const auto chosen = [&](const Candidate& c) { return c.reference == identification.reference; };
    if (std::none_of(identification.candidates.begin(), identification.candidates.end(), chosen))
        reader.at("reference").fail("is none of the candidates");
    return identification;
}

std::string mapping_to_json(const Mapping& mapping) {
    Json json;
    json["pairs"] = Json::array();
    for (const EndPair& pair : mapping.pairs) {
        Json item;
        item["end"] = pair.end;
        item["reference_end"] = pair.reference_end;
        item["cost"] = pair.cost;
        json["pairs"].push_back(item);
    }
    json["costs"] = Json::array();
    for (const std::vector<double>& row : mapping.costs) json["costs"].push_back(row);
    return to_json_text(json);
}

Mapping mapping_from_json(const std::string& text, const std::string& file, const SkeletonGraph& graph,
                          const ReferenceSkeleton& reference) {
    const Json json = parse_json(text, file);
    const JsonReader reader(json, file);
    const long vertices = static_cast<long>(graph.vertices.size()),
               nodes = static_cast<long>(reference.nodes.size());
    Mapping mapping;
    for (const JsonReader& item : reader.at("pairs").elements(1, 1000)) {
        EndPair pair;
        pair.end = read_int(item.at("end"), 0, vertices - 1);
        pair.reference_end = read_int(item.at("reference_end"), 0, nodes - 1);
        pair.cost = item.at("cost").number(-huge, huge);
        const auto same_end = [&](const EndPair& other) { return other.end == pair.end; };
        if (std::any_of(mapping.pairs.begin(), mapping.pairs.end(), same_end))
            item.at("end").fail("is mapped twice");
        mapping.pairs.push_back(pair);
    }
    std::sort(mapping.pairs.begin(), mapping.pairs.end(),
              [](const EndPair& a, const EndPair& b) { return a.end < b.end; });
    for (const JsonReader& row : reader.at("costs").elements(0, 10'000)) {
        mapping.costs.emplace_back();
        for (const JsonReader& cost : row.elements(0, 10'000))
            mapping.costs.back().push_back(cost.number(-huge, huge));
    }
    return mapping;
}

std::string voronoi_to_json(const std::vector<VoronoiEdge>& edges, const std::vector<double>& residuals) {
    Json json;
    json["edges"] = Json::array();
    for (std::size_t i = 0; i < edges.size(); ++i) {
        Json item;
        item["from"] = Json::array({edges[i].from.x, edges[i].from.y});
        item["to"] = Json::array({edges[i].to.x, edges[i].to.y});
        item["sites"] = Json::array({edges[i].site_a, edges[i].site_b});
        item["residual"] =
            std::isfinite(residuals[i]) ? Json(residuals[i]) : Json(nullptr); // between two borders
        json["edges"].push_back(item);
    }
    return to_json_text(json);
}

} // namespace pantin
