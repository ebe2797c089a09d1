// SPDX-License-Identifier: MIT
// The drawings and stages of the verification in the order of the flow, and their access to files (own).
#include "verify/stage.hpp"

#include <span>

#include "pantin/image.hpp"
#include "verify/bytes.hpp"

namespace pantin {

const std::vector<VerifiedDrawing>& verified_drawings() {
    static const std::vector<VerifiedDrawing> drawings = {{"humanoid", Detector::mask_rcnn, true, true},
                                                          {"quadruped", Detector::mask_rcnn, false, false},
                                                          {"flyer", Detector::contour, false, false}};
    return drawings;
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
    const auto found = files.find(drawing.name + "/" + name);
    if (found == files.end()) throw Error(ErrorKind::input, drawing.name + "/" + name + ": missing");
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
