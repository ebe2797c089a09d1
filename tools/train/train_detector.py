#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Trains the compact Mask R-CNN (backbones.py) on composed pages (pages.py), on the processor, within a given time.

usage: train_detector.py SHARDS OUT --minutes M [--resume CHECKPOINT | --start CHECKPOINT_OR_SAFETENSORS] [--rate 1e-3] [--batch 6] [--seed 1]
                         [--scenes 0.55] [--drawn FOLDER ...]
       train_detector.py SHARDS OUT --recipe thesis [--full] [--start CHECKPOINT] [--pages 200] [--epochs 2000] [--decay-epochs 3] [--steps N]
                         [--minutes M] [--seed 1]
       train_detector.py --export CHECKPOINT detector.safetensors      (F16, the moving average of the weights)
The loop is loop.py's. Writes OUT/last.pt every few minutes. --start: weights alone, of a former training. --scenes: share of pages with
things that are no characters (scenes.py; SHARDS must have some); --drawn: half of these pages are whole ones that
`doodle --scene` wrote.
--recipe thesis: the training of chapter 5 (thesis.py) of the compact network or, with --full, of torchvision's Mask R-CNN with ResNet-50,
whose OUT/last.pt ../convert_torch.py makes a weight file of.
"""
import collections
import sys

import numpy as np
import torch

import backbones
import dataset
import export
import full_size
import loop
import pages
import scenes
import thesis
from train import SHARES


# The real drawings are mostly of animals; what children draw is mostly people. Things are no characters.
SHARES = {**{source: share for source, share in SHARES.items() if source not in ("things", "scribbles")}, "people": 0.3}


def targets(masks):
    boxes, kept = [], []
    for mask in masks:
        ys, xs = np.nonzero(mask)
        if len(ys) < 30 or np.ptp(xs) < 4 or np.ptp(ys) < 4:
            continue
        boxes.append([xs.min(), ys.min(), xs.max() + 1, ys.max() + 1])
        kept.append(mask)
    return {"boxes": torch.tensor(np.array(boxes, np.float32).reshape(-1, 4)), "labels": torch.ones(len(boxes), dtype=torch.int64),
            "masks": torch.from_numpy(np.array(kept, np.uint8).reshape(-1, *masks.shape[1:]))}


def new_model():
    model, facts = backbones.compact_mask_rcnn()
    model.rpn._pre_nms_top_n.update(training=300)
    model.rpn._post_nms_top_n.update(training=150)
    model.rpn.fg_bg_sampler.batch_size_per_image = 128
    model.roi_heads.fg_bg_sampler.batch_size_per_image = 96      # nearly all proposals: those on things are few
    model.roi_heads.fg_bg_sampler.positive_fraction = 0.16
    return model, facts


def write_weights(checkpoint, path):
    model, facts = new_model()
    model.load_state_dict(torch.load(checkpoint, map_location="cpu")["average"])
    export.write_safetensors(path, export.tensors_of(model, "F16"), {"model": "pantin.mask_rcnn", "version": "1", **facts})


def start_from(model, path):
    """the weights of a checkpoint, or of a weight file: torch's counters of batches are not in that."""
    if path.endswith(".safetensors"):
        tensors = {name: torch.from_numpy(value.copy()) for name, value in export.read_safetensors(path)[0].items()}
    else:
        tensors = torch.load(path, map_location="cpu")["model"]
    missing, unexpected = model.load_state_dict(tensors, strict=False)
    if unexpected or any(not name.endswith("num_batches_tracked") for name in missing):
        raise SystemExit(f"{path}: not the weights of this network")


def train_own(args, shards):
    things = scenes.Things(args.shards) if args.scenes > 0 else None
    drawn = scenes.Drawn(args.drawn)
    model = new_model()[0].train()
    if args.start:
        start_from(model, args.start)

    exact = model.backbone.forward

    def fast(images):                                             # half of the work, in bfloat16
        with torch.autocast("cpu", dtype=torch.bfloat16):
            stages = exact(images)
        return collections.OrderedDict((name, stage.float()) for name, stage in stages.items())
    model.backbone.forward = fast

    def page(rng):
        if rng.random() >= args.scenes:
            return pages.compose(shards, rng)
        return drawn.draw(rng) if args.drawn and rng.random() < 0.5 else scenes.compose(shards, things, rng)

    def losses_of(model, rng):
        composed = [page(rng) for _ in range(args.batch)]
        return model([torch.from_numpy(ink)[None] for ink, _ in composed], [targets(masks) for _, masks in composed])
    recipe = loop.Clock(args.rate, weight_decay=0.01, clip=5.0, decay=0.995)
    loop.train(model, losses_of, args, recipe, report=args.report or 25, facts={}, after_report=shards.refresh)


def train_thesis(args, shards):
    model = (full_size.mask_rcnn() if args.full else backbones.compact_mask_rcnn()[0]).train()
    if args.start:
        start_from(model, args.start)

    def image(ink):                                               # the compact network sees ink, torchvision's the page's colours
        return torch.from_numpy(1 - ink)[None].expand(3, -1, -1) if args.full else torch.from_numpy(ink)[None]

    def losses_of(model, rng):
        composed = [thesis.page(shards, rng) for _ in range(args.batch)]
        return model([image(ink) for ink, _ in composed], [targets(masks) for _, masks in composed])
    steps_of_epoch = max(1, args.pages // args.batch)
    steps = args.epochs * steps_of_epoch
    recipe = thesis.Descent(lambda step: thesis.detector_rate(step, args.rate, steps_of_epoch, args.decay_epochs),
                            min(args.steps or steps, steps), thesis.WEIGHT_DECAY)
    loop.train(model, losses_of, args, recipe, report=args.report or 25, facts={}, after_report=shards.refresh)


def main():
    def more(parser):
        parser.add_argument("--start")
        parser.add_argument("--scenes", type=float, default=0.55)
        parser.add_argument("--drawn", nargs="*", default=[])
        parser.add_argument("--pages", type=int, default=thesis.PAGES, help="of an epoch of --recipe thesis")
        parser.add_argument("--epochs", type=int, default=thesis.EPOCHS)
        parser.add_argument("--decay-epochs", type=int, default=thesis.DECAY_EPOCHS)
    if sys.argv[1:2] == ["--export"]:
        return write_weights(sys.argv[2], sys.argv[3])
    args = loop.parse(__doc__, 1.5e-3, 6, thesis.DETECTOR_RATE, thesis.PAGE_BATCH, more)
    (train_thesis if args.recipe == "thesis" else train_own)(args, dataset.Shards(args.shards, SHARES))


if __name__ == "__main__":
    main()
