// SPDX-License-Identifier: MIT
// Between drawings and models in space: part labels become strokes, a model becomes a picture, part labels
// and a skeleton in the plane, which identification and mapping take as they take a drawing's; the rig that
// they find moves the model.
#pragma once

#include "pantin/grid.hpp"
#include "pantin/model.hpp"
#include "pantin/rigging.hpp"
#include "pantin/skeletonization.hpp"

namespace pantin {

// The parts of a label map as strokes in modelling order: body, head, limbs, tail, wings, each label's pieces
// from left to right. A piece reaches into the parts that come before it, where it touches them, by the
// silhouette's half width there, so that solids overlap. The canvas is the label map's, pixels. Error(input)
// when there is no part. Own.
Strokes strokes_from_labels(const LabelMap& labels);

// A parallel projection into a picture; pixel centres at integer coordinates, y down. Sheared so that far
// limbs do not hide behind near ones (a cabinet projection): a model's point (x, y, z) is seen where (x +
// shear.x · z, y + shear.y · z) is.
struct ModelView {
    int width = 0, height = 0;
    double scale = 1; // pixels per canvas unit
    Point2d offset;   // pixel of the model's origin
    Point2d shear;
    bool operator==(const ModelView&) const = default;
};
// The model with a margin; longer side `size` pixels. Without shear when all parts are drawn from the front
// at no depth. mesh: united(). No error. Own.
ModelView view_of(const Model& model, const SolidMesh& mesh, int size = 400);
// The pixel in which a point of the model, canvas units, is seen. No error. Own.
Point2d project(const ModelView& view, Vec3 p);

struct ModelPicture {
    RgbImage drawing; // flat colours on white, twice the size of the labels
    LabelMap labels;
};
// The model as a drawing, near parts in front. Error(input) when a part has no area. Own.
ModelPicture draw(Model& model, const ModelView& view);
// The part (an index of parts()) that is seen at each pixel of the view, −1 where there is none. Error(input)
// when a part has no area. Own.
Grid<int> seen_parts(Model& model, const ModelView& view);
// The model's skeleton as a graph in the view's pixels: ends and junctions with the chains between them.
// Trees that are not connected are joined where they are nearest. No error. Own.
SkeletonGraph project_skeleton(const Model& model, const ModelView& view);

// The part's own label, or else that of its name. No error. Own.
Label label_of(const ModelPart& part);
// The part's own colour, or else `solid` of its label's row (label.hpp). No error. Own.
Rgb8 colour_of(const ModelPart& part);
// The colour of each triangle of a united mesh: of its part. No error. Own.
std::vector<Rgb8> part_colours(const Model& model, const SolidMesh& mesh);

// The model with its own bones: one for each joint but the roots, from its parent to it, named after its
// part; skin weights by bone_heat(). Mesh and bones in pixels of the view, depths in world units. A vertex
// where parts meet is there once for each of them. `colours`: per triangle; none: the picture is projected
// on. No error. RealSkel 4.1, weights (errata 30).
Rig model_rig(const Model& model, const SolidMesh& mesh, const ModelView& view,
              const std::vector<Rgb8>& colours = {});
// The rig of the picture in space: the bones of `flat` (of the view's picture), each where the model's
// skeleton runs, on the model's surface. Units as model_rig(). No error. Own.
Rig lifted(const Rig& flat, const Model& model, const SolidMesh& mesh, const ModelView& view,
           const std::vector<Rgb8>& colours = {});

} // namespace pantin
