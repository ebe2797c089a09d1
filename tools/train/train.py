#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Trains the segmentation network on shards (dataset.py), on the processor, within a given time.

usage: train.py SHARDS OUT --minutes M [--resume CHECKPOINT] [--rate 2e-3] [--batch 16] [--size 256] [--seed 1] [--share source=weight ...]
                [--start CHECKPOINT_OR_SAFETENSORS]       (weights alone, into a network that may have more blocks)
                [--teacher CHECKPOINT_OR_SAFETENSORS]     (its mean of several views is learned, too: distil.py)
AdamW; the rate climbs for 2 %, stays until half of the time and falls along a cosine to zero at its end. Writes OUT/last.pt every few
minutes (model, moving average of the weights, optimiser, step) and one line per 50 steps on stdout.
"""
import torch
import torch.nn.functional as F

import dataset
import distil
import export
import loop
from model import EXPERTS, INPUT, LABELS, Segmenter, widen

SHARES = {"label_maps": 0.22, "strokes": 0.12, "more": 0.3, "spg": 0.05, "doodle": 0.26, "others": 0.02, "things": 0.02, "scribbles": 0.01}
IGNORE = dataset.UNKNOWN


def dice_loss(logits, labels):
    """1 - mean soft Dice over the parts present in each image (Milletari et al. 2016): thin parts count as much as broad ones."""
    judged = (labels != IGNORE).unsqueeze(1).float()
    truth = F.one_hot(torch.where(labels == IGNORE, 0, labels), len(LABELS)).permute(0, 3, 1, 2) * judged
    guess = logits.softmax(1) * judged
    both = 2 * (guess * truth).sum((2, 3)) + 20
    total = guess.sum((2, 3)) + truth.sum((2, 3)) + 20
    present = (truth.sum((2, 3)) > 0).float()
    return (((1 - both / total) * present).sum(1) / present.sum(1).clamp(min=1)).mean()


def gap_weights(labels):
    """3 on the paper between two parts that are close to each other (Ronneberger et al. 2015, eq. 2), so that legs do not grow together;
    1 elsewhere. Close: a closing by a square of 9 pixels bridges them."""
    inside = (labels > 0).float().unsqueeze(1)
    closed = -F.max_pool2d(-F.max_pool2d(inside, 9, 1, 4), 9, 1, 4)
    return 1 + 2 * ((closed > 0) & (inside == 0)).squeeze(1).float()


def part_loss(logits, labels):
    weights = gap_weights(labels) * (labels != IGNORE)
    entropy = (F.cross_entropy(logits, labels, ignore_index=IGNORE, reduction="none") * weights).sum() / weights.sum().clamp(min=1)
    return entropy + dice_loss(logits, labels)


def loss_of(model, ink, labels, experts, poses, types, teacher=None):
    route = torch.where(experts == IGNORE, 0, experts)
    with torch.autocast("cpu", dtype=torch.bfloat16):
        parts, router, pose, kind = model(ink, route)
    total = sum(part_loss(parts[name].float(), labels[route == i]) * (route == i).float().mean()
                for i, name in enumerate(EXPERTS) if name in parts)
    if teacher:
        total = total + distil.loss(teacher, ink, route, parts)
    total = total + 0.1 * F.cross_entropy(router.float(), experts, ignore_index=IGNORE)
    if bool((poses != IGNORE).any()):
        total = total + 0.03 * F.cross_entropy(pose.float(), poses, ignore_index=IGNORE)
    return total + 0.15 * F.cross_entropy(kind.float(), types, ignore_index=IGNORE, label_smoothing=0.05)


def main():
    def more(parser):
        parser.add_argument("--size", type=int, default=INPUT, help="side of the training images: small ones first, the input last")
        parser.add_argument("--share", nargs="*", default=[])
        parser.add_argument("--start")
        parser.add_argument("--teacher")
    args = loop.parse(__doc__, 2e-3, 16, more)
    shares = {**SHARES, **{k: float(v) for k, v in (s.split("=") for s in args.share)}}
    shards = dataset.Shards(args.shards, shares)
    model = Segmenter(size=args.size)
    if args.start:
        model.load_state_dict(widen(export.load(args.start).state_dict(), model))
    model = model.to(memory_format=torch.channels_last)
    teacher = export.load(args.teacher).to(memory_format=torch.channels_last) if args.teacher else None

    def losses_of(model, rng):
        ink, *truth = dataset.batch(shards, args.batch, rng, args.size)
        return {"loss": loss_of(model, torch.from_numpy(ink), *(torch.from_numpy(t).long() for t in truth), teacher)}
    facts = {key: getattr(model, key) for key in ("widths", "decoder", "size", "contexts", "refine")}
    loop.train(model, losses_of, args, weight_decay=0.02, clip=2.0, decay=0.998, report=50, facts=facts, after_report=shards.refresh)


if __name__ == "__main__":
    main()
