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
struct CharacterStory {
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
Values silhouette_chapter(const CharacterStory& story);
Values segment_chapter(const CharacterStory& story);
Values contour_chapter(const CharacterStory& story);
Values voronoi_chapter(const CharacterStory& story);
Values thinning_chapter(const CharacterStory& story);
Values graph_chapter(const CharacterStory& story);
Values identify_chapter(const CharacterStory& story);
Values paths_chapter(const CharacterStory& story);
Values assignment_chapter(const CharacterStory& story);
Values mesh_chapter(const CharacterStory& story);
Values weights_chapter(const CharacterStory& story);
Values motion_chapter(const CharacterStory& story);
Values solid_chapter(const CharacterStory& story);

} // namespace pantin
