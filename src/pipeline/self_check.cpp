// SPDX-License-Identifier: MIT
// A rigged character and the settings to its warnings: which products the measures look at.
#include "pipeline/self_check.hpp"

namespace pantin {

std::vector<Warning> check_result(const Character& c, const std::vector<ClipFilm>& films, Context& context) {
    ResultToCheck result{c.drawing,
                         c.mask,
                         c.segmentation.labels,
                         c.identification,
                         context.references(),
                         c.reference,
                         c.rig,
                         {},
                         c.exact_mask,
                         !context.options().identification.reference.empty()};
    for (const ClipFilm& film : films) result.clips.push_back({film.filmed, film.view});
    return find_warnings(result);
}

} // namespace pantin
