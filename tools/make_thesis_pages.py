#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Draws two of the pages on which `pantin verify` runs the preset `thesis`: tools/make_thesis_pages.py FOLDER writes
# FOLDER/{unpaired,crossed}/page.png. They show what tools/doodle does not draw: a figure with more ends than any reference has, and
# legs that cross. The head is off the middle, so that no vertex lies exactly where the reference has its node, which would leave
# it open whether the two are a pair. Standard library only; of the C library sqrt alone, so the pixels are the same everywhere.
import struct
import sys
import zlib
from math import sqrt
from pathlib import Path

SIZE = 150  # pixels, both sides
SIDE = 200  # of the page in the units of the figures
PEN = 2  # width of a line in pixels


def capsule(x0, y0, x1, y1, radius):
    """The points within `radius` of a segment: signed distance of (x, y), negative inside."""

    def distance(x, y):
        dx, dy = x1 - x0, y1 - y0
        t = ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy)
        t = min(1.0, max(0.0, t))
        ex, ey = x - x0 - t * dx, y - y0 - t * dy
        return sqrt(ex * ex + ey * ey) - radius

    return distance


def ellipse(cx, cy, rx, ry):
    """About the signed distance from an ellipse: exact in sign, first order near the line."""

    def distance(x, y):
        u, v = (x - cx) / rx, (y - cy) / ry
        gu, gv = u / rx, v / ry
        gradient = sqrt(gu * gu + gv * gv)
        return (u * u + v * v - 1) / (2 * gradient) if gradient > 0 else -min(rx, ry)

    return distance


def union(*shapes):
    return lambda x, y: min(shape(x, y) for shape in shapes)


def dot(x, y, radius):
    """A filled disc, as a shape whose inside is ink."""
    return ("ink", lambda px, py: sqrt((px - x) ** 2 + (py - y) ** 2) - radius)


def polyline(points, radius):
    return union(*(capsule(*a, *b, radius) for a, b in zip(points, points[1:])))


def face(x, y):
    return [dot(x - 7, y - 4, 2), dot(x + 7, y - 4, 2), ("line", capsule(x - 5, y + 9, x + 5, y + 9, 0))]


def unpaired():
    """Has four arms: more ends than any reference has."""
    ends = [(40, 62), (36, 124), (160, 62), (164, 124)]
    arms = [polyline([(100 + 0.25 * (x - 100), 94 + 0.25 * (y - 92)), (x, y)], 9) for x, y in ends]
    legs = [polyline([(88, 128), (78, 186)], 9), polyline([(112, 128), (122, 186)], 9)]
    return [*arms, *legs, ellipse(100, 98, 26, 40), ellipse(105, 34, 24, 24), *face(105, 34)]


def crossed():
    """Stands with crossed legs."""
    arms = [polyline([(86, 66), (34, 88)], 7), polyline([(114, 66), (166, 88)], 7)]
    legs = [polyline([(80, 96), (144, 188)], 7), polyline([(120, 96), (56, 188)], 7)]
    return [*arms, *legs, ellipse(100, 80, 30, 26), ellipse(97, 32, 22, 22), *face(97, 32)]


def darkness(shapes, x, y):
    """Of a pixel's centre, 0 to 1: later shapes lie before earlier ones."""
    ink = 0.0
    for shape in shapes:
        kind, distance = shape if isinstance(shape, tuple) else ("part", shape)
        d = distance(x, y) * SIZE / SIDE  # in pixels
        if kind == "ink":
            ink = max(ink, min(1.0, max(0.0, 0.5 - d)))
        elif kind == "line":
            ink = max(ink, min(1.0, max(0.0, PEN / 2 + 0.5 - d)))
        else:
            inside = min(1.0, max(0.0, 0.5 - d))
            ink = max(ink * (1 - inside), min(1.0, max(0.0, PEN / 2 + 0.5 - abs(d))))
    return ink


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def png(rows):
    """8-bit grey, each row of filter 0."""
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    pixels = b"".join(b"\0" + bytes(row) for row in rows)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(pixels, 9)) + chunk(b"IEND", b"")


def main():
    out = Path(sys.argv[1])
    for drawing in (unpaired, crossed):
        shapes = drawing()
        places = [(i + 0.5) * SIDE / SIZE for i in range(SIZE)]
        rows = [[int(255 * (1 - darkness(shapes, x, y)) + 0.5) for x in places] for y in places]
        folder = out / drawing.__name__
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "page.png").write_bytes(png(rows))


main()
