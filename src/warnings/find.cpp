// SPDX-License-Identifier: MIT
// Products of a character to its warnings: which measures are beyond their thresholds, and what that says to
// a person (docs/warnings.md). Own.
#include <algorithm>
#include <cmath>

#include "pantin/image.hpp"
#include "pantin/warnings.hpp"

namespace pantin {

namespace {

std::string percent(double share) { return std::to_string(static_cast<int>(std::rint(100 * share))) + " %"; }

class Findings {
public:
    // Adds a warning when the value is beyond the threshold.
    void judge(WarningKind kind, double value, const std::string& text) {
        if (is_marked(kind, value)) warnings_.push_back({kind, value, text});
    }
    // In the order of the table; of each kind the first.
    std::vector<Warning> sorted() {
        std::stable_sort(warnings_.begin(), warnings_.end(),
                         [](const Warning& a, const Warning& b) { return a.kind < b.kind; });
        return std::move(warnings_);
    }

private:
    std::vector<Warning> warnings_;
};

void judge_silhouette(Findings& findings, const ResultToCheck& r, const Grid<float>& ink) {
    const double filled = filled_crop(r.labels), lost = lost_ink(ink, r.mask, r.labels);
    findings.judge(WarningKind::filled_crop, filled,
                   "the silhouette fills " + percent(filled) +
                       " of its crop, as if the background were cut out: --mask says where the character is");
    findings.judge(WarningKind::lost_ink, lost,
                   percent(lost) + " of the ink lies outside of the silhouette and is not in the films");
    if (!r.mask_given) return;
    const double left_out = lost_mask(r.mask, r.labels);
    findings.judge(WarningKind::lost_mask, left_out,
                   "the silhouette leaves out " + percent(left_out) + " of the given mask");
}

bool steps(const ReferenceSkeleton& reference, const std::string& name) {
    return std::any_of(reference.clips.begin(), reference.clips.end(), [&](const ReferenceClip& clip) {
        return clip.name == name &&
               std::any_of(clip.tracks.begin(), clip.tracks.end(),
                           [](const ReferenceTrack& track) { return track.kind == TrackKind::step; });
    });
}

// The worst clip of one kind.
struct Worst {
    double value = 0;
    std::string clip;
};

void judge_motion(Findings& findings, const ResultToCheck& r, const Grid<float>& ink) {
    Worst head, still, size{1, ""};
    std::string walk;
    for (const ShownClip& shown : r.clips) {
        const PosedClip clip = posed(r.rig, shown.animation);
        if (const double v = hanging_head(r.rig, r.labels, clip); v > head.value) head = {v, clip.name};
        if (const double v = figure_size(clip, shown.view); v < size.value) size = {v, clip.name};
        if (!steps(r.reference, clip.name)) continue;
        if (walk.empty()) walk = clip.name;
        if (const double v = still_limbs(r.rig, r.labels, clip); v > still.value) still = {v, clip.name};
    }
    findings.judge(WarningKind::hanging_head, head.value,
                   head.clip + ": the head hangs upside down or below the body");
    findings.judge(WarningKind::still_limbs, still.value,
                   still.clip + ": " + percent(still.value) + " of the limbs hardly move");
    findings.judge(WarningKind::small_figure, size.value,
                   size.clip + ": the figure takes " + percent(size.value) + " of the frame's longer side");
    if (walk.empty()) return;
    findings.judge(WarningKind::joined_limbs, joined_limbs(ink, r.labels, r.rig, r.reference),
                   walk + ": several legs move as one, because the space between them is filled: "
                          "labels.png can be repainted");
}

void judge_type(Findings& findings, const ResultToCheck& r) {
    const std::string second = r.reference_given ? "" : second_type(r.identification, r.references);
    if (second.empty()) return;
    findings.judge(WarningKind::unsure_type, r.identification.confidence,
                   "identified as " + r.identification.reference + " with a confidence of " +
                       percent(r.identification.confidence) + "; --reference " + second +
                       " is the next choice");
}

} // namespace

double unproven_distance(const Identification& identification) {
    const std::vector<Candidate>& all = identification.candidates;
    if (all.empty() || !all.front().evidence.empty()) return 0;
    return static_cast<double>(
               std::count_if(all.begin(), all.end(), [](const Candidate& c) { return !c.optimal; })) /
           static_cast<double>(all.size());
}

std::string unproven_line(const Identification& identification) {
    if (unproven_distance(identification) == 0) return "";
    std::string names;
    for (const Candidate& c : identification.candidates)
        if (!c.optimal) names += (names.empty() ? "" : ", ") + c.reference;
    return "the graph distance to " + names +
           " is the best that was found, and not proven to be the smallest: identification.ilp_iterations "
           "or identification.max_nodes was too small";
}

std::string second_type(const Identification& identification,
                        const std::vector<ReferenceSkeleton>& references) {
    const std::vector<Candidate>& candidates = identification.candidates; // from best to worst
    const ReferenceSkeleton& chosen = find_reference(references, identification.reference);
    if (candidates.front().reference != chosen.name || candidates.front().evidence.empty() ||
        chosen.like == "any")
        return "";
    for (const Candidate& candidate : candidates)
        if (find_reference(references, candidate.reference).like.empty() &&
            candidate.reference != chosen.name && candidate.reference != chosen.like)
            return candidate.reference;
    return "";
}

std::vector<Warning> find_warnings(const ResultToCheck& result) {
    const Grid<float> ink =
        resize(ink_darkness(result.drawing), result.labels.width(), result.labels.height());
    Findings findings;
    judge_silhouette(findings, result, ink);
    judge_motion(findings, result, ink);
    judge_type(findings, result);
    findings.judge(WarningKind::unproven_distance, unproven_distance(result.identification),
                   unproven_line(result.identification));
    return findings.sorted();
}

} // namespace pantin
