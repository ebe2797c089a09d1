// SPDX-License-Identifier: MIT
// pantin evaluate DATASET -o DIR [--predictions DIR | --sweep OPTIONS]
#include <memory>

#include "cli/command.hpp"
#include "core/file.hpp"
#include "pantin/sweep.hpp"

namespace pantin::cli {

namespace {

struct Arguments {
    CommonOptions common;
    std::string dataset, out, csv, predictions, sweep;
};

// A file of the tables, or a folder with them and a line a character.
void write_csv(const std::filesystem::path& to, const Evaluation& evaluation) {
    const std::string tables = measurements_to_csv(measurements_of(evaluation));
    if (to.extension() == ".csv") {
        if (to.has_parent_path()) create_folder(to.parent_path());
        return write_file(to, tables);
    }
    create_folder(to);
    write_file(to / "measurements.csv", tables);
    write_file(to / "characters.csv", characters_to_csv(evaluation));
}

void write_results(const std::filesystem::path& out, const Evaluation& evaluation) {
    create_folder(out);
    write_file(out / "evaluation.json", evaluation_to_json(evaluation));
    write_file(out / "evaluation.html", evaluation_to_html(evaluation));
}

void print_lines(const CommonOptions& options, std::string text) {
    text.pop_back(); // print_result ends the line
    print_result(options, text);
}

int run_sweep(const Arguments& arguments) {
    const std::vector<SweptOption> options = parse_sweep(arguments.sweep);
    const std::filesystem::path out = arguments.out;
    const auto results = sweep(Dataset(arguments.dataset), out, make_settings(arguments.common), options);
    for (const SweepResult& result : results) {
        write_results(out / result.folder, result.evaluation);
        write_file(out / result.folder / "evaluation.txt", evaluation_to_text(result.evaluation));
        write_csv(out / result.folder / "measurements.csv", result.evaluation);
    }
    const std::string csv = sweep_to_csv(options, results);
    write_file(out / "sweep.csv", csv);
    if (!arguments.csv.empty()) {
        const std::filesystem::path to = arguments.csv;
        const bool file = to.extension() == ".csv";
        if (const auto folder = file ? to.parent_path() : to; !folder.empty()) create_folder(folder);
        write_file(file ? to : to / "sweep.csv", csv);
    }
    print_lines(arguments.common, sweep_to_text(options, results));
    return 0;
}

int run_evaluate(const Arguments& arguments) {
    if (!arguments.sweep.empty() && !arguments.predictions.empty())
        throw Error(ErrorKind::usage, "--sweep excludes --predictions");
    if (!arguments.sweep.empty()) return run_sweep(arguments);
    const Settings settings = make_settings(arguments.common);
    const Dataset dataset(arguments.dataset);
    const Evaluation evaluation = arguments.predictions.empty()
                                      ? evaluate(dataset, arguments.out, settings)
                                      : evaluate_predictions(dataset, arguments.predictions);
    write_results(arguments.out, evaluation);
    if (!arguments.csv.empty()) write_csv(arguments.csv, evaluation);
    print_lines(arguments.common, evaluation_to_text(evaluation));
    return 0;
}

} // namespace

void add_evaluate(Command app) {
    const auto arguments = std::make_shared<Arguments>();
    Command command = app.subcommand("evaluate", "accuracy tables on a folder of drawings with truth");
    command.option("DATASET", arguments->dataset, "folder with index.ndjson, image/, label/, instance/")
        .required();
    command.option("-o,--output", arguments->out, "folder for the results").required();
    command.option(
        "--predictions", arguments->predictions,
        "folder with another program's label/, instance/ or index.ndjson: they are judged, no step runs");
    command.option(
        "--sweep", arguments->sweep,
        "\"option=value,value;option=value\": all of it for each combination of these values, any of "
        "`pantin options`");
    command.option("--csv", arguments->csv,
                   "the tables as CSV, too: a file (NAME.csv), or a folder for them and a line a character "
                   "(--sweep: its table alone)");
    add_detector_option(command, arguments->common);
    add_common_options(command, arguments->common);
    command.run([arguments] { return run_evaluate(*arguments); });
}

} // namespace pantin::cli
