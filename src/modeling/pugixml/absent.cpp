// SPDX-License-Identifier: MIT
// Built without pugixml (`make PUGIXML=0`): strokes are read from JSON alone.
#include "pantin/error.hpp"
#include "pantin/strokes.hpp"

namespace pantin {

bool svg_available() { return false; }

Strokes strokes_from_svg(const std::string&, const std::string& file) {
    throw Error(ErrorKind::usage, file + ": this program was built without pugixml: SVG cannot be read");
}

} // namespace pantin
