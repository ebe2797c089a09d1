# SPDX-License-Identifier: MIT
"""The training loop of both networks: AdamW within a given time, moving average of the weights, resumable checkpoints. Another recipe
(thesis.py) brings its own optimiser, rates and end."""
import argparse
import collections
import copy
import math
import os
import time

import cv2
import numpy as np
import torch

CHECKPOINT_SECONDS = 150


def rate_at(progress, peak):
    """climbs for 2 %, stays until half of the time and falls along a cosine to zero at its end."""
    if progress < 0.02:
        return peak * max(progress / 0.02, 0.02)
    return peak if progress < 0.5 else peak * 0.5 * (1 + math.cos(math.pi * min(1, (progress - 0.5) / 0.5)))


@torch.no_grad()
def follow(average, model, decay):
    for kept, new in zip(average.state_dict().values(), model.state_dict().values()):
        kept.copy_(kept * decay + new * (1 - decay) if kept.dtype.is_floating_point else new)


def save(path, model, average, optimiser, step, facts):
    torch.save({**facts, "model": model.state_dict(), "average": average.state_dict(), "optimiser": optimiser.state_dict(),
                "step": step}, path + ".part")
    os.replace(path + ".part", path)


class Clock:
    """our own recipe: AdamW, a rate that follows the time, gradients cut off at `clip`, a moving average of the weights."""

    def __init__(self, rate, weight_decay, clip, decay):
        self.peak, self.weight_decay, self.clip, self.decay = rate, weight_decay, clip, decay

    def optimiser(self, model):
        return torch.optim.AdamW(model.parameters(), lr=self.peak, weight_decay=self.weight_decay)

    def rate(self, step, progress):
        return rate_at(progress, self.peak)

    def over(self, step, progress):
        return progress >= 1


def descend(model, losses, optimiser, rate, clip):
    for group in optimiser.param_groups:
        group["lr"] = rate * group.get("factor", 1)
    optimiser.zero_grad()
    sum(losses.values()).backward()
    if clip:
        torch.nn.utils.clip_grad_norm_(model.parameters(), clip)
    optimiser.step()


def train(model, losses_of, args, recipe, report, facts, after_report=lambda: None):
    """losses_of(model, rng) -> {name: loss} of one batch; their sum is descended as the recipe (Clock, thesis.Descent) says. Writes
    args.out/last.pt every few minutes and one line per `report` steps on stdout."""
    os.makedirs(args.out, exist_ok=True)
    rng = np.random.default_rng(args.seed)
    optimiser = recipe.optimiser(model)
    average, step = copy.deepcopy(model) if recipe.decay else model, 0
    if args.resume:
        state = torch.load(args.resume)
        model.load_state_dict(state["model"])
        average.load_state_dict(state["average"])
        optimiser.load_state_dict(state["optimiser"])
        step = state["step"]
    begin, saved, seen = time.time(), time.time(), collections.defaultdict(list)
    while not recipe.over(step, progress := (time.time() - begin) / (60 * args.minutes)):
        rate = recipe.rate(step, progress)
        losses = losses_of(model, rng)
        descend(model, losses, optimiser, rate, recipe.clip)
        step += 1
        if recipe.decay:
            follow(average, model, min(recipe.decay, step / (step + 20)))
        for name, loss in losses.items():
            seen[name].append(loss.item())
        if step % report == 0:
            means = " ".join(f"{name} {np.mean(values):.4f}" for name, values in seen.items())
            print(f"step {step} {time.time() - begin:.0f} s rate {rate:.5f} {means}", flush=True)
            seen.clear()
            after_report()
        if time.time() - saved > CHECKPOINT_SECONDS:
            save(f"{args.out}/last.pt", model, average, optimiser, step, facts)
            saved = time.time()
    save(f"{args.out}/last.pt", model, average, optimiser, step, facts)


def parse(description, rate, batch, thesis_rate, thesis_batch, add=lambda parser: None):
    """the arguments that both networks share; one processor thread, everything seeded. Without --recipe thesis a time is needed; with it
    --minutes and --steps end a run early."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("shards")
    parser.add_argument("out")
    parser.add_argument("--recipe", choices=["own", "thesis"], default="own")
    parser.add_argument("--full", action="store_true", help="the thesis's network in full size; with --recipe thesis")
    parser.add_argument("--minutes", type=float)
    parser.add_argument("--steps", type=int, default=None, help="with --recipe thesis: fewer steps than the recipe's")
    parser.add_argument("--resume")
    parser.add_argument("--rate", type=float)
    parser.add_argument("--batch", type=int)
    parser.add_argument("--report", type=int, help="steps between two lines of output")
    parser.add_argument("--seed", type=int, default=1)
    add(parser)
    args = parser.parse_args()
    thesis = args.recipe == "thesis"
    if not thesis and (args.minutes is None or args.full or args.steps is not None):
        parser.error("--minutes is needed, and --full and --steps are for --recipe thesis")
    args.minutes = float("inf") if args.minutes is None else args.minutes
    args.rate = args.rate or (thesis_rate if thesis else rate)
    args.batch = args.batch or (thesis_batch if thesis else batch)
    torch.set_num_threads(1)
    cv2.setNumThreads(1)
    torch.manual_seed(args.seed)
    return args
