// SPDX-License-Identifier: MIT
// The rule of the silhouette and its labels, on small drawings made for one fact each.
#include <catch2/catch.hpp>

#include <algorithm>

#include "pantin/image.hpp"
#include "segmentation/final_silhouette.hpp"
#include "segmentation/letterbox.hpp"
#include "segmentation/part_labels.hpp"

namespace pantin::segmentation {
namespace {

// What the rule sees: the detector's mask, the network's foreground, the ink.
struct Scene {
    Mask mask;
    Grid<float> foreground, ink;
    explicit Scene(int size = 200) : mask(size, size), foreground(size, size), ink(size, size) {}

    template <class T> static void rectangle(Grid<T>& grid, Box box, T value) {
        for (int y = box.y; y < box.y + box.height; ++y)
            for (int x = box.x; x < box.x + box.width; ++x) grid(x, y) = value;
    }
    void stroke(Box box) {
        rectangle<std::uint8_t>(mask, box, 1);
        rectangle(ink, box, 1.0f);
    }
    Mask decide(const SilhouetteOptions& options = {}) const {
        return decide_silhouette(mask, foreground, ink, options);
    }
};

long area(const Mask& mask) { return std::count(mask.begin(), mask.end(), 1); }

std::vector<Grid<float>> certain(int size, Label label) {
    std::vector<Grid<float>> probabilities(label_count, Grid<float>(size, size));
    for (float& p : probabilities[static_cast<std::size_t>(label)]) p = 1;
    return probabilities;
}

} // namespace

TEST_CASE("An outline that the detector left hollow is filled where the network sees a character") {
    Scene scene;
    scene.stroke({40, 40, 3, 120}); // two sides and the top of a box, open below
    scene.stroke({157, 40, 3, 120});
    scene.stroke({40, 40, 120, 3});
    Scene::rectangle(scene.foreground, {40, 40, 120, 120}, 0.9f);
    const Mask silhouette = scene.decide();
    CHECK(silhouette(100, 100) == 1);
    CHECK(silhouette(100, 155) == 1);
    CHECK(area(silhouette) > 120 * 120 * 0.98);
    CHECK(area(silhouette) < 120 * 120 * 1.02);
}

TEST_CASE("A gap between two legs that the detector bridged is cut, the inked legs stay") {
    Scene scene;
    Scene::rectangle<std::uint8_t>(scene.mask, {50, 40, 100, 130}, 1); // body and legs, filled solid
    Scene::rectangle(scene.foreground, {50, 40, 100, 60}, 0.95f);
    Scene::rectangle(scene.foreground, {50, 100, 20, 70}, 0.9f);
    Scene::rectangle(scene.foreground, {130, 100, 20, 70}, 0.9f);
    const Mask silhouette = scene.decide();
    CHECK(silhouette(100, 140) == 0);
    CHECK(silhouette(60, 160) == 1);
    CHECK(silhouette(140, 160) == 1);
    CHECK(silhouette(100, 60) == 1);
}

TEST_CASE("The space between two legs stays open, however narrow, when the network takes it for paper") {
    Scene scene;
    scene.stroke({50, 40, 100, 60});                                     // body
    for (const int x : {80, 92, 99, 111}) scene.stroke({x, 100, 3, 70}); // the sides of two legs
    scene.stroke({80, 167, 34, 3});                                      // one line under both
    Scene::rectangle<std::uint8_t>(scene.mask, {80, 100, 34, 70}, 1);
    Scene::rectangle(scene.foreground, {50, 40, 100, 130}, 0.9f);
    Scene::rectangle(scene.foreground, {95, 100, 4, 67}, 0.35f); // in doubt, on the whole rather paper
    const Mask silhouette = scene.decide();
    CHECK(silhouette(96, 130) == 0);
    CHECK(silhouette(97, 130) == 0);
    CHECK(silhouette(87, 130) == 1);
    CHECK(silhouette(105, 130) == 1);
    Scene::rectangle(scene.foreground, {95, 100, 4, 67}, 0.5f);
    CHECK(scene.decide()(96, 130) == 1);
}

TEST_CASE("A wing whose outline has a narrow gap is not cut for doubts") {
    Scene scene;
    scene.stroke({20, 80, 60, 40}); // body
    Scene::rectangle(scene.foreground, {20, 80, 60, 40}, 0.95f);
    Scene::rectangle<std::uint8_t>(scene.mask, {80, 40, 100, 100}, 1); // wing, closed by the detector
    for (const Box side :
         {Box{80, 40, 100, 3}, Box{80, 137, 100, 3}, Box{177, 40, 3, 45}, Box{177, 95, 3, 45}})
        scene.stroke(side);
    Scene::rectangle<float>(scene.ink, {80, 40, 3, 100}, 1.0f);
    Scene::rectangle(scene.foreground, {80, 40, 100, 100}, 0.2f);
    CHECK(scene.decide()(130, 90) == 1);
}

TEST_CASE("Ink of the mask is never cut, even where the network sees background everywhere") {
    Scene scene;
    scene.stroke({99, 20, 2, 160}); // a stick
    scene.stroke({60, 60, 80, 2});
    const Mask silhouette = scene.decide();
    for (std::size_t i = 0; i < silhouette.size(); ++i)
        if (scene.ink.data()[i] > 0) CHECK(silhouette.data()[i] == 1);
}

TEST_CASE("A small closed space is not cut for doubts alone, but is for certainty") {
    Scene scene;
    scene.stroke({10, 10, 180, 180}); // ink all over but for the space between arm and body
    Scene::rectangle(scene.foreground, {10, 10, 180, 180}, 0.9f);
    Scene::rectangle(scene.ink, {80, 80, 40, 40}, 0.0f);
    Scene::rectangle(scene.foreground, {80, 80, 40, 40}, 0.2f);
    CHECK(scene.decide()(100, 100) == 1);
    Scene::rectangle(scene.foreground, {80, 80, 40, 40}, 0.02f);
    CHECK(scene.decide()(100, 100) == 0);
}

TEST_CASE("A cloud of foreground that no stroke encloses is not taken, unless the silhouette stays hollow "
          "without it") {
    Scene scene;
    scene.stroke({40, 40, 120, 60});
    Scene::rectangle(scene.foreground, {40, 40, 120, 60}, 0.9f);
    Scene::rectangle(scene.foreground, {80, 100, 40, 40}, 0.9f); // below the body, open on three sides
    CHECK(scene.decide()(100, 120) == 0);
    Scene hollow;
    hollow.stroke({40, 40, 120, 3}); // one line above what the network sees
    Scene::rectangle(hollow.foreground, {40, 40, 120, 80}, 0.9f);
    CHECK(hollow.decide()(100, 100) == 1);
}

TEST_CASE("A closed body of which the network is sure to see nothing is not cut out") {
    Scene scene;
    Scene::rectangle<std::uint8_t>(scene.mask, {20, 20, 160, 160}, 1);
    for (const Box side :
         {Box{20, 20, 160, 3}, Box{20, 177, 160, 3}, Box{20, 20, 3, 160}, Box{177, 20, 3, 160}})
        scene.stroke(side);
    CHECK(scene.decide()(100, 100) == 1);
}

TEST_CASE("A rim that the network's blur adds around the outline is not taken") {
    Scene scene;
    scene.stroke({50, 50, 100, 100});
    Scene::rectangle(scene.foreground, {49, 49, 102, 102}, 0.8f);
    const Mask silhouette = scene.decide();
    CHECK(silhouette(49, 100) == 0);
    CHECK(silhouette(100, 150) == 0);
    CHECK(area(silhouette) == 100 * 100 - 4); // the four corners are smoothed
}

TEST_CASE("A near piece of some size is joined by a bridge, a far one and noise are dropped") {
    Scene scene;
    scene.stroke({40, 80, 80, 60});  // body
    scene.stroke({125, 70, 30, 30}); // head, 5 pixels away
    scene.stroke({2, 2, 20, 20});    // far away
    scene.stroke({60, 144, 2, 2});   // a speck near by
    const Mask silhouette = scene.decide();
    CHECK(silhouette(140, 85) == 1);
    CHECK(silhouette(10, 10) == 0);
    CHECK(silhouette(60, 144) == 0);
    CHECK(connected_components(silhouette).list.size() == 1);
}

TEST_CASE("Small holes are filled and large ones stay") {
    Scene scene;
    for (float& p : scene.foreground) p = 0.9f;
    scene.stroke({20, 20, 160, 160});
    Scene::rectangle<std::uint8_t>(scene.mask, {40, 40, 6, 6}, 0);
    Scene::rectangle<std::uint8_t>(scene.mask, {100, 100, 50, 50}, 0);
    Scene::rectangle(scene.foreground, {40, 40, 6, 6}, 0.0f);
    Scene::rectangle(scene.foreground, {100, 100, 50, 50}, 0.0f);
    const Mask silhouette = scene.decide();
    CHECK(silhouette(42, 42) == 1);
    CHECK(silhouette(125, 125) == 0);
}

TEST_CASE("The silhouette of nothing is empty, that of one pixel is that pixel") {
    Scene nothing;
    CHECK(area(nothing.decide()) == 0);
    Scene one;
    one.stroke({100, 100, 1, 1});
    const Mask silhouette = one.decide();
    CHECK(area(silhouette) == 1);
    CHECK(silhouette(100, 100) == 1);
    const LabelMap labels = label_parts(silhouette, certain(200, Label::background), {});
    CHECK(labels(100, 100) >= 1);
    CHECK(std::count(labels.begin(), labels.end(), 0) == 200 * 200 - 1);
}

TEST_CASE("Every pixel of the silhouette has a part and no other has one") {
    Mask silhouette(60, 60);
    Scene::rectangle<std::uint8_t>(silhouette, {10, 10, 40, 40}, 1);
    auto probabilities = certain(60, Label::background);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 30; ++x) {
            probabilities[0](x, y) = 0.1f;
            probabilities[3](x, y) = 0.5f, probabilities[4](x, y) = 0.4f;
        }
    const LabelMap labels = label_parts(silhouette, probabilities, {});
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 60; ++x)
            CHECK(labels(x, y) == (silhouette(x, y) ? 3 : 0)); // also right of 30: the nearest
}

TEST_CASE("Specks of a label take the label around them, parts stay") {
    Mask silhouette(100, 100, 1);
    auto probabilities = certain(100, Label::body);
    const auto paint = [&](Box box, Label label) {
        for (auto& plane : probabilities) Scene::rectangle(plane, box, 0.0f);
        Scene::rectangle(probabilities[static_cast<std::size_t>(label)], box, 1.0f);
    };
    paint({10, 10, 3, 3}, Label::wing);
    paint({50, 50, 20, 20}, Label::head);
    const LabelMap labels = label_parts(silhouette, probabilities, {});
    CHECK(std::count(labels.begin(), labels.end(), static_cast<int>(Label::wing)) == 0);
    CHECK(std::count(labels.begin(), labels.end(), static_cast<int>(Label::head)) == 400);
    CHECK(std::count(labels.begin(), labels.end(), static_cast<int>(Label::body)) == 9600);
}

TEST_CASE("The letterbox is centred and as large as fits") {
    CHECK(letterbox(512, 256, 256) == Box{0, 64, 256, 128});
    CHECK(letterbox(100, 100, 256) == Box{0, 0, 256, 256});
    CHECK(letterbox(3, 1000, 256) == Box{127, 0, 1, 256});
    CHECK(letterbox(1, 5000, 256) == Box{127, 0, 1, 256});
    Grid<float> ink(40, 20, 1.0f);
    const network::Tensor input = to_input(ink, 64, false);
    CHECK(input(0, 0, 15, 30) == 0);
    CHECK(input(0, 0, 16, 0) == 1);
    CHECK(input(0, 0, 47, 63) == 1);
    CHECK(input(0, 0, 48, 63) == 0);
    const auto planes = from_output(input, letterbox(40, 20, 64));
    REQUIRE(planes.size() == 1);
    CHECK(planes[0] == Grid<float>(64, 32, 1.0f));
}

TEST_CASE("Grey erosion thickens strokes") {
    Grid<float> ink(64, 64);
    for (int y = 0; y < 64; ++y) ink(30, y) = 0.7f;
    const network::Tensor plain = to_input(ink, 64, false), eroded = to_input(ink, 64, true);
    CHECK(plain(0, 0, 20, 29) == 0);
    CHECK(eroded(0, 0, 20, 29) == 0.7f);
    CHECK(eroded(0, 0, 20, 31) == 0.7f);
    CHECK(eroded(0, 0, 20, 32) == 0);
}

} // namespace pantin::segmentation
