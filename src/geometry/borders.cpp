// SPDX-License-Identifier: MIT
// Border following after Suzuki & Abe, "Topological structural analysis of digitized binary images by border
// following", 1985, Algorithm 1 and Appendix I, with the paper's names: f the picture, NBD the number of the
// border that is being followed, LNBD that of the border last met on the row.
#include "pantin/geometry.hpp"

#include <array>
#include <cmath>
#include <cstring>

namespace pantin {
namespace {

// The eight neighbours counterclockwise on the screen, from the east.
constexpr std::array<Point2i, 8> direction = {
    {{1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
constexpr int east = 0, west = 4;

// A pixel of f without the number of its border: 0, 1, or NBD > 1, or −NBD.
enum : std::uint8_t { zero, one, positive, negative };

// f with a frame of zeros, so that no neighbour lies outside. Numbers of borders are kept for the pixels that
// have one: in a list for each row, and of the row that is looked at in its places.
class Picture {
public:
    explicit Picture(const Mask& mask)
        : stride_(mask.width() + 2), f_(stride_ * (static_cast<std::size_t>(mask.height()) + 2)),
          first_(static_cast<std::size_t>(mask.height()), none), last_(first_), numbers_(stride_) {
        for (int y = 0; y < mask.height(); ++y) {
            const std::uint8_t* const from = mask.row(y);
            std::uint8_t* const to = row(y);
            for (int x = 0; x < mask.width(); ++x) to[x] = from[x] != 0;
        }
        for (int d = 0; d < 16; ++d)
            offset_[d] = direction[d % 8].y * static_cast<std::ptrdiff_t>(stride_) + direction[d % 8].x;
    }
    std::uint8_t* row(int y) { return f_.data() + (static_cast<std::size_t>(y) + 1) * stride_ + 1; }
    // To the neighbour in direction d mod 8, d < 16.
    std::ptrdiff_t offset(int d) const { return offset_[d]; }

    // From here on nbd() answers for this row.
    void look_at(int y) {
        row_ = y;
        for (int i = first_[y]; i != none; i = marks_[i].next) numbers_[marks_[i].x] = marks_[i].nbd;
    }
    // |f| of a pixel that was marked, in the row that is looked at.
    int nbd(int x) const { return numbers_[x]; }
    void mark(Point2i place, std::uint8_t* pixel, std::uint8_t value, int nbd) {
        *pixel = value;
        if (place.y == row_) {
            numbers_[place.x] = nbd;
            return;
        }
        const int mark = static_cast<int>(marks_.size());
        marks_.push_back({place.x, nbd, none});
        (first_[place.y] == none ? first_[place.y] : marks_[last_[place.y]].next) = mark;
        last_[place.y] = mark;
    }

private:
    static constexpr int none = -1;
    struct Mark {
        int x, nbd, next;
    };
    std::size_t stride_;
    std::vector<std::uint8_t> f_;
    std::vector<Mark> marks_;
    std::vector<int> first_, last_; // of each row
    std::vector<int> numbers_;
    int row_ = -1;
    std::array<std::ptrdiff_t, 16> offset_{};
};

// Step 3: follows the border that starts at `start`, the pixel `place` of the mask, with the zero pixel in
// direction `from`, marks its pixels in f with ±nbd (negative where the pixel's eastern neighbour is outside)
// and returns them in picture coordinates.
std::vector<Point2i> follow(Picture& f, std::uint8_t* start, Point2i place, int from, int nbd) {
    // (3.1) clockwise from the zero pixel: the first nonzero neighbour, where the border will close.
    int d = from;
    do d = (d + 7) & 7;
    while (d != from && start[f.offset(d)] == zero);
    if (d == from) { // a single pixel
        f.mark(place, start, negative, nbd);
        return {place};
    }
    std::vector<Point2i> border;
    const std::uint8_t* const last = start + f.offset(d);
    for (std::uint8_t* p = start;;) {
        // (3.3) counterclockwise from the pixel we came from: the next pixel of the border.
        const int back = d;
        for (d = back + 1; p[f.offset(d)] == zero;) ++d;
        const bool east_is_outside = d > 8; // 8 is the east
        // (3.4)
        if (east_is_outside)
            f.mark(place, p, negative, nbd);
        else if (*p == one)
            f.mark(place, p, positive, nbd);
        border.push_back(place);
        // (3.5)
        d &= 7;
        std::uint8_t* const next = p + f.offset(d);
        if (next == start && p == last) return border;
        p = next;
        place.x += direction[d].x;
        place.y += direction[d].y;
        d = (d + 4) & 7;
    }
}

// The first pixel from `from` on that is not zero, or `end`.
std::uint8_t* skip_zeros(std::uint8_t* from, const std::uint8_t* end) {
    for (std::uint64_t word = 0; end - from >= 8; from += 8) {
        std::memcpy(&word, from, sizeof word);
        if (word) break;
    }
    while (from != end && *from == zero) ++from;
    return from;
}

} // namespace

std::vector<Border> follow_borders(const Mask& mask) {
    Picture f(mask);
    std::vector<Border> borders; // number NBD = index + 2; 1 is the frame, which counts as a hole's border
    const auto start_border = [&](std::uint8_t* pixel, Point2i place, bool outer, int lnbd) {
        // Step 2, Table 1: the parent is the last border met, or that one's parent when both are of a kind.
        const int met = lnbd - 2;
        const bool met_outer = met >= 0 && borders[met].outer;
        Border border;
        border.outer = outer;
        border.parent = met < 0 || met_outer != outer ? met : borders[met].parent;
        border.points = follow(f, pixel, place, outer ? west : east, static_cast<int>(borders.size()) + 2);
        borders.push_back(std::move(border));
    };
    for (int y = 0; y < mask.height(); ++y) {
        f.look_at(y);
        std::uint8_t* const row = f.row(y);
        std::uint8_t* const end = row + mask.width();
        const auto place = [&](const std::uint8_t* pixel) {
            return Point2i{static_cast<int>(pixel - row), y};
        };
        // A border starts at the first pixel of a run of nonzero ones (an outer one) or at its last pixel (a
        // hole's); both have a number once the run is behind us.
        int lnbd = 1;
        for (std::uint8_t* first = skip_zeros(row, end); first != end;) {
            const bool outer = *first == one;
            if (outer) start_border(first, place(first), true, lnbd);
            auto* const after = static_cast<std::uint8_t*>(std::memchr(
                first, zero, static_cast<std::size_t>(end + 1 - first))); // the frame at the latest
            std::uint8_t* const last = after - 1;
            if (*last != negative && !(outer && last == first)) {
                std::uint8_t* met = last; // Step 4: the last pixel of the run that has a number
                while (*met == one) --met;
                start_border(last, place(last), false, f.nbd(place(met).x));
            }
            lnbd = f.nbd(place(last).x);
            first = skip_zeros(after, end);
        }
    }
    return borders;
}

double closed_length(const std::vector<Point2i>& border) {
    // Counted in whole steps, so that the sum does not depend on where the border starts.
    long straight = 0, diagonal = 0;
    for (std::size_t i = 0; i < border.size(); ++i) {
        const Point2i a = border[i], b = border[i + 1 < border.size() ? i + 1 : 0];
        const int steps = std::abs(a.x - b.x) + std::abs(a.y - b.y);
        straight += steps == 1;
        diagonal += steps == 2;
    }
    return static_cast<double>(straight) + static_cast<double>(diagonal) * std::sqrt(2.0);
}

} // namespace pantin
