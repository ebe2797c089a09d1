// SPDX-License-Identifier: MIT
// How a line gets onto the paper: wobble, overshoot, gaps, pressure, grain.
#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "doodle/canvas.hpp"

namespace pantin::doodle {

double pixel_noise(int x, int y, std::uint64_t seed) {
    std::uint64_t z = seed + 0x9e3779b97f4a7c15u * static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) +
                      0xc2b2ae3d27d4eb4fu * static_cast<std::uint64_t>(static_cast<std::uint32_t>(y));
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
}

namespace {

void blend(Colour& pixel, const Colour& colour, double alpha) {
    for (std::size_t c = 0; c < 3; ++c) pixel[c] += static_cast<float>(alpha) * (colour[c] - pixel[c]);
}

// The share of ink that the tooth of the paper takes at a pixel.
double tooth(int x, int y, double grain) {
    if (grain <= 0.0) return 1.0;
    const double coarse = pixel_noise(x >> 1, y >> 1, 77), fine = pixel_noise(x, y, 78);
    return std::clamp(1.0 - grain * (1.6 * (0.5 * coarse + 0.5 * fine) - 0.25), 0.0, 1.0);
}

// The line displaced sideways by slow and fast noise; its ends run over or stop short.
Path by_hand(const Path& line, const Hand& hand, Random& random) {
    Path path = hand.corners > 0.0 ? simplify(line, hand.corners) : line;
    const double total = path_length(path);
    path = resample(path, 1.5);
    const Waver slow(random, std::clamp(static_cast<int>(total / 60.0), 1, 6)),
        fast(random, std::clamp(static_cast<int>(total / 9.0), 2, 24), 0.3);
    const double amplitude = hand.wobble * std::min(1.0, total / 40.0);
    const Point2d drift{0.4 * hand.wobble * random.normal(), 0.0};
    const Point2d shift{drift.x, 0.4 * hand.wobble * random.normal()};
    Path out;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Point2d along = unit(path[std::min(i + 1, path.size() - 1)] - path[i > 0 ? i - 1 : 0]);
        const double t = static_cast<double>(i) / path.size();
        const double offset = amplitude * slow(0.8 * t) + hand.tremor * fast(0.9 * t);
        out.push_back(path[i] + shift + offset * Point2d{-along.y, along.x});
    }
    const auto lengthen = [&](Point2d end, Point2d inner, double by) { return end + by * unit(end - inner); };
    const double first = hand.overshoot * random.normal() * 0.6,
                 last = hand.overshoot * random.normal() * 0.6;
    if (out.size() > 8) {
        if (first > 0)
            out.insert(out.begin(), lengthen(out.front(), out[3], first));
        else
            out.erase(out.begin(), out.begin() + std::min<long>(3, static_cast<long>(-first / 1.5)));
        if (last > 0)
            out.push_back(lengthen(out.back(), out[out.size() - 4], last));
        else
            out.resize(out.size() - static_cast<std::size_t>(std::min(3.0, -last / 1.5)));
    }
    return out;
}

void lay_ink(Layer& layer, const Path& path, const Hand& hand, const Colour& colour, double width,
             Random& random, std::uint8_t label) {
    const Waver pressure(random, 4);
    std::vector<double> radius;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const double t = (i + 0.5) / path.size(), end = std::min(t, 1.0 - t) * 2.0;
        const double thin = 1.0 - hand.taper * (1.0 - std::min(1.0, 4.0 * end));
        radius.push_back(
            std::max(0.35, 0.5 * hand.pen * width * thin * (1.0 + hand.pressure * pressure(0.9 * t))));
    }
    const Patch<float> cover = cover_line(path, radius, layer.ink.width(), layer.ink.height());
    for (int y = 0; y < cover.box.height; ++y)
        for (int x = 0; x < cover.box.width; ++x) {
            const float c = cover.values(x, y);
            if (c <= 0.0f) continue;
            const int px = cover.box.x + x, py = cover.box.y + y;
            blend(layer.ink(px, py), colour, c * hand.opacity * tooth(px, py, hand.grain));
            if (c > 0.5f && layer.labels(px, py) == 0) layer.labels(px, py) = label;
        }
}

// The line as strokes that nearly meet, or as dashes; a short one as it is.
std::vector<Path> broken(const Path& whole, const Hand& hand, Random& random) {
    const double total = path_length(whole);
    const bool dashed = hand.dash > 0.0 && total > 2.0 * hand.dash;
    if (!dashed && !(total > 25.0 && hand.open > 0.0 && random.chance(hand.open))) return {whole};
    const int count = dashed ? static_cast<int>(total / hand.dash) : random.integer(2, 4);
    const double n = static_cast<double>(whole.size());
    std::vector<Path> pieces;
    double from = 0.0;
    for (int i = 0; i < count; ++i) {
        const double to = i + 1 == count ? 1.0 : (i + 1 + random.uniform(-0.25, 0.25)) / count;
        const double gap = dashed ? 0.4 / count : random.uniform(-0.02, 0.07);
        const long a = static_cast<long>(n * from),
                   b = static_cast<long>(n * std::clamp(to - gap, from, 1.0));
        pieces.push_back(
            Path(whole.begin() + a, whole.begin() + std::min<long>(b, static_cast<long>(whole.size()))));
        from = to;
    }
    return pieces;
}

} // namespace

void ink_line(Layer& layer, const Path& line, const Hand& hand, const Colour& colour, double width,
              Random& random, std::uint8_t label) {
    if (line.size() < 2) return;
    const double total = path_length(line);
    std::vector<Path> pieces = {resample(line, 1.5)};
    if (total > 25.0 && random.chance(hand.gap)) { // the pen was lifted
        const Path whole = pieces.front();
        const std::size_t n = whole.size(), hole = static_cast<std::size_t>(n * random.uniform(0.03, 0.16));
        const std::size_t at = static_cast<std::size_t>(n * random.uniform(0.1, 0.8));
        pieces = {Path(whole.begin(), whole.begin() + static_cast<long>(at)),
                  Path(whole.begin() + static_cast<long>(std::min(n - 1, at + hole)), whole.end())};
    }
    if (hand.open > 0.0 || hand.dash > 0.0) {
        std::vector<Path> shorter;
        for (const Path& piece : pieces)
            for (Path& part : broken(piece, hand, random)) shorter.push_back(std::move(part));
        pieces = std::move(shorter);
    }
    for (const Path& piece : pieces) {
        if (piece.size() < 2) continue;
        lay_ink(layer, by_hand(piece, hand, random), hand, colour, width, random, label);
        if (!random.chance(hand.again)) continue;
        Hand loose = hand;
        loose.wobble *= 2.0;
        for (int i = 0; i < hand.strokes; ++i)
            lay_ink(layer, by_hand(piece, loose, random), loose, colour, width, random, label);
    }
}

void fill_ink(Layer& layer, const Path& outline, const Hand& hand, const Colour& colour) {
    const Patch<float> cover = cover_polygon(outline, layer.ink.width(), layer.ink.height());
    for (int y = 0; y < cover.box.height; ++y)
        for (int x = 0; x < cover.box.width; ++x) {
            const int px = cover.box.x + x, py = cover.box.y + y;
            blend(layer.ink(px, py), colour, cover.values(x, y) * hand.opacity * tooth(px, py, hand.grain));
        }
}

void colour_in(Layer& layer, const Grid<std::uint8_t>& where, const Box& area, const Hand& hand,
               const Colour& colour, Random& random) {
    Grid<float> amount(area.width, area.height,
                       hand.filling == Filling::hatched ? 0.0f
                       : hand.solid                     ? 1.0f
                                                        : static_cast<float>(random.uniform(0.6, 1.0)));
    if (hand.filling == Filling::hatched) { // to and fro with a thick crayon, a little over the border
        const double angle = random.uniform(0.0, math::pi),
                     pitch = hand.hatch * hand.pen * random.uniform(0.9, 1.8),
                     reach = 0.6 * (area.width + area.height);
        const Point2d along = direction(angle), across{-along.y, along.x},
                      centre{area.x + 0.5 * area.width, area.y + 0.5 * area.height};
        Path zigzag;
        for (double s = -reach; s < reach; s += pitch)
            zigzag.push_back(centre + s * across + ((zigzag.size() % 2 ? 1 : -1) * reach) * along);
        const Patch<float> cover =
            cover_line(zigzag, std::vector<double>(zigzag.size(), 0.5 * hand.pen * random.uniform(0.8, 1.3)),
                       layer.ink.width(), layer.ink.height());
        for (int y = 0; y < area.height; ++y)
            for (int x = 0; x < area.width; ++x) amount(x, y) = 0.85f * cover.at(area.x + x, area.y + y);
    }
    const double grain = hand.filling == Filling::flat ? 0.0 : hand.filling == Filling::hatched ? 0.35 : 0.22;
    for (int y = 0; y < area.height; ++y)
        for (int x = 0; x < area.width; ++x) {
            const int px = area.x + x, py = area.y + y;
            if (where(px, py)) blend(layer.ink(px, py), colour, amount(x, y) * tooth(px, py, grain));
        }
}

} // namespace pantin::doodle
