// SPDX-License-Identifier: MIT
// Declarations in, paint out (SVG 2, chapters 13 and 14; CSS Custom Properties 1, W3C 2022).
#include "modeling/pugixml/svg_paint.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "modeling/pugixml/svg_text.hpp"
#include "modeling/svg_colour.hpp"
#include "pantin/error.hpp"

namespace pantin::svg {
namespace {

constexpr double unseen = 1.0 / 255; // opacities below it leave no mark on 8 bits
constexpr int longest_chain = 20;    // gradients that refer to gradients, variables to variables

// The mean of a gradient's stops, by alpha; nothing when there is none.
std::optional<SvgColour> gradient_colour(pugi::xml_node gradient, const StyleSheets& sheets,
                                         const Identified& identified) {
    for (int step = 0; gradient && step < longest_chain; ++step) {
        std::array<double, 3> sum{};
        double alphas = 0;
        int count = 0;
        for (const pugi::xml_node stop : gradient.children()) {
            if (kind_of(stop) != "stop") continue;
            Style style = sheets.style_of(stop);
            for (const char* name : {"stop-color", "stop-opacity"})
                if (!style.contains(name)) style[name] = attribute(stop, name);
            const auto colour = svg_colour(small(style["stop-color"])).value_or(SvgColour{});
            const double alpha = colour.alpha * svg_opacity(style["stop-opacity"]);
            sum[0] += alpha * colour.colour.r, sum[1] += alpha * colour.colour.g;
            sum[2] += alpha * colour.colour.b;
            alphas += alpha;
            ++count;
        }
        if (count > 0 && alphas == 0) return SvgColour{{}, 0};
        const auto mean = [&](double s) { return static_cast<std::uint8_t>(std::floor(s / alphas + 0.5)); };
        if (count > 0) return SvgColour{{mean(sum[0]), mean(sum[1]), mean(sum[2])}, alphas / count};
        const std::string href = reference(gradient);
        const auto next = href.starts_with('#') ? identified.find(href.substr(1)) : identified.end();
        gradient = next == identified.end() ? pugi::xml_node() : next->second;
    }
    return {};
}

// "url(#id) fallback": the id; empty for anything else.
std::string url_of(const std::string& text, std::string& fallback) {
    const std::size_t close = text.find(')');
    if (!small(text).starts_with("url(") || close == std::string::npos) return {};
    fallback = one_line(text.substr(close + 1));
    std::string id = one_line(text.substr(4, close - 4));
    std::erase_if(id, [](char c) { return c == '"' || c == '\''; });
    return id.starts_with('#') ? id.substr(1) : "";
}

} // namespace

bool Paint::seen() const { return opacity >= unseen; }

Look Look::inside(const Style& own) const {
    Look look = *this;
    look.values_.erase("vector-effect");
    for (const auto& [name, value] : own)
        if (small(value) != "inherit") look.values_[name] = value;
    if (const auto opacity = own.find("opacity"); opacity != own.end())
        look.opacity_ *= svg_opacity(opacity->second);
    const auto is = [&](const char* name, const char* value) {
        const auto found = own.find(name);
        return found != own.end() && small(found->second) == value;
    };
    look.displayed_ = displayed_ && !is("display", "none");
    for (const char* name : {"clip-path", "mask"})
        look.clipped_ = look.clipped_ || (own.contains(name) && !is(name, "none"));
    return look;
}

// "var(--name, otherwise)" is what the name stands for.
std::string Look::value(const std::string& name, const std::string& missing) const {
    const auto found = values_.find(name);
    std::string text = found == values_.end() ? missing : found->second;
    for (int step = 0; text.starts_with("var(") && text.ends_with(')') && step < longest_chain; ++step) {
        const std::size_t comma = std::min(text.find(','), text.size() - 1);
        const auto variable = values_.find(small(one_line(text.substr(4, comma - 4))));
        if (variable != values_.end())
            text = variable->second;
        else
            text =
                comma + 1 < text.size() ? one_line(text.substr(comma + 1, text.size() - comma - 2)) : missing;
    }
    return text;
}

bool Look::visible() const {
    const std::string visibility = small(value("visibility"));
    return visibility != "hidden" && visibility != "collapse";
}

Paint Look::paint(const std::string& property, const std::string& missing, const StyleSheets& sheets,
                  const Identified& identified) const {
    Paint paint;
    paint.given = values_.contains(property);
    std::string text = value(property, missing), fallback;
    const double own = opacity_ * svg_opacity(value(property + "-opacity"));
    if (const std::string id = url_of(text, fallback); !id.empty()) {
        const auto found = identified.find(id);
        const pugi::xml_node server = found == identified.end() ? pugi::xml_node() : found->second;
        const bool gradient = among(kind_of(server), {"linearGradient", "radialGradient"});
        if (const auto colour = gradient ? gradient_colour(server, sheets, identified) : std::nullopt) {
            paint.colour = colour->colour;
            paint.opacity = own * colour->alpha;
            return paint;
        }
        if (!fallback.empty()) text = fallback;
    }
    text = small(text);
    if (text == "currentcolor") text = small(value("color", "black"));
    if (text == "none" || text.empty()) return paint;
    if (const auto colour = svg_colour(text)) {
        paint.colour = colour->colour;
        paint.opacity = own * colour->alpha;
    } else {
        paint.odd = text;
        paint.opacity = own;
    }
    return paint;
}

Paint Look::fill(const StyleSheets& sheets, const Identified& identified) const {
    return paint("fill", "black", sheets, identified);
}

Paint Look::stroke(const StyleSheets& sheets, const Identified& identified) const {
    return paint("stroke", "none", sheets, identified);
}

FillRule Look::fill_rule() const {
    return small(value("fill-rule")) == "evenodd" ? FillRule::even_odd : FillRule::nonzero;
}

bool Look::width_given() const { return values_.contains("stroke-width"); }

LineStyle Look::line(const Viewport& viewport, const std::string& where) const {
    LineStyle style;
    const std::string place = where + ": stroke-width", cap = value("stroke-linecap"),
                      join = value("stroke-linejoin");
    style.width = svg_length(value("stroke-width", "1"), place, viewport.diagonal());
    if (style.width < 0) throw Error(ErrorKind::input, place + " must not be negative");
    style.cap = cap == "round" ? LineCap::round : cap == "square" ? LineCap::square : LineCap::butt;
    style.join = join == "round" ? LineJoin::round : join == "bevel" ? LineJoin::bevel : LineJoin::miter;
    return style;
}

} // namespace pantin::svg
