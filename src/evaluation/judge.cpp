// SPDX-License-Identifier: MIT
// The answers of a page compared with its truth.
#include <algorithm>
#include <tuple>

#include "evaluation/answers.hpp"

namespace pantin {

namespace {

// Intersection over union; 0 for two empty masks.
double overlap(const Mask& a, const Mask& b) {
    long both = 0, any = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        both += a.data()[i] && b.data()[i];
        any += a.data()[i] || b.data()[i];
    }
    return any == 0 ? 0 : static_cast<double>(both) / static_cast<double>(any);
}

// The true character that a mask overlaps most, and by how much.
std::pair<int, double> best_partner(const Mask& mask, const TruePage& truth) {
    std::pair<int, double> best{-1, 0};
    for (std::size_t k = 0; k < truth.characters.size(); ++k)
        if (!truth.characters[k].mask.empty())
            if (const double o = overlap(mask, truth.characters[k].mask); o > best.second)
                best = {static_cast<int>(k), o};
    return best;
}

void compare_parts(CharacterResult& result, const TruePage& truth, const Mask& mask, const LabelMap& labels) {
    std::array<long, label_count> both{}, any{}, there{};
    long right = 0, pixels = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        const int wanted = mask.data()[i] ? truth.labels.data()[i] : 0, got = labels.data()[i];
        pixels += wanted != 0;
        right += wanted != 0 && wanted == got;
        for (int part = 1; part < label_count; ++part) {
            both[part] += wanted == part && got == part;
            any[part] += wanted == part || got == part;
            there[part] += wanted == part;
        }
    }
    for (int part = 1; part < label_count; ++part)
        result.part_overlap[part] =
            there[part] == 0 ? -1 : static_cast<double>(both[part]) / static_cast<double>(any[part]);
    result.pixel_accuracy = pixels == 0 ? 0 : static_cast<double>(right) / static_cast<double>(pixels);
}

// Without label maps, a page with one true character and at least one answer: the largest answer is it.
const Answer* partner_of(const TruePage& truth, std::size_t k, const std::vector<Answer>& answers) {
    const TrueCharacter& character = truth.characters[k];
    const Answer* best = nullptr;
    double most = 0.5;
    for (const Answer& answer : answers) {
        if (answer.answers_to == static_cast<int>(k)) return &answer;
        if (answer.answers_to >= 0) continue;
        const double share = character.mask.empty()
                                 ? static_cast<double>(std::count(answer.mask.begin(), answer.mask.end(), 1))
                                 : overlap(answer.mask, character.mask);
        if (share >= most) best = &answer, most = share;
    }
    return character.mask.empty() && truth.characters.size() != 1 ? nullptr : best;
}

// The true labels of one character.
LabelMap labels_of(const TruePage& truth, const Mask& mask) {
    LabelMap labels = truth.labels;
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (!mask.data()[i]) labels.data()[i] = 0;
    return labels;
}

constexpr double near_end = 0.03; // of the figure's longer side: how far an end may lie from its part

CharacterResult judge(const TruePage& truth, std::size_t k, const std::vector<Answer>& answers,
                      const Measured& measured) {
    const TrueCharacter& character = truth.characters[k];
    CharacterResult result;
    result.page = truth.id;
    result.type = character.type;
    result.species = character.species;
    result.labelled = truth.is_labelled();
    result.part_overlap.fill(-1);
    result.status = "not found";
    const Answer* answer = partner_of(truth, k, answers);
    const LabelMap nothing(truth.labels.width(), truth.labels.height(), 0);
    if (!character.mask.empty() && measured.labels)
        compare_parts(result, truth, character.mask, answer ? answer->labels : nothing);
    if (!character.mask.empty() && measured.steps)
        result.ends =
            count_ends(labels_of(truth, character.mask), answer ? answer->ends : std::vector<SkeletonEnd>{},
                       character.limbs, answer ? near_end * answer->size : 0);
    if (!answer) return result;
    result.found = true;
    result.folder = answer->folder;
    result.status = answer->status;
    result.identified = answer->reference;
    result.confidence = answer->confidence;
    result.warnings = answer->warnings;
    if (!character.mask.empty() && !answer->mask.empty()) {
        result.mask_overlap = overlap(answer->mask, character.mask);
        result.silhouette_overlap = overlap(answer->silhouette, character.mask);
    }
    if (!character.pose.empty() && !answer->pose.empty()) result.pose_right = character.pose == answer->pose;
    if (!character.type.empty() && !answer->expert.empty())
        result.expert_right = answer->expert == (character.type == "flying" ? "winged" : "ground");
    return result;
}

} // namespace

void judge_page(Evaluation& evaluation, const TruePage& truth, const std::vector<Answer>& answers) {
    ++evaluation.pages;
    if (truth.is_labelled()) {
        evaluation.labelled_pages.push_back(truth.id);
        for (const Answer& answer : answers) {
            if (answer.mask.empty()) continue;
            FoundCharacter found{truth.id, answer.score, -1, -1, 0, 0};
            std::tie(found.true_by_mask, found.mask_overlap) = best_partner(answer.mask, truth);
            std::tie(found.true_by_silhouette, found.silhouette_overlap) =
                best_partner(answer.silhouette, truth);
            evaluation.found.push_back(found);
        }
    }
    for (std::size_t k = 0; k < truth.characters.size(); ++k)
        evaluation.characters.push_back(judge(truth, k, answers, evaluation.measured));
}

} // namespace pantin
