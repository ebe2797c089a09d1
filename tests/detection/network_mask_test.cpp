// SPDX-License-Identifier: MIT
// The network's own mask as a character's silhouette (thesis 4.2, 4.4), and what it is chosen from.
#include <catch2/catch.hpp>

#include <algorithm>

#include "core/file.hpp"
#include "detection/network_grouping.hpp"
#include "pantin/detection.hpp"
#include "pantin/image.hpp"

using namespace pantin;

namespace {

const CharacterFinder& tiny() {
    static const std::vector<unsigned char> bytes = read_file("testdata/mask_rcnn_tiny.safetensors");
    static const CharacterFinder finder(bytes, "tiny");
    return finder;
}

// The tiny network is not trained: everything that it finds counts.
DetectionOptions options_for(MaskSource mask) {
    DetectionOptions options;
    options.mask = mask;
    options.network_score = 0;
    options.inside_share = 2;
    options.working_size = 321;
    return options;
}

long count(const Mask& mask) { return std::count(mask.begin(), mask.end(), 1); }

} // namespace

TEST_CASE("With the mask of the network the silhouette is where its probability is one half and more") {
    const RgbImage page = load_image("testdata/demo.png");
    const DetectionOptions options = options_for(MaskSource::network);
    const Detection detection = detect(page, options, &tiny());
    const auto found = whole_characters(tiny().find(page, ink_darkness(page)), options);
    int compared = 0;
    for (const DetectedCharacter& c : detection.characters) {
        CHECK(c.mask.width() == c.ink_mask.width());
        CHECK(std::max(c.mask.width(), c.mask.height()) <= 321);
        REQUIRE(c.network_mask.width() == c.mask.width());
        if (count(c.network_mask) == 0) {
            CHECK(c.mask == c.ink_mask);
            continue;
        }
        CHECK(c.mask == c.network_mask);
        CHECK_FALSE(c.exact_mask);
        // Whose it is: the detection of that score. Its box, and the margin, are the character's.
        const auto by =
            std::find_if(found.begin(), found.end(), [&](const auto& f) { return f.score == c.score; });
        REQUIRE(by != found.end());
        CHECK(c.box.x <= by->left);
        CHECK(c.box.y <= by->top);
        CHECK(c.box.x + c.box.width >= std::min<double>(by->right, page.width()));
        CHECK(c.box.y + c.box.height >= std::min<double>(by->bottom, page.height()));
        for (int y = 0; y < c.mask.height(); ++y)
            for (int x = 0; x < c.mask.width(); ++x) {
                const double px = c.box.x + (x + 0.5) * c.box.width / c.mask.width(),
                             py = c.box.y + (y + 0.5) * c.box.height / c.mask.height();
                const double p = by->probability(px, py);
                if (std::abs(p - 0.5) > 1e-6) REQUIRE((c.mask(x, y) == 1) == (p >= 0.5));
            }
        ++compared;
    }
    CHECK(compared > 0);
}

TEST_CASE("The mask of the ink stays what it was, with the network's beside it") {
    const RgbImage page = load_image("testdata/demo.png");
    const Detection by_network = detect(page, options_for(MaskSource::ink), &tiny());
    REQUIRE_FALSE(by_network.characters.empty());
    for (const DetectedCharacter& c : by_network.characters) {
        CHECK(c.mask == c.ink_mask);
        CHECK(c.network_mask.width() == c.mask.width());
    }
    // Without a network there is nothing to choose.
    for (const MaskSource source : {MaskSource::ink, MaskSource::network}) {
        const Detection by_contours = detect(page, options_for(source));
        REQUIRE_FALSE(by_contours.characters.empty());
        for (const DetectedCharacter& c : by_contours.characters) {
            CHECK(c.mask == c.ink_mask);
            CHECK(c.network_mask.empty());
        }
    }
}
