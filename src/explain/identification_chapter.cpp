// SPDX-License-Identifier: MIT
// Step 4: each reference beside the character, what was matched, and what the distance is the sum of.
#include <algorithm>

#include "core/plural.hpp"
#include "explain/chapters.hpp"
#include "explain/palette.hpp"
#include "explain/svg.hpp"

namespace pantin {

namespace {

constexpr double panel = 200; // side of a graph's picture
constexpr double gap = 40, margin = 22;

// A graph in its own box of 0 to 1, as it is compared; matched vertices have numbers, the others are grey.
void draw(Svg& svg, const LabelledGraph& graph, double left, const std::vector<int>& numbers) {
    const auto at = [&](int i) {
        return Point2d{left + panel * graph.positions[i].x, panel * graph.positions[i].y};
    };
    for (const auto& [u, v] : graph.edges)
        svg.line(at(u), at(v), numbers[u] && numbers[v] ? "#111" : "#999", 2);
    for (int i = 0; i < std::ssize(graph.positions); ++i) {
        const bool matched = numbers[i] > 0;
        svg.disc(at(i), matched ? 9 : 5, matched ? css(graph.labels[i]) : "#999");
        if (!matched) continue;
        const std::string text = std::to_string(numbers[i]);
        svg.raw("<text x=\"" + decimal(at(i).x) + "\" y=\"" + decimal(at(i).y + 4) +
                "\" font-size=\"11\" text-anchor=\"middle\" fill=\"#fff\">" + text + "</text>");
    }
}

std::string pair_picture(const LabelledGraph& drawn, const LabelledGraph& reference,
                         const Candidate& candidate) {
    std::vector<int> left(drawn.positions.size()), right(reference.positions.size());
    int number = 0;
    for (const auto& [u, v] : candidate.pairs) left[u] = right[v] = ++number;
    Svg svg(2 * panel + gap, panel,
            "The character's graph and the " + candidate.reference +
                ", matched vertices with the same number",
            margin);
    draw(svg, drawn, 0, left);
    draw(svg, reference, panel + gap, right);
    return svg.str("pair");
}

struct Term {
    const char* name;
    double value;
};

std::string bars(const std::vector<Term>& terms, double most) {
    std::string rows;
    for (const Term& term : terms)
        rows += "<tr><th scope=\"row\">" + std::string(term.name) +
                "</th><td class=\"bar\"><span style=\"width:" +
                decimal(most > 0 ? 100 * std::max(0.0, term.value) / most : 0, 1) + "%\"></span></td><td>" +
                decimal(term.value, 3) + "</td></tr>";
    return rows;
}

std::vector<Term> terms_of(const GgdTerms& t) {
    return {{"moving matched vertices", t.places},
            {"changing their labels", t.labels},
            {"stretching matched edges", t.lengths},
            {"deleting edges of the drawing", t.edges_a},
            {"adding edges of the reference", t.edges_b}};
}

std::string evidence(const Candidate& candidate) {
    if (candidate.evidence.empty()) return "";
    std::string rows;
    double most = 0;
    for (const auto& [name, value] : candidate.evidence) most = std::max(most, std::abs(value));
    for (const auto& [name, value] : candidate.evidence) {
        const double half = most > 0 ? 50 * std::abs(value) / most : 0;
        rows += "<tr><th scope=\"row\">" + escaped(name) + "</th><td class=\"bar both\"><span class=\"" +
                (value < 0 ? "for" : "against") + "\" style=\"" + (value < 0 ? "right:50%" : "left:50%") +
                ";width:" + decimal(half, 1) + "%\"></span></td><td>" + decimal(value, 3) + "</td></tr>";
    }
    return "<details><summary>Evidence that adds up to the score (to the left: speaks for "
           "it)</summary><table class=\"bars\">" +
           rows + "</table></details>";
}

std::string candidate_figure(const ChapterInput& input, const LabelledGraph& drawn,
                             const Candidate& candidate, double most, bool chosen) {
    const LabelledGraph model =
        normalised(to_labelled_graph(find_reference(input.context.references(), candidate.reference)));
    return "<section class=\"candidate" + std::string(chosen ? " chosen" : "") + "\"><h4>" +
           escaped(candidate.reference) + (candidate.mirrored ? ", mirrored" : "") +
           (chosen ? " — chosen" : "") + "</h4>" +
           pair_picture(drawn, candidate.mirrored ? mirrored(model) : model, candidate) + "<p>distance " +
           decimal(candidate.distance, 3) + ", score " + decimal(candidate.score, 3) + ", " +
           count_of(static_cast<long>(candidate.pairs.size()), "vertex", "vertices") + " matched" +
           (candidate.optimal ? "" : ", search cut off at its limit") + "</p><table class=\"bars\">" +
           bars(terms_of(candidate.terms), most) + "</table>" + evidence(candidate) + "</section>";
}

} // namespace

Values identify_chapter(const ChapterInput& input) {
    const Identification& identification = input.character.identification;
    const LabelledGraph drawn = normalised(to_labelled_graph(input.character.skeletonization.graph));
    double most = 0;
    for (const Candidate& c : identification.candidates)
        for (const Term& term : terms_of(c.terms)) most = std::max(most, term.value);
    std::string figures;
    for (const Candidate& c : identification.candidates)
        figures += candidate_figure(input, drawn, c, most, c.reference == identification.reference);
    return {{"candidates", figures},
            {"reference", escaped(identification.reference)},
            {"type", escaped(identification.type)},
            {"confidence", percent(identification.confidence, 1)},
            {"count", std::to_string(identification.candidates.size())}};
}

} // namespace pantin
