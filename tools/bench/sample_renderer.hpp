// SPDX-License-Identifier: MIT
// The first rasteriser, which shades every sample: what the present one is measured and tested against.
#pragma once

#include <memory>
#include <vector>

#include "pantin/animation.hpp"

namespace pantin::bench {

// As FrameRenderer; `options.supersampling` may be any number of samples per axis.
class SampleRenderer {
public:
    SampleRenderer(const Rig& rig, const RgbaImage& texture, const View& view,
                   const RenderOptions& options = {});
    ~SampleRenderer();
    RgbaImage operator()(const std::vector<Vec3>& vertices) const;

private:
    struct Parts;
    std::unique_ptr<const Parts> parts_;
};

} // namespace pantin::bench
