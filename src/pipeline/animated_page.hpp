// SPDX-License-Identifier: MIT
// The driver's result: the page with its characters, for those who show what is in between (explain).
#pragma once

#include <filesystem>
#include <vector>

#include "pantin/page.hpp"
#include "pipeline/character.hpp"

namespace pantin {

struct AnimatedPage {
    Page page;
    std::vector<Character> characters; // in the order of the page's list
    RgbImage picture;                  // as it was given to the detector, and its ink, when they are kept
    Mask ink;
};

// All steps with their files, as animate() (pipeline.hpp). With `keep_intermediate` characters, picture and
// ink stay in memory. When no character could be animated the page says why.
AnimatedPage animate_page(const std::filesystem::path& image, const std::filesystem::path& out,
                          Context& context, bool keep_intermediate);

// As wanted, and what follows from the kind of input: a folder of AnimatedDrawings with the joints of a human
// figure is one.
Settings settings_for(const std::filesystem::path& image, const Settings& wanted);
// Error(not_animated) names the reasons when the status of no character is "ok".
void require_animated(const std::filesystem::path& image, const Page& page);

} // namespace pantin
