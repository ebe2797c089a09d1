#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""README's picture: the five steps on one drawing, from a character folder with PNG frames.

usage: steps_picture.py CHARACTER_DIR OUT.png [--cell PX] [--frame K]
Make the folder with: pantin animate PAGE -o DIR --format png --clip all. Needs numpy and OpenCV.
"""
import argparse
import glob
import os

import cv2
import numpy as np

from contact_sheet import fit, label_view, silhouette_view, skeleton_view, weights_view

CAPTIONS = ["detect", "segment", "skeletonize, identify", "rig", "animate"]


def frame_view(folder, number):
    paths = sorted(glob.glob(f"{folder}/frames/*/*.png"))
    walk = [p for p in paths if "idle" not in p] or paths
    rgba = cv2.imread(walk[number % len(walk)], cv2.IMREAD_UNCHANGED).astype(float)
    alpha = rgba[:, :, 3:] / 255
    return (rgba[:, :, 2::-1] * alpha + 255 * (1 - alpha)).astype(np.uint8)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("out")
    parser.add_argument("--cell", type=int, default=240)
    parser.add_argument("--frame", type=int, default=5)
    args = parser.parse_args()
    views = [silhouette_view(args.folder), label_view(args.folder), skeleton_view(args.folder), weights_view(args.folder),
             frame_view(args.folder, args.frame)]
    picture = np.full((args.cell + 30, len(views) * (args.cell + 10), 3), 255, np.uint8)
    for k, (view, caption) in enumerate(zip(views, CAPTIONS)):
        x = k * (args.cell + 10) + 5
        picture[:args.cell, x:x + args.cell] = fit(view, args.cell)
        cv2.putText(picture, caption, (x + 4, args.cell + 20), cv2.FONT_HERSHEY_SIMPLEX, 0.5, (40, 40, 40), 1, cv2.LINE_AA)
    os.makedirs(os.path.dirname(args.out) or ".", exist_ok=True)
    cv2.imwrite(args.out, picture[:, :, ::-1])


if __name__ == "__main__":
    main()
