#!/usr/bin/python3
"""Trains the compact Mask R-CNN (backbones.py) on composed pages (pages.py), on the processor, within a given time.

usage: train_detector.py SHARDS OUT --minutes M [--resume CHECKPOINT] [--rate 1e-3] [--batch 6] [--seed 1]
       train_detector.py --export CHECKPOINT detector.safetensors      (F16, the moving average of the weights)
AdamW; the rate climbs for 3 %, stays until half of the time and falls along a cosine to zero. Writes OUT/last.pt every few minutes.
"""
import argparse
import copy
import os
import sys
import time

import cv2
import numpy as np
import torch

import backbones
import dataset
import export
import pages
from train import SHARES, follow, rate_at


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
    model.roi_heads.fg_bg_sampler.batch_size_per_image = 48
    return model, facts


def save(path, model, average, optimiser, step):
    torch.save({"model": model.state_dict(), "average": average.state_dict(), "optimiser": optimiser.state_dict(), "step": step},
               path + ".part")
    os.replace(path + ".part", path)


def train(args):
    torch.set_num_threads(1)
    cv2.setNumThreads(1)
    torch.manual_seed(args.seed)
    rng = np.random.default_rng(args.seed)
    shards = dataset.Shards(args.shards, SHARES)
    model, _ = new_model()
    model.train()
    optimiser = torch.optim.AdamW(model.parameters(), lr=args.rate, weight_decay=0.01)
    step = 0
    if args.resume:
        state = torch.load(args.resume)
        model.load_state_dict(state["model"])
        optimiser.load_state_dict(state["optimiser"])
        step = state["step"]
    average = copy.deepcopy(model)
    if args.resume:
        average.load_state_dict(state["average"])
    begin, saved, losses = time.time(), time.time(), []
    while (progress := (time.time() - begin) / (60 * args.minutes)) < 1:
        for group in optimiser.param_groups:
            group["lr"] = rate_at(progress, args.rate)
        images, wanted = [], []
        while len(images) < args.batch:
            ink, masks = pages.compose(shards, rng)
            images.append(torch.from_numpy(ink)[None])
            wanted.append(targets(masks))
        parts = model(images, wanted)
        loss = sum(parts.values())
        optimiser.zero_grad()
        loss.backward()
        torch.nn.utils.clip_grad_norm_(model.parameters(), 5.0)
        optimiser.step()
        step += 1
        follow(average, model, min(0.995, step / (step + 20)))
        losses.append([v.item() for v in parts.values()])
        if step % 25 == 0:
            print(f"step {step} {time.time() - begin:.0f} s", " ".join(f"{k} {v:.3f}" for k, v in zip(parts, np.mean(losses, 0))), flush=True)
            losses = []
        if time.time() - saved > 150:
            save(f"{args.out}/last.pt", model, average, optimiser, step)
            saved = time.time()
    save(f"{args.out}/last.pt", model, average, optimiser, step)


def write_weights(checkpoint, path):
    model, facts = new_model()
    model.load_state_dict(torch.load(checkpoint, map_location="cpu")["average"])
    export.write_safetensors(path, export.tensors_of(model, "F16"), {"model": "pantin.mask_rcnn", "version": "1", **facts})


def main():
    if sys.argv[1:2] == ["--export"]:
        return write_weights(sys.argv[2], sys.argv[3])
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("shards")
    parser.add_argument("out")
    parser.add_argument("--minutes", type=float, required=True)
    parser.add_argument("--resume")
    parser.add_argument("--rate", type=float, default=1e-3)
    parser.add_argument("--batch", type=int, default=6)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    os.makedirs(args.out, exist_ok=True)
    train(args)


if __name__ == "__main__":
    main()
