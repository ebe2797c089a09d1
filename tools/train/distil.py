# SPDX-License-Identifier: MIT
"""Distillation (Hinton et al. 2015) of several views into one: the student sees a drawing once and learns what the teacher says in the
mean of four views of it (as it is, mirrored, tilted to either side), those with more confidence counting more, as in the program."""
import math

import torch
import torch.nn.functional as F

from model import EXPERTS

TILT = math.radians(20)
FILLED = 0.88                   # a tilted drawing is made smaller, so that it stays in the square
INVERSE_TEMPERATURE = 30        # a view counts exp(this times its confidence)
SHARE = 2                       # every SHARE-th image of a batch


def warped(x, angle, scale, mirror, fill):
    """x (n,c,h,w) turned by `angle` and scaled about its middle, then mirrored; what comes from outside is `fill`."""
    c, s = math.cos(angle) / scale, math.sin(angle) / scale
    matrix = torch.tensor([[[c, -s, 0], [s, c, 0]]]).repeat(len(x), 1, 1)
    result = F.grid_sample(x - fill, F.affine_grid(matrix, x.shape, align_corners=False), align_corners=False) + fill
    return result.flip(3) if mirror else result


def straightened(x, angle, scale, mirror, fill):
    return warped(x.flip(3) if mirror else x, -angle, 1 / scale, False, fill)


@torch.no_grad()
def views_mean(teacher, ink, route):
    """{expert: probabilities (k,c,h,w) of its images}, the mean of four views."""
    views = []
    for angle, scale, mirror in ((0, 1, False), (0, 1, True), (TILT, FILLED, False), (-TILT, FILLED, True)):
        with torch.autocast("cpu", dtype=torch.bfloat16):
            parts = teacher(warped(ink, angle, scale, mirror, 0), route)[0]
        paper = torch.eye(1, next(iter(parts.values())).shape[1]).reshape(1, -1, 1, 1)
        views.append({name: straightened(logits.float().softmax(1), angle, scale, mirror, paper) for name, logits in parts.items()})
    mean = {}
    for name in views[0]:
        answers = torch.stack([view[name] for view in views])                        # (views, k, c, h, w)
        part, drawn = answers[:, :, 1:].amax(2), 1 - answers[:, :, 0]
        confidence = (part * drawn).sum((2, 3)) / drawn.sum((2, 3)).clamp(min=1)
        mean[name] = (answers * (INVERSE_TEMPERATURE * confidence).softmax(0)[:, :, None, None, None]).sum(0)
    return mean


def loss(teacher, ink, route, parts):
    """cross-entropy of the student's parts ({expert: logits of its images}) with the teacher's, near the drawing."""
    chosen = torch.arange(len(ink)) % SHARE == 0
    wanted, total = views_mean(teacher, ink[chosen], route[chosen]), 0
    for i, name in enumerate(EXPERTS):
        if name in wanted:
            logits = parts[name][chosen[route == i]].float()
            near = 0.1 + 0.9 * (1 - wanted[name][:, :1]).clamp(0, 1)
            entropy = -(wanted[name] * logits.log_softmax(1)).sum(1, keepdim=True)
            total = total + (entropy * near).sum() / near.sum() * len(logits) / int(chosen.sum())
    return total
