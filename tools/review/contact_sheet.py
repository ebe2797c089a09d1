#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Contact sheet of whole runs: one row for each character of the given pictures.

usage: contact_sheet.py --pantin BINARY --out SHEET.png [--frames N] [--cell PX] [--preset NAME] IMAGE...

A row: drawing with the detected silhouette | part labels | skeleton graph | mesh with bones' weights | N frames of
the first clip, evenly spaced. The title says reference, confidence and status. Needs numpy and OpenCV.
"""
import argparse
import glob
import json
import os
import subprocess
import sys
import tempfile

import cv2
import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import labels as part_labels  # noqa: E402

COLOURS = np.array([(255, 255, 255)] + part_labels.COLOURS[1:], np.uint8)
NAMES = part_labels.NAMES


def fit(image, cell):
    """image (h, w, 3) -> cell×cell on white, aspect kept."""
    h, w = image.shape[:2]
    s = cell / max(h, w)
    image = cv2.resize(image, (max(1, round(w * s)), max(1, round(h * s))), interpolation=cv2.INTER_AREA)
    out = np.full((cell, cell, 3), 255, np.uint8)
    y, x = (cell - image.shape[0]) // 2, (cell - image.shape[1]) // 2
    out[y:y + image.shape[0], x:x + image.shape[1]] = image
    return out


def read(path):
    image = cv2.imread(path, cv2.IMREAD_COLOR)
    return image[:, :, ::-1] if image is not None else np.full((16, 16, 3), 255, np.uint8)


def silhouette_view(folder):
    drawing = read(f"{folder}/drawing.png").astype(float)
    mask = cv2.imread(f"{folder}/mask.png", cv2.IMREAD_GRAYSCALE)
    if mask is None:
        return drawing.astype(np.uint8)
    mask = cv2.resize(mask, (drawing.shape[1], drawing.shape[0]), interpolation=cv2.INTER_NEAREST) > 0
    drawing[mask] = drawing[mask] * 0.65 + np.array([120, 200, 255]) * 0.35
    return drawing.astype(np.uint8)


def label_view(folder):
    labels = cv2.imread(f"{folder}/labels.png", cv2.IMREAD_GRAYSCALE)
    return COLOURS[np.minimum(labels, len(NAMES) - 1)] if labels is not None else np.full((16, 16, 3), 255, np.uint8)


def skeleton_view(folder):
    view = (label_view(folder).astype(float) * 0.3 + 178).astype(np.uint8).copy()
    if not os.path.exists(f"{folder}/skeleton.json"):
        return view
    graph = json.load(open(f"{folder}/skeleton.json"))
    for edge in graph["edges"]:
        cv2.polylines(view, [np.array(edge["pixels"], np.int32)], False, (60, 60, 60), 2)
    for v in graph["vertices"]:
        colour = [int(c) for c in COLOURS[NAMES.index(v["label"]) if isinstance(v["label"], str) else v["label"]]]
        centre = (round(v["x"]), round(v["y"]))
        cv2.circle(view, centre, 7, colour, -1)
        cv2.circle(view, centre, 7, (0, 0, 0), 1 if v["kind"] == "junction" else 2)
    return view


def weights_view(folder):
    """mesh edges coloured by the heaviest bone of each vertex."""
    if not (os.path.exists(f"{folder}/mesh.obj") and os.path.exists(f"{folder}/weights.txt")):
        return np.full((16, 16, 3), 255, np.uint8)
    points, faces, bone = [], [], {}
    for line in open(f"{folder}/mesh.obj"):
        part = line.split()
        if part[:1] == ["vt"]:
            points.append([float(part[1]), float(part[2])])
        elif part[:1] == ["f"]:
            faces.append([int(p.split("/")[0]) - 1 for p in part[1:]])
    for line in open(f"{folder}/weights.txt"):
        part = line.split()
        if part[:1] == ["v"]:
            pairs = [(float(w), int(b)) for b, w in zip(part[2::2], part[3::2])]
            bone[int(part[1]) - 1] = max(pairs)[1]
    drawing = read(f"{folder}/drawing.png")
    h, w = drawing.shape[:2]
    size = (512, max(1, round(512 * h / w))) if w >= h else (max(1, round(512 * w / h)), 512)
    view = np.full((size[1], size[0], 3), 255, np.uint8)
    palette = [tuple(int(c) for c in cv2.cvtColor(np.uint8([[[(k * 47) % 180, 200, 220]]]), cv2.COLOR_HSV2RGB)[0, 0]) for k in range(64)]
    xy = np.array([[p[0] * size[0], (1 - p[1]) * size[1]] for p in points]) if points else np.zeros((0, 2))
    for face in faces:
        colour = palette[bone.get(face[0], 0) % 64]
        cv2.fillPoly(view, [np.round(xy[face]).astype(np.int32)], colour)
        cv2.polylines(view, [np.round(xy[face]).astype(np.int32)], True, (90, 90, 90), 1)
    return view


def rows(pantin, image, frames, cell, preset, work):
    out = os.path.join(work, os.path.splitext(os.path.basename(image))[0])
    run = subprocess.run([pantin, "animate", image, "-o", out, "--preset", preset, "--format", "png", "--size", "256", "--fps", "12", "--quiet"],
                         capture_output=True, text=True)
    title = os.path.basename(image)
    if not os.path.exists(f"{out}/page.json"):
        return [(f"{title}: exit {run.returncode} {run.stderr.strip()}", [fit(read(image), cell)])]
    result = []
    for character in json.load(open(f"{out}/page.json"))["characters"]:
        folder = os.path.join(out, character["folder"])
        views = [silhouette_view(folder), label_view(folder), skeleton_view(folder), weights_view(folder)]
        text = f"{title} {character['status']}"
        if os.path.exists(f"{folder}/identification.json"):
            found = json.load(open(f"{folder}/identification.json"))
            text += f"  {found['reference']} {found['confidence']:.2f}"
        pngs = sorted(glob.glob(f"{folder}/frames/*/*.png"))
        first = [p for p in pngs if os.path.basename(os.path.dirname(p)) != "idle"]  # the reference's clip of motion
        for k in range(min(frames, len(first))):
            rgba = cv2.imread(first[k * len(first) // frames], cv2.IMREAD_UNCHANGED).astype(float)
            alpha = rgba[:, :, 3:] / 255
            views.append((rgba[:, :, 2::-1] * alpha + np.array([225, 235, 245]) * (1 - alpha)).astype(np.uint8))
        result.append((text, [fit(v, cell) for v in views]))
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("images", nargs="+")
    parser.add_argument("--pantin", required=True)
    parser.add_argument("--out", required=True)
    parser.add_argument("--frames", type=int, default=6)
    parser.add_argument("--cell", type=int, default=200)
    parser.add_argument("--preset", default="default")
    parser.add_argument("--keep", help="folder for the runs' output (default: temporary)")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        work = args.keep or temporary
        table = [row for image in args.images
                 for row in rows(os.path.abspath(args.pantin), image, args.frames, args.cell, args.preset, work)]
    columns = max(len(views) for _, views in table)
    strips = []
    for text, views in table:
        strip = np.full((args.cell + 18, columns * args.cell, 3), 255, np.uint8)
        cv2.putText(strip, text[:150], (4, 13), cv2.FONT_HERSHEY_SIMPLEX, 0.42, (0, 0, 0), 1, cv2.LINE_AA)
        for k, view in enumerate(views):
            strip[18:, k * args.cell:(k + 1) * args.cell] = view
        strips.append(strip)
    cv2.imwrite(args.out, np.concatenate(strips, 0)[:, :, ::-1])
    print(len(table), "characters")


if __name__ == "__main__":
    main()
