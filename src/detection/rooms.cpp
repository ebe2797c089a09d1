// Rooms: background regions that open outlines enclose.
//
// Closing the ink with growing radii and filling asks, per radius, which background a disc of that radius
// cannot reach from outside. All radii at once are the flooding of the distance map of the ink from its
// maxima downwards: every maximum is a basin, two basins meet at a saddle, whose height is the half-width of
// the narrowest place between them. A basin (or several that have met) is a room when the mouth through which
// it meets the outside is narrow compared with its inradius: ratio = peak / saddle. The space between two
// legs is as wide at its mouth as anywhere, ratio 1, and stays outside at every radius; a body whose outline
// has a gap does not. The cut runs along the watershed line, which joins the two stroke ends beside the
// mouth; nothing is dilated. Where the way out is a corridor (a leg without a foot), the cut is moved to its
// outer end.
//
// Based on: F. Meyer, Topographic distance and watershed lines, Signal Processing 38, 1994 (flooding by
// priority); S. Beucher, C. Lantuéjoul, 1979 (watershed of the distance function); thesis 4.2 (gaps in
// contours).
#include "detection/rooms.hpp"

#include <algorithm>
#include <numeric>

#include "image/distance.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace {

struct Saddle {
    int a = 0, b = 0; // basins
    int height = 0;   // squared distance
};

struct Basins {
    Grid<int> ids;          // −1 on ink
    std::vector<int> peaks; // squared distance
    std::vector<char> at_border;
    std::vector<Saddle> saddles; // descending by height
};

// Background pixels from the farthest to the nearest to ink, ties in raster order (counting sort).
std::vector<int> descending_pixels(const Grid<int>& distance) {
    const int highest = *std::max_element(distance.begin(), distance.end());
    std::vector<int> start(static_cast<std::size_t>(highest) + 2, 0);
    for (int d : distance) ++start[highest - d + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<int> order(distance.size());
    for (std::size_t i = 0; i < distance.size(); ++i)
        order[start[highest - distance.data()[i]]++] = static_cast<int>(i);
    while (!order.empty() && distance.data()[order.back()] == 0) order.pop_back();
    return order;
}

// Flooding from the maxima; background is 4-connected. A pixel joins its highest neighbour's basin.
Basins flood(const Grid<int>& distance) {
    const int w = distance.width(), h = distance.height();
    Basins basins;
    basins.ids = Grid<int>(w, h, -1);
    for (int pixel : descending_pixels(distance)) {
        const int x = pixel % w, y = pixel / w;
        const Point2i neighbours[4] = {{x, y - 1}, {x - 1, y}, {x + 1, y}, {x, y + 1}};
        int id = -1, highest = -1;
        for (Point2i n : neighbours) {
            if (!distance.contains(n.x, n.y) || basins.ids(n.x, n.y) < 0) continue;
            if (distance(n.x, n.y) > highest) highest = distance(n.x, n.y), id = basins.ids(n.x, n.y);
        }
        if (id < 0) {
            id = static_cast<int>(basins.peaks.size());
            basins.peaks.push_back(distance(x, y));
            basins.at_border.push_back(0);
        }
        basins.ids(x, y) = id;
        if (x == 0 || y == 0 || x == w - 1 || y == h - 1) basins.at_border[id] = 1;
        for (Point2i n : neighbours) {
            if (!distance.contains(n.x, n.y)) continue;
            const int other = basins.ids(n.x, n.y);
            if (other >= 0 && other != id) basins.saddles.push_back({id, other, distance(x, y)});
        }
    }
    return basins;
}

// Sets of basins that have met.
class BasinSets {
public:
    explicit BasinSets(const Basins& basins)
        : parent_(basins.peaks.size()), peak_(basins.peaks), outside_(basins.at_border),
          room_(basins.peaks.size(), 0) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }
    int find(int i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void unite(int a, int b) {
        const int low = std::min(a, b), high = std::max(a, b);
        parent_[high] = low;
        peak_[low] = std::max(peak_[low], peak_[high]);
        outside_[low] |= outside_[high];
        room_[low] |= room_[high];
    }
    int peak(int root) const { return peak_[root]; }
    bool outside(int root) const { return outside_[root] != 0; }
    bool room(int root) const { return room_[root] != 0; }
    void make_room(int root) { room_[root] = 1; }

private:
    std::vector<int> parent_, peak_;
    std::vector<char> outside_, room_;
};

// Which basins are outside once every room has been cut off at its mouths.
std::vector<char> outside_basins(const Basins& basins, double ratio, double max_mouth) {
    BasinSets sets(basins);
    for (const Saddle& saddle : basins.saddles) {
        int inner = sets.find(saddle.a), outer = sets.find(saddle.b);
        if (inner == outer) continue;
        if (sets.outside(inner)) std::swap(inner, outer);
        if (!sets.outside(outer) || sets.outside(inner)) { // both inside or both outside
            sets.unite(inner, outer);
            continue;
        }
        if (sets.room(inner)) continue; // another mouth of the room, narrower than the first
        const double mouth = saddle.height;
        if (mouth <= max_mouth * max_mouth && sets.peak(inner) >= ratio * ratio * mouth)
            sets.make_room(inner);
        else
            sets.unite(inner, outer);
    }
    std::vector<char> outside(basins.peaks.size());
    for (std::size_t i = 0; i < outside.size(); ++i)
        outside[i] = sets.outside(sets.find(static_cast<int>(i)));
    return outside;
}

// Moves each cut to the outer end of its corridor: an outside basin that is hardly wider than the place where
// it meets a room belongs to the room. Repeated until nothing changes.
void extend_along_corridors(const Basins& basins, double corridor, std::vector<char>& outside) {
    bool changed = true;
    while (changed) {
        changed = false;
        for (const Saddle& saddle : basins.saddles) {
            if (outside[saddle.a] == outside[saddle.b]) continue;
            const int outer = outside[saddle.a] ? saddle.a : saddle.b;
            if (basins.at_border[outer] || basins.peaks[outer] > corridor * corridor * saddle.height)
                continue;
            outside[outer] = 0;
            changed = true;
        }
    }
}

double diagonal_of(const Mask& ink) {
    int low_x = ink.width(), low_y = ink.height(), high_x = -1, high_y = -1;
    for (int y = 0; y < ink.height(); ++y) {
        for (int x = 0; x < ink.width(); ++x) {
            if (!ink(x, y)) continue;
            low_x = std::min(low_x, x), high_x = std::max(high_x, x);
            low_y = std::min(low_y, y), high_y = std::max(high_y, y);
        }
    }
    return high_x < 0 ? 0 : distance({1.0 * low_x, 1.0 * low_y}, {high_x + 1.0, high_y + 1.0});
}

} // namespace

Mask find_rooms(const Mask& ink, const RoomOptions& options) {
    const double diagonal = diagonal_of(ink);
    if (diagonal == 0) return Mask(ink.width(), ink.height());
    // Paper around the picture, so that all of the outside is one region wider than any mouth.
    const int margin = 2 + static_cast<int>(options.max_mouth * diagonal);
    const Mask padded = pad(ink, margin);
    const Basins basins = flood(squared_distance_to(padded, 1, false));
    std::vector<char> outside = outside_basins(basins, options.mouth_ratio, options.max_mouth * diagonal);
    extend_along_corridors(basins, options.corridor, outside);
    Mask filled = padded;
    for (std::size_t i = 0; i < filled.size(); ++i) {
        const int id = basins.ids.data()[i];
        if (id >= 0 && !outside[id]) filled.data()[i] = 1;
    }
    filled = unpad(fill_holes(filled), margin); // background that the rooms cut off
    for (std::size_t i = 0; i < filled.size(); ++i) filled.data()[i] &= ink.data()[i] ^ 1;
    return filled;
}

} // namespace pantin
