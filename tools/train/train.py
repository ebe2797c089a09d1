#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Trains the segmentation network on shards (dataset.py), on the processor, within a given time.

usage: train.py SHARDS OUT --minutes M [--resume CHECKPOINT] [--rate 2e-3] [--batch 16] [--size 256] [--seed 1] [--share source=weight ...]
                [--start CHECKPOINT_OR_SAFETENSORS]       (weights alone, into a network that may have more blocks)
                [--teacher CHECKPOINT_OR_SAFETENSORS]     (its mean of several views is learned, too: distil.py)
       train.py SHARDS OUT --recipe thesis [--full [--depth 50|101]] [--start ...] [--steps N] [--minutes M] [--seed 1]
AdamW; the rate climbs for 2 %, stays until half of the time and falls along a cosine to zero at its end. Writes OUT/last.pt every few
minutes (model, moving average of the weights, optimiser, step) and one line per 50 steps on stdout.
--recipe thesis: the training of chapter 5 (thesis.py) of the compact network or, with --full, of SketchParse, whose OUT/last.pt
../convert_torch.py makes a weight file of.
"""
import torch
import torch.nn.functional as F

import dataset
import distil
import export
import full_size
import loop
import thesis
from model import EXPERTS, INPUT, LABELS, POSES, Segmenter, widen

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


def facts_of(model):
    return {key: getattr(model, key) for key in ("widths", "decoder", "size", "contexts", "refine")}


def compact(args):
    model = Segmenter(size=args.size)
    if args.start:
        model.load_state_dict(widen(export.load(args.start).state_dict(), model))
    return model


def train_own(args, shards):
    model = compact(args).to(memory_format=torch.channels_last)
    teacher = export.load(args.teacher).to(memory_format=torch.channels_last) if args.teacher else None

    def losses_of(model, rng):
        ink, *truth = dataset.batch(shards, args.batch, rng, args.size)
        return {"loss": loss_of(model, torch.from_numpy(ink), *(torch.from_numpy(t).long() for t in truth), teacher)}
    recipe = loop.Clock(args.rate, weight_decay=0.02, clip=2.0, decay=0.998)
    loop.train(model, losses_of, args, recipe, report=args.report or 50, facts=facts_of(model), after_report=shards.refresh)


def thesis_example(shards, rng, size):
    """ink, labels, expert, pose, type of one drawing with labels, as tensors."""
    while True:
        ink, labels, expert, pose, kind = shards.draw(rng)
        if expert < len(EXPERTS) and labels.any():
            break
    ink, labels, pose = thesis.drawing(ink, labels, pose, rng, size, POSES, IGNORE)
    return torch.from_numpy(ink), torch.from_numpy(labels).long(), expert, pose, kind


def compact_losses(model, ink, labels, expert, pose, kind):
    """plain cross-entropies: of the parts, the router, the pose and, the compact network's own, the type."""
    parts, router, direction, type_ = model(ink[None, None], torch.tensor([expert]))
    losses = {"parts": F.cross_entropy(parts[EXPERTS[expert]], labels[None], ignore_index=IGNORE),
              "router": F.cross_entropy(router, torch.tensor([expert])), "type": F.cross_entropy(type_, torch.tensor([kind]))}
    return losses | ({"pose": F.cross_entropy(direction, torch.tensor([pose]))} if pose != IGNORE else {})


def mean_losses(several):
    """of each name, the sum over the examples that have it by the number of all."""
    return {name: sum(losses[name] for losses in several if name in losses) / len(several)
            for name in sorted({name for losses in several for name in losses})}


def train_thesis(args, shards):
    model = full_size.two_experts(args.depth) if args.full else compact(args)
    if args.full and args.start:
        model.load_state_dict(torch.load(args.start, map_location="cpu")["model"])
    if args.start:
        full_size.keep_normalisations(model)
    size = thesis.SIDE if args.full else args.size

    def losses_of(model, rng):
        several = []
        for _ in range(args.batch):
            *example, kind = thesis_example(shards, rng, size)
            several.append(full_size.sketch_parse_losses(model, *example) if args.full else compact_losses(model, *example, kind))
        return mean_losses(several)
    recipe = thesis.Descent(lambda step: thesis.segmenter_rate(step, args.rate), min(args.steps or thesis.ITERATIONS, thesis.ITERATIONS),
                            factor_of=thesis.segmenter_factor)
    facts = full_size.facts() if args.full else facts_of(model)
    loop.train(model, losses_of, args, recipe, report=args.report or 50, facts=facts, after_report=shards.refresh)


def main():
    def more(parser):
        parser.add_argument("--size", type=int, default=INPUT, help="side of the training images: small ones first, the input last")
        parser.add_argument("--share", nargs="*", default=[])
        parser.add_argument("--start")
        parser.add_argument("--teacher")
        parser.add_argument("--depth", choices=sorted(full_size.DEPTHS), default="50", help="of SketchParse's ResNet")
    args = loop.parse(__doc__, 2e-3, 16, thesis.SEGMENTER_RATE, 1, more)
    shares = {**SHARES, **{k: float(v) for k, v in (s.split("=") for s in args.share)}}
    (train_thesis if args.recipe == "thesis" else train_own)(args, dataset.Shards(args.shards, shares))


if __name__ == "__main__":
    main()
