// SPDX-License-Identifier: MIT
// What the steps hand to each other in memory, as JSON files of the reference vectors (docs/formats.md,
// "Reference vectors"). Every double survives the way there and back to the bit. Readers throw Error(input)
// that names `file`, the place and the fact.
#pragma once

#include <string>
#include <vector>

#include "pantin/animation.hpp"
#include "pantin/detection.hpp"
#include "pantin/model.hpp"
#include "pantin/rigging.hpp"
#include "pantin/segmentation.hpp"

namespace pantin {

std::string found_to_json(const std::vector<CharacterFinder::Found>& found); // the three of highest score
// Every value whose x and y are multiples of the step, and a digest of all.
std::string probabilities_to_json(const std::vector<Grid<float>>& probabilities, int step);

// A rig in three files: mesh.json (size, mesh, texture), bones.json, and weights.txt with depths.json.
std::string mesh_to_json(const Rig& rig);
std::string bones_to_json(const Rig& rig);
std::string depths_to_json(const Rig& rig);
Rig rig_from_files(const std::string& mesh, const std::string& bones, const std::string& weights,
                   const std::string& depths);

std::string animations_to_json(const std::vector<BoneAnimation>& animations);
std::vector<BoneAnimation> animations_from_json(const std::string& text, const std::string& file);
std::string places_to_json(const std::vector<Vec3>& vertices);
std::vector<Vec3> places_from_json(const std::string& text, const std::string& file);

std::string inflation_to_json(const Inflation& inflation);
std::string solid_to_json(const SolidMesh& mesh);
SolidMesh solid_from_json(const std::string& text, const std::string& file);
// The bones of a model.json, from joint to joint.
std::vector<BoneSegment> segments_from_json(const std::string& text, const std::string& file);

} // namespace pantin
