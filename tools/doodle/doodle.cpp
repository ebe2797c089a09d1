// SPDX-License-Identifier: MIT
// A seed and options in, drawings and pages with their truth out.
#include "doodle/doodle.hpp"

#include <algorithm>
#include <cmath>

#include "doodle/canvas.hpp"
#include "doodle/composition.hpp"
#include "doodle/looks.hpp"
#include "doodle/species.hpp"
#include "doodle/things.hpp"
#include "pantin/error.hpp"

namespace pantin::doodle {
namespace {

const std::vector<std::string>& common_species(const std::string& type) {
    static const std::vector<std::string> people = {"person", "person", "stick person", "teddy"},
                                          animals = {"cat", "dog", "cow", "horse", "sheep", "pig"},
                                          birds = {"bird", "gull",      "standing bird",
                                                   "duck", "butterfly", "bat"};
    return type == "humanoid" ? people : type == "quadruped" ? animals : birds;
}

const std::string& checked(const std::vector<std::string>& species, const std::string& name,
                           const std::string& type) {
    if (std::find(species.begin(), species.end(), name) == species.end())
        throw Error(ErrorKind::usage, "no species '" + name + "' of type " + type);
    return name;
}

Figure build_figure(Random& random, const std::string& type, const std::string& wanted) {
    const std::vector<std::string> species = species_of(type), more = varied_species(type);
    if (std::find(more.begin(), more.end(), wanted) != more.end()) return build_varied(random, type, wanted);
    if (type == "other")
        return build_varied(random, type,
                            wanted.empty() ? random.pick(species) : checked(species, wanted, type));
    if (species.empty()) return build_decoy(random, type);
    if (type == "thing")
        return build_thing(random, wanted.empty() ? random.pick(species) : checked(species, wanted, type));
    // Half of the drawings are of what people draw most.
    const std::string common = random.pick(common_species(type)), any = random.pick(species);
    const std::string& drawn = random.chance(0.5) ? common : any;
    const std::string& name = wanted.empty() ? drawn : wanted;
    checked(species, name, type);
    if (type == "humanoid") return build_humanoid(random, name);
    if (type == "quadruped") return build_quadruped(random, name);
    return build_flyer(random, name);
}

} // namespace

void check_size(const DoodleOptions& options) {
    if (options.width < 64 || options.height < 64)
        throw Error(ErrorKind::usage, "a doodle is at least 64 pixels wide and high");
}

Figure build_named(Random& random, const std::string& what) {
    const std::size_t colon = what.find(':');
    return build_figure(random, what.substr(0, colon),
                        colon == std::string::npos ? "" : what.substr(colon + 1));
}

std::string choose(const std::string& what, Random& varied, const DoodleOptions& options) {
    if (what.find(':') != std::string::npos) return what;
    if (!options.species.empty()) return what + ":" + options.species;
    if (options.variety <= 0.0 || varied_species(what).empty() || !varied.chance(options.variety))
        return what;
    return what + ":" + pick_varied(varied, what);
}

namespace {

struct Drawn {
    Layer layer;
    Character character;
};

Drawn draw_alone(const std::string& what, Random& random, Random& varied, const Hand& hand,
                 const DoodleOptions& options) {
    Figure figure = build_named(random, choose(what, varied, options));
    const std::string type = figure.type;
    const int margin = std::max(4, static_cast<int>(1.5 * hand.pen + hand.overshoot));
    Box area{margin, margin, options.width - 2 * margin, options.height - 2 * margin};
    if (options.variety > 0.0 && varied.chance(0.04 * options.variety)) // cut by the paper's border
        area.x += static_cast<int>(varied.uniform(-0.12, 0.12) * options.width),
            area.y += static_cast<int>(varied.uniform(-0.12, 0.12) * options.height);
    Drawn drawn;
    drawn.character.type = type;
    drawn.character.species = figure.species;
    drawn.character.pose = place_figure(figure, random, area, options);
    drawn.layer = draw_figure(figure, type == "thing" ? natural_hand(hand, random) : hand, random,
                              options.width, options.height);
    drawn.character.box = label_box(drawn.layer.labels);
    drawn.character.limbs = drawn.layer.limbs;
    return drawn;
}

} // namespace

const std::vector<std::string>& character_types() {
    static const std::vector<std::string> types = {"humanoid", "quadruped", "flying"};
    return types;
}

std::vector<std::string> species_of(const std::string& type) {
    if (type == "humanoid") return humanoid_species();
    if (type == "quadruped") return quadruped_species();
    if (type == "flying") return flyer_species();
    if (type == "other") return varied_species(type);
    if (type == "thing") return thing_species();
    if (type == "head" || type == "blob" || type == "scribble") return {};
    throw Error(ErrorKind::usage, "unknown type of doodle '" + type + "'");
}

Doodle draw_character(const std::string& type, std::uint64_t seed, const DoodleOptions& options) {
    check_size(options);
    Random style = Random::stream(seed, 0), figure = Random::stream(seed, 1), paper = Random::stream(seed, 2),
           look = Random::stream(seed, 3), varied = Random::stream(seed, 5);
    Hand hand = random_hand(style, options);
    if (varied.chance(options.variety)) vary_hand(hand, varied, options);
    apply_look(options.look, hand, look);
    Drawn drawn = draw_alone(type, figure, varied, hand, options);
    Doodle doodle;
    static_cast<Character&>(doodle) = drawn.character;
    print_lines(options.look, hand, drawn.layer.ink, look);
    const Finish finish = random_finish(paper, options);
    doodle.picture = on_paper(drawn.layer.ink, paper, finish);
    doodle.labels = std::move(drawn.layer.labels);
    return doodle;
}

Page draw_page(const std::vector<std::string>& types, std::uint64_t seed, const DoodleOptions& options) {
    check_size(options);
    const int count = std::max(1, static_cast<int>(types.size()));
    // The grid whose cells are most nearly square.
    int columns = 1;
    double best = 1e9;
    for (int c = 1; c <= count; ++c) {
        const int rows = (count + c - 1) / c;
        const double ratio =
            (static_cast<double>(options.width) / c) / (static_cast<double>(options.height) / rows);
        const double badness = std::max(ratio, 1.0 / ratio) + 0.4 * (c * rows - count);
        if (badness < best) best = badness, columns = c;
    }
    const int rows = (count + columns - 1) / columns;
    Random style = Random::stream(seed, 0), paper = Random::stream(seed, 2), look = Random::stream(seed, 3),
           varied = Random::stream(seed, 5);
    DoodleOptions cell = options;
    cell.width = std::max(64, options.width / columns), cell.height = std::max(64, options.height / rows);
    Hand hand = random_hand(style, cell);
    if (varied.chance(options.variety)) vary_hand(hand, varied, cell);
    apply_look(options.look, hand, look);
    Page page;
    Grid<Colour> ink(options.width, options.height, hand.ground);
    page.labels = LabelMap(options.width, options.height);
    page.instances = GreyImage(options.width, options.height);
    for (std::size_t i = 0; i < types.size(); ++i) {
        Random figure = Random::stream(seed, 16 + i);
        Drawn drawn = draw_alone(types[i], figure, varied, hand, cell);
        const int row = static_cast<int>(i) / columns, in_row = std::min(columns, count - row * columns);
        const int indent = (columns - in_row) * cell.width / 2; // the last row stands in the middle
        const int left = indent + static_cast<int>(i) % columns * cell.width, top = row * cell.height;
        for (int y = 0; y < cell.height && top + y < options.height; ++y)
            for (int x = 0; x < cell.width && left + x < options.width; ++x) {
                ink(left + x, top + y) = drawn.layer.ink(x, y);
                page.labels(left + x, top + y) = drawn.layer.labels(x, y);
                if (drawn.layer.labels(x, y) != 0)
                    page.instances(left + x, top + y) = static_cast<std::uint8_t>(i + 1);
            }
        drawn.character.box.x += left, drawn.character.box.y += top;
        page.characters.push_back(drawn.character);
    }
    print_lines(options.look, hand, ink, look);
    const Finish finish = random_finish(paper, options);
    page.picture = on_paper(ink, paper, finish);
    return page;
}

} // namespace pantin::doodle
