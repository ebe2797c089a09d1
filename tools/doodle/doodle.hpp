// SPDX-License-Identifier: MIT
// A generator of labelled drawings: characters as people scribble them, with the truth that the pipeline has
// to find. It makes training data, testdata/ and the pages of the property tests. Everything follows from the
// seed, to the bit, on any machine.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/point.hpp"

namespace pantin::doodle {

struct DoodleOptions {
    int width = 320, height = 320; // pixels of the picture; at least 64
    double fill = 0.0;    // longer side of the character / side of its area; 0: random in 0.6 … 0.95
    double photo = 0.3;   // probability of a photograph: tinted paper, shadow, vignette, noise, blur
    double paper = 0.1;   // probability of tinted or ruled paper where it is no photograph
    double colour = 0.25; // probability that parts are coloured in
    double pen = 0.0;     // pen width in pixels; 0: random
    double gaps = 1.0;    // how much the outlines are interrupted (0: never, 1: as people do)
    double tilt = 1.0;    // how much figures are turned (0: upright)
    double variety = 0.0; // share of drawings of the species and in the manners of quick sketches
    std::string species;  // one of species_of(type); empty: random
    std::string look; // one of looks(); empty: a pen on white, photographed or on paper by the shares above
};

struct Character {
    std::string
        type; // humanoid, quadruped, flying, other; or head, blob, scribble, thing: no character at all
    std::string species; // what was drawn, e.g. "dog"
    std::string pose;    // the way it faces on the page: E, NE, N, NW, W, SW, S, SE
    Box box;             // smallest box of its label pixels
    // Arms, legs and fins that are seen, hands and feet not counted: legs drawn as one, or crossed, are two,
    // which the label map does not tell. −1: not known.
    int limbs = -1;
};

// Labels: 0 background, 1 head (ears, hair, hat, beak, horns), 2 body (neck), 3 limb, 4 tail, 5 wing. The
// silhouette is closed, filled and 8-connected; what is drawn as a single line is 2.5 pens thick.
struct Doodle : Character {
    RgbImage picture;
    LabelMap labels;
};

struct Page {
    RgbImage picture;
    LabelMap labels;
    GreyImage instances; // 0 paper, k + 1 where characters[k] is
    std::vector<Character> characters;
    std::vector<Character> things; // of a scene: what has no label, with the box of its ink
};

// The types that are told apart: humanoid, quadruped, flying. What is none of them, fish and crabs, is
// `other`.
const std::vector<std::string>& character_types();
// crayon (filled in, pale or strong), no-outline (areas on an even ground), tinted (even coloured paper),
// grid (ruled, up to as dark as the pen), chalk (light on a dark board), kraft (brown paper, dark or white
// ink or both).
const std::vector<std::string>& looks();
// What `variety` adds to a type.
std::vector<std::string> varied_species(const std::string& type);
// The species that a type is drawn as; empty for head, blob and scribble. Throws Error(usage) for another
// type.
std::vector<std::string> species_of(const std::string& type);

// `type` may be type:species too. Throws Error(usage) for unknown names and pictures below 64 pixels.
Doodle draw_character(const std::string& type, std::uint64_t seed, const DoodleOptions& options = {});
// Characters side by side in a loose grid; they never overlap. An entry is a type or type:species, such as
// quadruped:horse.
Page draw_page(const std::vector<std::string>& types, std::uint64_t seed, const DoodleOptions& options = {});

// What children draw: family (two to four people, at times a dog or cat and a bird) or animals, on the ground
// and in the sky, with things around them. Throws Error(usage) for another kind.
const std::vector<std::string>& scene_kinds();
Page draw_scene(const std::string& kind, std::uint64_t seed, const DoodleOptions& options = {});

// A page as a sheet on a desk, seen from the side.
struct DeskPhoto {
    Page page; // picture, labels, instances and boxes as the camera has them
    std::array<Point2d, 4>
        corners; // of the sheet in the photograph: upper left, upper right, lower right, lower left
};
// The size of the flat sheet, an A4 across or upright, for a photograph of these options' size.
DoodleOptions sheet_options(const DoodleOptions& options);
DeskPhoto on_desk(const Page& flat, std::uint64_t seed, int width, int height);

// A baseline JPEG, as a camera writes it; quality 1 … 100.
std::vector<unsigned char> encode_jpeg(const RgbImage& picture, int quality = 85);

} // namespace pantin::doodle
