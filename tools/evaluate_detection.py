#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""How well `pantin detect` finds silhouettes, against drawings with truth.

usage: evaluate_detection.py PANTIN DRAWINGS_DIR... [--ids FILE] [--compose N] [--worst N] [--sheet SHEET.png]
PANTIN: the program. DRAWINGS_DIR: image/<id>.png (ink on white) and label/<id>.png (0 background), as written by
label_map_to_drawing.py and strokes_to_regions.py. --ids: only the ids listed in FILE, one a line (a fold).

Prints per folder: share of drawings found as exactly one character, IoU of the union of the masks with the truth's
silhouette (mean, median), the share of hollow ones (IoU < 0.6 and less filled than the truth) and of those that are
too large (IoU < 0.6 and more filled). --compose N makes N pages of 2 to 6 drawings of all folders with gaps of 5, 10
and 20 % of their size and prints how many characters are found apart (one mask with IoU > 0.5 each).
--sheet writes a contact sheet of the --worst (default 18): green both, blue only truth, red only detected.
"""
import argparse
import json
import os
import random
import subprocess
import tempfile

import cv2
import numpy as np


def detect(pantin, picture, shape):
    """-> index map of the page: 0, or number of the character."""
    found = np.zeros(shape, np.uint8)
    with tempfile.TemporaryDirectory() as out:
        done = subprocess.run([pantin, "detect", picture, "-o", out, "--quiet"], capture_output=True, text=True)
        if done.returncode == 4:
            return found
        if done.returncode != 0:
            raise SystemExit(f"{picture}: {done.stderr.strip()}")
        with open(os.path.join(out, "page.json")) as f:
            page = json.load(f)
        for number, character in enumerate(page["characters"], 1):
            x, y, width, height = character["box"]
            mask = cv2.imread(os.path.join(out, character["folder"], "mask.png"), 0)
            mask = cv2.resize(mask, (width, height), interpolation=cv2.INTER_NEAREST) > 0
            found[y:y + height, x:x + width][mask] = number
    return found


def load(folder, name):
    image = cv2.imread(os.path.join(folder, "image", name), 0)
    truth = cv2.imread(os.path.join(folder, "label", name), 0) > 0
    return image, truth


def overlay(image, truth, mask, caption):
    picture = cv2.cvtColor(image, cv2.COLOR_GRAY2BGR).astype(np.float32)
    for where, colour in ((truth & mask, (0, 200, 0)), (truth & ~mask, (255, 0, 0)), (mask & ~truth, (0, 0, 255))):
        picture[where] = 0.5 * picture[where] + 0.5 * np.array(colour)
    picture = cv2.resize(picture.astype(np.uint8), (321, 321), interpolation=cv2.INTER_AREA)
    cv2.putText(picture, caption, (4, 14), 0, 0.4, (0, 0, 0), 1)
    return picture


def evaluate_folder(pantin, folder, names, worst):
    rows = []
    for name in names:
        image, truth = load(folder, name)
        if not truth.any():
            continue
        found = detect(pantin, os.path.join(folder, "image", name), image.shape)
        mask = found > 0
        iou = (truth & mask).sum() / (truth | mask).sum()
        rows.append((iou, mask.sum() < truth.sum(), found.max(), name, mask))
    ious = np.array([row[0] for row in rows])
    hollow = np.mean([row[0] < 0.6 and row[1] for row in rows])
    large = np.mean([row[0] < 0.6 and not row[1] for row in rows])
    single = np.mean([row[2] == 1 for row in rows])
    print(f"{folder}: {len(rows)} drawings, one character {single:.3f}, IoU mean {ious.mean():.3f} median "
          f"{np.median(ious):.3f}, hollow {hollow:.3f}, too large {large:.3f}")
    rows.sort(key=lambda row: row[0])
    return [overlay(*load(folder, row[3]), row[4], f"{row[3][:-4]} {row[0]:.2f}") for row in rows[:worst]]


def cut(image, truth):
    ys, xs = np.where(image < 200)
    box = np.s_[ys.min():ys.max() + 1, xs.min():xs.max() + 1]
    return image[box], truth[box].astype(np.uint8)


def compose(drawings, gap, rng):
    """One or two rows of 2 or 3 drawings of like size -> page, index map of the truth."""
    placed, y = [], 20
    for _ in range(rng.choice([1, 1, 2])):
        x, height = 20, 0
        for _ in range(rng.choice([2, 3])):
            image, truth = cut(*load(*rng.choice(drawings)))
            size = rng.uniform(150, 230)
            image = cv2.resize(image, None, fx=size / max(image.shape), fy=size / max(image.shape),
                               interpolation=cv2.INTER_AREA)
            truth = cv2.resize(truth, image.shape[::-1], interpolation=cv2.INTER_NEAREST)
            placed.append((x, y, image, truth))
            x, height = x + image.shape[1] + int(gap * size), max(height, image.shape[0])
        y += height + int(max(gap, 0.1) * 200)
    page = np.full((max(p[1] + p[2].shape[0] for p in placed) + 20, max(p[0] + p[2].shape[1] for p in placed) + 20),
                   255, np.uint8)
    truth = np.zeros_like(page)
    for number, (x, y, image, own) in enumerate(placed, 1):
        part = np.s_[y:y + image.shape[0], x:x + image.shape[1]]
        page[part] = np.minimum(page[part], image)
        truth[part][own > 0] = number
    return page, truth


def evaluate_pages(pantin, drawings, count):
    rng = random.Random(1)
    for gap in (0.05, 0.1, 0.2):
        total = matched = right = 0
        for _ in range(count):
            page, truth = compose(drawings, gap, rng)
            with tempfile.TemporaryDirectory() as folder:
                picture = os.path.join(folder, "page.png")
                cv2.imwrite(picture, page)
                found = detect(pantin, picture, page.shape)
            hits = 0
            for number in range(1, truth.max() + 1):
                own = truth == number
                hits += any((own & (found == k)).sum() > 0.5 * (own | (found == k)).sum()
                            for k in range(1, found.max() + 1))
            total, matched = total + int(truth.max()), matched + hits
            right += hits == truth.max() == found.max()
        print(f"pages with gaps of {gap:.0%}: {matched} of {total} characters apart, {right} of {count} pages right")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pantin")
    parser.add_argument("folders", nargs="+")
    parser.add_argument("--ids")
    parser.add_argument("--compose", type=int, default=0)
    parser.add_argument("--worst", type=int, default=18)
    parser.add_argument("--sheet")
    options = parser.parse_args()
    wanted = set(open(options.ids).read().split()) if options.ids else None
    pictures, drawings = [], []
    for folder in options.folders:
        names = [n for n in sorted(os.listdir(os.path.join(folder, "image"))) if not wanted or n[:-4] in wanted]
        pictures += evaluate_folder(options.pantin, folder, names, options.worst)
        drawings += [(folder, name) for name in names]
    if options.sheet and pictures:
        pictures += [np.full_like(pictures[0], 255)] * (-len(pictures) % 6)
        cv2.imwrite(options.sheet, np.vstack([np.hstack(pictures[i:i + 6]) for i in range(0, len(pictures), 6)]))
    if options.compose:
        evaluate_pages(options.pantin, drawings, options.compose)


if __name__ == "__main__":
    main()
