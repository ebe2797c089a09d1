// SPDX-License-Identifier: MIT
// Scenes: characters on the ground and in the sky with a sun, a house, grass and words around them. The kind
// of scene and a seed in; the page and its truth, which holds the characters only, out.
#include <algorithm>
#include <cmath>

#include "doodle/canvas.hpp"
#include "doodle/composition.hpp"
#include "doodle/looks.hpp"
#include "doodle/things.hpp"
#include "pantin/error.hpp"

namespace pantin::doodle {
namespace {

struct Area {
    double x = 0, y = 0, width = 1, height = 1;
};

// Upright in the middle of the area, standing on its lower edge.
void stand(Figure& figure, const Area& area, bool mirrored, bool stretched = false) {
    double x0 = 1e9, y0 = 1e9, x1 = -1e9, y1 = -1e9;
    for (const Part& part : figure.parts) {
        if (part.kind == PartKind::mark || part.within >= 0) continue;
        for (Point2d p : part.outline.points)
            x0 = std::min(x0, p.x), x1 = std::max(x1, p.x), y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
    }
    double sx = area.width / std::max(1e-6, x1 - x0), sy = area.height / std::max(1e-6, y1 - y0);
    if (!stretched) sx = sy = std::min(sx, sy);
    const double centre = area.x + 0.5 * area.width, foot = area.y + area.height, side = mirrored ? -1 : 1;
    for (Part& part : figure.parts)
        for (Point2d& p : part.outline.points)
            p = {centre + side * sx * (p.x - 0.5 * (x0 + x1)), foot + sy * (p.y - y1)};
}

std::string facing(const Figure& figure, bool mirrored) {
    if (std::abs(direction(figure.heading).x) < 0.5) return "S";
    return (direction(figure.heading).x > 0) != mirrored ? "E" : "W";
}

class Scene {
public:
    Scene(Composition& page, Random& random, Random& varied, const Hand& hand, const DoodleOptions& options)
        : page_(page), r_(random), varied_(varied), options_(options), hand_(hand), width_(options.width),
          height_(options.height), ground_(height_ * random.uniform(0.76, 0.9)) {}

    void draw(bool animals) {
        const int count = r_.integer(2, 4);
        for (int i = 0; i < count; ++i) columns_.push_back(animals ? "quadruped" : "humanoid");
        if (!animals && r_.chance(0.45))
            columns_.push_back(r_.chance(0.6) ? "quadruped:dog" : "quadruped:cat");
        if (r_.chance(0.65)) columns_.push_back("thing:house");
        if (r_.chance(0.5)) columns_.push_back(r_.chance(0.7) ? "thing:tree" : "thing:fir");
        if (r_.chance(0.4)) columns_.push_back("thing:flower");
        if (r_.chance(0.15)) columns_.push_back(r_.chance(0.5) ? "thing:car" : "thing:table");
        r_.shuffle(columns_);
        if (r_.chance(0.2))
            thing("hill", {-0.05 * width_, ground_ - 0.3 * height_, 1.1 * width_, 0.3 * height_}, true);
        fill_sky();
        fill_columns();
        fill_ground();
        write();
        if (r_.chance(0.08))
            thing("frame", {0.015 * width_, 0.015 * height_, 0.97 * width_, 0.97 * height_}, true);
    }

private:
    void thing(const std::string& species, const Area& area, bool stretched = false,
               double widest_pen = 1e9) {
        Figure figure = build_thing(r_, species);
        stand(figure, area, figure.may_mirror && r_.chance(0.5), stretched);
        Hand hand = natural_hand(hand_, r_);
        hand.pen = std::max(1.1, std::min(hand.pen, widest_pen)); // small things with a pointed crayon
        page_.add_thing(figure, hand, r_);
    }

    void character(const std::string& what, const Area& area) {
        Figure figure = build_named(r_, options_.variety > 0.0 ? choose(what, varied_, options_) : what);
        const bool mirrored = r_.chance(0.5);
        const std::string pose = facing(figure, mirrored);
        stand(figure, area, mirrored);
        page_.add_character(figure, pose, hand_, r_);
    }

    // Sun in a corner, clouds, at times a bird.
    void fill_sky() {
        const double size = 0.22 * std::min(width_, height_);
        std::vector<int> slots = {1, 2};
        r_.shuffle(slots);
        const bool right = r_.chance(0.5);
        if (r_.chance(0.9)) {
            const double side = size * r_.uniform(0.7, 1.3),
                         out = r_.chance(0.4) ? r_.uniform(0.25, 0.5) * side : -0.08 * side;
            thing("sun", {right ? width_ - side + out : -out, -out, side, side});
        }
        const Area high{0, 0.03 * height_, 0.2 * width_, 0.8 * size};
        const auto slot = [&](int k) {
            Area area = high;
            area.x = (right ? 0.02 + 0.26 * (2 - k) : 0.28 + 0.26 * (k - 1)) * width_,
            area.y += r_.uniform(0, 0.03) * height_;
            return area;
        };
        if (r_.chance(0.3))
            character("flying:bird", slot(slots[0]));
        else if (r_.chance(0.5))
            thing(r_.chance(0.7) ? "cloud" : "heart", slot(slots[0]));
        if (r_.chance(0.5)) thing(r_.chance(0.8) ? "cloud" : "rainbow", slot(slots[1]));
    }

    // Who and what stands on the ground, from left to right, apart from each other.
    void fill_columns() {
        const auto share = [](const std::string& what) {
            return what == "thing:house"             ? 1.5
                   : what == "thing:flower"          ? 0.5
                   : what.rfind("quadruped", 0) == 0 ? 1.25
                                                     : 1.0;
        };
        double total = 0.0, x = 0.02 * width_;
        for (const std::string& what : columns_) total += share(what);
        const double tallest = ground_ - 0.24 * height_;
        for (const std::string& what : columns_) {
            const double width = 0.96 * width_ * share(what) / total;
            const bool small = what == "thing:flower" || what.find(':') != std::string::npos;
            const double height = tallest * (what == "thing:flower"        ? r_.uniform(0.3, 0.5)
                                             : what.rfind("thing", 0) == 0 ? r_.uniform(0.7, 1.0)
                                             : small                       ? r_.uniform(0.3, 0.5)
                                                                           : r_.uniform(0.5, 1.0));
            const double foot = ground_ + height_ * r_.uniform(-0.012, 0.012);
            const Area area{x + 0.05 * width, foot - height, 0.9 * width, height};
            if (what.rfind("thing:", 0) == 0)
                thing(what.substr(6), area);
            else
                character(what, area);
            x += width;
        }
    }

    // The line that everybody stands on: beneath the feet, at them, or through them.
    void fill_ground() {
        if (r_.chance(0.85)) {
            const double tall = height_ * r_.uniform(0.015, 0.045),
                         lower = r_.chance(0.4) ? r_.uniform(0.02, 0.05) : r_.uniform(0.0, 0.02);
            const double left = r_.chance(0.7) ? -0.01 : r_.uniform(0.02, 0.15),
                         right = r_.chance(0.7) ? 1.01 : r_.uniform(0.85, 0.98);
            const double foot = ground_ + height_ * lower + (r_.chance(0.5) ? tall : 0.4 * tall);
            thing("grass line", {left * width_, foot - tall, (right - left) * width_, tall}, true);
        }
        for (int i = r_.integer(-2, 3); i > 0; --i) {
            const double side = height_ * r_.uniform(0.03, 0.07), x = r_.uniform(0.02, 0.92) * width_;
            thing("grass tuft",
                  {x, std::min(height_ - side, ground_ + height_ * r_.uniform(0.03, 0.08)), side, side},
                  false, 0.08 * side);
        }
    }

    void write() {
        static const std::vector<std::string> kinds = {"word", "word", "sentence", "scrawl", "signature"};
        if (r_.chance(0.65)) {
            const double width = r_.uniform(0.2, 0.6) * width_, height = r_.uniform(0.04, 0.075) * height_;
            const double x = r_.uniform(0.03, 0.97) * (width_ - width);
            thing(r_.pick(kinds), {x, height_ * 0.985 - height, width, height}, false, 0.1 * height);
        }
        if (r_.chance(0.2)) {
            const double width = r_.uniform(0.15, 0.3) * width_, height = 0.05 * height_;
            thing(r_.pick(kinds), {0.5 * (width_ - width), 0.21 * height_, width, height}, false,
                  0.1 * height);
        }
    }

    Composition& page_;
    Random& r_;
    Random& varied_;
    const DoodleOptions& options_;
    const Hand& hand_;
    double width_, height_, ground_;
    std::vector<std::string> columns_;
};

} // namespace

const std::vector<std::string>& scene_kinds() {
    static const std::vector<std::string> kinds = {"family", "animals"};
    return kinds;
}

Page draw_scene(const std::string& kind, std::uint64_t seed, const DoodleOptions& options) {
    check_size(options);
    if (kind != "family" && kind != "animals") throw Error(ErrorKind::usage, "unknown scene '" + kind + "'");
    Random style = Random::stream(seed, 0), random = Random::stream(seed, 1), paper = Random::stream(seed, 2),
           look = Random::stream(seed, 3), varied = Random::stream(seed, 5);
    DoodleOptions pens = options; // pens for figures that are half as high as the page
    pens.width = static_cast<int>(0.7 * options.width), pens.height = static_cast<int>(0.7 * options.height);
    Hand hand = random_hand(style, pens);
    hand.gap *= 0.5;
    apply_look(options.look, hand, look);
    Composition page(options.width, options.height, hand.ground);
    Scene(page, random, varied, hand, options).draw(kind == "animals");
    print_lines(options.look, hand, page.ink, look);
    const Finish finish = random_finish(paper, options);
    page.page.picture = on_paper(page.ink, paper, finish);
    return std::move(page.page);
}

} // namespace pantin::doodle
