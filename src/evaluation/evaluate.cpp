// SPDX-License-Identifier: MIT
// The pipeline's steps on every page of a dataset, compared with the truth.
#include <algorithm>
#include <chrono>

#include "core/file.hpp"
#include "core/json.hpp"
#include "core/json_reader.hpp"
#include "evaluation/page_run.hpp"
#include "formats/file_names.hpp"
#include "formats/skeleton_file.hpp"
#include "pantin/evaluation.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

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

// What the steps left in a character's folder.
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

// Calls `work` and notes how long it took, also when it failed.
template <class Work> void timed(std::vector<double>& seconds, Work work) {
    struct Watch {
        std::vector<double>& seconds;
        std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
        ~Watch() {
            seconds.push_back(
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        }
    } const watch{seconds};
    work();
}

constexpr void (*character_steps[])(const fs::path&, const Settings&) = {segment_folder, skeletonize_folder,
                                                                         identify_folder, rig_folder};
static_assert(std::size(character_steps) + 1 == evaluated_steps.size());

// Steps 2 to 5 as far as they are wanted.
void run_character(std::string& status, const fs::path& folder, const Settings& settings, std::size_t first,
                   std::size_t last, StepSeconds& seconds) {
    try {
        for (std::size_t step = std::max<std::size_t>(1, first); step < last && status == "ok"; ++step)
            timed(seconds[step], [&] { character_steps[step - 1](folder, settings); });
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::not_animated) throw;
        const std::string message = error.what(), name = folder.string() + ": ";
        status = message.starts_with(name) ? message.substr(name.size()) : message;
    }
}

// The skeleton's end-effectors on the page; none before there is a skeleton.
std::vector<SkeletonEnd> ends_on_page(const fs::path& folder, const PageCharacter& character) {
    const fs::path file = folder / file_names::skeleton;
    std::vector<SkeletonEnd> ends;
    if (!fs::exists(file)) return ends;
    for (const SkeletonVertex& v : skeleton_from_json(read_text(file), file.string()).vertices)
        if (v.end)
            ends.push_back({{character.box.x + (v.x + 0.5) / character.scale - 0.5,
                             character.box.y + (v.y + 0.5) / character.scale - 0.5},
                            v.label});
    return ends;
}

Answer read_answer(const PageCharacter& character, const Page& page, const fs::path& out) {
    const fs::path folder = out / character.folder;
    Answer answer;
    answer.folder = character.folder;
    answer.score = character.score;
    answer.warnings = character.warnings;
    read_files(answer, folder);
    answer.mask = foreground(on_page(folder / file_names::mask, character.box, page.width, page.height));
    answer.labels = on_page(folder / file_names::labels, character.box, page.width, page.height);
    answer.silhouette = foreground(answer.labels);
    answer.size = std::max(character.box.width, character.box.height);
    answer.ends = ends_on_page(folder, character);
    return answer;
}

} // namespace

void run_steps(PageRun& run, const TruePage& truth, const fs::path& out, const Settings& settings,
               std::size_t first, std::size_t last, StepSeconds& seconds) {
    if (first == 0) {
        Page page;
        try {
            timed(seconds[0], [&] { page = detect_page(truth.image, out, settings); });
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::no_character) throw;
            return;
        }
        run.status.assign(page.characters.size(), "ok");
    }
    if (run.status.empty()) return;
    const Page page = read_page(out / file_names::page);
    for (std::size_t i = 0; i < run.status.size(); ++i)
        run_character(run.status[i], out / page.characters[i].folder, settings, first, last, seconds);
}

std::vector<Answer> read_answers(const PageRun& run, const TruePage& truth, const fs::path& out) {
    std::vector<Answer> answers;
    if (run.status.empty()) return answers;
    const Page page = read_page(out / file_names::page); // with warnings
    if (!truth.labels.empty() && (truth.labels.width() != page.width || truth.labels.height() != page.height))
        throw Error(ErrorKind::input, truth.image.string() + ": has another size than its label map");
    for (std::size_t i = 0; i < run.status.size(); ++i) {
        answers.push_back(read_answer(page.characters[i], page, out));
        answers.back().status = run.status[i];
    }
    return answers;
}

Settings quiet(const Settings& settings) {
    Settings copy = settings;
    copy.rotate = settings.rotate.value_or(0); // the truth lies on the page as it is
    copy.progress = nullptr;
    copy.warning = nullptr;
    return copy;
}

Evaluation evaluate(const Dataset& dataset, const fs::path& out, const Settings& settings) {
    Evaluation evaluation;
    for (std::size_t i = 0; i < dataset.size(); ++i) {
        const TruePage truth = dataset.page(i);
        const fs::path folder = out / "pages" / truth.id;
        if (settings.progress)
            settings.progress(truth.id, static_cast<double>(i) / static_cast<double>(dataset.size()));
        PageRun run;
        run_steps(run, truth, folder, quiet(settings), 0, evaluated_steps.size(), evaluation.seconds);
        judge_page(evaluation, truth, read_answers(run, truth, folder));
    }
    return evaluation;
}

} // namespace pantin
