#include "pipeline/workshop.hpp"

#include "core/file.hpp"
#include "core/resources.hpp"

namespace pantin {

const Segmenter& Workshop::segmenter() {
    if (segmenter_) return *segmenter_;
    if (settings_.weights.empty()) {
        const std::span<const unsigned char> bytes = find_resource("weights/segmenter.safetensors");
        if (bytes.empty())
            throw Error(ErrorKind::weights,
                        "no weights are compiled into this program: give a folder with --weights");
        return segmenter_.emplace(bytes, "weights/segmenter.safetensors (compiled in)");
    }
    const std::filesystem::path file = settings_.weights / "segmenter.safetensors";
    try {
        weights_ = read_file(file);
    } catch (const Error& error) {
        throw Error(ErrorKind::weights, error.what());
    }
    return segmenter_.emplace(weights_, file.string());
}

const std::vector<ReferenceSkeleton>& Workshop::references() {
    if (!references_) references_ = load_references(settings_.references);
    return *references_;
}

const ReferenceSkeleton& Workshop::reference(const std::string& name) {
    for (const ReferenceSkeleton& reference : references())
        if (reference.name == name) return reference;
    throw Error(ErrorKind::input, "there is no reference '" + name + "'");
}

} // namespace pantin
