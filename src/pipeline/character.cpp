// SPDX-License-Identifier: MIT
#include "pipeline/character.hpp"

#include <algorithm>

#include "core/file.hpp"
#include "core/math.hpp"
#include "pantin/image.hpp"
#include "pipeline/json_files.hpp"

namespace pantin {

namespace {

std::string size_text(int width, int height) { return std::to_string(width) + "×" + std::to_string(height); }

} // namespace

void fail_size(const std::filesystem::path& file, int width, int height, const std::string& other,
               int other_width, int other_height) {
    throw Error(ErrorKind::input, file.string() + ": is " + size_text(width, height) + " pixels, but " +
                                      other + " is " + size_text(other_width, other_height));
}

void check_labels(const LabelMap& labels, const std::filesystem::path& file) {
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x)
            if (labels(x, y) >= label_count)
                throw Error(ErrorKind::input, file.string() + ": pixel (" + std::to_string(x) + ", " +
                                                  std::to_string(y) + ") has the value " +
                                                  std::to_string(labels(x, y)) + ", labels are 0 to " +
                                                  std::to_string(label_count - 1));
}

const RgbImage& drawing_of(Character& character) {
    if (!character.drawing) character.drawing = load_image(character.folder / "drawing.png", 1);
    return *character.drawing;
}

const Mask& mask_of(Character& character) {
    if (!character.mask) {
        Mask mask = load_grey(character.folder / "mask.png");
        for (std::uint8_t& pixel : mask) pixel = pixel >= 128 ? 1 : 0;
        character.mask = std::move(mask);
    }
    return *character.mask;
}

const LabelMap& labels_of(Character& character) {
    if (!character.labels) {
        const std::filesystem::path file = character.folder / "labels.png";
        LabelMap labels = load_grey(file);
        const Mask& mask = mask_of(character);
        if (labels.width() != mask.width() || labels.height() != mask.height())
            fail_size(file, labels.width(), labels.height(), "mask.png", mask.width(), mask.height());
        check_labels(labels, file);
        character.labels = std::move(labels);
    }
    return *character.labels;
}

const SkeletonGraph& skeleton_of(Character& character) {
    if (!character.skeleton) {
        const std::filesystem::path file = character.folder / "skeleton.json";
        SkeletonGraph graph = skeleton_from_json(read_text(file), file.string());
        const LabelMap& labels = labels_of(character);
        if (graph.width != labels.width() || graph.height != labels.height())
            fail_size(file, graph.width, graph.height, "labels.png", labels.width(), labels.height());
        character.skeleton = std::move(graph);
    }
    return *character.skeleton;
}

const Identification& identification_of(Character& character, Workshop& workshop) {
    if (!character.identification) {
        const std::filesystem::path file = character.folder / "identification.json";
        character.identification = identification_from_json(read_text(file), file.string(),
                                                            skeleton_of(character), workshop.references());
    }
    return *character.identification;
}

const ReferenceSkeleton& reference_of(Character& character, Workshop& workshop) {
    const Identification& identification = identification_of(character, workshop);
    const ReferenceSkeleton& chosen = workshop.reference(identification.reference);
    if (!workshop.settings().blend) return chosen;
    if (character.blended) return *character.blended;
    const std::vector<Candidate>& all = identification.candidates;
    const auto own =
        std::find_if(all.begin(), all.end(), [&](const Candidate& c) { return c.reference == chosen.name; });
    const auto other = std::find_if(all.begin(), all.end(), [&](const Candidate& c) {
        const ReferenceSkeleton& r = workshop.reference(c.reference);
        return r.like.empty() && r.name != chosen.name && r.name != chosen.like;
    });
    if (own == all.end() || other == all.end()) return chosen;
    const double share = 1 / (1 + math::exp(own->score - other->score));
    character.blended = blend(chosen, workshop.reference(other->reference), share);
    return *character.blended;
}

bool is_mirrored(const Identification& identification) {
    return std::any_of(
        identification.candidates.begin(), identification.candidates.end(),
        [&](const Candidate& c) { return c.reference == identification.reference && c.mirrored; });
}

Rig rig_from_mapping(Character& character, Workshop& workshop, const std::filesystem::path& file) {
    const Identification& identification = identification_of(character, workshop);
    const ReferenceSkeleton& reference = reference_of(character, workshop);
    const bool mirrored = is_mirrored(identification);
    const Mapping mapping =
        mapping_from_json(read_text(file), file.string(), skeleton_of(character), reference);
    return in_its_space(rig_with_mapping(skeleton_of(character), labels_of(character), reference, mirrored,
                                         mapping, workshop.options().rigging),
                        character, workshop);
}

const Solid* solid_of(Character& character, Workshop& workshop) {
    std::error_code ignored;
    if (!character.solid && std::filesystem::exists(character.folder / "strokes.json", ignored))
        character.solid =
            std::make_shared<const Solid>(read_solid(character.folder, workshop.options().modeling));
    return character.solid.get();
}

Rig in_its_space(Rig rig, Character& character, Workshop& workshop) {
    const Solid* solid = solid_of(character, workshop);
    return solid ? lifted(rig, solid->model, solid->mesh, solid->view, solid->colours) : std::move(rig);
}

RgbaImage texture_of(Character& character, Workshop& workshop) {
    const RgbImage& drawing = drawing_of(character);
    return solid_of(character, workshop) ? make_solid_texture(drawing, labels_of(character))
                                         : make_texture(drawing, labels_of(character));
}

const Rig& rig_of(Character& character, Workshop& workshop) {
    if (!character.rig) {
        const std::filesystem::path file = character.folder / "weights.txt";
        const std::string text = read_text(file);
        Rig made = rig_from_mapping(character, workshop, character.folder / "mapping.json");
        made.weights = weights_from_text(text, file.string(), made);
        character.rig = std::move(made);
    }
    return *character.rig;
}

GreyImage to_grey(const Mask& mask) {
    GreyImage grey = mask;
    for (std::uint8_t& pixel : grey) pixel = pixel != 0 ? 255 : 0;
    return grey;
}

} // namespace pantin
