// SPDX-License-Identifier: MIT
// The names of the files and folders that a run writes (docs/formats.md), each in this one place.
#pragma once

namespace pantin::file_names {

// A page's folder.
inline constexpr const char* page = "page.json";
inline constexpr const char* overview = "page.png";
inline constexpr const char* scene = "scene"; // and the ending of a film
inline constexpr const char* walkthrough = "index.html";

// A character's folder, in the order of the steps.
inline constexpr const char* drawing = "drawing.png";
inline constexpr const char* ink = "ink.png";
inline constexpr const char* mask = "mask.png";
inline constexpr const char* labels = "labels.png";
inline constexpr const char* segmentation = "segmentation.json";
inline constexpr const char* contour = "contour.json";
inline constexpr const char* skeleton_picture = "skeleton.png";
inline constexpr const char* skeleton = "skeleton.json";
inline constexpr const char* identification = "identification.json";
inline constexpr const char* mapping = "mapping.json";
inline constexpr const char* mesh = "mesh.obj";
inline constexpr const char* material = "mesh.mtl";
inline constexpr const char* weights = "weights.txt";
inline constexpr const char* glb = "character.glb";
inline constexpr const char* animation =
    "animation";                                // with -CLIP but for the first, and the ending of a film
inline constexpr const char* frames = "frames"; // folder: films as single pictures
inline constexpr const char* animated_drawings = "animated_drawings"; // folder

// Skeletons of all methods side by side.
inline constexpr const char* skeleton_comparison_picture = "skeletons.png";
inline constexpr const char* skeleton_comparison = "skeletons.json";

// A folder of AnimatedDrawings.
inline constexpr const char* texture = "texture.png";
inline constexpr const char* animated_drawings_config = "char_cfg.yaml";
inline constexpr const char* animated_drawings_config_short = "char_cfg.yml";

// A model's folder, besides drawing, mask, labels and skeleton.
inline constexpr const char* strokes = "strokes.json";
inline constexpr const char* model = "model.json";
inline constexpr const char* model_mesh = "model.obj";
inline constexpr const char* model_material = "model.mtl";
inline constexpr const char* model_glb = "model.glb";
inline constexpr const char* model_views = "views.png";

// Intermediate products (--trace), in a folder of either.
inline constexpr const char* trace = "trace"; // folder
inline constexpr const char* trace_ink = "ink.png";
inline constexpr const char* trace_ink_mask = "mask-ink.png";
inline constexpr const char* trace_network_mask = "mask-network.png";
inline constexpr const char* trace_probability = "probability-"; // and LABEL.png
inline constexpr const char* trace_silhouette = "silhouette.png";
inline constexpr const char* trace_voronoi = "voronoi.json";
inline constexpr const char* trace_voronoi_picture = "voronoi.png";
inline constexpr const char* trace_thinned = "thinned.png";
inline constexpr const char* trace_skeleton_raw = "skeleton-raw.json";
inline constexpr const char* trace_skeleton_h1 = "skeleton-h1.json";

} // namespace pantin::file_names
