// SPDX-License-Identifier: MIT
#include "replay/stored.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "pantin/image.hpp"
#include "support/folders.hpp"

namespace pantin::test::replay {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

Mask read_mask(const fs::path& file) {
    Mask mask = load_grey(file);
    for (auto& pixel : mask) pixel = pixel != 0;
    return mask;
}

Graph read_graph(const fs::path& file) {
    const json stored = json::parse(read(file));
    Graph graph;
    for (const json& v : stored["vertices"]) graph.vertices.push_back({v["x"], v["y"], v["label"]});
    for (const json& e : stored["edges"]) {
        Edge edge{e["u"], e["v"], e["length"], {}};
        for (const json& p : e["pixels"]) edge.pixels.push_back({p[0], p[1]});
        graph.edges.push_back(edge);
    }
    return graph;
}

void read_mesh(const fs::path& file, Stored& stored) {
    std::istringstream lines(read(file));
    const double w = stored.width, h = stored.height;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        double a = 0, b = 0;
        if (kind == "v" && words >> a >> b)
            stored.vertices.push_back({a * h + 0.5 * w - 0.5, h - 0.5 - b * h});
        else if (kind == "vt" && words >> a >> b)
            stored.texture.push_back({a, 1 - b});
        else if (kind == "f") {
            std::vector<int>& face = stored.faces.emplace_back();
            for (std::string corner; words >> corner;) face.insert(face.begin(), std::stoi(corner) - 1);
        }
    }
}

void read_weights(const fs::path& file, Stored& stored) {
    std::istringstream lines(read(file));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string kind;
        int vertex = 0, bone = 0;
        if (!(words >> kind >> vertex) || kind != "v") continue;
        std::map<int, double>& weights = stored.weights.emplace_back();
        for (double weight = 0; words >> bone >> weight;) weights[bone] = weight;
    }
}

} // namespace

Stored read_stored(const fs::path& character, bool thesis) {
    Stored s;
    s.thesis = thesis;
    s.labels = load_grey(character / "labels.png");
    s.width = s.labels.width();
    s.height = s.labels.height();
    const fs::path trace = character / "trace";
    s.silhouette = read_mask(trace / "silhouette.png");
    s.voronoi = read_mask(trace / "voronoi.png");
    s.thinned = read_mask(trace / "thinned.png");
    s.skeleton = read_mask(character / "skeleton.png");
    const json contour = json::parse(read(character / "contour.json"));
    for (const json& border : contour["borders"]) {
        s.outer.push_back(border["outer"]);
        std::vector<Point2i>& points = s.borders.emplace_back();
        for (const json& p : border["points"]) points.push_back({p[0], p[1]});
    }
    s.voronoi_edges = json::parse(read(trace / "voronoi.json"))["edges"];
    s.raw = read_graph(trace / "skeleton-raw.json");
    s.after_h1 = read_graph(trace / "skeleton-h1.json");
    s.graph = read_graph(character / "skeleton.json");
    s.rigged = fs::exists(character / "weights.txt");
    if (fs::exists(character / "identification.json"))
        s.identification = json::parse(read(character / "identification.json"));
    if (!s.rigged) return s;
    s.mapping = json::parse(read(character / "mapping.json"));
    read_mesh(character / "mesh.obj", s);
    read_weights(character / "weights.txt", s);
    return s;
}

void Tally::add(const std::string& stage, bool equal, const std::string& detail) {
    auto& [count, of] = rows_[stage];
    count += equal;
    ++of;
    if (!equal) misses_.push_back(where_ + ": " + stage + (detail.empty() ? "" : ": " + detail));
}

std::string Tally::table() const {
    std::string text;
    for (const auto& [stage, row] : rows_)
        text += stage + " " + std::to_string(row.first) + "/" + std::to_string(row.second) + "\n";
    return text;
}

int Tally::of(const std::string& stage) const {
    const auto row = rows_.find(stage);
    return row == rows_.end() ? 0 : row->second.second;
}

Regions regions_of(const Mask& mask, bool foreground, bool diagonal) {
    Regions regions{Grid<int>(mask.width(), mask.height(), 0), {}};
    const auto wanted = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < mask.width() && y < mask.height() && (mask(x, y) != 0) == foreground &&
               regions.id(x, y) == 0;
    };
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) {
            if (!wanted(x, y)) continue;
            regions.area.push_back(0);
            const int id = static_cast<int>(regions.area.size());
            std::vector<Point2i> todo = {{x, y}};
            regions.id(x, y) = id;
            while (!todo.empty()) {
                const Point2i p = todo.back();
                todo.pop_back();
                ++regions.area.back();
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx) {
                        if ((!diagonal && dx != 0 && dy != 0) || !wanted(p.x + dx, p.y + dy)) continue;
                        regions.id(p.x + dx, p.y + dy) = id;
                        todo.push_back({p.x + dx, p.y + dy});
                    }
            }
        }
    return regions;
}

int holes_of(const Mask& mask) {
    Mask framed(mask.width() + 2, mask.height() + 2);
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) framed(x + 1, y + 1) = mask(x, y);
    return static_cast<int>(regions_of(framed, false, false).area.size()) - 1;
}

int nearest_label(const LabelMap& labels, int x, int y) {
    if (labels(x, y) != 0) return labels(x, y);
    long best = -1;
    int label = 0;
    for (int v = 0; v < labels.height(); ++v)
        for (int u = 0; u < labels.width(); ++u) {
            if (labels(u, v) == 0) continue;
            const long d = static_cast<long>(u - x) * (u - x) + static_cast<long>(v - y) * (v - y);
            if (best < 0 || d < best) best = d, label = labels(u, v);
        }
    return label;
}

Grid<double> depths_of(const Mask& mask) {
    // The nearest background pixel has the foreground beside it.
    const auto inside = [&](int x, int y) { return mask.value_or(x, y, 0) != 0; };
    std::vector<Point2i> rim;
    for (int y = -1; y <= mask.height(); ++y)
        for (int x = -1; x <= mask.width(); ++x)
            if (!inside(x, y) &&
                (inside(x - 1, y) || inside(x + 1, y) || inside(x, y - 1) || inside(x, y + 1)))
                rim.push_back({x, y});
    Grid<double> depths(mask.width(), mask.height(), 0.0);
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) {
            if (!mask(x, y)) continue;
            int best = 1 << 30;
            for (const Point2i p : rim) best = std::min(best, (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y));
            depths(x, y) = std::sqrt(static_cast<double>(best));
        }
    return depths;
}

} // namespace pantin::test::replay
