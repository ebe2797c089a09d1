// SPDX-License-Identifier: MIT
// A character's folder as `animate --trace` leaves it, for the replay: every stage is computed again from the
// stored result of the one before it, by code that shares nothing with src but the types and the reading of
// pictures.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "pantin/grid.hpp"
#include "pantin/point.hpp"

namespace pantin::test::replay {

struct Vertex {
    double x = 0, y = 0;
    std::string label;
};
struct Edge {
    int u = 0, v = 0;
    double length = 0;
    std::vector<Point2i> pixels;
};
struct Graph {
    std::vector<Vertex> vertices;
    std::vector<Edge> edges;
};
struct Stored {
    bool thesis = false; // the preset
    int width = 0, height = 0;
    LabelMap labels;
    Mask silhouette, voronoi, thinned, skeleton;
    std::vector<std::vector<Point2i>> borders;
    std::vector<bool> outer; // per border
    nlohmann::json voronoi_edges, identification, mapping;
    Graph raw, after_h1, graph;
    bool rigged = false;                        // the following is there
    std::vector<Point2d> vertices, texture;     // of mesh.obj; working pixels; [0, 1], v down
    std::vector<std::vector<int>> faces;        // clockwise on screen
    std::vector<std::map<int, double>> weights; // per vertex: bone to weight
    double scale() const { return std::max(width, height) / 321.0; } // of the lengths of thesis ch. 5
};
Stored read_stored(const std::filesystem::path& character, bool thesis);

// How often each stage was equal, and where it was not.
class Tally {
public:
    void add(const std::string& stage, bool equal, const std::string& detail = "");
    void start(const std::string& where) { where_ = where; }
    const std::vector<std::string>& misses() const { return misses_; }
    std::string table() const; // `stage equal/of`, a line each
    int of(const std::string& stage) const;

private:
    std::string where_;
    std::map<std::string, std::pair<int, int>> rows_;
    std::vector<std::string> misses_;
};

void replay_shape(const Stored& stored, Tally& tally);    // silhouette, borders
void replay_voronoi(const Stored& stored, Tally& tally);  // diagram, residuals, raster
void replay_thinning(const Stored& stored, Tally& tally); // Zhang–Suen, redundant pixels
void replay_graph(const Stored& stored, Tally& tally);    // graph, H1, H2
void replay_distance(const Stored& stored, Tally& tally); // the graph distance of every reference
void replay_mapping(const Stored& stored, Tally& tally);  // path similarity, bijection, assignment
void replay_mesh(const Stored& stored, Tally& tally);     // marching squares, texture coordinates
void replay_weights(const Stored& stored, Tally& tally);  // Algorithm 4.4

// --- what several stages use
// ---------------------------------------------------------------------------------

// Connected regions of the pixels with mask ≠ 0 == foreground: 0 where there is none, else 1, 2, …
struct Regions {
    Grid<int> id;
    std::vector<long> area; // of region i at i − 1
};
Regions regions_of(const Mask& mask, bool foreground, bool diagonal);
// Background regions that do not touch the image's rim.
int holes_of(const Mask& mask);
// The pixel of the labels, or that of the nearest labelled pixel (the uppermost of those, then the leftmost).
int nearest_label(const LabelMap& labels, int x, int y);
// Distance of every foreground pixel to the nearest background pixel; what lies outside is background.
Grid<double> depths_of(const Mask& mask);

} // namespace pantin::test::replay
