// SPDX-License-Identifier: MIT
// Drawings whose names do not tell their parts: the part network looks at their picture.
#pragma once

#include <optional>
#include <string>

#include "pantin/model_view.hpp"
#include "pantin/strokes.hpp"
#include "pipeline/context.hpp"

namespace pantin {

// Strokes with labels, and what the model is coloured with.
struct LabelledStrokes {
    Strokes strokes;
    // The whole drawing with its labels, whose pixels are the strokes' canvas: the parts are cut out of it.
    std::optional<ModelPicture> picture;
    bool painted = false; // the strokes' own painting is to be seen on the model
};

// Whether names and labels leave open what parts a model has: fewer than two labels are told, or, of a
// drawing that is all seen from the front at one depth, one part's is not. A model that was made in space
// with names for its parts is left as its names say. No error. Own.
bool needs_a_look(const Strokes& strokes);

// A drawing all of whose parts have names, without those that lie on a larger part of the same label (eyes on
// a head): they would be hidden in its solid, so they are shown by the drawing on its surface. Nothing when
// there is none. No error. Own.
std::optional<LabelledStrokes> with_decoration(const Strokes& strokes);

// The labels that the part network sees; those that the strokes have, and known names, overrule it. Shapes
// that are parts keep their strokes; where they are not (one outline of a whole animal, a drawing of many
// patches) the silhouette is cut by its labels, as a scanned drawing's is. Lines about it in `repairs`.
// `name` stands in messages. Error(input) when there is nothing to be seen; errors of the network. Own; the
// network: thesis 4.3.
LabelledStrokes labelled_by_look(const Strokes& strokes, const std::string& name, Context& context);

} // namespace pantin
