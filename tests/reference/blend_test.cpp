// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>

#include "pantin/reference.hpp"

using namespace pantin;

namespace {

const ReferenceSkeleton& named(const std::vector<ReferenceSkeleton>& all, const std::string& name) {
    return *std::find_if(all.begin(), all.end(), [&](const ReferenceSkeleton& r) { return r.name == name; });
}

long ends(const ReferenceSkeleton& reference, Label label) {
    long count = 0;
    for (int n = 0; n < std::ssize(reference.nodes); ++n)
        count += reference.nodes[n].label == label &&
                 std::count_if(reference.edges.begin(), reference.edges.end(),
                               [n](const auto& e) { return e.first == n || e.second == n; }) == 1;
    return count;
}

// Sum of the amplitudes of one kind of track of the joints whose name begins so.
double swing(const ReferenceSkeleton& reference, const ReferenceClip& clip, const std::string& begin,
             TrackKind kind) {
    double sum = 0;
    for (const ReferenceTrack& t : clip.tracks)
        if (t.kind == kind && reference.joints[t.joint].name.starts_with(begin)) sum += t.amplitude;
    return sum;
}

} // namespace

TEST_CASE("a blend of a flyer and a quadruped has wings that flap and four legs that walk") {
    const std::vector<ReferenceSkeleton> all = load_references();
    const ReferenceSkeleton &flying = named(all, "flying"), &quadruped = named(all, "quadruped");
    const ReferenceSkeleton gryphon = blend(flying, quadruped, 0.75);
    CHECK(gryphon.name == "flying");
    CHECK(ends(gryphon, Label::wing) == 2);
    CHECK(ends(gryphon, Label::limb) == 4);
    CHECK(ends(gryphon, Label::head) == 1);
    for (std::size_t n = 0; n < flying.nodes.size(); ++n)
        CHECK(gryphon.nodes[n].name == flying.nodes[n].name);
    const ReferenceClip &fly = flying.clips[0], &walk = quadruped.clips[0], &mixed = gryphon.clips[0];
    CHECK(mixed.name == "fly");
    CHECK(swing(gryphon, mixed, "wing", TrackKind::flap) == swing(flying, fly, "wing", TrackKind::flap));
    CHECK(swing(gryphon, mixed, "leg", TrackKind::step) ==
          Approx(swing(quadruped, walk, "leg", TrackKind::step)));
    CHECK(swing(gryphon, mixed, "leg", TrackKind::z) == 0); // not the flyer's dangling
    const double head = 0.75 * swing(flying, fly, "head", TrackKind::lift) +
                        0.25 * swing(quadruped, walk, "head", TrackKind::lift);
    CHECK(swing(gryphon, mixed, "head", TrackKind::lift) == Approx(head));
    for (const ReferenceTrack& track : mixed.tracks) CHECK(track.joint < std::ssize(gryphon.joints));
    for (std::size_t j = 1; j < gryphon.joints.size(); ++j)
        CHECK(gryphon.joints[j].parent < static_cast<int>(j));
}

TEST_CASE("a reference blended with itself stays what it is") {
    for (const ReferenceSkeleton& reference : load_references()) {
        const ReferenceSkeleton same = blend(reference, reference, 0.5);
        CHECK(same.nodes.size() == reference.nodes.size());
        CHECK(same.joints.size() == reference.joints.size());
        for (std::size_t c = 0; c < same.clips.size(); ++c)
            for (std::size_t k = 0; k < track_kind_names.size(); ++k) {
                const TrackKind kind = static_cast<TrackKind>(k);
                CHECK(swing(same, same.clips[c], "", kind) ==
                      Approx(swing(reference, reference.clips[c], "", kind)));
            }
    }
}
