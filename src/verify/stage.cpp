// SPDX-License-Identifier: MIT
// The drawings and stages of the verification in the order of the flow, and their access to files (own).
#include "verify/stage.hpp"

#include <span>

#include "pantin/image.hpp"
#include "verify/bytes.hpp"

namespace pantin {

std::span<const std::string_view> verified_presets() {
    static constexpr std::string_view presets[] = {"default", "thesis"};
    return presets;
}

const std::vector<VerifiedDrawing>& verified_drawings(std::string_view preset) {
    static const std::vector<VerifiedDrawing> of_default = {
        {"humanoid", "humanoid", Detector::mask_rcnn, true, true},
        {"quadruped", "quadruped", Detector::mask_rcnn, false, false},
        {"flyer", "flyer", Detector::contour, false, false}};
    static const std::vector<VerifiedDrawing> of_thesis = [] {
        std::vector<VerifiedDrawing> drawings;
        for (const char* name : {"hole", "unpaired", "crossed"}) {
            VerifiedDrawing& drawing = drawings.emplace_back();
            drawing.name = name;
            drawing.folder = std::string("thesis/") + name;
            drawing.probability_step = 16;
        }
        return drawings;
    }();
    if (preset == "default") return of_default;
    if (preset == "thesis") return of_thesis;
    throw Error(ErrorKind::usage, "no stored results of a preset '" + std::string(preset) + "'");
}

const std::vector<Stage>& verified_stages() {
    static const std::vector<Stage> stages = [] {
        std::vector<Stage> all = shape_stages();
        for (const auto& group : {motion_stages(), solid_stages()})
            all.insert(all.end(), group.begin(), group.end());
        return all;
    }();
    return stages;
}

const std::string& StageContext::text(const std::string& name) const {
    const auto found = files.find(drawing.folder + "/" + name);
    if (found == files.end()) throw Error(ErrorKind::input, drawing.folder + "/" + name + ": missing");
    return found->second;
}

RgbImage StageContext::picture(const std::string& name) const {
    return decode_image(as_bytes(text(name)), name, 1);
}
GreyImage StageContext::grey(const std::string& name) const {
    return decode_grey(as_bytes(text(name)), name);
}
Mask StageContext::mask(const std::string& name) const { return foreground(grey(name)); }

std::string png(const GreyImage& image) { return as_text(encode_png(image)); }
std::string png(const RgbImage& image) { return as_text(encode_png(image)); }
std::string png(const RgbaImage& image) { return as_text(encode_png(image)); }

} // namespace pantin
