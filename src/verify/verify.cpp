// SPDX-License-Identifier: MIT
// The stages on the drawings, each output against the stored one.
#include "pantin/verify.hpp"

#include <algorithm>

#include "core/digest.hpp"
#include "verify/stage.hpp"
#include "verify/values.hpp"
#include "verify/vectors.hpp"

namespace pantin {

namespace {

Options options_for(const VerifiedDrawing& drawing, Options options) {
    options.detection.detector = drawing.detector;
    if (drawing.several_views) {
        options.segmentation.sufficient_confidence = 1;
    } else {
        options.segmentation.mirror = false;
        options.segmentation.tilt = 0;
    }
    return options;
}

// The stored files with what the stages have made so far in their place.
void replace(Files& files, const std::string& folder, const Files& made) {
    for (const auto& [name, bytes] : made) files[folder + "/" + name] = bytes;
}

// The message of a stage that throws takes the place of its files.
struct Outcome {
    Files made;
    std::string message;
};
Outcome outcome_of(const Stage& stage, const StageContext& context) {
    try {
        return {stage.run(context), ""};
    } catch (const CharacterRejected& rejected) {
        return {{}, rejected.step() + ": " + rejected.what()};
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::weights || error.kind() == ErrorKind::usage)
            throw; // of the call, not of the results
        return {{}, error.what()};
    }
}

FileDifference fact(const std::string& file, const std::string& first, const std::string& second) {
    FileDifference difference;
    difference.file = file;
    difference.first = first;
    difference.second = second;
    difference.values = 1;
    return difference;
}

std::vector<FileDifference> differences_of(const Stage& stage, const std::string& folder,
                                           const Outcome& outcome, const Files& stored) {
    std::vector<FileDifference> differences;
    for (const std::string& output : stage.outputs) {
        const std::string name = folder + "/" + output;
        const auto wanted = stored.find(name);
        const auto made = outcome.made.find(output);
        if (made == outcome.made.end()) {
            differences.push_back(fact(name, wanted == stored.end() ? "missing" : "a file", outcome.message));
            break; // one message for all files
        }
        if (wanted == stored.end())
            differences.push_back(fact(name, "missing", "a file"));
        else if (const auto difference = compare_files(name, wanted->second, made->second))
            differences.push_back(*difference);
    }
    return differences;
}

std::string digest_of(const Files& files) {
    Digest digest;
    for (const auto& [name, bytes] : files) {
        digest.add(name + "\n");
        digest.add(encoded_values(name, bytes));
    }
    return digest.text();
}

class Verifier {
public:
    explicit Verifier(const VerificationSettings& settings)
        : settings_(settings), drawings_(verified_drawings(settings.preset)),
          references_(load_references({}, settings.options.animation.clips)), stored_(stored_vectors()) {}

    Verification run() {
        for (const VerifiedDrawing& drawing : drawings_) result_.drawings.push_back(drawing.name);
        for (const Stage& stage : verified_stages())
            if (std::any_of(drawings_.begin(), drawings_.end(),
                            [&](const VerifiedDrawing& drawing) { return stage.is_for(drawing); }))
                result_.stages.push_back(stage.name);
        for (const VerifiedDrawing& drawing : drawings_) check(drawing);
        result_.digest = digest_of(result_.outputs);
        return std::move(result_);
    }

private:
    const VerificationSettings& settings_;
    const std::vector<VerifiedDrawing>& drawings_;
    Networks networks_;
    const std::vector<ReferenceSkeleton> references_;
    const Files stored_;
    Verification result_;
    double done_ = 0; // drawings and stages

    void check(const VerifiedDrawing& drawing) {
        const Options options =
            settings_.preset == "default" ? options_for(drawing, settings_.options) : settings_.options;
        const std::string page = drawing.folder + "/page.png";
        if (const auto found = stored_.find(page); found != stored_.end())
            result_.outputs[page] = found->second;
        Files chain = stored_;
        for (const Stage& stage : verified_stages()) {
            const double total = static_cast<double>(drawings_.size() * verified_stages().size());
            if (settings_.progress) settings_.progress(drawing.name + ": " + stage.name, done_++ / total);
            if (!stage.is_for(drawing)) continue;
            const Files& input = settings_.end_to_end ? chain : stored_;
            const Outcome outcome =
                outcome_of(stage, {drawing, options, settings_.threads, networks_, references_, input});
            if (settings_.end_to_end) replace(chain, drawing.folder, outcome.made);
            replace(result_.outputs, drawing.folder, outcome.made);
            result_.results.push_back(
                {stage.name, drawing.name, differences_of(stage, drawing.folder, outcome, stored_)});
        }
    }
};

} // namespace

Options VerificationSettings::verification_options(std::string_view preset) {
    Options options = make_preset(preset);
    if (preset == "thesis") {
        options.animation.samples = 4;
        options.rigging.mesh.cell = 6;
        return options;
    }
    options.animation.samples = 8;
    options.modeling.inflation.polygon.samples = 100;
    options.modeling.inflation.longest_edge = 0.1;
    return options;
}

VerificationSettings VerificationSettings::of(std::string_view preset) {
    VerificationSettings settings;
    settings.preset = preset;
    settings.options = verification_options(preset);
    return settings;
}

const StageDifferences* Verification::first_difference() const {
    for (const std::string& stage : stages)
        for (const StageDifferences& result : results)
            if (result.stage == stage && !result.files.empty()) return &result;
    return nullptr;
}

Verification verify(const VerificationSettings& settings) { return Verifier(settings).run(); }

} // namespace pantin
