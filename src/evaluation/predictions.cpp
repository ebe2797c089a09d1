// SPDX-License-Identifier: MIT
// Another program's answers, judged as the pipeline's are.
#include <algorithm>
#include <map>

#include "evaluation/answers.hpp"
#include "evaluation/dataset_files.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

struct Predictions {
    fs::path folder;
    std::map<std::string, IndexRow> rows;
    Measured measured;
};

Predictions read_predictions(const fs::path& folder) {
    Predictions all;
    all.folder = folder;
    const fs::path index = folder / "index.ndjson";
    all.measured.steps = false;
    all.measured.labels = fs::is_directory(folder / "label");
    all.measured.masks = all.measured.labels || fs::is_directory(folder / "instance");
    all.measured.types = false;
    if (fs::exists(index))
        for (IndexRow& row : read_index(index)) {
            for (const TrueCharacter& c : row.characters) all.measured.types |= !c.type.empty();
            const std::string id = row.id;
            if (!all.rows.emplace(id, std::move(row)).second)
                throw Error(ErrorKind::input, index.string() + ": lists '" + id + "' twice");
        }
    if (!all.measured.masks && !all.measured.types)
        throw Error(ErrorKind::input,
                    folder.string() + ": has neither label/, instance/ nor types in an index.ndjson");
    return all;
}

void check_size(const fs::path& folder, const TruePage& truth, int width, int height) {
    if (truth.labels.empty() || (truth.labels.width() == width && truth.labels.height() == height)) return;
    throw Error(ErrorKind::input, folder.string() + ": the prediction for " + truth.id +
                                      " has another size than its label map");
}

Answer answer_of(const PagePictures& pictures, const Mask& mask) {
    Answer answer;
    answer.mask = answer.silhouette = mask;
    if (pictures.labels.empty()) return answer;
    answer.labels = pictures.labels;
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (!mask.data()[i]) answer.labels.data()[i] = 0;
    answer.silhouette = foreground(answer.labels);
    return answer;
}

// None when nothing is said about the page.
std::optional<std::vector<Answer>> answers_of(const Predictions& all, const TruePage& truth) {
    const PagePictures pictures = read_pictures(all.folder, truth.id);
    const auto row = all.rows.find(truth.id);
    const bool pictured = !pictures.labels.empty() || !pictures.masks.empty();
    if (!pictured && (all.measured.masks || row == all.rows.end())) return std::nullopt;
    std::vector<Answer> answers;
    for (const Mask& mask : pictures.masks) {
        check_size(all.folder, truth, mask.width(), mask.height());
        answers.push_back(answer_of(pictures, mask));
    }
    if (row != all.rows.end())
        for (std::size_t k = 0; k < row->second.characters.size(); ++k) {
            if (k == answers.size() && all.measured.masks) break; // an answer without a place
            if (k == answers.size()) answers.emplace_back().answers_to = static_cast<int>(k);
            answers[k].reference = row->second.characters[k].type;
            answers[k].pose = row->second.characters[k].pose;
            answers[k].score = row->second.scores[k];
        }
    for (Answer& answer : answers) answer.status = "ok";
    return answers;
}

} // namespace

Evaluation evaluate_predictions(const Dataset& dataset, const fs::path& predictions) {
    const Predictions all = read_predictions(predictions);
    Evaluation evaluation;
    evaluation.measured = all.measured;
    for (std::size_t i = 0; i < dataset.size(); ++i) {
        const TruePage truth = dataset.page(i);
        const auto answers = answers_of(all, truth);
        evaluation.unanswered_pages += !answers;
        judge_page(evaluation, truth, answers.value_or(std::vector<Answer>{}));
    }
    return evaluation;
}

} // namespace pantin
