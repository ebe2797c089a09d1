// make figures: the figures of docs/figures from testdata/.
// Usage: figures FOLDER [TESTDATA]      writes all figures
#include <cstdio>
#include <exception>

#include "core/file.hpp"
#include "figures/figures.hpp"

int main(int argc, char** argv) {
    if (argc < 2 || argc > 3) {
        std::fprintf(stderr, "usage: figures FOLDER [TESTDATA]\n");
        return 2;
    }
    try {
        pantin::create_folder(argv[1]);
        for (const auto& figure : pantin::figures::all_figures(argc > 2 ? argv[2] : "testdata"))
            pantin::write_file(std::filesystem::path(argv[1]) / figure.name, figure.svg);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "figures: %s\n", error.what());
        return 1;
    }
}
