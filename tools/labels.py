# SPDX-License-Identifier: MIT
"""The label table of include/pantin/label.hpp for the scripts: NAMES and COLOURS (R, G, B), both by label."""
import pathlib
import re

_HEADER = pathlib.Path(__file__).resolve().parents[1] / "include/pantin/label.hpp"
_ROW = re.compile(r'\{Label::\w+, +"(\w+)", +PartRole::\w+, +\{ *(\d+), *(\d+), *(\d+)\}')
_ROWS = _ROW.findall(_HEADER.read_text(encoding="utf-8"))

NAMES = [name for name, *_ in _ROWS]
COLOURS = [tuple(map(int, colour)) for _, *colour in _ROWS]
assert NAMES[:1] == ["background"], f"{_HEADER}: no label table found"
