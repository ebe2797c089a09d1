// SPDX-License-Identifier: MIT
// The steps on one character: each takes what it needs from the character, keeps what it makes and writes it.
// CharacterRejected says why a character cannot go on; nothing of that step is written then.
#pragma once

#include "pipeline/character.hpp"

namespace pantin {

void run_segment(Character& character, Workshop& workshop);
void run_skeletonize(Character& character, Workshop& workshop);
void run_identify(Character& character, Workshop& workshop);
void run_rig(Character& character, Workshop& workshop);
void run_render(Character& character, Workshop& workshop);

} // namespace pantin
