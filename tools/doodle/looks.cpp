// SPDX-License-Identifier: MIT
// Looks: crayon, no-outline, tinted, grid, chalk, kraft. A hand with a pen in, a hand with other colours out.
#include "doodle/looks.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "pantin/error.hpp"

namespace pantin::doodle {
namespace {

float shade(Random& r, double low, double high) { return static_cast<float>(r.uniform(low, high)); }

Colour near(Random& r, const Colour& colour, double by) {
    Colour out = colour;
    for (float& c : out) c = std::clamp(c + shade(r, -by, by), 0.0f, 255.0f);
    return out;
}

double apart(const Colour& a, const Colour& b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return std::sqrt(sum);
}

double brightness(const Colour& c) { return 0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2]; }

// A pen that can hardly be seen on the ground gets darker.
void keep_visible(Hand& hand) {
    while (std::abs(brightness(hand.ink) - brightness(hand.ground)) < 80.0 && brightness(hand.ink) > 20.0)
        for (float& c : hand.ink) c *= 0.8f;
}

const std::vector<Colour>& pale_crayons() {
    static const std::vector<Colour> colours = {{252, 243, 170}, {250, 220, 195}, {190, 220, 245},
                                                {250, 205, 220}, {205, 235, 190}, {225, 210, 240},
                                                {235, 228, 215}};
    return colours;
}

const std::vector<Colour>& strong_crayons() {
    static const std::vector<Colour> colours = {{225, 50, 45}, {245, 150, 30}, {250, 210, 30},
                                                {50, 150, 70}, {45, 105, 200}, {120, 60, 160},
                                                {120, 75, 45}, {30, 30, 35},   {235, 120, 165}};
    return colours;
}

// Every part filled in, pale or strong, with lines of one crayon.
void crayon(Hand& hand, Random& r) {
    const bool pale = r.chance(0.4);
    for (Colour& paint : hand.paints)
        paint = near(r, r.pick(pale || r.chance(0.35) ? pale_crayons() : strong_crayons()), 12);
    hand.filling = r.pick(std::vector<Filling>{Filling::flat, Filling::hatched, Filling::wash});
    hand.fill_all = r.chance(0.7);
    hand.coloured_lines = false;
    hand.pen *= r.uniform(1.0, 1.6);
    hand.grain = r.uniform(0.1, 0.6);
    if (r.chance(0.5)) hand.ink = near(r, {60, 50, 45}, 40);
}

// Areas of colour that touch each other, no lines between, on a ground of one colour.
void no_outline(Hand& hand, Random& r) {
    static const std::vector<Colour> grounds = {{255, 255, 255}, {250, 240, 215}, {190, 215, 235},
                                                {150, 190, 150}, {235, 190, 170}, {70, 95, 130},
                                                {60, 60, 65}};
    hand.ground = near(r, r.pick(grounds), 12);
    for (Colour& paint : hand.paints) do
            paint = near(r, r.pick(r.chance(0.4) ? pale_crayons() : strong_crayons()), 15);
        while (apart(paint, hand.ground) < 70.0);
    do hand.ink = near(r, r.pick(strong_crayons()), 15);
    while (apart(hand.ink, hand.ground) < 110.0);
    hand.outlines = false, hand.fill_all = true;
    hand.filling = r.chance(0.7) ? Filling::flat : Filling::wash;
    hand.coloured_lines = true;
    hand.opacity = 1.0;
}

// Even paper of any colour that a dark pen can be seen on.
void tinted(Hand& hand, Random& r) {
    static const std::vector<Colour> sheets = {
        {250, 235, 140}, {245, 190, 200}, {175, 215, 240}, {180, 225, 170}, {240, 190, 120}, {205, 190, 230},
        {200, 200, 200}, {235, 225, 200}, {225, 110, 100}, {110, 170, 210}, {120, 185, 110}};
    hand.ground = near(r, r.pick(sheets), 15);
    keep_visible(hand);
}

void chalk(Hand& hand, Random& r) {
    const bool green = r.chance(0.5);
    hand.ground = green ? Colour{shade(r, 25, 50), shade(r, 65, 90), shade(r, 50, 70)}
                        : Colour{shade(r, 20, 48), shade(r, 20, 48), shade(r, 22, 52)};
    hand.ink = near(r, r.chance(0.7) ? Colour{238, 238, 232} : r.pick(pale_crayons()), 12);
    for (Colour& paint : hand.paints) paint = near(r, r.pick(pale_crayons()), 15);
    hand.opacity = r.uniform(0.75, 1.0);
    hand.grain = r.uniform(0.3, 0.8);
    hand.pen *= r.uniform(1.0, 1.6);
}

// Brown paper: a dark pen, a white one, or a dark pen and white fills and faces.
void kraft(Hand& hand, Random& r) {
    hand.ground = near(r, {185, 145, 105}, 20);
    const Colour white = near(r, {245, 243, 238}, 8);
    const int kind = r.integer(0, 2);
    if (kind == 1) hand.ink = white;
    if (kind == 2) {
        hand.second_ink = white;
        for (std::size_t i = 0; i < hand.paints.size(); ++i)
            if (r.chance(0.6)) hand.paints[i] = white;
        hand.filling = r.chance(0.5) ? Filling::flat : Filling::hatched;
        hand.fill_all = r.chance(0.5);
    }
    keep_visible(hand);
}

using Look = void (*)(Hand&, Random&);

void grid(Hand&, Random&) {}

const std::vector<std::pair<std::string, Look>>& table() {
    static const std::vector<std::pair<std::string, Look>> looks = {
        {"crayon", crayon}, {"no-outline", no_outline}, {"tinted", tinted},
        {"grid", grid},     {"chalk", chalk},           {"kraft", kraft}};
    return looks;
}

} // namespace

const std::vector<std::string>& looks() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> out;
        for (const auto& [name, apply] : table()) out.push_back(name);
        return out;
    }();
    return names;
}

void apply_look(const std::string& look, Hand& hand, Random& r) {
    if (look.empty()) return;
    for (const auto& [name, apply] : table())
        if (name == look) return apply(hand, r);
    throw Error(ErrorKind::usage, "unknown look '" + look + "'");
}

void print_lines(const std::string& look, const Hand& hand, Grid<Colour>& ink, Random& r) {
    if (look != "grid") return;
    // As dark as the pen at most.
    const double size = std::min(ink.width(), ink.height()), pitch = size * r.uniform(0.04, 0.1);
    const double phase_x = r.uniform(0, pitch), phase_y = r.uniform(0, pitch), strength = r.uniform(0.1, 1.0);
    const double radius = std::max(0.5, size * r.uniform(0.0008, 0.002));
    const bool squared = r.chance(0.6);
    const Colour full = r.chance(0.5) ? hand.ink : near(r, {70, 110, 180}, 30);
    const auto cover = [&](double position) {
        return std::clamp(radius + 0.5 - std::abs(position - pitch * std::floor(position / pitch + 0.5)), 0.0,
                          1.0);
    };
    for (int y = 0; y < ink.height(); ++y)
        for (int x = 0; x < ink.width(); ++x) {
            const double on = strength * std::max(cover(y + phase_y), squared ? cover(x + phase_x) : 0.0);
            for (std::size_t k = 0; k < 3; ++k)
                ink(x, y)[k] *= static_cast<float>(1.0 - on * (1.0 - full[k] / 255.0));
        }
}

} // namespace pantin::doodle
