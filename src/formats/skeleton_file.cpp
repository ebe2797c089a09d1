// SPDX-License-Identifier: MIT
// The skeleton graph to the text of skeleton.json, and back (thesis 4.4).
#include "formats/skeleton_file.hpp"

#include "formats/json_values.hpp"

namespace pantin {

namespace {

SkeletonVertex read_vertex(const JsonReader& reader, std::size_t id, int width, int height) {
    SkeletonVertex vertex;
    if (reader.at("id").integer(0, 1'000'000) != static_cast<long>(id))
        reader.at("id").fail("ids count up from 0");
    vertex.x = reader.at("x").number(-1, width);
    vertex.y = reader.at("y").number(-1, height);
    vertex.label = label_from_name(reader.at("label").text());
    if (vertex.label == Label::background) reader.at("label").fail("must be " + listed_parts());
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

} // namespace

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

} // namespace pantin
