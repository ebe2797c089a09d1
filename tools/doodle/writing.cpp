// SPDX-License-Identifier: MIT
// Words in block letters, a scrawl of joined letters, a signature.
#include <map>
#include <sstream>

#include "core/math.hpp"
#include "doodle/things.hpp"

namespace pantin::doodle {
namespace {

// Strokes of the capital letters on a grid of 5 × 7 points: two digits (x, y) a point, '~' before a curve.
const std::map<char, std::string>& letter_strokes() {
    static const std::map<char, std::string> strokes = {{'A', "06 20 46/14 34"},
                                                        {'B', "00 06/~00 30 41 33 03/~03 34 45 36 06"},
                                                        {'C', "~41 20 02 04 26 45"},
                                                        {'D', "00 06/~00 30 43 36 06"},
                                                        {'E', "40 00 06 46/03 33"},
                                                        {'F', "40 00 06/03 33"},
                                                        {'G', "~41 20 02 04 26 44/44 24"},
                                                        {'H', "00 06/40 46/03 43"},
                                                        {'I', "20 26"},
                                                        {'J', "~40 43 45 26 05"},
                                                        {'K', "00 06/40 03 46"},
                                                        {'L', "00 06 46"},
                                                        {'M', "06 00 23 40 46"},
                                                        {'N', "06 00 46 40"},
                                                        {'O', "~20 02 04 26 44 42 20"},
                                                        {'P', "00 06/~00 30 41 33 03"},
                                                        {'R', "00 06/~00 30 41 33 03/13 46"},
                                                        {'S', "~41 20 01 23 45 26 05"},
                                                        {'T', "00 40/20 26"},
                                                        {'U', "~00 04 26 44 40"},
                                                        {'V', "00 26 40"},
                                                        {'W', "00 16 22 36 40"},
                                                        {'X', "00 46/40 06"},
                                                        {'Y', "00 23 40/23 26"},
                                                        {'Z', "00 40 06 46"}};
    return strokes;
}

void add_letter(Builder& b, char letter, Point2d corner, double size) {
    Random& r = b.random;
    const bool mirrored = r.chance(0.06); // as beginners do
    const double slant = r.uniform(-0.15, 0.15);
    std::istringstream strokes(letter_strokes().at(letter));
    for (std::string stroke; std::getline(strokes, stroke, '/');) {
        const bool curved = stroke[0] == '~';
        std::istringstream points(stroke.substr(curved ? 1 : 0));
        Path line;
        for (std::string point; points >> point;) {
            const double x = point[0] - '0', y = point[1] - '0';
            line.push_back(corner + size * Point2d{(mirrored ? 4 - x : x) - slant * y, y});
        }
        add_line(b, curved ? spline(line, false) : line, Crayon::blue);
    }
}

std::string random_word(Random& r) {
    static const std::vector<std::string> known = {
        "MAMA", "PAPA", "OMA", "OPA", "TOM", "LISA", "EMMA",  "LEON", "ANNA",  "PIA",    "MIA", "BEN", "LOVE",
        "MY",   "DAD",  "MUM", "DOG", "CAT", "SUN",  "HALLO", "FOR",  "HOUSE", "FAMILY", "ICH", "UND", "ZOO"};
    if (r.chance(0.7)) return r.pick(known);
    std::string word;
    for (int i = 0, n = r.integer(1, 8); i < n; ++i) {
        auto letter = letter_strokes().begin();
        std::advance(letter, r.integer(0, static_cast<int>(letter_strokes().size()) - 1));
        word += letter->first;
    }
    return word;
}

// A line of block letters that starts at `corner`; returns where it ends.
double add_word(Builder& b, Point2d corner, double size) {
    Random& r = b.random;
    double x = corner.x;
    for (char letter : random_word(r)) {
        const double scale = size * r.uniform(0.85, 1.15), dy = size * r.uniform(-0.5, 0.5);
        add_letter(b, letter, {x, corner.y + dy}, scale);
        x += scale * (letter == 'I' ? 4.0 : 5.5) + size * r.uniform(0.0, 0.8);
    }
    return x;
}

void word(Builder& b) {
    b.figure.may_mirror = false;
    add_word(b, {0, 0}, 2.0);
}

void sentence(Builder& b) {
    b.figure.may_mirror = false;
    for (int row = 0, rows = b.random.integer(1, 3); row < rows; ++row) {
        double x = b.random.uniform(0, 8);
        for (int i = 0, n = b.random.integer(2, 4); i < n; ++i) x = 7.0 + add_word(b, {x, 18.0 * row}, 2.0);
    }
}

// Joined letters: loops of varying height along a base line.
double add_scrawl(Builder& b, Point2d start, int letters) {
    Random& r = b.random;
    Path line = {start};
    double x = start.x;
    for (int i = 0; i < letters; ++i) {
        const double tall = r.chance(0.3) ? r.uniform(7, 13) : r.uniform(3, 5), width = r.uniform(2, 4.5);
        const double down = r.chance(0.15) ? r.uniform(4, 8) : 0.0, loop = r.uniform(-1.5, 1.0);
        line.push_back({x + width, start.y - tall});
        line.push_back({x + width + loop, start.y - 0.5 * tall});
        line.push_back({x + width + 0.5, start.y + down});
        x += width + 1.5;
    }
    add_line(b, spline(line, false), Crayon::blue);
    return x;
}

void scrawl(Builder& b) {
    b.figure.may_mirror = false;
    for (int row = 0, rows = b.random.integer(1, 4); row < rows; ++row) {
        double x = 0;
        for (int i = 0, n = b.random.integer(1, 4); i < n; ++i) {
            const int letters = b.random.integer(2, 9);
            x = 6.0 + add_scrawl(b, {x, 20.0 * row}, letters);
        }
    }
}

void signature(Builder& b) {
    b.figure.may_mirror = false;
    b.figure.max_tilt = 0.3;
    const int letters = b.random.integer(4, 9);
    const double end = add_scrawl(b, {0, 0}, letters);
    if (!b.random.chance(0.6)) return;
    const double droop = b.random.uniform(-3, 3);
    add_line(b, spline({{end + 2, 2}, {0.4 * end, 9 + droop}, {0, 7}, {1.1 * end, 6 - droop}}, false),
             Crayon::blue);
}

} // namespace

const ThingTable& written_things() {
    static const ThingTable table = {
        {"word", word}, {"sentence", sentence}, {"scrawl", scrawl}, {"signature", signature}};
    return table;
}

} // namespace pantin::doodle
