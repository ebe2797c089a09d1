// SPDX-License-Identifier: MIT
// A function on a body-centred cubic lattice in, its zero surface as triangles out: marching tetrahedra (Doi
// & Koide 1991) after isosurface stuffing (Labelle & Shewchuk 2007).
#include "modeling/tetrahedra.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pantin {
namespace {

// Differences of a lattice point to its 14 neighbours, in half cells: the first six edges are long.
constexpr int neighbour_count = 14;
constexpr int ways[neighbour_count][3] = {{2, 0, 0},   {-2, 0, 0},  {0, 2, 0},   {0, -2, 0},  {0, 0, 2},
                                          {0, 0, -2},  {1, 1, 1},   {1, 1, -1},  {1, -1, 1},  {-1, 1, 1},
                                          {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}, {-1, -1, -1}};
// So far along an edge a point may move and no tetrahedron turns over (Labelle & Shewchuk 2007).
constexpr double long_reach = 0.21, short_reach = 0.33;
constexpr double least_share =
    0.04; // crossings keep away from the ends of their edge, so that no triangle is flat
constexpr int search_steps = 4; // of the crossing along an edge
constexpr int most_rounds = 12; // of releasing points

bool are_neighbours(const int a[3], const int b[3]) {
    const int x = std::abs(a[0] - b[0]), y = std::abs(a[1] - b[1]), z = std::abs(a[2] - b[2]);
    return x + y + z == 2 ? (x == 2 || y == 2 || z == 2) : x == 1 && y == 1 && z == 1;
}

// Bit k of row i: the neighbours i and k of a point are neighbours of each other.
std::array<unsigned, neighbour_count> make_links() {
    std::array<unsigned, neighbour_count> links{};
    for (int i = 0; i < neighbour_count; ++i)
        for (int k = 0; k < neighbour_count; ++k)
            if (i != k && are_neighbours(ways[i], ways[k])) links[i] |= 1u << k;
    return links;
}

bool connected(unsigned set) {
    static const std::array<unsigned, neighbour_count> links = make_links();
    if (set == 0) return false;
    unsigned reached = set & (~set + 1);
    for (unsigned last = 0; reached != last;) {
        last = reached;
        for (int i = 0; i < neighbour_count; ++i)
            if (reached & 1u << i) reached |= links[i] & set;
    }
    return reached == set;
}

std::uint64_t key_of(std::uint32_t a, std::uint32_t b) {
    return static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
}

} // namespace

TetrahedraLattice::TetrahedraLattice(Vec3 low, Vec3 high, double cell)
    : origin_(low - 2 * cell * Vec3{1, 1, 1}), cell_(cell) {
    const Vec3 size = high - low;
    const double sizes[3] = {size.x, size.y, size.z};
    std::size_t points = 2;
    for (int k = 0; k < 3; ++k) {
        count_[k] = static_cast<int>(std::ceil(sizes[k] / cell)) + 4;
        points *= static_cast<std::size_t>(count_[k] + 1);
    }
    values_.assign(points, std::numeric_limits<double>::infinity());
    snapped_.assign(points, 0);
}

TetrahedraLattice::Range TetrahedraLattice::range(double low, double high, double origin, int count,
                                                  int odd) const {
    const double shift = 0.5 * odd;
    return {std::max(1, static_cast<int>(std::ceil((low - origin) / cell_ - shift))),
            std::min(count - 1 - odd, static_cast<int>(std::floor((high - origin) / cell_ - shift)))};
}

TetrahedraLattice::Node TetrahedraLattice::node(Index n) const {
    const int odd = static_cast<int>(n & 1);
    const std::size_t corner = n / 2, row = static_cast<std::size_t>(count_[0] + 1),
                      plane = row * (count_[1] + 1);
    return {2 * static_cast<int>(corner % row) + odd, 2 * static_cast<int>(corner % plane / row) + odd,
            2 * static_cast<int>(corner / plane) + odd};
}

bool TetrahedraLattice::holds(Node n) const {
    return n.x >= 0 && n.y >= 0 && n.z >= 0 && n.x <= 2 * count_[0] && n.y <= 2 * count_[1] &&
           n.z <= 2 * count_[2];
}

// False position, from the inner end.
double TetrahedraLattice::crossing(Vec3 from, double value, Vec3 to, double other, const Field& field) const {
    double low = 0, high = 1, at_low = value, at_high = other;
    double t = 0.5;
    for (int step = 0; step < search_steps; ++step) {
        t = std::clamp(at_low / (at_low - at_high), 0.1, 0.9);
        t = low + t * (high - low);
        const double f = field(from + t * (to - from));
        if (f < 0)
            low = t, at_low = f;
        else
            high = t, at_high = std::max(f, 1e-300);
    }
    return std::clamp(t, least_share, 1 - least_share);
}

void TetrahedraLattice::find_crossings(const Field& field) {
    crossed_.clear();
    for (Index n = 0; n < values_.size(); ++n) {
        if (values_[n] >= 0) continue;
        const Node at = node(n);
        for (const auto& way : ways) {
            const Node next{at.x + way[0], at.y + way[1], at.z + way[2]};
            const Index m = index(next);
            if (values_[m] < 0) continue;
            const double t = crossing(rest(at), values_[n], rest(next), values_[m], field);
            crossed_[key_of(n, m)] = n < m ? t : 1 - t;
        }
    }
}

// Whether what is inside and what is not are each in one piece around the point: then it can lie on the
// surface.
bool TetrahedraLattice::is_simple(Index n) const {
    const Node at = node(n);
    unsigned in = 0, out = 0;
    for (int w = 0; w < neighbour_count; ++w) {
        const Node next{at.x + ways[w][0], at.y + ways[w][1], at.z + ways[w][2]};
        (inside(index(next)) ? in : out) |= 1u << w;
    }
    return connected(in) && connected(out);
}

void TetrahedraLattice::snap() {
    std::vector<std::pair<Index, Index>> wanted; // point, other end
    for (Index n = 0; n < values_.size(); ++n) {
        const Node at = node(n);
        if (!holds({at.x - 2, at.y - 2, at.z - 2}) || !holds({at.x + 2, at.y + 2, at.z + 2})) continue;
        double nearest = 1;
        Index other = 0;
        for (int w = 0; w < neighbour_count; ++w) {
            const Index m = index({at.x + ways[w][0], at.y + ways[w][1], at.z + ways[w][2]});
            if ((values_[n] < 0) == (values_[m] < 0)) continue;
            const double t = crossed_.at(key_of(n, m)), share = n < m ? t : 1 - t;
            if (const double relative = share / (w < 6 ? long_reach : short_reach); relative < nearest)
                nearest = relative, other = m + 1;
        }
        if (other > 0) wanted.emplace_back(n, other);
    }
    for (const auto& [n, other] : wanted)
        if (is_simple(n)) snapped_[n] = other;
}

// Tetrahedra between a face's two centres and its four edges, positively oriented, that have a corner inside
// and one that is not.
void TetrahedraLattice::collect(std::vector<Tetrahedron>& active) const {
    constexpr int around[3][4][3] = {{{0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}},
                                     {{-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}},
                                     {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}};
    for (int z = 1; z < 2 * count_[2] - 2; z += 2)
        for (int y = 1; y < 2 * count_[1] - 2; y += 2)
            for (int x = 1; x < 2 * count_[0] - 2; x += 2)
                for (int axis = 0; axis < 3; ++axis) {
                    const int step[3] = {axis == 0, axis == 1, axis == 2};
                    const Index first = index({x, y, z}),
                                second = index({x + 2 * step[0], y + 2 * step[1], z + 2 * step[2]});
                    Index ring[4];
                    int in = inside(first) + inside(second);
                    for (int k = 0; k < 4; ++k) {
                        const int* d = around[axis][k];
                        ring[k] = index({x + step[0] + d[0], y + step[1] + d[1], z + step[2] + d[2]});
                        in += inside(ring[k]);
                    }
                    if (in == 0 || in == 6) continue;
                    for (int k = 0; k < 4; ++k) active.push_back({first, second, ring[k], ring[(k + 1) % 4]});
                }
}

std::vector<TetrahedraLattice::Piece>
TetrahedraLattice::pieces(const std::vector<Tetrahedron>& active) const {
    // Even orders of the corners that bring those inside to the front, by the set of corners inside.
    constexpr int orders[16][4] = {{0, 1, 2, 3}, {0, 1, 2, 3}, {1, 0, 3, 2}, {0, 1, 2, 3},
                                   {2, 3, 0, 1}, {0, 2, 3, 1}, {1, 2, 0, 3}, {3, 2, 1, 0},
                                   {3, 2, 1, 0}, {0, 3, 1, 2}, {1, 3, 2, 0}, {2, 3, 0, 1},
                                   {2, 3, 0, 1}, {1, 0, 3, 2}, {0, 1, 2, 3}, {0, 1, 2, 3}};
    std::vector<Piece> found;
    const auto add = [&](Corner a, Corner b, Corner c) {
        if (a != b && b != c && c != a) found.push_back({a, b, c});
    };
    for (const Tetrahedron& t : active) {
        unsigned set = 0;
        for (int k = 0; k < 4; ++k) set |= inside(t[k]) ? 1u << k : 0;
        if (set == 0 || set == 15) continue;
        const int* order = orders[set];
        const auto at = [&](int i, int k) { // on the edge from the i-th to the k-th corner of that order
            Index a = t[order[i]], b = t[order[k]];
            if (!inside(a)) std::swap(a, b);
            return snapped_[b] != 0 ? static_cast<Corner>(b) << 32 | b : key_of(a, b);
        };
        const int count = __builtin_popcount(set);
        if (count == 1) add(at(0, 1), at(0, 2), at(0, 3));
        if (count == 3) add(at(0, 1), at(0, 3), at(0, 2)); // the first one is outside
        if (count != 2) continue;
        const Corner a = at(0, 2), b = at(0, 3), c = at(1, 3), d = at(1, 2);
        if (distance(place_of(a), place_of(c)) <= distance(place_of(b), place_of(d))) {
            add(a, b, c);
            add(a, c, d);
        } else {
            add(a, b, d);
            add(b, c, d);
        }
    }
    return found;
}

Vec3 TetrahedraLattice::place_of(Corner corner) const {
    Index a = static_cast<Index>(corner >> 32), b = static_cast<Index>(corner);
    if (a == b) {
        const Index other = snapped_[a] - 1;
        b = std::max(a, other), a = std::min(a, other);
    }
    const double t = crossed_.at(static_cast<Corner>(a) << 32 | b);
    const Vec3 from = rest(node(a)), to = rest(node(b));
    return from + t * (to - from);
}

// Releases the points at which the surface would touch itself; returns how many.
int TetrahedraLattice::release_bad(const std::vector<Piece>& pieces) {
    std::unordered_map<Corner, int> number;
    std::vector<Corner> corners;
    std::vector<std::array<int, 3>> faces;
    for (const Piece& piece : pieces) {
        std::array<int, 3> face{};
        for (int k = 0; k < 3; ++k) {
            const auto [at, added] = number.try_emplace(piece[k], static_cast<int>(corners.size()));
            if (added) corners.push_back(piece[k]);
            face[k] = at->second;
        }
        faces.push_back(face);
    }
    std::vector<char> bad(corners.size());
    std::vector<std::vector<std::pair<int, int>>> fans(corners.size()); // the edges opposite each corner
    for (const auto& f : faces)
        for (int k = 0; k < 3; ++k) fans[f[k]].emplace_back(f[(k + 1) % 3], f[(k + 2) % 3]);
    for (std::size_t c = 0; c < corners.size(); ++c) {
        auto& fan = fans[c];
        std::sort(fan.begin(), fan.end());
        std::size_t steps = 0;
        int at = fan.front().first;
        const auto leaving = [&](int from) {
            return std::lower_bound(fan.begin(), fan.end(), std::pair(from, -1));
        };
        do { // one cycle through all of them, or else the surface is no disc here
            const auto next = leaving(at);
            if (next == fan.end() || next->first != at || (next + 1 != fan.end() && (next + 1)->first == at))
                break;
            at = next->second;
            ++steps;
        } while (at != fan.front().first && steps <= fan.size());
        if (steps == fan.size() && at == fan.front().first && fan.size() >= 3) continue;
        bad[c] = 1;
        for (const auto& [from, to] : fan) bad[from] = bad[to] = 1;
    }
    int released = 0;
    for (std::size_t c = 0; c < corners.size(); ++c) {
        const Index n = static_cast<Index>(corners[c]);
        if (!bad[c] || corners[c] >> 32 != n) continue;
        snapped_[n] = 0;
        ++released;
    }
    return released;
}

SolidMesh TetrahedraLattice::surface(const Field& field) {
    find_crossings(field);
    snap();
    std::vector<Piece> found;
    for (int round = 0; round < most_rounds; ++round) {
        if (round + 1 == most_rounds) std::fill(snapped_.begin(), snapped_.end(), 0);
        std::vector<Tetrahedron> active;
        collect(active);
        found = pieces(active);
        if (release_bad(found) == 0) break;
    }
    SolidMesh mesh;
    std::unordered_map<Corner, int> number;
    for (const Piece& piece : found) {
        std::array<int, 3> triangle{};
        for (int k = 0; k < 3; ++k) {
            const auto [at, added] = number.try_emplace(piece[k], static_cast<int>(mesh.vertices.size()));
            if (added) mesh.vertices.push_back(place_of(piece[k]));
            triangle[k] = at->second;
        }
        mesh.triangles.push_back(triangle);
    }
    return mesh;
}

} // namespace pantin
