// SPDX-License-Identifier: MIT
// A run and a clip in, rendered frames in a row out (thesis, Fig. 4.19).
#include "figures/rendering.hpp"

#include <algorithm>

#include "figures/panel.hpp"
#include "pantin/image.hpp"

namespace pantin::figures {

BoneAnimation clip_of(const Run& run, const std::string& clip) {
    const auto found = std::find_if(run.reference->clips.begin(), run.reference->clips.end(),
                                    [&](const ReferenceClip& c) { return c.name == clip; });
    return retarget(run.rig, *run.reference, *found);
}

void draw_film(Svg& svg, Rectangle place, const Run& run, const std::string& clip, int count, double start) {
    const BoneAnimation animation = clip_of(run, clip);
    const View view = view_of(run.rig, {animation});
    const RgbaImage texture = make_texture(run.detected.drawing, run.detected.ink, run.labels());
    RenderOptions options;
    options.size = 300;
    const FrameRenderer renderer(run.rig, texture, view, options);
    for (int i = 0; i < count; ++i) {
        const double share = start + static_cast<double>(i) / count;
        const RgbaImage frame =
            renderer(skin(run.rig, animation, animation.duration * (share - static_cast<int>(share))));
        const double width = place.width / count;
        const Panel panel(svg, {place.x + i * width, place.y, width, place.height}, frame.width(),
                          frame.height());
        svg.image(panel.frame(), encode_png(frame));
    }
}

} // namespace pantin::figures
