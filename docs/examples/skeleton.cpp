// SPDX-License-Identifier: MIT
// The skeleton of a part label map (labels.png), with the library alone:
//   g++ -std=c++20 skeleton.cpp $(pkg-config --cflags --libs pantin) -o skeleton && ./skeleton
//   out/character-1/labels.png
#include <cstdio>
#include <exception>

#include <pantin/image.hpp>
#include <pantin/skeletonization.hpp>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: skeleton LABELS.png\n");
        return 2;
    }
    try {
        const pantin::Skeletonization result = pantin::skeletonize(pantin::load_grey(argv[1]));
        for (const pantin::SkeletonVertex& v : result.graph.vertices)
            std::printf("%s %s at (%g, %g)\n", pantin::name_of(v.label).data(), v.end ? "end" : "junction",
                        v.x, v.y);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "skeleton: %s\n", error.what());
        return 1;
    }
}
