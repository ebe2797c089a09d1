// SPDX-License-Identifier: MIT
// The pipeline's steps on every page of a dataset, compared with the truth.
#include <algorithm>
#include <tuple>

#include "core/file.hpp"
#include "core/json.hpp"
#include "core/json_reader.hpp"
#include "formats/file_names.hpp"
#include "pantin/evaluation.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

// What the steps left in a character's folder, put back onto the page.
struct Answer {
    double score = 0;
    Mask mask, silhouette; // page size
    LabelMap labels;       // page size
    std::string folder, status, reference, expert, pose;
    double confidence = 0;
    std::vector<Warning> warnings; // as page.json lists them
};

// A working-size picture at its place on the page.
Grid<std::uint8_t> on_page(const fs::path& file, const Box& box, int width, int height) {
    Grid<std::uint8_t> page(width, height, 0);
    if (!fs::exists(file)) return page;
    const RgbImage picture = load_image(file);
    for (int y = 0; y < box.height; ++y)
        for (int x = 0; x < box.width; ++x)
            page(box.x + x, box.y + y) =
                picture(x * picture.width() / box.width, y * picture.height() / box.height).r;
    return page;
}

// The key with the largest number of an object.
std::string largest_key(const JsonReader& object) {
    std::string best;
    double most = -1;
    for (const auto& [key, value] : object.entries())
        if (const double p = value.number(0, 1); p > most) best = key, most = p;
    return best;
}

void read_files(Answer& answer, const fs::path& folder) {
    if (const fs::path file = folder / file_names::segmentation; fs::exists(file)) {
        const Json json = parse_json(read_text(file), file.string());
        const JsonReader reader(json, file.string());
        answer.expert = reader.at("expert").text();
        answer.pose = largest_key(reader.at("pose"));
    }
    if (const fs::path file = folder / file_names::identification; fs::exists(file)) {
        const Json json = parse_json(read_text(file), file.string());
        const JsonReader reader(json, file.string());
        answer.reference = reader.at("type").text();
        answer.confidence = reader.at("confidence").number(0, 1);
    }
}

// Steps 2 to 5. "ok", or the step and the reason why not.
std::string run_steps(const fs::path& folder, const Settings& settings) {
    try {
        segment_folder(folder, settings);
        skeletonize_folder(folder, settings);
        identify_folder(folder, settings);
        rig_folder(folder, settings);
        return "ok";
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::not_animated) throw;
        const std::string message = error.what(), name = folder.string() + ": ";
        return message.starts_with(name) ? message.substr(name.size()) : message;
    }
}

std::vector<Answer> run_page(const TruePage& truth, const fs::path& out, const Settings& settings) {
    std::vector<Answer> answers;
    Page page;
    try {
        page = detect_page(truth.image, out, settings);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::no_character) throw;
        return answers;
    }
    if (!truth.labels.empty() && (truth.labels.width() != page.width || truth.labels.height() != page.height))
        throw Error(ErrorKind::input, truth.image.string() + ": has another size than its label map");
    for (const PageCharacter& character : page.characters) {
        const fs::path folder = out / character.folder;
        Answer answer;
        answer.folder = character.folder;
        answer.score = character.score;
        answer.status = run_steps(folder, settings);
        read_files(answer, folder);
        answer.mask = foreground(on_page(folder / file_names::mask, character.box, page.width, page.height));
        answer.labels = on_page(folder / file_names::labels, character.box, page.width, page.height);
        answer.silhouette = foreground(answer.labels);
        answers.push_back(std::move(answer));
    }
    page = read_page(out / file_names::page);
    for (std::size_t i = 0; i < answers.size(); ++i) answers[i].warnings = page.characters[i].warnings;
    return answers;
}

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
        const double share = character.mask.empty()
                                 ? static_cast<double>(std::count(answer.mask.begin(), answer.mask.end(), 1))
                                 : overlap(answer.mask, character.mask);
        if (share >= most) best = &answer, most = share;
    }
    return character.mask.empty() && truth.characters.size() != 1 ? nullptr : best;
}

CharacterResult judge(const TruePage& truth, std::size_t k, const std::vector<Answer>& answers) {
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
    if (!character.mask.empty())
        compare_parts(result, truth, character.mask, answer ? answer->labels : nothing);
    if (!answer) return result;
    result.found = true;
    result.folder = answer->folder;
    result.status = answer->status;
    result.identified = answer->reference;
    result.confidence = answer->confidence;
    result.warnings = answer->warnings;
    if (!character.mask.empty()) {
        result.mask_overlap = overlap(answer->mask, character.mask);
        result.silhouette_overlap = overlap(answer->silhouette, character.mask);
    }
    if (!character.pose.empty() && !answer->pose.empty()) result.pose_right = character.pose == answer->pose;
    if (!character.type.empty() && !answer->expert.empty())
        result.expert_right = answer->expert == (character.type == "flying" ? "winged" : "ground");
    return result;
}

} // namespace

Evaluation evaluate(const Dataset& dataset, const fs::path& out, const Settings& settings) {
    Evaluation evaluation;
    for (std::size_t i = 0; i < dataset.size(); ++i) {
        const TruePage truth = dataset.page(i);
        if (settings.progress)
            settings.progress(truth.id, static_cast<double>(i) / static_cast<double>(dataset.size()));
        Settings quiet = settings;
        quiet.progress = nullptr;
        quiet.warning = nullptr;
        const std::vector<Answer> answers = run_page(truth, out / "pages" / truth.id, quiet);
        if (truth.is_labelled()) evaluation.labelled_pages.push_back(truth.id);
        for (const Answer& answer : answers) {
            if (!truth.is_labelled()) continue;
            FoundCharacter found{truth.id, answer.score, -1, -1, 0, 0};
            std::tie(found.true_by_mask, found.mask_overlap) = best_partner(answer.mask, truth);
            std::tie(found.true_by_silhouette, found.silhouette_overlap) =
                best_partner(answer.silhouette, truth);
            evaluation.found.push_back(found);
        }
        for (std::size_t k = 0; k < truth.characters.size(); ++k)
            evaluation.characters.push_back(judge(truth, k, answers));
        ++evaluation.pages;
    }
    return evaluation;
}

} // namespace pantin
