// SPDX-License-Identifier: MIT
// What was answered on a page, by the pipeline or by another program, and how it is judged.
#pragma once

#include <string>
#include <vector>

#include "evaluation/end_effectors.hpp"
#include "pantin/evaluation.hpp"

namespace pantin {

// A character that was found, put back onto the page.
struct Answer {
    double score = 1;
    Mask mask, silhouette; // page size; empty when another program gives none
    LabelMap labels;       // likewise
    int answers_to = -1;   // the true character that an answer without a mask is for
    std::string folder, status, reference, expert, pose;
    double confidence = 0;
    std::vector<SkeletonEnd> ends; // of the skeleton graph
    double size = 0;               // longer side of its box, pixels of the page
    std::vector<Warning> warnings; // as page.json lists them
};

// Adds what is found on the page, its characters and the page itself to the evaluation.
void judge_page(Evaluation& evaluation, const TruePage& truth, const std::vector<Answer>& answers);

} // namespace pantin
