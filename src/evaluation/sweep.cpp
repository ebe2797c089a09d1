// SPDX-License-Identifier: MIT
// Values of options in, an evaluation for each combination out.
#include "pantin/sweep.hpp"

#include <algorithm>

#include "core/file.hpp"
#include "evaluation/page_run.hpp"
#include "pantin/error.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

// The first of evaluated_steps that depends on an option. Steps look at nothing but the options of their own
// group and of those before; detection asks the part network which way a page was held, so it is the first
// for segmentation, too.
std::size_t first_step(const std::string& option) {
    const std::string group = option.substr(0, option.find('.'));
    return group == "skeletonization" ? 2 : group == "identification" ? 3 : group == "rigging" ? 4 : 0;
}

// The combinations of one value each, the last option fastest.
std::vector<std::vector<std::string>> combinations_of(const std::vector<SweptOption>& options) {
    std::vector<std::vector<std::string>> all = {{}};
    for (const SweptOption& option : options) {
        std::vector<std::vector<std::string>> longer;
        for (const std::vector<std::string>& values : all)
            for (const std::string& value : option.values) {
                longer.push_back(values);
                longer.back().push_back(value);
            }
        all = std::move(longer);
    }
    return all;
}

Settings with_values(Settings settings, const std::vector<SweptOption>& options,
                     const std::vector<std::string>& values) {
    for (std::size_t i = 0; i < options.size(); ++i)
        apply_config_text(settings.options, "{\"" + options[i].name + "\":" + values[i] + "}", "--sweep");
    return settings;
}

// What all combinations have in common.
struct Shared {
    std::size_t steps = 0; // that ran
    fs::path folder;
    std::vector<PageRun> pages;
    StepSeconds seconds;
};

class Sweep {
public:
    Sweep(const Dataset& dataset, const Settings& settings, std::size_t combinations)
        : dataset_(dataset), settings_(settings), all_(dataset.size() * (combinations + 1)) {}

    Shared run_shared(const fs::path& folder, std::size_t steps) {
        Shared shared{steps, folder, std::vector<PageRun>(dataset_.size()), {}};
        for (std::size_t i = 0; i < dataset_.size() && steps > 0; ++i) {
            const TruePage truth = dataset_.page(i);
            progress(truth.id);
            run_steps(shared.pages[i], truth, folder / truth.id, quiet(settings_), 0, steps, shared.seconds);
        }
        return shared;
    }

    Evaluation run(const Shared& shared, const fs::path& folder, const Settings& settings) {
        Evaluation evaluation;
        evaluation.seconds = shared.seconds;
        for (std::size_t i = 0; i < dataset_.size(); ++i) {
            const TruePage truth = dataset_.page(i);
            const fs::path page = folder / "pages" / truth.id;
            progress(truth.id);
            if (shared.steps > 0) copy(shared.folder / truth.id, page);
            PageRun run = shared.pages[i];
            run_steps(run, truth, page, quiet(settings), shared.steps, evaluated_steps.size(),
                      evaluation.seconds);
            judge_page(evaluation, truth, read_answers(run, truth, page));
        }
        return evaluation;
    }

private:
    void progress(const std::string& id) {
        if (settings_.progress)
            settings_.progress(id, static_cast<double>(done_) / static_cast<double>(all_));
        ++done_;
    }

    static void copy(const fs::path& from, const fs::path& to) {
        create_folder(to.parent_path());
        std::error_code failed;
        fs::remove_all(to, failed);
        if (!fs::exists(from)) return; // of a page without a character
        fs::copy(from, to, fs::copy_options::recursive, failed);
        if (failed) throw Error(ErrorKind::output, to.string() + ": " + failed.message());
    }

    const Dataset& dataset_;
    const Settings& settings_;
    std::size_t done_ = 0, all_;
};

} // namespace

std::vector<SweepResult> sweep(const Dataset& dataset, const fs::path& out, const Settings& settings,
                               const std::vector<SweptOption>& options) {
    const auto combinations = combinations_of(options);
    std::size_t steps = evaluated_steps.size();
    for (const SweptOption& option : options) steps = std::min(steps, first_step(option.name));
    Sweep runs(dataset, settings, combinations.size());
    const Shared shared = runs.run_shared(out / "shared", steps);
    std::vector<SweepResult> results;
    for (const std::vector<std::string>& values : combinations) {
        const fs::path folder = "combination-" + std::to_string(results.size() + 1);
        results.push_back(
            {values, folder, runs.run(shared, out / folder, with_values(settings, options, values))});
    }
    return results;
}

} // namespace pantin
