// SPDX-License-Identifier: MIT
// Drawings as programs write them: paint, style sheets, references, viewports, compound paths, thick lines.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "core/math.hpp"
#include "geometry/extent.hpp"
#include "modeling/svg_colour.hpp"
#include "modeling/svg_outlines.hpp"
#include "modeling/svg_viewport.hpp"
#include "modeling/thick_line.hpp"
#include "pantin/error.hpp"
#include "pantin/strokes.hpp"

using namespace pantin;

namespace {

using Line = std::vector<Point2d>;
using Lines = std::vector<std::string>;

std::string message_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::input);
        return error.what();
    }
    return "no error";
}

Strokes svg(const std::string& inside, const std::string& attributes = "") {
    return strokes_from_svg("<svg xmlns='http://www.w3.org/2000/svg' " + attributes + ">" + inside + "</svg>",
                            "drawing.svg");
}
std::string svg_error(const std::string& inside) {
    return message_of([&] { svg(inside); });
}
std::vector<PartStroke> parts_of(const Strokes& strokes) {
    std::vector<PartStroke> parts;
    for (const ModelCall& call : strokes.calls) parts.push_back(std::get<PartStroke>(call));
    return parts;
}
PartStroke only_part(const Strokes& strokes) {
    REQUIRE(strokes.calls.size() == 1);
    return parts_of(strokes)[0];
}
Lines names_of(const Strokes& strokes) {
    Lines names;
    for (const PartStroke& part : parts_of(strokes)) names.push_back(part.name);
    return names;
}
bool near(const Line& a, const Line& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (distance(a[i], b[i]) > 1e-9) return false;
    return true;
}
// A body of 60 × 30 in a page of 100 × 100, and what is beside it.
const std::string body = "<rect id='body' x='20' y='40' width='60' height='30'/>";
const std::string page = "viewBox='0 0 100 100'";

} // namespace

// --- what is no part ---------------------------------------------------------------------------------------

TEST_CASE("What is not painted is no part, with a line", "[needs-pugixml]") {
    const auto lines = [](const std::string& shape) {
        const Strokes strokes = svg(shape + body, page);
        CHECK(names_of(strokes) == Lines{"body"});
        CHECK(strokes.painting.size() == 1);
        return strokes.repairs;
    };
    const std::string r = "<rect id='r' width='90' height='90' ";
    for (const char* paint :
         {"fill='none'", "fill='none' stroke='none'", "fill-opacity='0'", "fill-opacity='0%'", "opacity='0'",
          "fill='transparent'", "fill='rgba(1,2,3,0)'", "fill='rgb(1 2 3 / 0%)'", "fill='#12345600'",
          "fill='#1230'", "fill='hsla(1,2%,3%,0)'", "style='opacity:0'", "style='fill:none'",
          "fill='red' style='fill:none'", "fill='none' stroke='red' stroke-width='0'",
          "fill='none' stroke='red' stroke-opacity='0'", "fill='url(#clear)'"}) {
        CAPTURE(paint);
        const std::string defs =
            "<defs><linearGradient id='clear'><stop stop-opacity='0'/></linearGradient></defs>";
        const Lines found = lines(defs + r + paint + "/>");
        REQUIRE(found.size() == 1);
        const bool thin = std::string(paint).find("stroke-width") != std::string::npos;
        CHECK(found[0] == (thin ? "rect 'r': has no area, left out" : "rect 'r': not painted, left out"));
    }
    CHECK(lines(r + "visibility='hidden'/>") == Lines{"rect 'r': not visible, left out"});
    CHECK(lines("<g visibility='hidden'>" + r + "/></g>") == Lines{"rect 'r': not visible, left out"});
    CHECK(lines(r + "display='none'/>") == Lines{"rect 'r': not displayed, left out"});
    CHECK(lines("<g id='g' display='none'>" + r + "/>" + r + "/></g>") ==
          Lines{"g 'g': not displayed, left out"});
    CHECK(lines("<g opacity='0'><g>" + r + "/></g></g>") == Lines{"rect 'r': not painted, left out"});
    CHECK(lines("<g opacity='0.01'><g opacity='0.1'>" + r + "/></g></g>").size() == 1);
    // Seen again, or still.
    for (const char* seen :
         {"<g visibility='hidden'><rect id='r' visibility='visible' width='9' height='9'/></g>",
          "<rect id='r' fill='none' stroke='red' width='9' height='9'/>",
          "<rect id='r' fill-opacity='0' stroke='red' width='9' height='9'/>",
          "<rect id='r' opacity='.2' width='9' height='9'/>"})
        CHECK(names_of(svg(seen + body, page)) == Lines{"r", "body"});
}

TEST_CASE("A ground behind everything is no part", "[needs-pugixml]") {
    const auto names = [](const std::string& ground, const std::string& attributes = page) {
        return names_of(svg(ground + body, attributes));
    };
    for (const char* ground :
         {"<rect id='g' width='100' height='100'/>", "<rect id='g' width='100%' height='100%'/>",
          "<path id='g' d='M0 0h100v100H0z'/>", "<rect id='g' x='-5' y='-5' width='110' height='110'/>",
          "<rect id='g' width='98' height='98' rx='6'/>", "<circle id='g' cx='50' cy='50' r='50'/>"}) {
        CAPTURE(ground);
        CHECK(names(ground) == Lines{"body"});
        CHECK(svg(ground + body, page).repairs.back().ends_with("a ground that covers the page, left out"));
    }
    CHECK(names("<rect id='g' width='100' height='100'/>", "width='100' height='100px'") == Lines{"body"});
    // Two of them; one in front is what one sees; one of half a page is not; a page of nothing but a ground.
    CHECK(names("<rect width='100' height='100'/><circle cx='50' cy='50' r='50'/>") == Lines{"body"});
    CHECK(names_of(svg(body + "<rect id='g' width='100' height='100'/>", page)) == Lines{"body", "g"});
    CHECK(names("<rect id='g' width='100' height='60'/>") == Lines{"g", "body"});
    CHECK(names_of(svg("<rect id='g' width='100' height='100'/>", page)) == Lines{"g"});
    CHECK(names("<rect id='g' width='100' height='100'/>", "") == Lines{"g", "body"}); // no page is known
    // A large round animal with something beyond its outline is none.
    CHECK(
        names(
            "<circle id='g' cx='50' cy='50' r='48'/><rect id='leg' x='90' y='80' width='9' height='19'/>") ==
        Lines{"g", "leg", "body"});
    CHECK(names("<circle id='head' cx='50' cy='50' r='50'/>") == Lines{"head", "body"});
    CHECK(names("<rect id='far' x='300' width='9' height='9'/>") == Lines{"body"});
}

TEST_CASE("One useless shape does not end the drawing", "[needs-pugixml]") {
    const auto left_out = [](const std::string& shape) {
        const Strokes strokes = svg(body + shape, page);
        CHECK(names_of(strokes) == Lines{"body"});
        REQUIRE(strokes.repairs.size() == 1);
        return strokes.repairs[0];
    };
    for (const char* flat :
         {"<path d='M20 60L5 55'/>", "<path d='M20 60 10 57.5 0 55'/>", "<path d='M0 0h5h-9h20'/>",
          "<path d='M1 1L4 4L1 1L3 3z'/>", "<polygon points='1,2 3,4'/>", "<polyline points='20,60 5,55'/>",
          "<path d='M5 5C6 6 7 7 8 8'/>", "<line x2='9' y2='9'/>"}) {
        CAPTURE(flat);
        const std::string line = left_out(flat);
        const bool drawn = line.find("line:") == 0;
        CHECK((line.ends_with("has no area, left out") || (drawn && line.ends_with("left out"))));
    }
    CHECK(left_out("<path id='w' d='M20 60L5 55' stroke='black'/>") == "path 'w': a thin line, left out");
    for (const char* nothing :
         {"<path d=''/>", "<path d='M5 5'/>", "<path d='M10 10z'/>", "<polygon points=''/>",
          "<path transform='scale(0)' d='M0 0h5v5'/>", "<path d='M1 1M2 2M3 3'/>"})
        CHECK(left_out(nothing).ends_with("empty, left out"));
}

// --- files -------------------------------------------------------------------------------------------------

TEST_CASE("Byte order marks, line ends and entities of other programs do not matter", "[needs-pugixml]") {
    const std::string text =
        "<?xml version='1.0'?>\n<svg>\n<path id='the\n tail'\nd='M0 0\nL5 0\n5 5z'/>\n</svg>\n";
    const Strokes plain = strokes_from_svg(text, "d.svg");
    CHECK(only_part(plain).name == "the tail");
    const auto same = [&](const std::string& other) {
        const Strokes strokes = strokes_from_svg(other, "d.svg");
        CHECK(strokes.calls == plain.calls);
        CHECK(strokes.repairs.empty());
    };
    same("\xEF\xBB\xBF" + text);
    same(text + "\x1a");
    same(text + "\r\n\x1a\r\n");
    std::string crlf, cr, wide = "\xFF\xFE";
    for (const char c : text) {
        crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
        cr += c == '\n' ? '\r' : c;
        wide += c;
        wide += '\0';
    }
    same(crlf);
    same(cr);
    same(wide);
    // Illustrator's entities: namespaces and whole styles.
    const std::string declared =
        "<!DOCTYPE svg PUBLIC \"x\" \"y\" [\n<!ENTITY ns \"http://www.w3.org/2000/svg\">\n"
        "<!ENTITY st0 \"fill:#123456;\">\n<!ENTITY bomb \"&st0;&st0;\">]>\n"
        "<svg xmlns=\"&ns;\"><path style=\"&st0;\" d=\"M0 0h5v5z\"/></svg>";
    CHECK(only_part(strokes_from_svg(declared, "d.svg")).colour == Rgb8{0x12, 0x34, 0x56});
}

// --- style sheets ------------------------------------------------------------------------------------------

TEST_CASE("Style sheets are followed by specificity, order and importance", "[needs-pugixml]") {
    const auto colour = [](const std::string& css, const std::string& shape, const std::string& around = "") {
        const std::string close = around.empty() ? "" : "</g>";
        return only_part(svg("<style>" + css + "</style>" + around + shape + close)).colour;
    };
    const std::string p = "<path id='p' class='a b' fill='lime' d='M0 0h5v5z'/>";
    const Rgb8 red{255, 0, 0}, blue{0, 0, 255}, lime{0, 255, 0};
    CHECK(colour(".a{fill:red}", p) == red);
    CHECK(colour("path{fill:red}", p) == red);
    CHECK(colour("#p{fill:red}", p) == red);
    CHECK(colour("*{fill:red}", p) == red);
    CHECK(colour("path.a.b#p{fill:red}", p) == red);
    CHECK(colour(".c{fill:red}", p) == lime);
    CHECK(colour(".c, .b , rect{fill:red}", p) == red);
    CHECK(colour(".a{fill:red}.b{fill:blue}", p) == blue);  // the later one
    CHECK(colour(".a{fill:red}path{fill:blue}", p) == red); // the more specific one
    CHECK(colour("#p{fill:red}.a.b{fill:blue}", p) == red);
    CHECK(colour(".a{fill:red!important}#p{fill:blue}", p) == red);
    CHECK(colour("g .a{fill:red}", p, "<g>") == red);
    CHECK(colour("g > .a{fill:red}", p, "<g>") == red);
    CHECK(colour("g.x .a{fill:red}", p, "<g class='x'>") == red);
    CHECK(colour("g.x>.a{fill:red}", p, "<g class='x'><g/>") == red);
    CHECK(colour("g.y .a{fill:red}", p, "<g class='x'>") == lime);
    CHECK(colour("svg>path{fill:red}", p, "<g>") == lime);
    CHECK(colour("/* .a{fill:blue} */ .a/**/{fill:/* no */red}", p) == red);
    CHECK(colour("<![CDATA[<!-- .a{fill:red} -->]]>", p) == red);
    CHECK(colour("<![CDATA[.a{fill:red}]]>", p) == red);
    CHECK(colour("<!-- .a{fill:red} -->", p) == lime); // XML's comment, not CSS's
    CHECK(colour("@import url(x.css); @media print{.a{fill:blue}} .a{fill:red}", p) == red);
    CHECK(colour("@font-face{font-family:x}\n.a\n{\n fill : red ;\n}\n", p) == red);
    CHECK(colour(".a{fill:red", p) == red); // the end of the sheet closes
    // The attribute `style` before the sheet, but not before what is important there.
    const std::string own = "<path class='a' style='fill:red' d='M0 0h5v5z'/>";
    CHECK(colour(".a{fill:blue}", own) == red);
    CHECK(colour(".a{fill:blue !important}", own) == blue);
    // Inherited, and what is not shown.
    CHECK(colour("g{fill:red}", "<path d='M0 0h5v5z'/>", "<g>") == red);
    CHECK(names_of(svg("<style>.gone{display:none}.h{visibility:hidden}.o{opacity:0}.n{fill:none}</style>"
                       "<rect class='gone' width='9' height='9'/><rect class='h' width='9' height='9'/>"
                       "<rect class='o' width='9' height='9'/><rect class='n' width='9' height='9'/>" +
                       body)) == Lines{"body"});
    CHECK(svg("<style>a:hover{fill:red}rect[x]{fill:red}</style>" + body).repairs ==
          Lines{"2 selectors of the style sheets not understood"});
    CHECK(only_part(svg("<style>.t{transform:translate(3px,4px)}</style><path class='t' d='M0 0h5v5z'/>"))
              .stroke[0] == Point2d{3, 4});
}

TEST_CASE("A gradient's colour is the mean of its stops", "[needs-pugixml]") {
    const auto colour = [](const std::string& defs, const std::string& fill) {
        const Strokes strokes = svg("<defs>" + defs + "</defs><path fill='" + fill + "' d='M0 0h5v5z'/>");
        CHECK(strokes.repairs.empty());
        return only_part(strokes).colour;
    };
    const std::string stops = "<stop stop-color='#000'/><stop offset='1' style='stop-color:#640032'/>";
    CHECK(colour("<linearGradient id='g'>" + stops + "</linearGradient>", "url(#g)") == Rgb8{50, 0, 25});
    CHECK(colour("<radialGradient id='g'>" + stops + "</radialGradient>", "url(\"#g\") red") ==
          Rgb8{50, 0, 25});
    CHECK(colour("<linearGradient id='h'>" + stops + "</linearGradient><radialGradient id='g' href='#h'/>",
                 "url(#g)") == Rgb8{50, 0, 25});
    // Gradients in a ring, patterns, and what is not there: the colour behind them.
    CHECK(colour("<linearGradient id='g' href='#h'/><linearGradient id='h' href='#g'/>", "url(#g) #010203") ==
          Rgb8{1, 2, 3});
    CHECK(colour("<pattern id='g'><path d='M0 0h9v9z'/></pattern>", "url(#g) navy") == Rgb8{0, 0, 128});
    CHECK(colour("", "url(#none) navy") == Rgb8{0, 0, 128});
}

// --- references and viewports ------------------------------------------------------------------------------

TEST_CASE("use shows shapes, groups and symbols where it stands", "[needs-pugixml]") {
    const std::string leg = "<defs><path id='leg' d='M0 0h4v9z'/></defs>";
    Strokes strokes =
        svg(leg + "<use href='#leg' x='10' y='20'/>"
                  "<use xmlns:xlink='x' xlink:href='#leg' id='tail' transform='scale(2)' x='1'/>");
    CHECK(names_of(strokes) == Lines{"leg", "tail"});
    CHECK(parts_of(strokes)[0].stroke == Line{{10, 20}, {14, 20}, {14, 29}});
    CHECK(parts_of(strokes)[1].stroke == Line{{2, 0}, {10, 0}, {10, 18}});
    // What it inherits, and the data of the use itself.
    strokes = svg(leg + "<g fill='red'><use href='#leg' data-label='tail' data-depth='3'/></g>");
    CHECK(only_part(strokes).colour == Rgb8{255, 0, 0});
    CHECK(only_part(strokes).label == Label::tail);
    CHECK(only_part(strokes).depth == 3);
    CHECK(names_of(svg("<g id='all'>" + body + "</g><use href='#all' x='100'/>")) == Lines{"body", "body-2"});
    // A use of a use, and of something that comes later.
    CHECK(svg("<use href='#u'/><use id='u' href='#r' x='5'/><rect id='r' width='1' height='1'/>")
              .calls.size() == 3);
    // Symbols have a viewport.
    strokes = svg("<symbol id='s' viewBox='0 0 10 10'><rect width='10' height='5'/></symbol>"
                  "<use href='#s' x='100' y='200' width='50' height='50'/>");
    CHECK(near(only_part(strokes).stroke, {{100, 200}, {150, 200}, {150, 225}, {100, 225}}));
    CHECK(svg_error("<symbol id='s'><rect width='10' height='5'/></symbol>") ==
          "drawing.svg: holds no path, polygon, polyline, rect, circle, ellipse or line");
}

TEST_CASE("A use that leads nowhere or to itself is left out with a line", "[needs-pugixml]") {
    const auto line = [](const std::string& inside) {
        const Strokes strokes = svg(body + inside);
        REQUIRE(strokes.repairs.size() == 1);
        return strokes.repairs[0];
    };
    CHECK(line("<use id='u' href='#none'/>") == "use 'u': refers to 'none', which is not there, left out");
    CHECK(line("<use id='u' href='other.svg#x'/>") == "use 'u': refers to another file, left out");
    CHECK(line("<use id='u'/>") == "use 'u': refers to nothing, left out");
    CHECK(line("<use id='u' href='#u'/>") == "use 'u': refers to itself, left out");
    CHECK(line("<g id='g'><use id='u' href='#g'/></g>") == "use 'u': refers to itself, left out");
    const Strokes ring =
        svg(body + "<g id='a'><use href='#b'/></g><defs><g id='b'><use href='#a'/></g></defs>");
    CHECK(names_of(ring) == Lines{"body"});
    CHECK(ring.repairs.size() == 1);
    // Uses that multiply come to an end.
    std::string bomb = "<defs><rect id='x0' width='1' height='1'/>";
    for (int i = 1; i < 40; ++i) {
        const std::string before = "<use href='#x" + std::to_string(i - 1) + "'/>";
        bomb += "<g id='x" + std::to_string(i) + "'>" + before + before + "</g>";
    }
    CHECK(svg_error(bomb + "</defs><use href='#x39'/>") == "drawing.svg: more than 100000 elements");
}

TEST_CASE("Viewports scale what is inside them", "[needs-pugixml]") {
    const auto corner = [](const std::string& aspect) {
        const Affine m = svg_viewport({10, 20, 100, 50}, {1000, 2000, 400, 400}, aspect);
        return std::vector<double>{m.a, m.d, (m * Point2d{10, 20}).x, (m * Point2d{10, 20}).y};
    };
    using V = std::vector<double>;
    CHECK(corner("") == V{4, 4, 1000, 2100}); // xMidYMid meet
    CHECK(corner("xMinYMin") == V{4, 4, 1000, 2000});
    CHECK(corner("xMaxYMax meet") == V{4, 4, 1000, 2200});
    CHECK(corner("xMidYMid slice") == V{8, 8, 800, 2000});
    CHECK(corner("xMinYMax slice") == V{8, 8, 1000, 2000});
    CHECK(corner("none") == V{4, 8, 1000, 2000});
    const auto inner = [](const std::string& attributes) {
        return only_part(svg("<svg " + attributes + "><rect width='10' height='10'/></svg>", page)).stroke;
    };
    CHECK(near(inner("x='5' y='6'"), {{5, 6}, {15, 6}, {15, 16}, {5, 16}}));
    CHECK(near(inner("x='5' width='20' height='20' viewBox='0 0 10 10'"),
               {{5, 0}, {25, 0}, {25, 20}, {5, 20}}));
    CHECK(near(inner("width='50%' viewBox='0 0 10 10' preserveAspectRatio='none'"),
               {{0, 0}, {50, 0}, {50, 100}, {0, 100}}));
    // Percentages: of the width, the height, and the diagonal over √2.
    CHECK(near(
        only_part(svg("<rect x='10%' y='10%' width='50%' height='50%'/>", "viewBox='0 0 200 100'")).stroke,
        {{20, 10}, {120, 10}, {120, 60}, {20, 60}}));
    const double r = std::sqrt((200.0 * 200 + 100 * 100) / 2) / 10;
    CHECK(area_of(only_part(svg("<circle cx='50%' cy='50%' r='10%'/>", "viewBox='0 0 200 100'")).stroke) ==
          Approx(math::pi * r * r).epsilon(0.002));
    CHECK(names_of(svg("<switch><foreignObject requiredExtensions='x'/><g>" + body +
                       "</g><g><rect width='1' height='1'/></g></switch>")) == Lines{"body"});
}

// --- outlines ----------------------------------------------------------------------------------------------

TEST_CASE("Of a compound path what is filled is a part with its holes", "[needs-pugixml]") {
    const std::string outer = "M0 0h20v20h-20z", same = "M5 5h10v10h-10z", other = "M5 5v10h10v-10z",
                      beside = "M40 0h10v10h-10z", island = "M8 8h4v4h-4z";
    const auto read = [](const std::string& d, const std::string& rule = "") {
        return svg("<path id='p' d='" + d + "' " + rule + "/>");
    };
    const auto holes = [&](const Strokes& strokes) { return parts_of(strokes)[0].holes; };
    Strokes strokes = read(outer + other);
    CHECK(names_of(strokes) == Lines{"p"});
    CHECK(strokes.repairs.empty());
    CHECK(parts_of(strokes)[0].stroke.size() == 4);
    CHECK(holes(strokes) == std::vector<Line>{{{5, 5}, {5, 15}, {15, 15}, {15, 5}}});
    CHECK(holes(read(outer + same)).empty()); // of one sense: no hole by nonzero
    CHECK(holes(read(outer + same, "fill-rule='evenodd'")).size() == 1);
    CHECK(holes(read(outer + same, "style='fill-rule:evenodd'")).size() == 1);
    CHECK(parts_of(read(outer + other + island))[1].holes.empty());
    CHECK(holes(read("M0 0h200v200h-200zM50 50v1h1v-1z")).empty()); // a speck
    CHECK(names_of(read(outer + beside)) == Lines{"p", "p-2"});
    CHECK(names_of(read(outer + other + island)) == Lines{"p", "p-2"}); // filled again
    CHECK(names_of(read(island + other + outer)) == Lines{"p", "p-2"}); // in any order
    CHECK(names_of(read(outer + same + island, "fill-rule='evenodd'")) == Lines{"p", "p-2"});
    // Specks beside the animal, and a subpath that is a line.
    CHECK(read("M0 0h200v200h-200zM300 0h1v1z").repairs ==
          Lines{"part 'p': 1 outline left out, too small beside the others"});
    CHECK(names_of(read(outer + "M30 30L40 40")) == Lines{"p"});
    // What is seen has its holes.
    CHECK(strokes.painting[0].outlines.size() == 2);
    const RgbaImage seen = paint(strokes.painting, {}, 20, 20);
    CHECK(seen(2, 2).a == 255);
    CHECK(seen(10, 10).a == 0);
}

TEST_CASE("A thick line has the outline computed by hand", "[needs-pugixml]") {
    LineStyle style;
    style.width = 2;
    CHECK(near(thick_line({{0, 0}, {10, 0}}, style), {{0, 1}, {10, 1}, {10, -1}, {0, -1}}));
    style.cap = LineCap::square;
    CHECK(near(thick_line({{0, 0}, {10, 0}}, style), {{-1, 1}, {11, 1}, {11, -1}, {-1, -1}}));
    style.cap = LineCap::butt;
    // A right angle: the miter outside, the crossing inside.
    CHECK(near(thick_line({{0, 0}, {10, 0}, {10, 10}}, style),
               {{0, 1}, {9, 1}, {9, 10}, {11, 10}, {11, -1}, {0, -1}}));
    style.join = LineJoin::bevel;
    CHECK(near(thick_line({{0, 0}, {10, 0}, {10, 10}}, style),
               {{0, 1}, {9, 1}, {9, 10}, {11, 10}, {11, 0}, {10, -1}, {0, -1}}));
    style.cap = LineCap::round;
    const Line round = thick_line({{0, 0}, {10, 0}}, style);
    CHECK(std::abs(area_of(round)) == Approx(20 + math::pi).epsilon(0.01));
    for (const Point2d p : round) CHECK(distance(p, {std::clamp(p.x, 0.0, 10.0), 0}) == Approx(1));
    CHECK(thick_line({{3, 3}, {3, 3}}, style).size() >= 16); // a dot
    style.cap = LineCap::butt;
    CHECK(thick_line({{3, 3}, {3, 3}}, style).empty());
    CHECK(thick_line({}, style).empty());
    // The pieces cover the same.
    for (const LineCap cap : {LineCap::butt, LineCap::round, LineCap::square}) {
        style.cap = cap;
        const Line way = {{5, 5}, {25, 5}, {25, 25}};
        const auto area = [](const std::vector<Line>& outlines) {
            const RgbaImage image = paint({{outlines, false, {}, 1, false}}, {10, {0, 0}}, 400, 400);
            return std::count_if(image.begin(), image.end(), [](Rgba8 p) { return p.a >= 128; });
        };
        CHECK(std::abs(area({thick_line(way, style)}) - area(line_pieces(way, false, style))) < 60);
        for (const Line& piece : line_pieces(way, false, style)) CHECK(area_of(piece) >= 0);
    }
}

TEST_CASE("Open lines with a width are parts as thick as they are drawn", "[needs-pugixml]") {
    const std::string style = " fill='none' stroke='#112233' stroke-width='4' ";
    const Line bar = {{0, 2}, {30, 2}, {30, -2}, {0, -2}};
    for (const std::string& shape : Lines{"<line x2='30'" + style + "/>", "<path d='M0 0H30'" + style + "/>",
                                          "<polyline points='0,0 30,0'" + style + "/>",
                                          "<path d='M0 0H30' stroke='#123' stroke-width='4'/>"}) {
        CAPTURE(shape);
        const PartStroke part = only_part(svg(shape));
        CHECK(near(part.stroke, bar));
        CHECK(part.colour == Rgb8{0x11, 0x22, 0x33});
    }
    // As wide as the transform makes it: twice, or in one direction.
    CHECK(near(only_part(svg("<g transform='scale(2)'><line x2='30'" + style + "/></g>")).stroke,
               {{0, 4}, {60, 4}, {60, -4}, {0, -4}}));
    CHECK(near(only_part(svg("<line transform='scale(1 3)' x2='30'" + style + "/>")).stroke,
               {{0, 6}, {30, 6}, {30, -6}, {0, -6}}));
    CHECK(near(
        only_part(svg("<line transform='scale(2)' vector-effect='non-scaling-stroke' x2='30'" + style + "/>"))
            .stroke,
        {{0, 2}, {60, 2}, {60, -2}, {0, -2}}));
    CHECK(near(only_part(svg("<g stroke='red' stroke-width='4%'><line x2='30'/></g>", page)).stroke, bar));
    CHECK(std::abs(area_of(only_part(svg("<line x2='30' stroke-linecap='round'" + style + "/>")).stroke)) ==
          Approx(120 + 4 * math::pi).epsilon(0.01));
    // An outline of lines is what it encloses; one with a gap, too; a bent limb is not.
    CHECK(only_part(svg("<path d='M0 0h50v50h-50z'" + style + "/>")).stroke.size() == 4);
    const Strokes gap = svg("<path id='p' d='M0 0h50v50h-50v-40'" + style + "/>");
    CHECK(only_part(gap).stroke.size() == 5);
    CHECK(gap.repairs == Lines{"part 'p': the open path was closed"});
    CHECK(std::abs(area_of(only_part(svg("<path d='M0 0L30 5L60 0'" + style + "/>")).stroke)) ==
          Approx(4 * 2 * std::sqrt(925.0)).epsilon(0.02));
    // A drawing of nothing but thin lines has those.
    CHECK(svg("<path d='M0 0h30' stroke='red'/>").calls.size() == 1);
    CHECK(svg_error("<line id='l' x2='9' stroke='red' stroke-width='-1'/>") ==
          "drawing.svg: line 'l': stroke-width must not be negative");
}

TEST_CASE("A fill and the outline of the same shape are one part", "[needs-pugixml]") {
    const std::string fill = "<rect id='path1' width='40' height='30' fill='tan'/>",
                      line = "<rect id='belly' width='40' height='30' fill='none' stroke='#000'/>";
    for (const std::string& both : {fill + line, line + fill}) {
        const Strokes strokes = svg(both);
        CHECK(only_part(strokes).name == "belly"); // the name that says something
        CHECK(only_part(strokes).colour == Rgb8{0xd2, 0xb4, 0x8c});
        CHECK(strokes.repairs == Lines{"rect 'belly': the outline of rect 'path1', no part of its own"});
        CHECK(strokes.painting.size() == 2);
    }
    CHECK(svg(fill + "<rect x='9' width='40' height='30' fill='none' stroke='#000'/>").calls.size() == 2);
    CHECK(svg(fill + fill).calls.size() == 2); // two legs, one behind the other
}

TEST_CASE("Groups and classes name parts that have no telling name", "[needs-pugixml]") {
    const auto labels = [](const std::string& inside) {
        std::vector<Label> all;
        for (const PartStroke& part : parts_of(svg(inside))) all.push_back(part.label);
        return all;
    };
    const std::string p = "<path id='path7' d='M0 0h9v9z'/>";
    CHECK(labels("<g id='Head'>" + p + "<g>" + p + "</g></g><g id='body'>" + p + "</g>") ==
          std::vector{Label::head, Label::head, Label::body});
    CHECK(labels("<path class='tail' d='M0 0h9v9z'/><path class='st0 leg' d='M0 0h9v9z'/>") ==
          std::vector{Label::tail, Label::limb});
    // The shape's own name is stronger; a group around everything tells nothing.
    CHECK(labels("<g id='head'><path id='left_wing' d='M0 0h9v9z'/>" + p + "</g>") ==
          std::vector{Label::background, Label::head});
    CHECK(labels("<g id='body'>" + p + p + "</g>") == std::vector{Label::background, Label::background});
}

TEST_CASE("Colours are those of CSS") {
    const auto is = [](const std::string& text, Rgb8 colour, double alpha = 1) {
        const auto found = svg_colour(text);
        return found && found->colour == colour && std::abs(found->alpha - alpha) < 1e-9;
    };
    CHECK(is("#abc", {0xaa, 0xbb, 0xcc}));
    CHECK(is("#aabbcc80", {0xaa, 0xbb, 0xcc}, 128 / 255.0));
    CHECK(is("#abc0", {0xaa, 0xbb, 0xcc}, 0));
    CHECK(is("rgba(1, 2, 3, 0.25)", {1, 2, 3}, 0.25));
    CHECK(is("rgb(100% 0% 50% / 25%)", {255, 0, 128}, 0.25));
    CHECK(is("rgba(1, 2, 3, .5 )", {1, 2, 3}, 0.5));
    CHECK(is("hsl(0, 100%, 50%)", {255, 0, 0}));
    CHECK(is("hsl(60deg 100% 50%)", {255, 255, 0}));
    CHECK(is("hsl(210, 50%, 40%)", {51, 102, 153}));
    CHECK(is("aliceblue", {0xf0, 0xf8, 0xff}));
    CHECK(is("yellowgreen", {0x9a, 0xcd, 0x32}));
    CHECK(is("transparent", {0, 0, 0}, 0));
    for (const char* none : {"", "#", "#ab", "#abcde", "#ggg", "rgb(1,2)", "rgb(", "reddish", "hsl(a,b,c)"})
        CHECK_FALSE(svg_colour(none));
    CHECK(svg_opacity("50%") == 0.5);
    CHECK(svg_opacity("7") == 1);
    CHECK(svg_opacity("-1") == 0);
    CHECK(svg_opacity("", 0.25) == 0.25);
}

TEST_CASE("Painting covers pixels by area, over what is below") {
    const Line half = {{-0.5, -0.5}, {1.5, -0.5}, {1.5, 0.5}, {-0.5, 0.5}};
    RgbaImage image = paint({{{half}, false, {10, 20, 30}, 1, false}}, {}, 3, 2);
    CHECK(image(0, 0) == Rgba8{10, 20, 30, 255});
    CHECK(image(1, 0) == Rgba8{10, 20, 30, 255});
    CHECK(image(2, 0) == Rgba8{});
    CHECK(image(0, 1) == Rgba8{});
    // Half a pixel to the right, half opaque.
    image = paint({{{half}, false, {10, 20, 30}, 0.5, false}}, {1, {0.5, 0}}, 3, 1);
    CHECK(static_cast<int>(image(0, 0).a) == 64);
    CHECK(static_cast<int>(image(1, 0).a) == 128);
    // Half white over black is grey.
    const PaintedShape black{{half}, false, {0, 0, 0}, 1, false},
        veil{{half}, false, {255, 255, 255}, 0.5, false};
    CHECK(paint({black, veil}, {}, 1, 1)(0, 0) == Rgba8{128, 128, 128, 255});
    // Two outlines of one sense, and the rules.
    const Line big = {{-1, -1}, {5, -1}, {5, 5}, {-1, 5}},
               inner = {{1.5, 1.5}, {2.5, 1.5}, {2.5, 2.5}, {1.5, 2.5}};
    CHECK(paint({{{big, inner}, false, {}, 1, false}}, {}, 4, 4)(2, 2).a == 255);
    CHECK(paint({{{big, inner}, true, {}, 1, false}}, {}, 4, 4)(2, 2).a == 0);
}

// --- what stands beside the figure
// ---------------------------------------------------------------------------

namespace {

const std::string dog =
    "<ellipse id='p1' cx='50' cy='45' rx='25' ry='12'/><circle id='p2' cx='22' cy='30' r='10'/>"
    "<rect id='p3' x='32' y='50' width='6' height='28'/><rect id='p4' x='62' y='50' width='6' height='28'/>";
const Lines dog_names = {"p1", "p2", "p3", "p4"};

bool has_line(const Strokes& strokes, const std::string& text) {
    return std::any_of(strokes.repairs.begin(), strokes.repairs.end(),
                       [&](const std::string& line) { return line.find(text) != std::string::npos; });
}

} // namespace

TEST_CASE("An element that cannot be read is left out with a line, the others stay", "[svg][needs-pugixml]") {
    for (const std::string bad :
         {"<path id='b' d='M 1 2 L nonsense'/>", "<circle id='b' cx='undefined' cy='3' r='4'/>",
          "<polygon id='b' points='1 2 3'/>", "<rect id='b' x='NaN' y='0' width='5' height='5'/>",
          "<g id='b' transform='spin(3)'><rect width='5' height='5'/></g>"}) {
        CAPTURE(bad);
        const Strokes strokes = svg(dog + bad, "viewBox='0 0 100 100'");
        CHECK(names_of(strokes) == dog_names);
        REQUIRE(strokes.repairs.size() == 1);
        CHECK(strokes.repairs[0].find(" 'b': ") != std::string::npos);
        CHECK(strokes.repairs[0].ends_with(", left out"));
    }
    // Alone it is an error that says why, and so is a mistake in an attribute of ours.
    CHECK(svg_error("<path id='b' d='M 1 2 L nonsense'/>").starts_with("drawing.svg: path 'b': "));
    CHECK(svg_error(dog + "<rect width='5' height='5' data-depth='deep'/>").find("data-depth") !=
          std::string::npos);
}

TEST_CASE("Frames, bands across the page and shadows on the ground are no parts", "[svg][needs-pugixml]") {
    const auto left_out = [&](const std::string& behind, const std::string& why) {
        const Strokes strokes = svg(behind + dog, "viewBox='0 0 100 100'");
        CAPTURE(behind);
        CHECK(names_of(strokes) == dog_names);
        CHECK(has_line(strokes, why));
    };
    left_out("<rect x='5' y='5' width='90' height='85' fill='none' stroke='black' stroke-width='2'/>",
             "a frame around everything");
    left_out("<path fill-rule='evenodd' fill='white' d='M2 2H98V98H2Z M6 6V94H94V6Z'/>", ", left out");
    left_out(
        "<rect width='100' height='60' fill='skyblue'/><rect y='60' width='100' height='40' fill='green'/>",
        "a ground as wide as the page");
    left_out("<ellipse cx='50' cy='79' rx='30' ry='4' fill='black' fill-opacity='.2'/>",
             "a shadow on the ground");
    left_out("<ellipse cx='50' cy='79' rx='30' ry='4' fill='#bbb'/>", "a shadow on the ground");
    // A skateboard is none of these, nor is a shape that has a name, nor the outline of a face.
    const auto kept = [&](const std::string& shape, std::size_t parts) {
        CAPTURE(shape);
        CHECK(svg(shape + dog, "viewBox='0 0 100 100'").calls.size() == parts);
    };
    kept("<ellipse cx='50' cy='79' rx='30' ry='4' fill='crimson'/>", 5);
    kept("<ellipse id='foot' cx='50' cy='79' rx='30' ry='4' fill='#bbb'/>", 5);
    CHECK(svg("<circle cx='50' cy='50' r='45' fill='none' stroke='black' stroke-width='4'/>"
              "<circle cx='35' cy='40' r='5'/><circle cx='65' cy='40' r='5'/>",
              "viewBox='0 0 100 100'")
              .calls.size() == 3);
}

TEST_CASE("Transforms turn about their origin; the outermost element is :root, screens are all media",
          "[svg][needs-pugixml]") {
    const auto corner = [](const std::string& attributes) {
        const Line stroke =
            only_part(svg("<rect width='10' height='4' " + attributes + "/>", "viewBox='0 0 100 60'")).stroke;
        return stroke.front();
    };
    const auto is_at = [&](const std::string& attributes, Point2d p) {
        CAPTURE(attributes);
        CHECK(distance(corner(attributes), p) < 1e-9);
    };
    is_at("transform='rotate(180)' transform-origin='20 10'", {40, 20});
    is_at("transform='rotate(180)' style='transform-origin: 50% 50%'", {100, 60});
    is_at("transform='rotate(180)' style='transform-origin: right bottom'", {200, 120});
    is_at("style='transform: rotate(180deg); transform-origin: 20px 10px'", {40, 20});
    is_at("transform='translate(3 4)' transform-origin='20 10'", {3, 4});
    const auto colour = [](const std::string& css) {
        return only_part(svg("<style>" + css + "</style><rect width='10' height='4' class='a'/>")).colour;
    };
    const Rgb8 red{255, 0, 0};
    CHECK(colour(":root { --fur: #f00 } .a { fill: var(--fur) }") == red);
    CHECK(colour("@media screen { .a { fill: #f00 } }") == red);
    CHECK(colour("@media all { .a { fill: #f00 } } .b { fill: blue }") == red);
    CHECK(colour("@media print { .a { fill: blue } } .a { fill: #f00 }") == red);
}
