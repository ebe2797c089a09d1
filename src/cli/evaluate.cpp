// SPDX-License-Identifier: MIT
// pantin evaluate DATASET -o DIR
#include <memory>

#include "cli/command.hpp"
#include "core/file.hpp"
#include "pantin/evaluation.hpp"

namespace pantin::cli {

namespace {

struct Arguments {
    CommonOptions common;
    std::string dataset, out;
};

int run_evaluate(const Arguments& arguments) {
    const Settings settings = make_settings(arguments.common);
    const Dataset dataset(arguments.dataset);
    const std::filesystem::path out = arguments.out;
    const Evaluation evaluation = evaluate(dataset, out, settings);
    create_folder(out);
    write_file(out / "evaluation.json", evaluation_to_json(evaluation));
    write_file(out / "evaluation.html", evaluation_to_html(evaluation));
    std::string text = evaluation_to_text(evaluation);
    text.pop_back(); // print_result ends the line
    print_result(arguments.common, text);
    return 0;
}

} // namespace

void add_evaluate(Command app) {
    const auto arguments = std::make_shared<Arguments>();
    Command command = app.subcommand("evaluate", "accuracy tables on a folder of drawings with truth");
    command.option("DATASET", arguments->dataset, "folder with index.ndjson, image/, label/, instance/")
        .required();
    command.option("-o,--output", arguments->out, "folder for the results").required();
    add_detector_option(command, arguments->common);
    add_common_options(command, arguments->common);
    command.run([arguments] { return run_evaluate(*arguments); });
}

} // namespace pantin::cli
