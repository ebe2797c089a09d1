// SPDX-License-Identifier: MIT
// From strokes to models (Ma et al. 2021, Table 2): the sub-skeletons of fifty silhouettes, one call of each
// kind on a model of twelve parts, and whole models.
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "bench.hpp"
#include "core/file.hpp"
#include "doodle/doodle.hpp"
#include "pantin/image.hpp"
#include "pantin/model_view.hpp"

namespace pantin::bench {
namespace {

constexpr int silhouettes = 50;

std::vector<Point2d> outline_of(const LabelMap& labels) {
    const Mask mask = pad(largest_component(foreground(labels)), 1);
    const std::vector<Border> borders = follow_borders(mask);
    std::vector<Point2d> outline;
    for (const Point2i p : borders.front().points) outline.push_back(to_double(p));
    return outline;
}

// Label maps of a folder (*.png), or drawings of our own.
std::vector<std::vector<Point2d>> outlines(const std::string& folder) {
    std::vector<std::vector<Point2d>> found;
    if (folder.empty()) {
        const std::vector<std::string>& types = doodle::character_types();
        for (int i = 0; i < silhouettes; ++i)
            found.push_back(outline_of(
                doodle::draw_character(types[i % types.size()], static_cast<std::uint64_t>(i)).labels));
        return found;
    }
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".png") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const auto& file : files)
        if (std::ssize(found) < silhouettes) found.push_back(outline_of(load_grey(file)));
    return found;
}

void bench_sub_skeletons(const std::string& folder, int rounds) {
    std::vector<double> times;
    double sum = 0;
    for (const std::vector<Point2d>& outline : outlines(folder)) {
        times.push_back(least_time([&] { sub_skeleton(outline); }, rounds));
        sum += times.back();
    }
    std::sort(times.begin(), times.end());
    std::printf("\nsub-skeletons of %zu silhouettes (3.1)\n  median %.3f ms, mean %.3f, largest %.3f\n",
                times.size(), times[times.size() / 2], sum / static_cast<double>(times.size()), times.back());
}

void bench_calls(const Strokes& strokes, int rounds) {
    Strokes before = strokes;
    const ModelCall last = before.calls.back();
    before.calls.pop_back();
    const auto& part = std::get<PartStroke>(last);
    std::vector<double> add, move, refine;
    for (int i = 0; i < rounds; ++i) {
        Model model(before);
        add.push_back(least_time([&] { model.apply(last); }, 0));
        move.push_back(least_time([&] { model.move_part({part.name, {1, 2, 0}, 'z', 3, 1}); }, 0));
        RefineSkeleton call;
        call.prune = 0.05;
        refine.push_back(least_time([&] { model.refine(call); }, 0));
    }
    const auto middle = [](std::vector<double> v) {
        std::sort(v.begin(), v.end());
        return v[v.size() / 2];
    };
    std::printf("  add a part %.3f ms, move it %.3f (connection and refinement alone), refine all %.3f\n",
                middle(add), middle(move), middle(refine));
}

} // namespace

void bench_modeling(const std::string& folder, int rounds) {
    bench_sub_skeletons(folder, rounds);
    for (const char* name : {"cat", "panda", "octopus"}) {
        const std::string file = std::string("testdata/models/") + name + ".json";
        const Strokes strokes = strokes_from_json(read_text(file), file);
        std::printf("\nmodel %s, %zu strokes, %zu parts with copies\n", name, strokes.calls.size(),
                    Model(strokes).parts().size());
        bench_calls(strokes, 10 * rounds);
        SolidMesh mesh;
        const double whole = median_time([&] { mesh = Model(strokes).united(); }, rounds);
        Model model(strokes);
        const double inflation = median_time([&] { Model(strokes).inflated(); }, rounds);
        const ModelView view = view_of(model, mesh);
        const double skin = median_time([&] { model_rig(model, mesh, view); }, rounds);
        std::printf("  skeleton and inflation %.1f ms, with the union %.1f ms (%zu triangles), skin weights "
                    "%.1f ms\n",
                    inflation, whole, mesh.triangles.size(), skin);
    }
}

} // namespace pantin::bench
