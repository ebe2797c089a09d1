// SPDX-License-Identifier: MIT
// The chapters of the page, one for each thing that a step makes. Each says with what its template
// (assets/chapters/<name>.html) is filled.
#pragma once

#include <string>

#include "core/reference_scale.hpp"
#include "explain/markup.hpp"
#include "pipeline/animated_page.hpp"

namespace pantin {

// A character as far as it came, with its intermediate products.
struct ChapterInput {
    std::string id;             // of its elements on the page: the name of its folder
    const PageCharacter& entry; // of page.json
    const Character& character;
    Context& context;

    int width() const { return character.mask.width(); } // working size
    int height() const { return character.mask.height(); }
    double line() const { return reference_scale(width(), height()); } // width of a thin line
    std::string drawing() const { return id + "-drawing"; }
    std::string element(const std::string& name) const { return id + "-" + name; }
};

// Of the page.
Values page_chapter(const AnimatedPage& animated);

// Of a character. Those of a step that was not reached are not asked for.
Values silhouette_chapter(const ChapterInput& input);
Values segment_chapter(const ChapterInput& input);
Values contour_chapter(const ChapterInput& input);
Values voronoi_chapter(const ChapterInput& input);
Values thinning_chapter(const ChapterInput& input);
Values graph_chapter(const ChapterInput& input);
Values identify_chapter(const ChapterInput& input);
Values paths_chapter(const ChapterInput& input);
Values assignment_chapter(const ChapterInput& input);
Values mesh_chapter(const ChapterInput& input);
Values weights_chapter(const ChapterInput& input);
Values motion_chapter(const ChapterInput& input);
Values solid_chapter(const ChapterInput& input);

} // namespace pantin
