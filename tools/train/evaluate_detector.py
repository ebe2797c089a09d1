#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""AP50 and AP75 of the compact detector's masks on pages with truth, in PyTorch: of weights in floats and in integers side by side.

usage: evaluate_detector.py PAGES WEIGHTS.safetensors ...       (PAGES: written by pages.py)
The network alone, from every score that it gives; what the program makes of it measures `pantin evaluate --detector mask-rcnn`.
"""
import argparse
import json

import cv2
import numpy as np
import torch

import export
import integer_networks
import tone
import train_detector


def network_of(path):
    tensors, facts = export.read_safetensors(path)
    if facts.get("arithmetic") == "integer":
        return integer_networks.mask_rcnn(integer_networks.Emulated(tensors), tensors, facts)
    model, _ = train_detector.new_model()
    train_detector.start_from(model, path)
    return model.eval()


def pages_of(folder):
    """ink (h, w) in [0, 1] and masks (n, h, w)"""
    for line in open(f"{folder}/index.ndjson"):
        name = json.loads(line)["id"]
        numbers = cv2.imread(f"{folder}/instance/{name}.png", cv2.IMREAD_GRAYSCALE)
        ink = tone.ink_darkness(cv2.imread(f"{folder}/image/{name}.png", cv2.IMREAD_GRAYSCALE))
        yield ink, numbers[None] == np.arange(1, numbers.max() + 1)[:, None, None]


@torch.no_grad()
def overlaps(model, ink, truth):
    """scores of the detections, and the IoU of each with every true mask."""
    answer = model([torch.from_numpy(ink)[None]])[0]
    masks = (answer["masks"][:, 0] > 0.5).flatten(1).float()
    wanted = torch.from_numpy(truth).flatten(1).float()
    both = masks @ wanted.T
    return answer["scores"].numpy(), (both / (masks.sum(1)[:, None] + wanted.sum(1)[None] - both).clamp(min=1)).numpy()


def average_precision(seen, threshold):
    """seen: (scores, IoU) of each page. The best detections choose first; each true mask once (Everingham et al. 2010, every recall)."""
    marks, total = [], sum(iou.shape[1] for _, iou in seen)
    for scores, iou in seen:
        free = np.ones(iou.shape[1], bool)
        for k in np.argsort(-scores, kind="stable"):
            candidates = np.where(free, iou[k], 0) if free.size else np.zeros(1)
            hit = candidates.max() >= threshold
            if hit:
                free[candidates.argmax()] = False
            marks.append((scores[k], hit))
    hits = np.array([hit for _, hit in sorted(marks, key=lambda mark: -mark[0])])
    precision = np.cumsum(hits) / np.arange(1, len(hits) + 1)
    best = np.maximum.accumulate(precision[::-1])[::-1]                      # precision at this recall or a larger one
    return best[hits].sum() / total


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pages")
    parser.add_argument("weights", nargs="+")
    args = parser.parse_args()
    torch.set_num_threads(1)
    for path in args.weights:
        model = network_of(path)
        seen = [overlaps(model, ink, truth) for ink, truth in pages_of(args.pages)]
        figures = sum(iou.shape[1] for _, iou in seen)
        print(f"{path}: {len(seen)} pages, {figures} characters, AP50 {average_precision(seen, 0.5):.4f}, AP75 {average_precision(seen, 0.75):.4f}",
              flush=True)


if __name__ == "__main__":
    main()
