// SPDX-License-Identifier: MIT
// Ruled lines: found by a Hough transform of a few directions, taken out run by run, as forms are cleaned of
// their lines. Based on: R. O. Duda, P. E. Hart: Use of the Hough transformation to detect lines and curves
// in pictures. CACM 15, 1972; B. Yu, A. K. Jain: A generic system for form dropout. PAMI 18, 1996.
#include "image/ruling.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pantin {

namespace {

constexpr int searched_size = 1024; // longer side of the grid on which lines are searched
constexpr double steepest = 0.06;   // slope against the page's sides
// A line is this much darker than both of its sides; lines as dark as possible are looked for first, so that
// what is left of a shadow does not lie between them.
constexpr float line_contrasts[] = {0.32f, 0.16f, 0.08f, 0.04f};
constexpr double long_line = 0.5;   // of the page's side are covered by a line,
constexpr double stretch = 0.1;     // in stretches of at least this length
constexpr int longest_break = 4;    // with no more between two places,
constexpr double across_page = 0.8; // from its first to its last place,
constexpr double known_line = 0.25; // or so much where the spacing says that one is due
constexpr int fewest_lines = 3;
constexpr double even_spacing = 0.15; // of the pitch
constexpr double evenly_spaced = 0.6; // least share of the gaps that are one or two pitches

// The page with x along the lines: as it is, or transposed.
template <class T> class Along {
public:
    Along(Grid<T>& grid, bool transposed) : grid_(grid), transposed_(transposed) {}
    int length() const { return transposed_ ? grid_.height() : grid_.width(); }
    int breadth() const { return transposed_ ? grid_.width() : grid_.height(); }
    T& operator()(int x, int y) const { return transposed_ ? grid_(y, x) : grid_(x, y); }
    // From a pixel to the next one of its column, in elements.
    std::ptrdiff_t step() const { return transposed_ ? 1 : grid_.width(); }
    // Calls visit(x, y, pixel) for all pixels as they lie in memory.
    template <class Visit> void for_each(const Visit& visit) const {
        for (int v = 0; v < grid_.height(); ++v) {
            const T* const row = grid_.row(v);
            for (int u = 0; u < grid_.width(); ++u) transposed_ ? visit(v, u, row[u]) : visit(u, v, row[u]);
        }
    }

private:
    Grid<T>& grid_;
    bool transposed_;
};

struct Place {
    int x, y;
};

// Where a pixel is darker than both sides, in pixels of the searched grid.
std::vector<Place> ridges(const Along<float>& page, int factor, float contrast) {
    const int reach = std::max(4, std::max(page.length(), page.breadth()) / 100);
    const int length = (page.length() + factor - 1) / factor,
              breadth = (page.breadth() + factor - 1) / factor;
    Mask found(breadth, length);
    const std::ptrdiff_t across = reach * page.step();
    page.for_each([&](int x, int y, const float& at) {
        const float d = at - contrast;
        if (d <= 0) return;
        if ((y < reach || (&at)[-across] <= d) && (y + reach >= page.breadth() || (&at)[across] <= d))
            found(y / factor, x / factor) = 1;
    });
    std::vector<Place> places;
    for (int x = 0; x < length; ++x)
        for (int y = 0; y < breadth; ++y)
            if (found(y, x)) places.push_back({x, y});
    return places; // column by column
}

// A line y = offset + slope · (x − length / 2) in the searched grid.
int offset_of(const Place& p, double slope, int length) {
    return static_cast<int>(std::floor(p.y - slope * (p.x - 0.5 * length) + 0.5));
}

// Per offset, the number of columns in which the line, three pixels thick, has a ridge, in stretches that are
// long enough for a line; 0 where it does not go on from one side of the page to the other. (The trousers of
// figures in a row are many short stretches.)
std::vector<int> coverage(const std::vector<Place>& places, double slope, int length, int breadth) {
    struct Line {
        int columns = 0, first = -1, last = -1, start = -1;
    };
    std::vector<Line> lines(static_cast<std::size_t>(breadth));
    const auto end_stretch = [&](Line& line) {
        if (line.start >= 0 && line.last - line.start + 1 >= stretch * length)
            line.columns += line.last - line.start + 1;
    };
    for (const Place& p : places) {
        const int middle = offset_of(p, slope, length);
        for (int o = std::max(0, middle - 1); o <= std::min(breadth - 1, middle + 1); ++o) {
            Line& line = lines[static_cast<std::size_t>(o)];
            if (line.last == p.x) continue;
            if (line.first < 0) line.first = p.x;
            if (line.start < 0 || p.x - line.last > longest_break) end_stretch(line), line.start = p.x;
            line.last = p.x;
        }
    }
    std::vector<int> columns;
    for (Line& line : lines) {
        end_stretch(line);
        columns.push_back(line.last - line.first >= across_page * length ? line.columns : 0);
    }
    return columns;
}

// Middles of the runs of offsets that are covered at least half as much as they must be, where the run has
// one that is covered so much: a thick line is one line.
std::vector<int> peaks_of(const std::vector<int>& columns, int least) {
    std::vector<int> peaks;
    const int n = static_cast<int>(columns.size());
    for (int o = 0; o < n; ++o) {
        const int first = o;
        int most = 0;
        for (; o < n && 2 * columns[static_cast<std::size_t>(o)] >= least; ++o)
            most = std::max(most, columns[static_cast<std::size_t>(o)]);
        if (most >= least) peaks.push_back((first + o - 1) / 2);
    }
    return peaks;
}

// The pitch of evenly spaced offsets; 0: they are not.
double pitch_of(const std::vector<int>& offsets) {
    if (offsets.size() < static_cast<std::size_t>(fewest_lines)) return 0;
    std::vector<int> gaps;
    for (std::size_t i = 1; i < offsets.size(); ++i) gaps.push_back(offsets[i] - offsets[i - 1]);
    std::vector<int> sorted = gaps;
    std::sort(sorted.begin(), sorted.end());
    const double pitch = sorted[sorted.size() / 2];
    std::size_t even = 0;
    for (int gap : gaps)
        even += std::abs(gap - pitch) <= std::max(1.0, even_spacing * pitch) ||
                std::abs(gap - 2 * pitch) <= std::max(1.0, even_spacing * pitch);
    return static_cast<double>(even) >= evenly_spaced * static_cast<double>(gaps.size()) ? pitch : 0;
}

struct Ruling {
    double slope = 0;
    std::vector<int> offsets;
};

// The direction in which the lines stand out most (the sum of squares of a projection is largest where it is
// sharpest), and its evenly spaced lines.
Ruling find_ruling(const std::vector<Place>& places, int length, int breadth) {
    if (places.empty() || places.back().x - places.front().x < across_page * length) return {};
    const int steps = static_cast<int>(steepest * length);
    double best = -1;
    Ruling ruling;
    for (int step = -steps; step <= steps; ++step) {
        const double slope = static_cast<double>(step) / length;
        std::vector<int> counts(static_cast<std::size_t>(breadth), 0);
        for (const Place& p : places)
            if (const int o = offset_of(p, slope, length); o >= 0 && o < breadth)
                ++counts[static_cast<std::size_t>(o)];
        double squares = 0;
        for (int c : counts) squares += static_cast<double>(c) * c;
        if (squares > best) best = squares, ruling.slope = slope;
    }
    const std::vector<int> columns = coverage(places, ruling.slope, length, breadth);
    const std::vector<int> sure = peaks_of(columns, static_cast<int>(long_line * length));
    const double pitch = pitch_of(sure);
    if (pitch == 0) return ruling;
    for (int offset : peaks_of(columns, static_cast<int>(known_line * length))) {
        const bool due = std::any_of(sure.begin(), sure.end(), [&](int s) {
            const double pitches = (offset - s) / pitch;
            return std::abs(pitches - std::floor(pitches + 0.5)) * pitch <=
                   std::max(1.0, even_spacing * pitch);
        });
        if (due) ruling.offsets.push_back(offset);
    }
    return ruling;
}

struct Run {
    int x, top, bottom; // rows of the line in this column
};

// The line's run of dark pixels in every column that has one near where it should be.
std::vector<Run> runs_of(const Along<float>& page, const Ruling& ruling, int offset, int factor,
                         float contrast) {
    std::vector<Run> runs;
    const int breadth = page.breadth(), reach = factor + 2;
    for (int x = 0; x < page.length(); ++x) {
        const double searched = offset + ruling.slope * ((x + 0.5) / factor - 0.5 * page.length() / factor);
        const int due = static_cast<int>(std::floor((searched + 0.5) * factor));
        int peak = -1;
        float most = contrast;
        for (int y = std::max(0, due - reach); y <= std::min(breadth - 1, due + reach); ++y)
            if (page(x, y) > most) most = page(x, y), peak = y;
        if (peak < 0) continue;
        Run run{x, peak, peak};
        while (run.top > 0 && page(x, run.top - 1) >= 0.4f * most) --run.top;
        while (run.bottom + 1 < breadth && page(x, run.bottom + 1) >= 0.4f * most) ++run.bottom;
        runs.push_back(run);
    }
    return runs;
}

// The lower quartile: where nothing crosses them.
int line_thickness(const std::vector<std::vector<Run>>& lines) {
    std::vector<int> thickness;
    for (const std::vector<Run>& runs : lines)
        for (const Run& run : runs) thickness.push_back(run.bottom - run.top + 1);
    if (thickness.empty()) return 0;
    const auto quartile = thickness.begin() + static_cast<std::ptrdiff_t>(thickness.size() / 4);
    std::nth_element(thickness.begin(), quartile, thickness.end());
    return *quartile;
}

void erase(const Along<float>& page, const std::vector<Run>& runs, int thickness) {
    const int thickest = thickness + thickness / 2 + 1;
    const int rim = 1; // the blurred edge
    for (const Run& run : runs) {
        if (run.bottom - run.top + 1 > thickest) continue; // something crosses here
        const int above = run.top - rim - 1, below = run.bottom + rim + 1;
        const float upper = above >= 0 ? page(run.x, above) : 0;
        const float lower = below < page.breadth() ? page(run.x, below) : 0;
        for (int y = std::max(0, above + 1); y <= std::min(page.breadth() - 1, below - 1); ++y)
            page(run.x, y) = std::min(page(run.x, y), std::min(upper, lower));
    }
}

// Takes out the lines of one direction.
void remove_lines(const Along<float>& page, int factor, float contrast) {
    const int length = (page.length() + factor - 1) / factor,
              breadth = (page.breadth() + factor - 1) / factor;
    const Ruling ruling = find_ruling(ridges(page, factor, contrast), length, breadth);
    std::vector<std::vector<Run>> lines;
    for (int offset : ruling.offsets) lines.push_back(runs_of(page, ruling, offset, factor, contrast));
    const int thickness = line_thickness(lines);
    for (const std::vector<Run>& runs : lines) erase(page, runs, thickness);
}

} // namespace

void remove_ruling(Grid<float>& distance) {
    const int longer = std::max(distance.width(), distance.height());
    const int factor = std::max(1, (longer + searched_size - 1) / searched_size);
    for (const bool transposed : {false, true})
        for (const float contrast : line_contrasts)
            remove_lines(Along<float>(distance, transposed), factor, contrast);
}

} // namespace pantin
