// SPDX-License-Identifier: MIT
// Files that other programs read: OBJ/MTL/weights.txt (thesis ch. 5), glTF 2.0, WebP, GIF, APNG, MP4, PNG
// frames.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pantin/animation.hpp"
#include "pantin/rigging.hpp"

namespace pantin {

std::string to_obj(const Rig& rig, const std::string& mtl_file);
std::string to_mtl(const std::string& texture_file);
std::string to_weights_text(const Rig& rig); // "# pantin weights 1", docs/formats.md
// glTF 2.0 binary: one skinned mesh at the scene root, unlit textured material, one animation per clip.
std::vector<unsigned char> to_glb(const Rig& rig, const RgbaImage& texture,
                                  const std::vector<BoneAnimation>& animations);

// Frames with transparency. Delay of a GIF frame is a whole number of 1/100 s.
std::vector<unsigned char> encode_webp(const std::vector<RgbaImage>& frames, double fps);
std::vector<unsigned char> encode_gif(const std::vector<RgbaImage>& frames, double fps);
std::vector<unsigned char> encode_apng(const std::vector<RgbaImage>& frames, double fps);
// H.264 on white, the loop repeated until it lasts 3 s. Needs the program ffmpeg; Error(output) with its
// message.
void write_mp4(const std::filesystem::path& file, const std::vector<RgbaImage>& frames, double fps);
bool webp_available();
bool gif_available();
bool mp4_available(); // an ffmpeg is in the PATH

} // namespace pantin
