// SPDX-License-Identifier: MIT
// A flat page in, a photograph of it on a desk out: perspective, the desk's surface, shadow, a pencil.
#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "core/math.hpp"
#include "doodle/canvas.hpp"

namespace pantin::doodle {
namespace {

using math::pi;
using Corners = std::array<Point2d, 4>;

float shade(Random& r, double low, double high) { return static_cast<float>(r.uniform(low, high)); }

// The homography that takes the quadrilateral's corners to those of the unit square.
Eigen::Matrix3d to_unit_square(const Corners& quad) {
    static const Point2d unit_corners[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    Eigen::Matrix<double, 8, 8> a;
    Eigen::Matrix<double, 8, 1> b;
    for (int i = 0; i < 4; ++i) {
        const Point2d p = quad[static_cast<std::size_t>(i)], q = unit_corners[i];
        a.row(2 * i) << p.x, p.y, 1, 0, 0, 0, -q.x * p.x, -q.x * p.y;
        a.row(2 * i + 1) << 0, 0, 0, p.x, p.y, 1, -q.y * p.x, -q.y * p.y;
        b[2 * i] = q.x, b[2 * i + 1] = q.y;
    }
    const Eigen::Matrix<double, 8, 1> h = a.fullPivLu().solve(b);
    Eigen::Matrix3d out;
    out << h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], 1.0;
    return out;
}

// Turned, the far edge shorter than the near one, within the picture's inner 96 %.
Corners random_corners(Random& r, double aspect, int width, int height) {
    const double far = r.uniform(0.62, 0.95), skew = r.uniform(-0.12, 0.12), turn = r.uniform(-0.3, 0.3);
    const double flat = r.uniform(0.72, 1.0);
    Corners quad = {
        {{-far * aspect + skew, -flat}, {far * aspect + skew, -flat}, {aspect, flat}, {-aspect, flat}}};
    double x0 = 1e9, y0 = 1e9, x1 = -1e9, y1 = -1e9;
    for (Point2d& p : quad) {
        p = rotated(p, turn);
        x0 = std::min(x0, p.x), x1 = std::max(x1, p.x), y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
    }
    const double scale = r.uniform(0.72, 0.96) * std::min(width / (x1 - x0), height / (y1 - y0));
    const double left = r.uniform(0.2, 0.8) * (width - scale * (x1 - x0)),
                 top = r.uniform(0.2, 0.8) * (height - scale * (y1 - y0));
    for (Point2d& p : quad) p = {left + scale * (p.x - x0), top + scale * (p.y - y0)};
    return quad;
}

// Distance to the quadrilateral's border, positive outside (exact along its edges).
double outside_by(const Corners& quad, Point2d p) {
    double out = -1e9;
    for (std::size_t i = 0; i < 4; ++i) {
        const Point2d along = unit(quad[(i + 1) % 4] - quad[i]);
        out = std::max(out, cross(p - quad[i], along));
    }
    return out;
}

double smooth_noise(double x, double y, std::uint64_t seed) {
    const double fx = std::floor(x), fy = std::floor(y), tx = x - fx, ty = y - fy;
    const int cx = static_cast<int>(fx), cy = static_cast<int>(fy);
    const double top = pixel_noise(cx, cy, seed) * (1 - tx) + pixel_noise(cx + 1, cy, seed) * tx;
    const double low = pixel_noise(cx, cy + 1, seed) * (1 - tx) + pixel_noise(cx + 1, cy + 1, seed) * tx;
    return top * (1 - ty) + low * ty;
}

// The top of the desk: wood with its grain, one plain dark colour, or a woven cloth.
class Surface {
public:
    Surface(Random& r, double size) : kind_(r.integer(0, 2)), size_(size), seed_(r.next()) {
        const float light = shade(r, 0.45, 1.0);
        along_ = direction(r.uniform(0, pi));
        if (kind_ == 0) colour_ = {light * 200, light * 150, light * 100};
        if (kind_ == 1) colour_ = {shade(r, 25, 80), shade(r, 25, 80), shade(r, 25, 85)};
        if (kind_ == 2) colour_ = {shade(r, 60, 210), shade(r, 60, 200), shade(r, 60, 200)};
        pitch_ = size * r.uniform(0.004, 0.01);
        check_ = r.chance(0.4) ? size * r.uniform(0.05, 0.12) : 0.0;
    }

    Colour at(double x, double y) const {
        const Point2d p{x, y};
        const double u = dot(p, along_), v = cross(along_, p);
        double value = 1.0;
        if (kind_ == 0) {
            const double bend = 0.03 * size_ * smooth_noise(u / (0.3 * size_), v / (0.15 * size_), seed_);
            value = 0.8 + 0.3 * smooth_noise(u / (0.25 * size_), (v + bend) / (0.006 * size_), seed_ + 1) +
                    0.1 * smooth_noise(u / (0.05 * size_), (v + bend) / (0.0025 * size_), seed_ + 2) - 0.1;
            const double plank = v / (0.22 * size_),
                         seam = std::abs(plank - std::floor(plank + 0.5)) * 0.22 * size_;
            if (seam < 0.0015 * size_) value *= 0.55;
        } else if (kind_ == 1) {
            value = 0.94 + 0.12 * smooth_noise(x / (0.02 * size_), y / (0.02 * size_), seed_);
        } else {
            value = 0.92 + 0.05 * math::sin(2 * pi * u / pitch_) + 0.05 * math::sin(2 * pi * v / pitch_);
            if (check_ > 0.0)
                value *= 1.0 - 0.25 * ((static_cast<long>(std::floor(u / check_)) & 1) != 0) -
                         0.2 * ((static_cast<long>(std::floor(v / check_)) & 1) != 0);
        }
        Colour out = colour_;
        for (float& c : out) c = std::clamp(c * static_cast<float>(value), 0.0f, 255.0f);
        return out;
    }

private:
    int kind_;
    double size_, pitch_ = 1, check_ = 0;
    std::uint64_t seed_;
    Point2d along_{1, 0};
    Colour colour_{};
};

void paint_over(Grid<Colour>& view, const Path& outline, const Colour& colour, float strength = 1.0f) {
    const Patch<float> cover = cover_polygon(outline, view.width(), view.height());
    for (int y = 0; y < cover.box.height; ++y)
        for (int x = 0; x < cover.box.width; ++x)
            for (std::size_t k = 0; k < 3; ++k) {
                float& c = view(cover.box.x + x, cover.box.y + y)[k];
                c += strength * cover.values(x, y) * (colour[k] - c);
            }
}

Path strip(Point2d a, Point2d b, double half) {
    const Point2d along = unit(b - a), side{-half * along.y, half * along.x};
    return {a + side, b + side, b - side, a - side};
}

void draw_pencil(Grid<Colour>& view, Random& r, Point2d from, Point2d to, double half) {
    const Colour paint{shade(r, 20, 250), shade(r, 20, 220), shade(r, 20, 220)};
    const Point2d along = unit(to - from), side{-half * along.y, half * along.x},
                  neck = to - (4.0 * half) * along;
    paint_over(view,
               strip(from + Point2d{0.6 * half, 0.9 * half}, to + Point2d{0.6 * half, 0.9 * half}, half),
               {0, 0, 0}, 0.35f);
    paint_over(view, strip(from, neck, half), paint);
    paint_over(view, strip(from, neck, 0.3 * half), {255, 255, 255}, 0.2f);
    paint_over(view, {neck + side, to, neck - side}, {225, 190, 145});
    paint_over(view, {to - (1.3 * half) * along + 0.33 * side, to, to - (1.3 * half) * along - 0.33 * side},
               paint);
}

void draw_coin(Grid<Colour>& view, Random& r, Point2d centre, double radius) {
    const float grey = shade(r, 120, 210);
    paint_over(view, ellipse(centre + Point2d{0.1 * radius, 0.15 * radius}, radius, 0.9 * radius), {0, 0, 0},
               0.35f);
    paint_over(view, ellipse(centre, radius, 0.9 * radius), {grey, 0.9f * grey, 0.65f * grey});
    paint_over(view, ellipse(centre, 0.82 * radius, 0.72 * radius), {0.9f * grey, 0.8f * grey, 0.55f * grey});
}

// Pencils and coins where the sheet is not.
void add_objects(Grid<Colour>& view, Random& r, const Corners& quad) {
    const int w = view.width(), h = view.height();
    const double size = std::min(w, h);
    for (int i = r.integer(0, 3); i > 0; --i) {
        const bool coin = r.chance(0.25);
        const double half = size * r.uniform(0.006, 0.012), length = coin ? 0.0 : size * r.uniform(0.25, 0.5);
        for (int attempt = 0; attempt < 30; ++attempt) {
            const Point2d a{r.uniform(0, w), r.uniform(0, h)},
                b = a + length * direction(r.uniform(0, 2 * pi));
            double nearest = 1e9;
            for (int k = 0; k <= 8; ++k) nearest = std::min(nearest, outside_by(quad, mix(a, b, k / 8.0)));
            if (nearest < 4.0 * half) continue;
            if (coin)
                draw_coin(view, r, a, 2.5 * half);
            else
                draw_pencil(view, r, a, b, half);
            break;
        }
    }
}

Colour sample(const RgbImage& picture, double x, double y) {
    x = std::clamp(x, 0.0, picture.width() - 1.0), y = std::clamp(y, 0.0, picture.height() - 1.0);
    const int x0 = std::min(static_cast<int>(x), picture.width() - 2),
              y0 = std::min(static_cast<int>(y), picture.height() - 2);
    const float tx = static_cast<float>(x - x0), ty = static_cast<float>(y - y0);
    const Rgb8 a = picture(x0, y0), b = picture(x0 + 1, y0), c = picture(x0, y0 + 1),
               d = picture(x0 + 1, y0 + 1);
    const auto mixed = [&](int p, int q, int s, int t) {
        return (1 - ty) * ((1 - tx) * p + tx * q) + ty * ((1 - tx) * s + tx * t);
    };
    return {mixed(a.r, b.r, c.r, d.r), mixed(a.g, b.g, c.g, d.g), mixed(a.b, b.b, c.b, d.b)};
}

// Boxes of the instances as the photograph shows them.
void renew_boxes(Page& page) {
    for (std::size_t i = 0; i < page.characters.size(); ++i) {
        LabelMap own(page.instances.width(), page.instances.height());
        for (std::size_t k = 0; k < own.size(); ++k) own.data()[k] = page.instances.data()[k] == i + 1;
        page.characters[i].box = label_box(own);
    }
    page.things.clear(); // their boxes were the flat page's
}

} // namespace

DoodleOptions sheet_options(const DoodleOptions& options) {
    DoodleOptions sheet = options;
    const bool across = options.width >= options.height;
    const int longer = std::max(91, std::max(options.width, options.height) * 4 / 5),
              shorter = longer * 1000 / 1414;
    sheet.width = across ? longer : shorter, sheet.height = across ? shorter : longer;
    sheet.photo = 0.0;
    return sheet;
}

DeskPhoto on_desk(const Page& flat, std::uint64_t seed, int width, int height) {
    Random r = Random::stream(seed, 4);
    const int fw = flat.picture.width(), fh = flat.picture.height();
    DeskPhoto photo;
    photo.corners = random_corners(r, static_cast<double>(fw) / fh, width, height);
    photo.page.characters = flat.characters;
    photo.page.labels = LabelMap(width, height), photo.page.instances = GreyImage(width, height);
    const Surface surface(r, std::min(width, height));
    Grid<Colour> view(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) view(x, y) = surface.at(x, y);
    add_objects(view, r, photo.corners);
    const Eigen::Matrix3d map = to_unit_square(photo.corners);
    const double depth = r.uniform(0.25, 0.6), reach = std::min(width, height) * r.uniform(0.004, 0.02);
    const Point2d fall = reach * direction(r.uniform(0, 2 * pi));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Point2d p{static_cast<double>(x), static_cast<double>(y)};
            const double out = outside_by(photo.corners, p);
            const float cover = static_cast<float>(std::clamp(0.5 - out, 0.0, 1.0));
            const double shadow = std::clamp(0.5 - outside_by(photo.corners, p - fall) / reach, 0.0, 1.0);
            Colour& there = view(x, y);
            if (cover < 1.0f)
                for (float& c : there) c *= static_cast<float>(1.0 - depth * shadow);
            if (cover <= 0.0f) continue;
            const Eigen::Vector3d q = map * Eigen::Vector3d(p.x, p.y, 1.0);
            const double fx = q[0] / q[2] * fw - 0.5, fy = q[1] / q[2] * fh - 0.5;
            const Colour sheet = sample(flat.picture, fx, fy);
            for (std::size_t k = 0; k < 3; ++k) there[k] += cover * (sheet[k] - there[k]);
            const int ix = static_cast<int>(std::floor(fx + 0.5)),
                      iy = static_cast<int>(std::floor(fy + 0.5));
            photo.page.labels(x, y) = flat.labels.value_or(ix, iy, 0);
            photo.page.instances(x, y) = flat.instances.value_or(ix, iy, 0);
        }
    renew_boxes(photo.page);
    photo.page.picture = under_camera(std::move(view), r);
    return photo;
}

} // namespace pantin::doodle
