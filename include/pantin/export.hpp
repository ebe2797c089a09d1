// SPDX-License-Identifier: MIT
// Files that other programs read: OBJ/MTL/weights.txt (thesis ch. 5), glTF 2.0, WebP, GIF, APNG, MP4, PNG
// frames.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pantin/animation.hpp"
#include "pantin/rigging.hpp"

namespace pantin {

// The mesh at rest as Wavefront OBJ, world units (animation.hpp), v of the texture up; `mtl_file`: its name
// in the OBJ. No error. Thesis ch. 5.
std::string to_obj(const Rig& rig, const std::string& mtl_file);
// One material with the picture of that name. No error. Thesis ch. 5.
std::string to_mtl(const std::string& texture_file);
// "# pantin weights 1" (docs/formats.md): four bones a vertex at most, weights in [0, 1] that sum to 1. No
// error. Thesis ch. 5.
std::string to_weights_text(const Rig& rig);
// glTF 2.0 binary in world units: one skinned mesh at the scene root, unlit textured material, one animation
// per clip. `texture`: RGBA, any size, v down; seconds. No error. Own, by the glTF 2.0 specification.
std::vector<unsigned char> to_glb(const Rig& rig, const RgbaImage& texture,
                                  const std::vector<BoneAnimation>& animations);

// Film formats by name: src/export/film_formats.hpp. All take one loop of frames of one size, at least one,
// at `fps` frames a second. The bytes do not depend on `threads`.

// WebP with transparency; times in whole milliseconds. `quality`: 0 to 100, colours lossy, alpha as it is;
// none: lossless. Error(usage) in a build without it; Error(internal) without frames. Own, over libwebp.
std::vector<unsigned char> encode_webp(const std::vector<RgbaImage>& frames, double fps,
                                       std::optional<int> quality = {}, int threads = 1);
// GIF with one palette of at most 255 colours, drawn where alpha is at least ½; delays are whole 1/100 s of
// at least 2. Errors as encode_webp(). Own, over giflib.
std::vector<unsigned char> encode_gif(const std::vector<RgbaImage>& frames, double fps, int threads = 1);
// APNG with transparency. Error(internal) without frames. Own, by the PNG specification (third edition).
std::vector<unsigned char> encode_apng(const std::vector<RgbaImage>& frames, double fps, int threads = 1);
// H.264 on white, the loop repeated until it lasts 3 s. Needs the program ffmpeg; Error(output) with its
// message; Error(internal) without frames. Own, over ffmpeg.
void write_mp4(const std::filesystem::path& file, const std::vector<RgbaImage>& frames, double fps);
// Whether this build, and for MP4 this machine (an ffmpeg is in the PATH), can write the format. No error.
// Own.
bool webp_available();
bool gif_available();
bool mp4_available();

} // namespace pantin
