// SPDX-License-Identifier: MIT
// Results of a former run, which the next one replaces.
#pragma once

#include <filesystem>

namespace pantin {

// Removes from a page's folder what a run wrote: the characters that its page.json lists, scene, frames and
// intermediate products, and the beginnings of files that a killed run left. Files that are not ours stay,
// and their folder with them; a page.json that is not ours lists nothing.
void remove_former_run(const std::filesystem::path& out);

} // namespace pantin
