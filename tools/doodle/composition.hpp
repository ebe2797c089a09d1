// SPDX-License-Identifier: MIT
// A page on the way: figures drawn one after the other, each on a canvas of its own size.
#pragma once

#include "doodle/canvas.hpp"

namespace pantin::doodle {

// A figure of a type or type:species. Throws Error(usage) for unknown names (doodle.cpp).
Figure build_named(Random& random, const std::string& what);
// A type as type:species, where `options` say which or `variety` has more to choose from (doodle.cpp).
std::string choose(const std::string& what, Random& varied, const DoodleOptions& options);
// Throws Error(usage) below 64 pixels.
void check_size(const DoodleOptions& options);

class Composition {
public:
    Composition(int width, int height, const Colour& ground);

    // Figures whose points are pixels of the page; what lies beyond its border is cut. A thing leaves no
    // truth but a line in page.things; a character covers what was there before.
    void add_character(Figure figure, const std::string& pose, const Hand& hand, Random& random);
    void add_thing(Figure figure, const Hand& hand, Random& random);

    Grid<Colour> ink;
    Page page; // without its picture

private:
    struct Drawn {
        Layer layer;
        int left = 0, top = 0;
    };
    Drawn draw_apart(Figure& figure, const Hand& hand, Random& random) const;
    Box lay(const Drawn& drawn, std::uint8_t id);
    Colour ground_;
};

} // namespace pantin::doodle
