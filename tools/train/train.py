#!/usr/bin/python3
"""Trains the segmentation network on shards (dataset.py), on the processor, within a given time.

usage: train.py SHARDS OUT --minutes M [--resume CHECKPOINT] [--rate 2e-3] [--batch 16] [--size 256] [--seed 1] [--share source=weight ...]
AdamW; the rate climbs for 2 %, stays until half of the time and falls along a cosine to zero at its end. Writes OUT/last.pt every few
minutes (model, moving average of the weights, optimiser, step) and one line per 50 steps on stdout.
"""
import argparse
import copy
import math
import os
import time

import cv2
import numpy as np
import torch
import torch.nn.functional as F

import dataset
from model import EXPERTS, INPUT, LABELS, Segmenter

SHARES = {"label_maps": 0.36, "strokes": 0.24, "spg": 0.12, "doodle": 0.28}
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


def part_loss(logits, labels):
    return F.cross_entropy(logits, labels, ignore_index=IGNORE) + dice_loss(logits, labels)


def loss_of(model, ink, labels, experts, poses):
    route = torch.where(experts == IGNORE, 0, experts)
    with torch.autocast("cpu", dtype=torch.bfloat16):
        parts, router, pose = model(ink, route)
    total = sum(part_loss(parts[name].float(), labels[route == i]) * (route == i).float().mean()
                for i, name in enumerate(EXPERTS) if name in parts)
    total = total + 0.1 * F.cross_entropy(router.float(), experts, ignore_index=IGNORE)
    if bool((poses != IGNORE).any()):
        total = total + 0.03 * F.cross_entropy(pose.float(), poses, ignore_index=IGNORE)
    return total


def rate_at(progress, peak):
    if progress < 0.02:
        return peak * max(progress / 0.02, 0.02)
    return peak if progress < 0.5 else peak * 0.5 * (1 + math.cos(math.pi * min(1, (progress - 0.5) / 0.5)))


@torch.no_grad()
def follow(average, model, decay):
    for kept, new in zip(average.state_dict().values(), model.state_dict().values()):
        kept.copy_(kept * decay + new * (1 - decay) if kept.dtype.is_floating_point else new)


def save(path, model, average, optimiser, step):
    torch.save({"widths": model.widths, "decoder": model.decoder, "size": model.size, "model": model.state_dict(),
                "average": average.state_dict(), "optimiser": optimiser.state_dict(), "step": step}, path + ".part")
    os.replace(path + ".part", path)


def train(args):
    torch.set_num_threads(1)
    cv2.setNumThreads(1)
    torch.manual_seed(args.seed)
    rng = np.random.default_rng(args.seed)
    shares = {**SHARES, **{k: float(v) for k, v in (s.split("=") for s in args.share)}}
    shards = dataset.Shards(args.shards, shares)
    model = Segmenter(size=args.size).to(memory_format=torch.channels_last)
    optimiser = torch.optim.AdamW(model.parameters(), lr=args.rate, weight_decay=0.02)
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
        ink, labels, experts, poses = dataset.batch(shards, args.batch, rng, args.size)
        loss = loss_of(model, torch.from_numpy(ink), torch.from_numpy(labels).long(), torch.from_numpy(experts).long(),
                       torch.from_numpy(poses).long())
        optimiser.zero_grad()
        loss.backward()
        torch.nn.utils.clip_grad_norm_(model.parameters(), 2.0)
        optimiser.step()
        step += 1
        follow(average, model, min(0.998, step / (step + 20)))
        losses.append(loss.item())
        if step % 50 == 0:
            print(f"step {step} {time.time() - begin:.0f} s rate {rate_at(progress, args.rate):.5f} loss {np.mean(losses):.4f}",
                  {k: len(v) for k, v in shards.sources.items()}, flush=True)
            losses = []
            shards.refresh()
        if time.time() - saved > 150:
            save(f"{args.out}/last.pt", model, average, optimiser, step)
            saved = time.time()
    save(f"{args.out}/last.pt", model, average, optimiser, step)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("shards")
    parser.add_argument("out")
    parser.add_argument("--minutes", type=float, required=True)
    parser.add_argument("--resume")
    parser.add_argument("--rate", type=float, default=2e-3)
    parser.add_argument("--batch", type=int, default=16)
    parser.add_argument("--size", type=int, default=INPUT, help="side of the training images: small ones first, the input last")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--share", nargs="*", default=[])
    args = parser.parse_args()
    os.makedirs(args.out, exist_ok=True)
    train(args)


if __name__ == "__main__":
    main()
