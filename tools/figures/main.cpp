// SPDX-License-Identifier: MIT
// make figures, make results: the figures of docs/figures from testdata/, and docs/results.md.
// Usage: figures FOLDER [TESTDATA]                              writes all figures
//        figures review PICTURES FOLDER                         what became of every drawing, to judge by eye
//        figures results PAGE.md DATASET WORK VERDICTS.csv      runs both presets on a dataset of generated
//        drawings (minutes)
#include <cstdio>
#include <cstring>
#include <exception>

#include "core/file.hpp"
#include "figures/figures.hpp"
#include "figures/results.hpp"
#include "figures/review.hpp"

using namespace pantin;

namespace {

void write_figures(const std::filesystem::path& folder, const std::string& testdata) {
    create_folder(folder);
    for (const figures::Figure& figure : figures::all_figures(testdata))
        write_file(folder / figure.name, figure.svg);
}

} // namespace

int main(int argc, char** argv) {
    try {
        if (argc == 6 && std::strcmp(argv[1], "results") == 0)
            write_file(argv[2],
                       figures::results_page(argv[3], argv[4], "testdata", figures::Verdicts(argv[5])));
        else if (argc == 4 && std::strcmp(argv[1], "review") == 0)
            figures::write_review(argv[2], argv[3]);
        else if (argc == 2 || argc == 3)
            write_figures(argv[1], argc > 2 ? argv[2] : "testdata");
        else {
            std::fprintf(stderr, "usage: figures FOLDER [TESTDATA] | figures review PICTURES FOLDER | "
                                 "figures results PAGE.md DATASET WORK VERDICTS.csv\n");
            return 2;
        }
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "figures: %s\n", error.what());
        return 1;
    }
}
