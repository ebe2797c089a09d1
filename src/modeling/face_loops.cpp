// SPDX-License-Identifier: MIT
// Loops in a triangle in, triangles out: ears are cut (Meisters 1975).
#include "modeling/face_loops.hpp"

#include <algorithm>
#include <tuple>

#include "geometry/wide_integer.hpp"

namespace pantin {
namespace {

using Loop = std::vector<LoopCorner>;

bool same_place(const LoopCorner& a, const LoopCorner& b) { return a.x == b.x && a.y == b.y; }

WideInteger twice_area(const LoopCorner& a, const LoopCorner& b, const LoopCorner& c) {
    return WideInteger(b.x - a.x) * WideInteger(c.y - a.y) - WideInteger(b.y - a.y) * WideInteger(c.x - a.x);
}
int turn(const LoopCorner& a, const LoopCorner& b, const LoopCorner& c) {
    const WideInteger area = twice_area(a, b, c);
    return (area > WideInteger(0)) - (area < WideInteger(0));
}
double square(const LoopCorner& a, const LoopCorner& b) {
    const double x = static_cast<double>(b.x - a.x), y = static_cast<double>(b.y - a.y);
    return x * x + y * y;
}

bool is_hole(const Loop& loop) {
    WideInteger sum(0);
    for (std::size_t i = 0; i < loop.size(); ++i)
        sum = sum + twice_area(loop[0], loop[i], loop[(i + 1) % loop.size()]);
    return sum < WideInteger(0);
}

// Whether the way from a loop's corner to another point begins on the left of the loop.
bool leaves_inwards(const Loop& loop, std::size_t i, const LoopCorner& to) {
    const LoopCorner &at = loop[i], &before = loop[(i + loop.size() - 1) % loop.size()],
                     &after = loop[(i + 1) % loop.size()];
    const bool left_of_after = turn(at, after, to) > 0, left_of_before = turn(before, at, to) > 0;
    return turn(before, at, after) >= 0 ? left_of_after && left_of_before : left_of_after || left_of_before;
}

bool crosses(const LoopCorner& a, const LoopCorner& b, const LoopCorner& p, const LoopCorner& q) {
    if (same_place(a, p) || same_place(a, q) || same_place(b, p) || same_place(b, q)) return false;
    return turn(a, b, p) * turn(a, b, q) <= 0 && turn(p, q, a) * turn(p, q, b) <= 0;
}

// Joins a hole to a border by a way there and back.
void join(std::vector<Loop>& borders, const Loop& hole, const std::vector<Loop>& holes) {
    std::vector<std::tuple<double, int, int, int>> ways; // length, border, corner, hole's corner
    for (int b = 0; b < std::ssize(borders); ++b)
        for (int i = 0; i < std::ssize(borders[b]); ++i)
            for (int k = 0; k < std::ssize(hole); ++k)
                ways.emplace_back(square(borders[b][i], hole[k]), b, i, k);
    std::sort(ways.begin(), ways.end());
    const auto is_free = [&](const auto& way) {
        const auto& [length, b, i, k] = way;
        const LoopCorner &from = borders[b][i], &to = hole[k];
        if (!leaves_inwards(borders[b], i, to) || !leaves_inwards(hole, k, from)) return false;
        for (const std::vector<Loop>* loops :
             std::initializer_list<const std::vector<Loop>*>{&borders, &holes})
            for (const Loop& loop : *loops)
                for (std::size_t c = 0; c < loop.size(); ++c)
                    if (crosses(from, to, loop[c], loop[(c + 1) % loop.size()])) return false;
        return true;
    };
    auto best = std::find_if(ways.begin(), ways.end(), is_free);
    if (best == ways.end()) best = ways.begin(); // of loops that rounding has folded
    const auto [length, b, i, k] = *best;
    Loop joined(borders[b].begin(), borders[b].begin() + i + 1);
    for (int c = 0; c <= std::ssize(hole); ++c) joined.push_back(hole[(k + c) % hole.size()]);
    joined.insert(joined.end(), borders[b].begin() + i, borders[b].end());
    borders[b] = joined;
}

class EarCutter {
public:
    explicit EarCutter(const Loop& loop) : loop_(loop), worth_(loop.size()) {}

    void cut(std::vector<std::array<int, 3>>& triangles) {
        for (std::size_t i = 0; i < loop_.size(); ++i) worth_[i] = worth(i, 0);
        while (loop_.size() > 3) {
            std::size_t best = most_worth();
            // When no corner is an ear, ever less is asked of one: of loops that rounding has folded.
            for (int lax = 1; worth_[best] < 0 && lax <= 3; ++lax) {
                for (std::size_t i = 0; i < loop_.size(); ++i) worth_[i] = worth(i, lax == 1 ? 0 : lax - 1);
                best = most_worth();
            }
            emit(best, triangles);
            loop_.erase(loop_.begin() + static_cast<std::ptrdiff_t>(best));
            worth_.erase(worth_.begin() + static_cast<std::ptrdiff_t>(best));
            const std::size_t after = best % loop_.size(), before = (best + loop_.size() - 1) % loop_.size();
            worth_[after] = worth(after, 0), worth_[before] = worth(before, 0);
        }
        emit(1, triangles);
    }

private:
    const LoopCorner& before(std::size_t i) const { return loop_[(i + loop_.size() - 1) % loop_.size()]; }
    const LoopCorner& after(std::size_t i) const { return loop_[(i + 1) % loop_.size()]; }
    std::size_t most_worth() const {
        return static_cast<std::size_t>(std::max_element(worth_.begin(), worth_.end()) - worth_.begin());
    }
    void emit(std::size_t i, std::vector<std::array<int, 3>>& triangles) const {
        triangles.push_back({before(i).vertex, loop_[i].vertex, after(i).vertex});
    }
    // How well shaped the ear is, 1 at most; negative: the corner is none. lax 1: others may lie in it; 2: it
    // may be turned over.
    double worth(std::size_t i, int lax) const {
        const LoopCorner &a = before(i), &b = loop_[i], &c = after(i);
        if ((a.edges & c.edges) != 0 || a.vertex == c.vertex) return -1;
        if (lax < 2 && turn(a, b, c) <= 0) return -1;
        if (lax < 1)
            for (const LoopCorner& p : loop_)
                if (p.vertex != a.vertex && p.vertex != b.vertex && p.vertex != c.vertex &&
                    turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0)
                    return -1;
        const double longest = std::max({square(a, b), square(b, c), square(c, a)});
        return longest > 0 ? std::max(0.0, static_cast<double>(twice_area(a, b, c)) / longest) : 0;
    }

    Loop loop_;
    std::vector<double> worth_;
};

} // namespace

std::vector<std::array<int, 3>> fill_loops(std::vector<Loop> loops) {
    std::vector<Loop> borders, holes;
    for (Loop& loop : loops) (is_hole(loop) ? holes : borders).push_back(std::move(loop));
    if (borders.empty()) borders.swap(holes);
    for (const Loop& hole : holes) join(borders, hole, holes);
    std::vector<std::array<int, 3>> triangles;
    for (const Loop& border : borders) EarCutter(border).cut(triangles);
    return triangles;
}

} // namespace pantin
