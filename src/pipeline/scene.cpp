// SPDX-License-Identifier: MIT
// Rigged characters and their page to one film: each moves in its place, over the page from which they are
// taken off and the holes filled in. Own.
#include "pipeline/scene.hpp"

#include <algorithm>
#include <cmath>

#include "core/thread_pool.hpp"
#include "formats/file_names.hpp"
#include "pantin/image.hpp"
#include "pipeline/film.hpp"
#include "pipeline/overrides.hpp"

namespace pantin {

namespace {

constexpr double wanted_seconds = 4; // of the loop
constexpr double on_the_spot = 0.3;  // heights of a figure
constexpr int rim = 2;               // pixels around a character that still hold some of its ink

struct Figure {
    const Rig& rig;
    const RgbaImage& texture;
    BoneAnimation animation;
    Box box;       // of the page
    int loops = 1; // of the animation in one loop of the scene
};

// The part of the frame in which a figure moves.
struct Place {
    int x = 0, y = 0; // frame pixels
    FrameRenderer renderer;
};

// The wanted one where there is such, else the first.
const BoneAnimation& animation_for(const std::vector<BoneAnimation>& all, const std::string& wanted) {
    for (const BoneAnimation& animation : all)
        if (animation.name == wanted) return animation;
    return all.front();
}

// A motion that goes a way, along the page or up, and would take the figure off the page, is played without
// that way.
BoneAnimation staying_on(const Page& page, const Box& box, const Character& c, BoneAnimation animation) {
    animation = as_filmed(std::move(animation));
    for (double Vec3::*along : {&Vec3::x, &Vec3::y}) {
        const auto [least, most] =
            std::minmax_element(animation.root_translation.begin(), animation.root_translation.end(),
                                [&](const Vec3& a, const Vec3& b) { return a.*along < b.*along; });
        if ((*most).*along - (*least).*along < on_the_spot) continue;
        const View reach = view_of(c.rig, {animation});
        const double middle = box.x + 0.5 * box.width, bottom = box.y + box.height;
        const bool stays = along == &Vec3::x
                               ? middle + box.height * reach.left >= 0 &&
                                     middle + box.height * (reach.left + reach.width) <= page.width
                               : bottom - box.height * (reach.bottom + reach.height) >= 0 &&
                                     bottom - box.height * reach.bottom <= page.height;
        if (stays) continue;
        for (Vec3& t : animation.root_translation) t.*along = 0;
    }
    return animation;
}

std::vector<Figure> moving_figures(const Page& page, const std::vector<Character>& characters,
                                   const std::string& clip) {
    std::vector<Figure> figures;
    for (std::size_t i = 0; i < characters.size(); ++i) {
        const Character& c = characters[i];
        if (page.characters[i].status != "ok" || c.reference.clips.empty()) continue;
        const Box& box = page.characters[i].box;
        figures.push_back(
            {c.rig, c.texture, staying_on(page, box, c, animation_for(c.animations, clip)), box});
    }
    return figures;
}

// The longest clip an entire number of times; the others as often as fits best, a little faster or slower.
double common_duration(std::vector<Figure>& figures) {
    double longest = 0;
    for (const Figure& figure : figures) longest = std::max(longest, figure.animation.duration);
    const double duration = longest * std::max(1.0, std::rint(wanted_seconds / longest));
    for (Figure& figure : figures)
        figure.loops = std::max(1, static_cast<int>(std::rint(duration / figure.animation.duration)));
    return duration;
}

// Where the figure gets to, on whole pixels of a frame that shows the page with so many pixels to a pixel of
// the page. In the figure's world one unit is the height of its box and the origin the middle of its lower
// edge.
Place place_of(const Figure& figure, double scale, RenderOptions picture) {
    const View reach = view_of(figure.rig, {figure.animation});
    const double unit = scale * figure.box.height;
    const double origin_x = scale * (figure.box.x + 0.5 * figure.box.width),
                 origin_y = scale * (figure.box.y + figure.box.height);
    const double left = std::floor(origin_x + unit * reach.left),
                 right = std::ceil(origin_x + unit * (reach.left + reach.width));
    const double top = std::floor(origin_y - unit * (reach.bottom + reach.height)),
                 bottom = std::ceil(origin_y - unit * reach.bottom);
    const View view{(left - origin_x) / unit, (origin_y - bottom) / unit, (right - left) / unit,
                    (bottom - top) / unit};
    picture.background = {0, 0, 0, 0};
    picture.perspective = false;
    picture.size = static_cast<int>(std::max(right - left, bottom - top));
    return {static_cast<int>(left), static_cast<int>(top),
            FrameRenderer(figure.rig, figure.texture, view, picture)};
}

std::vector<Vec3> pose_of(const Figure& figure, double share) {
    const double turns = share * figure.loops;
    return skin(figure.rig, figure.animation, (turns - std::floor(turns)) * figure.animation.duration);
}

void put_over(RgbaImage& picture, const RgbaImage& layer, int left, int top) {
    const auto mix = [](int above, int below, int alpha) {
        return static_cast<std::uint8_t>((above * alpha + below * (255 - alpha) + 127) / 255);
    };
    for (int y = 0; y < layer.height(); ++y)
        for (int x = 0; x < layer.width(); ++x) {
            const Rgba8 above = layer(x, y);
            if (above.a == 0 || !picture.contains(left + x, top + y)) continue;
            Rgba8& p = picture(left + x, top + y);
            p = {mix(above.r, p.r, above.a), mix(above.g, p.g, above.a), mix(above.b, p.b, above.a), 255};
        }
}

// Where a character is drawn, on a page of that size.
void mark(Mask& hole, const Figure& figure, const Page& page) {
    const double sx = static_cast<double>(page.width) / hole.width(),
                 sy = static_cast<double>(page.height) / hole.height();
    for (int y = 0; y < hole.height(); ++y)
        for (int x = 0; x < hole.width(); ++x) {
            const double u = ((x + 0.5) * sx - figure.box.x) / figure.box.width * figure.texture.width();
            const double v = ((y + 0.5) * sy - figure.box.y) / figure.box.height * figure.texture.height();
            const int column = static_cast<int>(std::floor(u)), row = static_cast<int>(std::floor(v));
            if (figure.texture.contains(column, row) && figure.texture(column, row).a > 0) hole(x, y) = 1;
        }
}

RgbaImage empty_paper(const RgbImage& drawn, const std::vector<Figure>& figures, const Page& page) {
    Mask hole(drawn.width(), drawn.height());
    for (const Figure& figure : figures) mark(hole, figure, page);
    const RgbImage filled = fill_in(drawn, dilate_square(hole, rim));
    RgbaImage paper(filled.width(), filled.height());
    for (std::size_t i = 0; i < paper.size(); ++i) {
        const Rgb8 p = filled.data()[i];
        paper.data()[i] = {p.r, p.g, p.b, 255};
    }
    return paper;
}

} // namespace

void render_scene(const RgbImage& page_picture, const std::filesystem::path& out, const Page& page,
                  const std::vector<Character>& characters, const Context& context) {
    const Settings& settings = context.settings();
    if (!wants_pictures(settings.render)) return;
    std::vector<Figure> figures = moving_figures(page, characters, settings.render.clip);
    if (figures.empty()) return;
    Film film = blank_film(common_duration(figures), settings.render.fps);
    const double scale =
        static_cast<double>(settings.render.picture.size) / std::max(page.width, page.height);
    const auto pixels = [&](int length) {
        return std::max(1, static_cast<int>(std::floor(scale * length + 0.5)));
    };
    const RgbImage drawn = resize(page_picture, pixels(page.width), pixels(page.height));
    const RgbaImage paper = empty_paper(drawn, figures, page);
    std::vector<Place> places;
    for (const Figure& figure : figures) places.push_back(place_of(figure, scale, settings.render.picture));
    parallel_for(settings.threads, static_cast<int>(film.frames.size()), [&](int frame) {
        const auto i = static_cast<std::size_t>(frame);
        const double share = static_cast<double>(i) / static_cast<double>(film.frames.size());
        RgbaImage picture = paper;
        for (std::size_t k = 0; k < figures.size(); ++k)
            put_over(picture, places[k].renderer(pose_of(figures[k], share)), places[k].x, places[k].y);
        film.frames[i] = std::move(picture);
    });
    write_film(film, out, file_names::scene, out / file_names::frames / file_names::scene, settings, true);
}

} // namespace pantin
