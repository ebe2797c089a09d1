// SPDX-License-Identifier: MIT
// Attribute text of an SVG in, polylines, matrices and numbers out (SVG 2, W3C 2018, chapters 8 and 9).
#include "modeling/svg_path.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/math.hpp"
#include "geometry/extent.hpp"
#include "pantin/error.hpp"

namespace pantin {
namespace {

constexpr double chord_error = 1.0 / 2000; // of the diagonal of the path
constexpr int probes = 8;                  // points of a curve by which the diagonal is measured
constexpr double most_chords = 10000;      // of one curve; a guard, real curves need a few dozen

// --- characters --------------------------------------------------------------------------------------------

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

class Scanner {
public:
    Scanner(const std::string& text, const std::string& where) : text_(text), where_(where) {}

    [[noreturn]] void fail(const std::string& fact) const {
        throw Error(ErrorKind::input, where_ + ", character " + std::to_string(at_ + 1) + ": " + fact);
    }
    // 0 at the end.
    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    bool at_end() const { return at_ >= text_.size(); }
    void step() { ++at_; }
    void skip_space() {
        while (!at_end() && is_space(text_[at_])) ++at_;
    }
    bool take(char c) {
        skip_space();
        const bool found = !at_end() && text_[at_] == c;
        at_ += found;
        return found;
    }
    std::string word() {
        const std::size_t from = at_;
        while (is_letter(peek())) ++at_;
        return text_.substr(from, at_ - from);
    }

    // Before the first number of a list: no comma may come before it.
    void begin_list() { fresh_ = true; }
    // Whether the list goes on; after a comma it has to.
    bool more_numbers() {
        skip_space();
        return (!fresh_ && peek() == ',') || is_digit(peek()) || peek() == '.' || peek() == '+' ||
               peek() == '-';
    }
    double number() {
        skip_separator();
        const std::size_t from = at_;
        if (!pass_number()) {
            at_ = from;
            fail("a number is missing");
        }
        // from_chars knows no plus sign.
        const char* first = text_.data() + from + (text_[from] == '+');
        double value = 0;
        const std::from_chars_result result = std::from_chars(first, text_.data() + at_, value);
        if (result.ec != std::errc() || !(std::abs(value) <= svg_limit)) {
            at_ = from;
            fail("a number is out of range");
        }
        return value;
    }
    // One character, so that "a1 1 0 015 5" is read as SVG wants it.
    bool flag() {
        skip_separator();
        if (peek() != '0' && peek() != '1') fail("an arc's flag must be 0 or 1");
        return text_[at_++] == '1';
    }

private:
    const std::string& text_;
    const std::string& where_;
    std::size_t at_ = 0;
    bool fresh_ = true;

    void skip_separator() {
        skip_space();
        if (!fresh_ && peek() == ',') {
            ++at_;
            skip_space();
        }
        fresh_ = false;
    }
    bool pass_digits() {
        const std::size_t from = at_;
        while (is_digit(peek())) ++at_;
        return at_ > from;
    }
    bool pass_number() {
        if (peek() == '+' || peek() == '-') ++at_;
        bool digits = pass_digits();
        if (peek() == '.') {
            ++at_;
            digits = pass_digits() || digits;
        }
        // Only an e with digits is an exponent; "1em" is a length.
        if (digits && (peek() == 'e' || peek() == 'E')) {
            const std::size_t mark = at_++;
            if (peek() == '+' || peek() == '-') ++at_;
            if (!pass_digits()) at_ = mark;
        }
        return digits;
    }
};

// --- angles ------------------------------------------------------------------------------------------------

struct Turn {
    double cosine = 1, sine = 0;
};
// Right angles are exact, so that a drawing on its side keeps straight edges straight.
Turn turn_of(double degrees) {
    const double rest = std::fmod(degrees, 360); // exact
    if (rest == 0) return {1, 0};
    if (rest == 90 || rest == -270) return {0, 1};
    if (std::abs(rest) == 180) return {-1, 0};
    if (rest == 270 || rest == -90) return {0, -1};
    const double angle = rest * math::pi / 180;
    return {math::cos(angle), math::sin(angle)};
}

// --- pieces of a path --------------------------------------------------------------------------------------

// centre + cos θ · u + sin θ · v, θ from start to start + sweep.
struct Ellipse {
    Point2d centre, u, v;
    double start = 0, sweep = 0;
};
// A line or a Bézier curve with its control points; with an ellipse: its arc between the first and the last
// point.
struct Piece {
    std::vector<Point2d> controls;
    std::optional<Ellipse> ellipse;
};
struct Outline {
    Point2d start;
    std::vector<Piece> pieces;
    bool closed = false;
};

Point2d linear(const Affine& m, Point2d p) { return {m.a * p.x + m.c * p.y, m.b * p.x + m.d * p.y}; }

void move(Piece& piece, const Affine& m) {
    for (Point2d& p : piece.controls) p = m * p;
    if (piece.ellipse) {
        Ellipse& e = *piece.ellipse;
        e = {m * e.centre, linear(m, e.u), linear(m, e.v), e.start, e.sweep};
    }
}

Point2d point_at(const Piece& piece, double t) {
    if (piece.ellipse) {
        const Ellipse& e = *piece.ellipse;
        const double angle = e.start + t * e.sweep;
        return e.centre + math::cos(angle) * e.u + math::sin(angle) * e.v;
    }
    std::array<Point2d, 4> p; // de Casteljau
    std::copy(piece.controls.begin(), piece.controls.end(), p.begin());
    for (std::size_t left = piece.controls.size() - 1; left > 0; --left)
        for (std::size_t i = 0; i < left; ++i) p[i] = p[i] + t * (p[i + 1] - p[i]);
    return p[0];
}

// How many chords of equal parameter stay within the tolerance. A chord over a step h of the parameter is off
// by at most h²/8 · max |p″|; a Bézier curve of degree d has |p″| ≤ d (d − 1) · the largest second difference
// of its control points, an ellipse |p″| ≤ √(|u|² + |v|²).
int chords_of(const Piece& piece, double tolerance) {
    double bend = 0;
    if (piece.ellipse) {
        const Ellipse& e = *piece.ellipse;
        bend = e.sweep * e.sweep * std::sqrt(dot(e.u, e.u) + dot(e.v, e.v));
    } else {
        const std::vector<Point2d>& p = piece.controls;
        const double degree = static_cast<double>(p.size() - 1);
        for (std::size_t i = 2; i < p.size(); ++i)
            bend = std::max(bend, degree * (degree - 1) * length(p[i] - 2 * p[i - 1] + p[i - 2]));
    }
    if (!(bend > 0) || !(tolerance > 0)) return 1;
    return static_cast<int>(std::clamp(std::ceil(std::sqrt(bend / (8 * tolerance))), 1.0, most_chords));
}

double diagonal_of(const std::vector<Outline>& outlines) {
    std::vector<Point2d> points;
    for (const Outline& outline : outlines) {
        points.push_back(outline.start);
        for (const Piece& piece : outline.pieces) {
            points.push_back(piece.controls.back());
            const bool straight = !piece.ellipse && piece.controls.size() == 2;
            for (int k = 1; k < probes && !straight; ++k)
                points.push_back(point_at(piece, static_cast<double>(k) / probes));
        }
    }
    return points.empty() ? 0 : diagonal_of(points);
}

Subpath flatten(const Outline& outline, double tolerance) {
    Subpath subpath{{outline.start}, outline.closed};
    for (const Piece& piece : outline.pieces) {
        const int chords = chords_of(piece, tolerance);
        for (int k = 1; k < chords; ++k)
            subpath.points.push_back(point_at(piece, static_cast<double>(k) / chords));
        subpath.points.push_back(piece.controls.back());
    }
    return subpath;
}

// --- arcs --------------------------------------------------------------------------------------------------

// The arc as SVG gives it, from the centre of its chord; `half` leads from there to where it begins.
struct EndPointArc {
    double rx = 0, ry = 0;
    Turn turn;
    bool large = false, sweep = false;
};

// SVG 2, appendix B.2.4: from end points to the centre, in the frame in which the ellipse is the unit circle,
// where the numbers stay moderate whatever the radii; B.2.5 for radii that are too small. Nothing where the
// arc is a line.
std::optional<Ellipse> ellipse_of(const EndPointArc& arc, Point2d middle, Point2d half) {
    double rx = std::abs(arc.rx), ry = std::abs(arc.ry);
    if (rx == 0 || ry == 0) return {};
    const auto [cosine, sine] = arc.turn;
    Point2d p = {(cosine * half.x + sine * half.y) / rx, (cosine * half.y - sine * half.x) / ry};
    const double square = dot(p, p);
    if (!(square > 0) || !std::isfinite(square)) return {};
    if (square > 1) {
        const double grow = std::sqrt(square);
        rx *= grow;
        ry *= grow;
        p = 1 / grow * p;
    }
    const double away = square < 1 ? std::sqrt(1 / square - 1) : 0;
    const double signed_away = arc.large == arc.sweep ? -away : away;
    const Point2d c = {signed_away * p.y, -signed_away * p.x};
    Ellipse e;
    e.u = rx * Point2d{cosine, sine};
    e.v = ry * Point2d{-sine, cosine};
    e.centre = middle + c.x * e.u + c.y * e.v;
    e.start = math::atan2(p.y - c.y, p.x - c.x);
    e.sweep = math::atan2(-p.y - c.y, -p.x - c.x) - e.start;
    const double whole = arc.sweep ? 2 * math::pi : -2 * math::pi;
    if (e.sweep * whole < 0) e.sweep += whole;
    // Where the chord is tiny, rounding may take almost nothing for a whole turn and the other way round.
    if (!arc.large && std::abs(e.sweep) > math::pi + 0.1) e.sweep -= whole;
    if (arc.large && std::abs(e.sweep) < math::pi - 0.1) e.sweep += whole;
    return e;
}

// --- path data ---------------------------------------------------------------------------------------------

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

class PathReader {
public:
    PathReader(const std::string& data, const std::string& where) : scan_(data, where) {}

    std::vector<Outline> read() {
        for (scan_.skip_space(); !scan_.at_end(); scan_.skip_space()) read_command();
        return std::move(outlines_);
    }

private:
    Scanner scan_;
    std::vector<Outline> outlines_;
    Point2d start_, here_;
    Point2d control_;    // the last one of a curve, for S and T
    char before_ = '\0'; // the command before, as a capital
    bool relative_ = false;

    void read_command() {
        const char letter = scan_.peek();
        char command = upper(letter);
        if (letter == '\0' || std::string_view("MZLHVCSQTA").find(command) == std::string_view::npos)
            scan_.fail(is_letter(letter) ? std::string("there is no command '") + letter + "'"
                                         : "a command is missing");
        if (outlines_.empty() && command != 'M') scan_.fail("a path begins with M");
        relative_ = letter != command;
        scan_.step();
        if (command == 'Z') return close();
        scan_.begin_list();
        do {
            read_segment(command);
            before_ = command;
            if (command == 'M') command = 'L'; // further pairs are lines
        } while (scan_.more_numbers());
    }
    void read_segment(char command) {
        switch (command) {
        case 'M':
            return move_to(point());
        case 'L':
            return add({here_, point()});
        case 'H':
            return add({here_, {scan_.number() + (relative_ ? here_.x : 0), here_.y}});
        case 'V':
            return add({here_, {here_.x, scan_.number() + (relative_ ? here_.y : 0)}});
        case 'A':
            return read_arc();
        default:
            return read_curve(command);
        }
    }
    void read_curve(char command) {
        const bool cubic = command == 'C' || command == 'S';
        const bool smooth = cubic ? before_ == 'C' || before_ == 'S' : before_ == 'Q' || before_ == 'T';
        Piece piece{{here_}, {}};
        if (command == 'S' || command == 'T')
            piece.controls.push_back(smooth ? 2 * here_ - control_ : here_);
        else
            piece.controls.push_back(point());
        if (cubic) piece.controls.push_back(point());
        control_ = piece.controls.back();
        piece.controls.push_back(point());
        add(std::move(piece));
    }
    void read_arc() {
        EndPointArc arc;
        arc.rx = scan_.number();
        arc.ry = scan_.number();
        arc.turn = turn_of(scan_.number());
        arc.large = scan_.flag();
        arc.sweep = scan_.flag();
        const Point2d to = point();
        if (to == here_) return; // B.2.5: as if it were not there
        add({{here_, to}, ellipse_of(arc, 0.5 * (here_ + to), 0.5 * (here_ - to))});
    }

    Point2d point() {
        const double x = scan_.number(), y = scan_.number();
        return relative_ ? here_ + Point2d{x, y} : Point2d{x, y};
    }
    void move_to(Point2d p) {
        start_ = here_ = p;
        outlines_.push_back({p, {}, false});
    }
    void close() {
        // A second Z closes nothing more.
        if (before_ != 'Z') outlines_.back().closed = true;
        here_ = start_;
        before_ = 'Z';
    }
    void add(std::vector<Point2d> controls) { add(Piece{std::move(controls), {}}); }
    void add(Piece piece) {
        if (outlines_.back().closed) outlines_.push_back({start_, {}, false}); // after a Z without an M
        here_ = piece.controls.back();
        outlines_.back().pieces.push_back(std::move(piece));
    }
};

// --- transforms --------------------------------------------------------------------------------------------

Affine skew(Scanner& scan, double degrees, bool along_x) {
    const Turn turn = turn_of(degrees);
    if (turn.cosine == 0) scan.fail("a skew by a right angle");
    const double tangent = turn.sine / turn.cosine;
    return along_x ? Affine{1, 0, tangent, 1, 0, 0} : Affine{1, tangent, 0, 1, 0, 0};
}

Affine rotation(const std::vector<double>& v) {
    const Turn turn = turn_of(v[0]);
    const Affine about_origin = {turn.cosine, turn.sine, -turn.sine, turn.cosine, 0, 0};
    if (v.size() == 1) return about_origin;
    return Affine{1, 0, 0, 1, v[1], v[2]} * about_origin * Affine{1, 0, 0, 1, -v[1], -v[2]};
}

Affine transform_of(Scanner& scan, const std::string& name, const std::vector<double>& v) {
    const std::size_t n = v.size();
    if (name == "matrix" && n == 6) return {v[0], v[1], v[2], v[3], v[4], v[5]};
    if (name == "translate" && (n == 1 || n == 2)) return {1, 0, 0, 1, v[0], n == 2 ? v[1] : 0};
    if (name == "scale" && (n == 1 || n == 2)) return {v[0], 0, 0, n == 2 ? v[1] : v[0], 0, 0};
    if (name == "rotate" && (n == 1 || n == 3)) return rotation(v);
    if (name == "skewX" && n == 1) return skew(scan, v[0], true);
    if (name == "skewY" && n == 1) return skew(scan, v[0], false);
    const std::array<std::string_view, 6> known = {"matrix", "translate", "scale",
                                                   "rotate", "skewX",     "skewY"};
    if (std::find(known.begin(), known.end(), name) == known.end())
        scan.fail("there is no transform '" + name + "'");
    scan.fail("'" + name + "' does not take " + std::to_string(n) + (n == 1 ? " number" : " numbers"));
}

std::vector<double> read_list(Scanner& scan) {
    std::vector<double> numbers;
    scan.begin_list();
    while (scan.more_numbers()) numbers.push_back(scan.number());
    return numbers;
}

} // namespace

bool is_moderate(const Affine& m) {
    const std::array<double, 6> all = {m.a, m.b, m.c, m.d, m.e, m.f};
    return std::all_of(all.begin(), all.end(), [](double x) { return std::abs(x) <= svg_limit; });
}

std::vector<Subpath> svg_path(const std::string& data, const Affine& transform, const std::string& where) {
    if (data == "none") return {};
    std::vector<Outline> outlines = PathReader(data, where).read();
    for (Outline& outline : outlines) {
        outline.start = transform * outline.start;
        for (Piece& piece : outline.pieces) move(piece, transform);
    }
    const double tolerance = chord_error * diagonal_of(outlines);
    std::vector<Subpath> subpaths;
    for (const Outline& outline : outlines) subpaths.push_back(flatten(outline, tolerance));
    return subpaths;
}

Affine svg_transform(const std::string& text, const std::string& where) {
    Scanner scan(text, where);
    Affine all;
    scan.skip_space();
    if (text == "none") return all;
    while (!scan.at_end()) {
        const std::string name = scan.word();
        if (name.empty()) scan.fail("the name of a transform is missing");
        if (!scan.take('(')) scan.fail("'(' is missing");
        const std::vector<double> numbers = read_list(scan);
        if (!scan.take(')')) scan.fail("')' is missing");
        all = all * transform_of(scan, name, numbers);
        if (!is_moderate(all)) scan.fail("a number is out of range");
        scan.take(',');
        scan.skip_space();
    }
    return all;
}

std::vector<double> svg_numbers(const std::string& text, const std::string& where) {
    Scanner scan(text, where);
    std::vector<double> numbers = read_list(scan);
    if (!scan.at_end()) scan.fail("a number is missing");
    return numbers;
}

double svg_length(const std::string& text, const std::string& where, double whole) {
    constexpr double font = 16; // the usual size of text, which no shape depends on
    constexpr auto units = std::to_array<std::pair<std::string_view, double>>({{"", 1},
                                                                               {"px", 1},
                                                                               {"in", 96},
                                                                               {"cm", 96 / 2.54},
                                                                               {"mm", 96 / 25.4},
                                                                               {"Q", 96 / 101.6},
                                                                               {"pt", 96 / 72.0},
                                                                               {"pc", 16},
                                                                               {"em", font},
                                                                               {"rem", font},
                                                                               {"ex", font / 2}});
    Scanner scan(text, where);
    const double number = scan.number();
    const bool percent = scan.peek() == '%';
    if (percent) scan.step();
    const std::string unit = scan.word();
    const auto known =
        std::find_if(units.begin(), units.end(), [&](const auto& u) { return u.first == unit; });
    scan.skip_space();
    if (known == units.end() || (percent && !unit.empty()) || !scan.at_end())
        scan.fail("only the units px, in, cm, mm, Q, pt, pc, em, rem, ex and % are known");
    return percent ? number / 100 * whole : number * known->second;
}

} // namespace pantin
