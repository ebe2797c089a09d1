// SPDX-License-Identifier: MIT
// The whole page as one film: every character moves in its place, before the paper with the characters taken
// off.
#pragma once

#include <filesystem>
#include <vector>

#include "pantin/page.hpp"
#include "pipeline/character.hpp"

namespace pantin {

// Writes out/scene.webp and so on (PNG frames: out/frames/scene). `picture`: the page; `characters` are those
// of `page`; those whose status is not "ok" stay on the paper as they were drawn.
void render_scene(const RgbImage& picture, const std::filesystem::path& out, const Page& page,
                  const std::vector<Character>& characters, const Context& context);

} // namespace pantin
