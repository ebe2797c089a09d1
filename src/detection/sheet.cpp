// SPDX-License-Identifier: MIT
// The quadrilateral of a sheet in a photograph: bright regions at several thresholds, the quadrilateral
// around each one's convex hull, the one whose sides are edges; then a homography. Based on: Z. Zhang, L. He:
// Whiteboard scanning and image enhancement. Digital Signal Processing 17, 2007.
#include "pantin/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace {

constexpr int searched_size = 512;     // longer side of the picture on which the sheet is searched
constexpr int refined_size = 2048;     // … and on which its sides are placed
constexpr double least_area = 0.25;    // of the picture
constexpr double most_area = 0.94;     // beyond, the picture is the sheet
constexpr double least_solidity = 0.9; // of the region in its hull: ink may cut into it
constexpr double least_fit = 0.93;     // of the hull in the quadrilateral
constexpr double least_contrast = 0.1; // of the sheet's brightness, from inside to outside of a side
constexpr double least_edge = 0.6;     // of a side's places have it
constexpr double least_sine = 0.6;     // of a corner's angle: 37° to 143°
constexpr double least_opposite = 0.4; // of the length of the opposite side
// Focal lengths in longer sides of the picture. The main camera of a telephone: 26 mm to a frame of 36 mm.
constexpr double usual_focal = 0.75, nearest_focal = 0.4, farthest_focal = 4;
constexpr double least_perspective =
    0.004; // product of the two sides' perspective that tells the focal length
constexpr double longest_ratio = 4;
constexpr double margin = 0.006; // of the sheet's sides that is cut off: its edge and its shadow

double area_of(const std::vector<Point2d>& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    return std::abs(twice) / 2;
}

// The smallest channel: paper is white, desks are dark or coloured.
GreyImage whiteness(const RgbImage& picture) {
    GreyImage out(picture.width(), picture.height());
    std::transform(picture.begin(), picture.end(), out.begin(), [](Rgb8 p) {
        return std::min({p.r, p.g, p.b});
    });
    return out;
}

RgbImage reduced(const RgbImage& picture, int longer) {
    const int side = std::max(picture.width(), picture.height());
    if (side <= longer) return picture;
    const double scale = static_cast<double>(longer) / side;
    return resize(picture, std::max(1, static_cast<int>(picture.width() * scale + 0.5)),
                  std::max(1, static_cast<int>(picture.height() * scale + 0.5)));
}

// Andrew's monotone chain, of the first and last pixel of each row; clockwise on y-down pixels.
std::vector<Point2d> convex_hull(const Mask& region) {
    std::vector<Point2d> points;
    for (int y = 0; y < region.height(); ++y) {
        int first = -1, last = -1;
        for (int x = 0; x < region.width(); ++x)
            if (region(x, y)) first = first < 0 ? x : first, last = x;
        if (first < 0) continue;
        points.push_back({1.0 * first, 1.0 * y});
        if (last > first) points.push_back({1.0 * last, 1.0 * y});
    }
    std::sort(points.begin(), points.end(),
              [](Point2d a, Point2d b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    std::vector<Point2d> hull;
    for (const bool upper : {false, true}) {
        const std::size_t start = hull.size();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Point2d p = upper ? points[points.size() - 1 - i] : points[i];
            while (hull.size() >= start + 2 &&
                   cross(hull[hull.size() - 1] - hull[hull.size() - 2], p - hull[hull.size() - 2]) <= 0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
    }
    return hull;
}

std::optional<Point2d> intersection(Point2d a, Point2d b, Point2d c, Point2d d) {
    const double denominator = cross(b - a, d - c);
    if (std::abs(denominator) < 1e-9) return std::nullopt;
    return a + (cross(c - a, d - c) / denominator) * (b - a);
}

// Leaves out, again and again, the side whose neighbours meet with the least area added, until four are left.
std::vector<Point2d> enclosing_quadrilateral(std::vector<Point2d> hull) {
    while (hull.size() > 4) {
        const std::size_t n = hull.size();
        double least = -1;
        std::size_t chosen = n;
        Point2d corner;
        for (std::size_t i = 0; i < n; ++i) { // the side from i to i + 1
            const Point2d before = hull[(i + n - 1) % n], from = hull[i], to = hull[(i + 1) % n],
                          after = hull[(i + 2) % n];
            // They meet beyond the side only if they turn by less than half a circle.
            if (cross(from - before, after - to) <= 1e-9) continue;
            const std::optional<Point2d> meet = intersection(before, from, to, after);
            if (!meet) continue;
            const double added = std::abs(cross(to - from, *meet - from)) / 2;
            if (least < 0 || added < least) least = added, chosen = i, corner = *meet;
        }
        if (chosen == n) return {};
        hull[chosen] = corner;
        hull.erase(hull.begin() + static_cast<std::ptrdiff_t>((chosen + 1) % n));
    }
    return hull.size() == 4 ? hull : std::vector<Point2d>();
}

// Top left first (smallest x + y), then clockwise.
SheetCorners in_order(const std::vector<Point2d>& corners) {
    std::vector<Point2d> sorted = corners;
    Point2d centre;
    for (Point2d c : corners) centre = centre + 0.25 * c;
    std::sort(sorted.begin(), sorted.end(), [&](Point2d a, Point2d b) {
        return math::atan2(a.y - centre.y, a.x - centre.x) < math::atan2(b.y - centre.y, b.x - centre.x);
    });
    const auto first = std::min_element(sorted.begin(), sorted.end(),
                                        [](Point2d a, Point2d b) { return a.x + a.y < b.x + b.y; });
    std::rotate(sorted.begin(), first, sorted.end());
    return {sorted[0], sorted[1], sorted[2], sorted[3]};
}

// Outwards, of length one, of the side from a to b of a clockwise polygon.
Point2d normal_of(Point2d a, Point2d b) {
    const Point2d along = b - a;
    const double l = std::max(1e-9, length(along));
    return {along.y / l, -along.x / l};
}

// Per side, the share of its places that have the sheet inside and something darker or more colourful
// outside; 0 where the picture ends there.
std::array<double, 4> edges_of(const GreyImage& white, const SheetCorners& corners) {
    const int longer = std::max(white.width(), white.height());
    std::array<double, 4> shares{};
    for (std::size_t s = 0; s < 4; ++s) {
        const Point2d a = corners[s], b = corners[(s + 1) % 4], out = normal_of(a, b);
        int count = 0, edges = 0;
        for (int i = 1; i < 32; ++i) {
            const Point2d p = a + (i / 32.0) * (b - a);
            for (const double step : {0.012, 0.02, 0.03}) {
                const Point2d in = p - step * longer * out, beyond = p + step * longer * out;
                const int x0 = static_cast<int>(std::floor(in.x)), y0 = static_cast<int>(std::floor(in.y)),
                          x1 = static_cast<int>(std::floor(beyond.x)),
                          y1 = static_cast<int>(std::floor(beyond.y));
                if (!white.contains(x0, y0) || !white.contains(x1, y1)) continue;
                ++count;
                edges += white(x0, y0) - white(x1, y1) >= least_contrast * white(x0, y0);
            }
        }
        if (count >= 16) shares[s] = static_cast<double>(edges) / count;
    }
    return shares;
}

// A rectangle seen from a place that a photograph is taken from.
bool is_possible(const SheetCorners& corners) {
    for (std::size_t s = 0; s < 4; ++s) {
        const Point2d side = corners[(s + 1) % 4] - corners[s], before = corners[(s + 3) % 4] - corners[s],
                      opposite = corners[(s + 2) % 4] - corners[(s + 3) % 4];
        const double sine = std::abs(cross(side, before)) / std::max(1e-9, length(side) * length(before));
        if (sine < least_sine || length(side) < least_opposite * length(opposite)) return false;
    }
    return true;
}

struct Candidate {
    SheetCorners corners;
    double score; // how well region, quadrilateral and edges agree
};

double pixels_of(const Mask& mask) { return static_cast<double>(std::count(mask.begin(), mask.end(), 1)); }

// The quadrilateral of the largest bright region at this threshold.
std::optional<Candidate> sheet_at(const GreyImage& white, int threshold) {
    Mask bright(white.width(), white.height());
    std::transform(white.begin(), white.end(), bright.begin(),
                   [&](std::uint8_t v) -> std::uint8_t { return v >= threshold; });
    const auto pixels = static_cast<double>(white.size());
    const Mask opened = open_disc(bright, 1.5), core = largest_component(opened);
    // Closing and filling only add to it, and no other region can become larger: the usual drawing on white.
    if (2 * pixels_of(core) > pixels && pixels_of(fill_holes(core)) > most_area * pixels) return std::nullopt;
    const Mask region = fill_holes(largest_component(close_disc(opened, 3)));
    const double area = pixels_of(region);
    if (area < 0.9 * least_area * pixels || area > most_area * pixels) return std::nullopt;
    const std::vector<Point2d> hull = convex_hull(region);
    const double hull_area = area_of(hull);
    if (hull.size() < 4 || area < least_solidity * hull_area) return std::nullopt;
    const std::vector<Point2d> four = enclosing_quadrilateral(hull);
    if (four.empty() || hull_area < least_fit * area_of(four)) return std::nullopt;
    const double covered = area_of(four) / pixels;
    if (covered < least_area || covered > most_area) return std::nullopt;
    for (Point2d c : four)
        if (c.x < -0.05 * white.width() || c.y < -0.05 * white.height() || c.x > 1.05 * white.width() ||
            c.y > 1.05 * white.height())
            return std::nullopt;
    const SheetCorners corners = in_order(four);
    if (!is_possible(corners)) return std::nullopt;
    const std::array<double, 4> edges = edges_of(white, corners);
    if (std::count_if(edges.begin(), edges.end(), [](double e) { return e >= least_edge; }) < 3)
        return std::nullopt;
    const double edge = (edges[0] + edges[1] + edges[2] + edges[3]) / 4;
    return Candidate{corners, area / area_of(four) * edge};
}

// The line of a side by least squares through the steepest places near it; the side itself where there are
// few.
std::pair<Point2d, Point2d> refined_side(const GreyImage& white, Point2d a, Point2d b) {
    constexpr int samples = 64;
    const double reach = 0.012 * std::max(white.width(), white.height());
    const Point2d out = normal_of(a, b);
    std::vector<Point2d> places; // along the side 0 … 1, distance outwards
    for (int i = 2; i < samples - 1; ++i) {
        const Point2d p = a + (static_cast<double>(i) / samples) * (b - a);
        int steepest = 12; // levels
        double at = 2 * reach;
        for (double t = -reach; t <= reach; t += 0.5) {
            const auto value = [&](double d) {
                const Point2d q = p + d * out;
                const int x = static_cast<int>(std::floor(q.x + 0.5)),
                          y = static_cast<int>(std::floor(q.y + 0.5));
                return white.contains(x, y) ? static_cast<int>(white(x, y)) : -1;
            };
            const int inside = value(t - 2), outside = value(t + 2);
            if (inside < 0 || outside < 0) continue;
            if (inside - outside > steepest) steepest = inside - outside, at = t;
        }
        if (at <= reach) places.push_back({static_cast<double>(i) / samples, at});
    }
    if (places.size() < samples / 4) return {a, b};
    // Pencils and ink lie across the edge at places: the median line first, then what is near it.
    std::vector<double> offsets;
    for (Point2d p : places) offsets.push_back(p.y);
    std::nth_element(offsets.begin(), offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2),
                     offsets.end());
    const double median = offsets[offsets.size() / 2];
    double n = 0, su = 0, sv = 0, suu = 0, suv = 0;
    for (Point2d p : places) {
        if (std::abs(p.y - median) > reach / 3) continue;
        ++n, su += p.x, sv += p.y, suu += p.x * p.x, suv += p.x * p.y;
    }
    const double determinant = n * suu - su * su;
    if (n < samples / 8.0 || determinant < 1e-9) return {a, b};
    const double slope = (n * suv - su * sv) / determinant, offset = (sv - slope * su) / n;
    return {a + offset * out, b + (offset + slope) * out};
}

SheetCorners refined(const GreyImage& white, const SheetCorners& corners) {
    std::array<std::pair<Point2d, Point2d>, 4> sides;
    for (std::size_t s = 0; s < 4; ++s) sides[s] = refined_side(white, corners[s], corners[(s + 1) % 4]);
    SheetCorners out = corners;
    for (std::size_t s = 0; s < 4; ++s) {
        const auto& [a, b] = sides[(s + 3) % 4];
        const auto& [c, d] = sides[s];
        if (const std::optional<Point2d> meet = intersection(a, b, c, d)) out[s] = *meet;
    }
    return out;
}

// --- homography ------------------------------------------------------------------------------------------

// From the unit square (0, 0), (1, 0), (1, 1), (0, 1) to the corners (Heckbert 1989, section 2.2.2).
struct Homography {
    double a = 1, b = 0, c = 0, d = 0, e = 1, f = 0, g = 0, h = 0;
    Point2d at(double u, double v) const {
        const double w = g * u + h * v + 1;
        return {(a * u + b * v + c) / w, (d * u + e * v + f) / w};
    }
};

Homography from_unit_square(const SheetCorners& p) {
    const Point2d d1 = p[1] - p[2], d2 = p[3] - p[2], s = p[0] - p[1] + p[2] - p[3];
    Homography m;
    const double denominator = cross(d1, d2);
    m.g = cross(s, d2) / denominator;
    m.h = cross(d1, s) / denominator;
    m.a = p[1].x - p[0].x + m.g * p[1].x, m.b = p[3].x - p[0].x + m.h * p[3].x, m.c = p[0].x;
    m.d = p[1].y - p[0].y + m.g * p[1].y, m.e = p[3].y - p[0].y + m.h * p[3].y, m.f = p[0].y;
    return m;
}

// Width over height of the sheet. The camera's axis goes through the picture's middle; its focal length
// follows from the perspective. From straight above a side nothing follows: then it is a telephone's.
double aspect_ratio(const SheetCorners& p, Point2d middle) {
    SheetCorners q = p;
    for (Point2d& c : q) c = c - middle;
    const Homography m = from_unit_square(q);
    const double longer = 2 * std::max(middle.x, middle.y);
    // The images of the sides' directions, (a, d, g) and (b, e, h), are at right angles in space.
    const double gh = m.g * m.h;
    double focal = std::abs(gh) < least_perspective ? 0 : -(m.a * m.b + m.d * m.e) / gh;
    focal = focal > 0 ? std::sqrt(focal) : 0;
    if (focal < nearest_focal * longer || focal > farthest_focal * longer) focal = usual_focal * longer;
    const double width = m.a * m.a + m.d * m.d + m.g * m.g * focal * focal,
                 height = m.b * m.b + m.e * m.e + m.h * m.h * focal * focal;
    return std::clamp(std::sqrt(width / height), 1 / longest_ratio, longest_ratio);
}

std::uint8_t mixed(double a, double b, double c, double d, double fx, double fy) {
    return static_cast<std::uint8_t>(
        std::floor((1 - fy) * ((1 - fx) * a + fx * b) + fy * ((1 - fx) * c + fx * d) + 0.5));
}

Rgb8 sample(const RgbImage& picture, Point2d p) {
    const double x = std::clamp(p.x, 0.0, picture.width() - 1.0),
                 y = std::clamp(p.y, 0.0, picture.height() - 1.0);
    const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
    const int x1 = std::min(x0 + 1, picture.width() - 1), y1 = std::min(y0 + 1, picture.height() - 1);
    const Rgb8 a = picture(x0, y0), b = picture(x1, y0), c = picture(x0, y1), d = picture(x1, y1);
    const double fx = x - x0, fy = y - y0;
    return {mixed(a.r, b.r, c.r, d.r, fx, fy), mixed(a.g, b.g, c.g, d.g, fx, fy),
            mixed(a.b, b.b, c.b, d.b, fx, fy)};
}

} // namespace

std::optional<SheetCorners> find_sheet(const RgbImage& picture) {
    if (std::min(picture.width(), picture.height()) < 64) return std::nullopt;
    const GreyImage white = whiteness(reduced(picture, searched_size));
    std::optional<Candidate> best;
    for (int threshold = 40; threshold <= 230; threshold += 10)
        if (const std::optional<Candidate> found = sheet_at(white, threshold);
            found && (!best || found->score > best->score))
            best = found;
    if (!best) return std::nullopt;
    const GreyImage fine = whiteness(reduced(picture, refined_size));
    const double up = static_cast<double>(fine.width()) / white.width(),
                 rest = static_cast<double>(picture.width()) / fine.width();
    SheetCorners corners = best->corners;
    for (Point2d& c : corners) c = up * c;
    corners = refined(fine, corners);
    for (Point2d& c : corners) c = rest * c;
    return corners;
}

RgbImage flattened(const RgbImage& picture, const SheetCorners& corners) {
    const double ratio = aspect_ratio(corners, {picture.width() / 2.0, picture.height() / 2.0});
    const double across = std::max(length(corners[1] - corners[0]), length(corners[2] - corners[3])),
                 down = std::max(length(corners[3] - corners[0]), length(corners[2] - corners[1]));
    const double width = std::max(across, down * ratio), height = width / ratio;
    const double shrink = std::min(1.0, max_image_side / std::max(width, height));
    RgbImage sheet(std::max(min_image_side, static_cast<int>(shrink * width + 0.5)),
                   std::max(min_image_side, static_cast<int>(shrink * height + 0.5)));
    const Homography m = from_unit_square(corners);
    const double scale = 1 - 2 * margin;
    for (int y = 0; y < sheet.height(); ++y)
        for (int x = 0; x < sheet.width(); ++x)
            sheet(x, y) = sample(picture, m.at(margin + scale * (x + 0.5) / sheet.width(),
                                               margin + scale * (y + 0.5) / sheet.height()));
    return sheet;
}

} // namespace pantin
