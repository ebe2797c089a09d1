// SPDX-License-Identifier: MIT
// Measures of an evaluation and how far they can be trusted.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/random.hpp"
#include "pantin/evaluation.hpp"

namespace pantin {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double z = 1.959963984540054; // the normal distribution's 97.5th percentile

// What average precision needs to know, so that pages can be drawn again and again.
struct Ranking {
    struct Answer {
        std::size_t page;
        bool hit;
    };
    std::vector<Answer> answers; // by descending score
    std::vector<int> true_count; // characters of each page
};

Ranking ranking_of(const Evaluation& evaluation, double least_overlap, bool by_mask) {
    Ranking ranking;
    std::map<std::string, std::size_t> numbers;
    const auto number_of = [&](const std::string& page) {
        const auto [at, fresh] = numbers.emplace(page, numbers.size());
        if (fresh) ranking.true_count.push_back(0);
        return at->second;
    };
    for (const std::string& page : evaluation.labelled_pages) number_of(page);
    for (const CharacterResult& c : evaluation.characters)
        if (c.labelled) ++ranking.true_count[number_of(c.page)];
    std::vector<const FoundCharacter*> ranked;
    for (const FoundCharacter& found : evaluation.found) ranked.push_back(&found);
    std::stable_sort(ranked.begin(), ranked.end(), [](auto a, auto b) { return a->score > b->score; });
    std::set<std::pair<std::string, int>> taken;
    for (const FoundCharacter* found : ranked) {
        const double overlap = by_mask ? found->mask_overlap : found->silhouette_overlap;
        const int character = by_mask ? found->true_by_mask : found->true_by_silhouette;
        const bool hit = overlap >= least_overlap && taken.emplace(found->page, character).second;
        ranking.answers.push_back({number_of(found->page), hit});
    }
    return ranking;
}

// Of a set of pages that has page i `times[i]` times. A page drawn twice is two pages with the same answers.
double average_precision(const Ranking& ranking, const std::vector<int>& times) {
    int all = 0;
    for (std::size_t i = 0; i < times.size(); ++i) all += times[i] * ranking.true_count[i];
    if (all == 0) return nan;
    std::vector<double> precisions; // at each hit
    int seen = 0;
    for (const Ranking::Answer& answer : ranking.answers)
        for (int k = 0; k < times[answer.page]; ++k) {
            ++seen;
            if (answer.hit) precisions.push_back(static_cast<double>(precisions.size() + 1) / seen);
        }
    double best = 0, area = 0;
    for (std::size_t i = precisions.size(); i-- > 0;) {
        best = std::max(best, precisions[i]);
        area += best;
    }
    return area / all;
}

} // namespace

double CharacterResult::mean_overlap() const {
    double sum = 0;
    int parts = 0;
    for (std::size_t part = 1; part < part_overlap.size(); ++part)
        if (part_overlap[part] >= 0) sum += part_overlap[part], ++parts;
    return parts == 0 ? -1 : sum / parts;
}

double average_precision(const Evaluation& evaluation, double least_overlap, bool by_mask) {
    const Ranking ranking = ranking_of(evaluation, least_overlap, by_mask);
    return average_precision(ranking, std::vector<int>(ranking.true_count.size(), 1));
}

Interval average_precision_interval(const Evaluation& evaluation, double least_overlap, bool by_mask) {
    constexpr int draws = 1000;
    const Ranking ranking = ranking_of(evaluation, least_overlap, by_mask);
    const int pages = static_cast<int>(ranking.true_count.size());
    if (pages < 2) return {nan, nan};
    Random random(18);
    std::vector<double> values;
    for (int draw = 0; draw < draws; ++draw) {
        std::vector<int> times(ranking.true_count.size(), 0);
        for (int i = 0; i < pages; ++i) ++times[static_cast<std::size_t>(random.integer(0, pages - 1))];
        if (const double value = average_precision(ranking, times); !std::isnan(value))
            values.push_back(value);
    }
    if (values.empty()) return {nan, nan};
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    };
    return {at(0.025), at(0.975)};
}

Interval share_interval(int hits, int count) {
    if (count <= 0) return {nan, nan};
    const double n = count, p = hits / n, square = z * z;
    const double middle = (p + square / (2 * n)) / (1 + square / n),
                 half = z / (1 + square / n) * std::sqrt(p * (1 - p) / n + square / (4 * n * n));
    return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

Interval mean_interval(const std::vector<double>& values) {
    if (values.size() < 2) return {nan, nan};
    const double n = static_cast<double>(values.size());
    double mean = 0, squares = 0;
    for (const double value : values) mean += value / n;
    for (const double value : values) squares += (value - mean) * (value - mean);
    const double half = z * std::sqrt(squares / (n - 1) / n);
    return {mean - half, mean + half};
}

} // namespace pantin
