# SPDX-License-Identifier: MIT
"""The training recipe of chapter 5 of Korpitsch 2023 (`--recipe thesis`): optimiser, rates, number of steps, pages and drawings. What is
not printed is read as docs/errata.md says, 37 to 40."""
import cv2
import numpy as np
import torch

import pages

MOMENTUM = 0.9                # of both networks
DETECTOR_RATE = 0.005
WEIGHT_DECAY = 0.0005         # of the detector
GAMMA = 0.1
DECAY_EPOCHS = 3
EPOCHS = 2000
PAGES = 200                   # of one epoch: not printed (ERRATA 38)
PAGE_BATCH = 2                # not printed: the tutorial's
PAGE_WIDTH = 640              # "the size of the input images"
PAGE_HEIGHT = 480
DRAWINGS = (2, 6)             # on a page: not printed
SIZES = (0.45, 0.9)           # of a drawing on a page, shares of SIDE: not printed
SIDE = 321                    # of a drawing, and the input of the segmenter
SEGMENTER_RATE = 0.005
POWER = 0.9
ITERATIONS = 20000            # the text's epochs are iterations of one drawing (ERRATA 39)
CLASSIFIER_FACTOR = 10        # on the rate: the public code's
POSE_FACTOR = 50
TURNS = (-30, -20, -10, 0, 10, 20, 30)      # degrees, each also mirrored (ERRATA 40)
CLEAR = 4                     # pixels between the boxes of two drawings


def detector_rate(step, rate=DETECTOR_RATE, steps_of_epoch=PAGES // PAGE_BATCH, decay_epochs=DECAY_EPOCHS):
    return rate * GAMMA ** (step // steps_of_epoch // decay_epochs)


def segmenter_rate(step, rate=SEGMENTER_RATE, iterations=ITERATIONS):
    return rate * (1 - step / iterations) ** POWER


class Descent:
    """stochastic gradient descent for `steps` steps; what loop.train asks of a recipe. rate_of(step) -> the rate; factor_of(name of a
    parameter) -> what it is multiplied by for this parameter."""

    def __init__(self, rate_of, steps, weight_decay=0.0, factor_of=lambda name: 1):
        self.rate_of, self.steps, self.weight_decay, self.factor_of = rate_of, steps, weight_decay, factor_of
        self.clip = self.decay = None                            # neither gradients cut off nor weights averaged

    def optimiser(self, model):
        groups = {}
        for name, parameter in model.named_parameters():
            if parameter.requires_grad:
                groups.setdefault(self.factor_of(name), []).append(parameter)
        return torch.optim.SGD([{"params": members, "factor": factor} for factor, members in sorted(groups.items())],
                               lr=self.rate_of(0), momentum=MOMENTUM, weight_decay=self.weight_decay)

    def rate(self, step, progress):
        return self.rate_of(step)

    def over(self, step, progress):
        return step >= self.steps or progress >= 1


def segmenter_factor(name):
    """of a parameter of SketchParse or of the compact network: the last layers learn faster."""
    if name.startswith("pose"):
        return POSE_FACTOR
    return CLASSIFIER_FACTOR if ".layer5_r" in name or ".logits." in name else 1


def page(shards, rng):
    """drawings of the data set on one sheet (4.2, Fig. 4.6): ink (480, 640) float32 in [0, 1] and masks (n, 480, 640) bool, one label a
    drawing (Fig. 4.5). Each is turned by any angle and put where its box meets no other; one that finds no place is left out."""
    ink, masks, boxes = np.zeros((PAGE_HEIGHT, PAGE_WIDTH), np.uint8), [], []
    for _ in range(int(rng.integers(DRAWINGS[0], DRAWINGS[1] + 1))):
        size, angle = SIDE * rng.uniform(*SIZES), rng.uniform(0, 360)
        drawing = pages.turned(*pages.character(shards, rng), size, angle, rng, mirror=False)
        if drawing is None:
            continue
        h, w = drawing[0].shape
        for _ in range(50 if h < PAGE_HEIGHT and w < PAGE_WIDTH else 0):
            x, y = int(rng.integers(0, PAGE_WIDTH - w)), int(rng.integers(0, PAGE_HEIGHT - h))
            if all(x >= a + c + CLEAR or a >= x + w + CLEAR or y >= b + d + CLEAR or b >= y + h + CLEAR for a, b, c, d in boxes):
                ink[y:y + h, x:x + w] = drawing[0]
                whole = np.zeros(ink.shape, bool)
                whole[y:y + h, x:x + w] = drawing[1]
                masks.append(whole)
                boxes.append((x, y, w, h))
                break
    return ink.astype(np.float32) / 255, np.array(masks, bool).reshape(-1, *ink.shape)


def drawing(ink, labels, pose, rng, side, poses, unknown):
    """one of the fourteen versions of a drawing: ink (side, side) float32 in [0, 1], labels (side, side) uint8, pose. It becomes smaller
    where the turned one would leave the square."""
    angle, mirror = TURNS[rng.integers(len(TURNS))], rng.random() < 0.5
    ys, xs = np.nonzero(labels)
    middle = np.array([xs.min() + xs.max(), ys.min() + ys.max()]) / 2
    radians = np.radians(angle)
    forward = np.array([[np.cos(radians), np.sin(radians)], [-np.sin(radians), np.cos(radians)]]) @ np.diag([-1 if mirror else 1, 1])
    reach = np.abs((np.stack([xs, ys], 1) - middle) @ forward.T).max()
    forward = forward * min(side / ink.shape[0], 0.49 * side / max(reach, 1))
    matrix = np.c_[forward, side / 2 - forward @ middle].astype(np.float32)
    ink = cv2.warpAffine(ink, matrix, (side, side), flags=cv2.INTER_LINEAR).astype(np.float32) / 255
    labels = cv2.warpAffine(labels, matrix, (side, side), flags=cv2.INTER_NEAREST)
    if mirror and pose != unknown:
        pose = poses.index(poses[pose].translate(str.maketrans("EW", "WE")))
    return ink, labels, pose
