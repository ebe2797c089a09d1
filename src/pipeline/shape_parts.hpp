// SPDX-License-Identifier: MIT
// Whether the shapes of a flat drawing are the parts that the part network sees.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pantin/model.hpp"
#include "pantin/strokes.hpp"
#include "pipeline/drawing_look.hpp"

namespace pantin {

using Parts = std::vector<const PartStroke*>;
// In modelling order; they live as long as the strokes. No error.
Parts parts_of(const Strokes& strokes);
// The label that the part has or that its name tells; background when neither does. No error.
Label told(const PartStroke& part);

// Whether each part lies on an earlier one that is much larger, and has its label or none of its own. No
// error. Own.
std::vector<bool> decoration_of(const Parts& parts);
// What is said of such a part.
std::string decoration_line(const PartStroke& part);
// The strokes with a label for each: its own, or the one that most of what is seen of it has, in an order in
// which each meets an earlier one; small shapes on larger ones decorate these and are left out, with a line.
// Nothing when shapes do not part the drawing as the network does, or do not make one skeleton. No error.
// Own.
std::optional<Strokes> shapes_as_parts(const Strokes& strokes, const DrawingLook& look,
                                       const ModelOptions& options);
// Where a part that is told lies uppermost, it is what it is told to be. No error. Own.
void overrule(DrawingLook& look, const Parts& parts);

} // namespace pantin
