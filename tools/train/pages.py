#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Pages of several characters for the detector, composed from the shards of dataset.py: random place, size and rotation, never overlapping,
with stray marks, ruled lines and the look of a photograph at times.

usage: pages.py DATA OUT [--count 200] [--clean | --things SHARDS] [--more] [--erase 0.0] [--seed 1]
writes a dataset for `pantin evaluate` from the held-out drawings (fold 0; --more: those of more-labelled.ndjson alone, else without them), at 1.7 times the training size. --clean: one character, upright,
on white paper. --things: pages of scenes.py, with the things of these shards around the characters.
"""
import argparse
import json
import os

import cv2
import numpy as np

import dataset
import render

LONGER = 384


def character(shards, rng):
    """ink (h, w) uint8 and mask (h, w) bool of one drawing, cut to its box."""
    ink, labels, *_ = shards.draw(rng)
    return cut(ink, labels > 0)


def cut(ink, mask):
    ys, xs = np.nonzero(cv2.dilate(mask.astype(np.uint8), np.ones((9, 9), np.uint8)))
    box = np.s_[ys.min():ys.max() + 1, xs.min():xs.max() + 1]
    return np.asarray(ink[box]), mask[box]


def random_angle(rng):
    """mostly upright, sometimes by quarters or at any angle."""
    choice = rng.random()
    return rng.normal(0, 8) if choice < 0.6 else rng.uniform(-30, 30) if choice < 0.8 else 90 * int(rng.integers(1, 4)) if choice < 0.93 \
        else rng.uniform(0, 360)


def turned(ink, mask, side, angle, rng, mirror=True):
    """the drawing at another size (longer side `side`), turned, and mirrored at times."""
    h, w = mask.shape
    scale = side / max(h, w)
    matrix = cv2.getRotationMatrix2D((w / 2, h / 2), angle, scale)
    if mirror and rng.random() < 0.5:
        matrix = matrix @ np.array([[-1, 0, w - 1], [0, 1, 0], [0, 0, 1]], float)
    size = int(np.ceil(np.hypot(h, w) * scale)) + 4
    matrix[:, 2] += size / 2 - np.array([w, h]) / 2
    if scale < 0.6:                                               # thin lines survive: blurred before they shrink
        ink = cv2.GaussianBlur(ink, (0, 0), 0.35 / scale)
    ink = cv2.warpAffine(ink, matrix, (size, size), flags=cv2.INTER_LINEAR)
    mask = cv2.warpAffine(mask.astype(np.uint8), matrix, (size, size), flags=cv2.INTER_NEAREST) > 0
    ys, xs = np.nonzero(mask | (ink > 40))
    if len(ys) < 20:
        return None
    box = np.s_[ys.min():ys.max() + 1, xs.min():xs.max() + 1]
    return ink[box], mask[box]


def fitting(ink, mask, side, angle, w, h, rng):
    """turned, and smaller until it fits a page of w x h."""
    while side > 8:
        drawing = turned(ink, mask, side, angle, rng)
        if drawing is None or (drawing[1].shape[0] < h and drawing[1].shape[1] < w):
            return drawing
        side *= 0.9
    return None


def stray_marks(page, free, rng):
    """marks that are no character: dashes, scribbles, ruled lines; only where no character is."""
    h, w = page.shape
    layer = np.zeros_like(page)
    for _ in range(int(rng.integers(0, 5))):
        x, y, r = rng.uniform(0, w), rng.uniform(0, h), rng.uniform(2, 14)
        points = np.cumsum(rng.normal(0, r / 3, (int(rng.integers(2, 12)), 2)), 0) + (x, y)
        cv2.polylines(layer, [np.round(points * 16).astype(np.int32)], False, int(rng.integers(90, 256)), 1, cv2.LINE_AA, 4)
    layer[~free] = 0
    if rng.random() < 0.06:
        step, level = int(rng.integers(9, 24)), int(rng.integers(15, 90))
        for y in range(int(rng.integers(0, step)), h, step):
            cv2.line(layer, (0, y), (w, y), level, 1)
    return np.maximum(page, layer)


def compose(shards, rng, longer=LONGER, clean=False):
    """ink (h, w) float32 in [0, 1] and masks (n, h, w) bool."""
    shorter = int(longer * rng.uniform(0.6, 1.0))
    w, h = (longer, shorter) if rng.random() < 0.7 else (shorter, longer)
    page, taken, masks = np.zeros((h, w), np.uint8), np.zeros((h, w), np.uint8), []
    count = int(rng.choice([0, 1, 2, 3, 4, 5, 6], p=[0.02, 0.26, 0.22, 0.2, 0.15, 0.1, 0.05]))
    if clean:
        count = 1
    for _ in range(count):
        largest = 1.5 if count == 1 else 0.9 if count == 2 else 0.55       # alone it may fill the page
        drawing = fitting(*character(shards, rng), min(w, h) * rng.uniform(0.22, largest), 0 if clean else random_angle(rng), w, h, rng)
        if drawing is None:
            continue
        ink, mask = drawing
        a, b = mask.shape
        near = cv2.dilate(np.pad((mask | (ink > 40)).astype(np.uint8), 4), np.ones((3, 3), np.uint8), iterations=int(rng.integers(1, 4)))
        for _ in range(25):
            y, x = int(rng.integers(0, h - a)), int(rng.integers(0, w - b))
            y0, x0 = max(0, y - 4), max(0, x - 4)
            window = taken[y0:y + a + 4, x0:x + b + 4]
            part = near[y0 - (y - 4):, x0 - (x - 4):][:window.shape[0], :window.shape[1]]
            if (window & part).any():
                continue
            page[y:y + a, x:x + b] = np.maximum(page[y:y + a, x:x + b], ink)
            taken[y:y + a, x:x + b] |= (mask | (ink > 40)).astype(np.uint8)
            whole = np.zeros((h, w), bool)
            whole[y:y + a, x:x + b] = mask
            masks.append(whole)
            break
    masks = np.array(masks, bool).reshape(-1, h, w)
    if clean:
        return page.astype(np.float32) / 255, masks
    page = stray_marks(page, cv2.dilate(taken, np.ones((9, 9), np.uint8)) == 0, rng)
    return dataset.as_photographed(page, rng), masks


class HeldOut:
    """the drawings of fold 0, drawn as by the shared scripts."""

    def __init__(self, data, erase, more):
        import evaluate
        self.drawings = [d for d in evaluate.held_out_drawings(data, 0, erase)
                         if np.isin(d.truth, (3, 5)).any() and d.group.startswith("more") == more]

    def draw(self, rng):
        d = self.drawings[int(rng.integers(len(self.drawings)))]
        return 255 - d.image, d.truth


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data")
    parser.add_argument("out")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--clean", action="store_true")
    parser.add_argument("--things")
    parser.add_argument("--more", action="store_true")
    parser.add_argument("--erase", type=float, default=0.0)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    rng, drawings = np.random.default_rng(args.seed), HeldOut(args.data, args.erase, args.more)
    if args.things:
        import scenes
        things = scenes.Things(args.things)
    for part in ("image", "label", "instance"):
        os.makedirs(f"{args.out}/{part}", exist_ok=True)
    with open(f"{args.out}/index.ndjson", "w") as index:
        number = 0
        while number < args.count:
            longer = int(1.7 * LONGER)
            ink, masks = scenes.compose(drawings, things, rng, longer) if args.things else compose(drawings, rng, longer, args.clean)
            if len(masks) == 0:
                continue
            name = f"{number:03d}"
            instances = sum(((k + 1) * m.astype(np.uint8) for k, m in enumerate(masks)), np.zeros(ink.shape, np.uint8))
            cv2.imwrite(f"{args.out}/image/{name}.png", (255 * (1 - ink) + 0.5).astype(np.uint8))
            cv2.imwrite(f"{args.out}/label/{name}.png", (2 * (instances > 0)).astype(np.uint8))
            cv2.imwrite(f"{args.out}/instance/{name}.png", instances)
            index.write(json.dumps({"id": name, "characters": [{} for _ in masks]}) + "\n")
            number += 1


if __name__ == "__main__":
    main()
