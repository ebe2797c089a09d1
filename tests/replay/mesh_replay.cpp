// SPDX-License-Identifier: MIT
// Marching squares with midpoints (thesis 4.6, Fig. 4.17, ERRATA 21) from a table of the sixteen cases, and
// texture coordinates.
#include <algorithm>
#include <cmath>
#include <set>

#include "replay/stored.hpp"

namespace pantin::test::replay {
namespace {

using Key = std::pair<int, int>; // twice the place, so that midpoints are whole numbers
using Face = std::vector<Key>;   // from its smallest corner on

Face turned(Face face) {
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    return face;
}

// What lies inside a voxel, as positions 0 … 7 around it: even ones are corners (top left, top right, bottom
// right, bottom left), odd ones the midpoint that follows. The case has bit i for corner i.
std::vector<std::vector<int>> polygons_of(int inside, bool joined) {
    if ((inside == 5 || inside == 10) && !joined) {
        if (inside == 5) return {{7, 0, 1}, {3, 4, 5}};
        return {{1, 2, 3}, {5, 6, 7}};
    }
    std::vector<int> polygon;
    for (int i = 0; i < 4; ++i) {
        const bool here = (inside >> i) & 1, next = (inside >> ((i + 1) % 4)) & 1;
        if (here) polygon.push_back(2 * i);
        if (here != next) polygon.push_back(2 * i + 1);
    }
    return {polygon};
}

std::multiset<Face> faces_of(const Mask& mask, int cell) {
    constexpr int x_at[8] = {0, 1, 2, 2, 2, 1, 0, 0}, y_at[8] = {0, 0, 0, 1, 2, 2, 2, 1};
    const auto in = [&](int x, int y) { return mask.value_or(x, y, 0) != 0; };
    std::multiset<Face> faces;
    for (int y = -cell; y < mask.height() + cell; y += cell)
        for (int x = -cell; x < mask.width() + cell; x += cell) {
            int inside = 0;
            for (int i = 0; i < 4; ++i)
                inside |= in(x + cell * x_at[2 * i] / 2, y + cell * y_at[2 * i] / 2) << i;
            if (inside == 0) continue;
            for (const std::vector<int>& polygon : polygons_of(inside, in(x + cell / 2, y + cell / 2))) {
                Face corners;
                for (const int i : polygon)
                    corners.emplace_back(2 * x + cell * x_at[i], 2 * y + cell * y_at[i]);
                faces.insert(turned(corners));
            }
        }
    return faces;
}

// Pieces, and by Euler's formula holes.
std::pair<int, int> topology_of(const std::multiset<Face>& faces) {
    std::map<Key, Key> parent;
    const auto root = [&](Key k) {
        while (parent.at(k) != k) k = parent.at(k);
        return k;
    };
    std::set<std::pair<Key, Key>> edges;
    for (const Face& face : faces)
        for (std::size_t i = 0; i < face.size(); ++i) {
            const Key a = face[i], b = face[(i + 1) % face.size()];
            parent.emplace(a, a);
            parent.emplace(b, b);
            edges.insert({std::min(a, b), std::max(a, b)});
            const Key low = root(a), high = root(b);
            parent[high] = low;
        }
    int pieces = 0;
    for (const auto& [key, up] : parent) pieces += key == up;
    return {pieces, pieces - (static_cast<int>(parent.size()) - static_cast<int>(edges.size()) +
                              static_cast<int>(faces.size()))};
}

int large_holes_of(const Mask& mask, long area) {
    Mask framed(mask.width() + 2, mask.height() + 2);
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) framed(x + 1, y + 1) = mask(x, y);
    const Regions gaps = regions_of(framed, false, false); // the first one is the outside
    return static_cast<int>(
        std::count_if(gaps.area.begin() + 1, gaps.area.end(), [&](long a) { return a > area; }));
}

// The cell starts at a 64th of the longer side and shrinks by a quarter until no piece and no hole of more
// than four voxels is lost (at least 2).
std::multiset<Face> mesh_of(const Mask& mask) {
    const int pieces = static_cast<int>(regions_of(mask, true, true).area.size()), holes = holes_of(mask);
    for (int cell = std::max(4, std::max(mask.width(), mask.height()) / 64);;
         cell = std::max(2, cell * 3 / 4)) {
        const std::multiset<Face> faces = faces_of(mask, cell);
        std::set<Key> vertices;
        for (const Face& face : faces) vertices.insert(face.begin(), face.end());
        const auto [found, found_holes] = topology_of(faces);
        const bool kept =
            found == pieces && found_holes <= holes && found_holes >= large_holes_of(mask, 4L * cell * cell);
        if (cell == 2 || kept || vertices.size() > 4000) return faces;
    }
}

} // namespace

void replay_mesh(const Stored& s, Tally& tally) {
    if (!s.rigged) return;
    bool texture = s.texture.size() == s.vertices.size();
    for (std::size_t i = 0; texture && i < s.vertices.size(); ++i)
        texture = std::abs(s.texture[i].x - (s.vertices[i].x + 0.5) / s.width) < 1e-9 &&
                  std::abs(s.texture[i].y - (s.vertices[i].y + 0.5) / s.height) < 1e-9;
    tally.add("texture coordinates", texture);
    if (!s.thesis) return; // the default's mesh is of its own (ERRATA 21)
    Mask mask(s.width, s.height);
    for (std::size_t i = 0; i < mask.size(); ++i) mask.data()[i] = s.labels.data()[i] != 0;
    bool whole = true;
    std::multiset<Face> stored;
    for (const std::vector<int>& face : s.faces) {
        Face corners;
        for (const int v : face) {
            const double x = 2 * s.vertices.at(v).x, y = 2 * s.vertices.at(v).y;
            whole = whole && std::abs(x - std::rint(x)) < 1e-6 && std::abs(y - std::rint(y)) < 1e-6;
            corners.emplace_back(static_cast<int>(std::rint(x)), static_cast<int>(std::rint(y)));
        }
        stored.insert(turned(corners));
    }
    std::set<std::pair<long, long>> places;
    for (const Point2d& p : s.vertices) places.insert({std::lrint(2 * p.x), std::lrint(2 * p.y)});
    tally.add("mesh: midpoints and corners, none twice", whole && places.size() == s.vertices.size());
    tally.add("mesh: faces", stored == mesh_of(mask));
}

} // namespace pantin::test::replay
