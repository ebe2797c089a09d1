# SPDX-License-Identifier: MIT
"""The training loop of both networks: AdamW within a given time, moving average of the weights, resumable checkpoints."""
import argparse
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


def train(model, losses_of, args, weight_decay, clip, decay, report, facts, after_report=lambda: None):
    """losses_of(model, rng) -> {name: loss} of one batch; their sum is descended. Writes args.out/last.pt every few minutes and one line
    per `report` steps on stdout."""
    os.makedirs(args.out, exist_ok=True)
    rng = np.random.default_rng(args.seed)
    optimiser = torch.optim.AdamW(model.parameters(), lr=args.rate, weight_decay=weight_decay)
    average, step = copy.deepcopy(model), 0
    if args.resume:
        state = torch.load(args.resume)
        model.load_state_dict(state["model"])
        average.load_state_dict(state["average"])
        optimiser.load_state_dict(state["optimiser"])
        step = state["step"]
    begin, saved, seen = time.time(), time.time(), []
    while (progress := (time.time() - begin) / (60 * args.minutes)) < 1:
        for group in optimiser.param_groups:
            group["lr"] = rate_at(progress, args.rate)
        losses = losses_of(model, rng)
        optimiser.zero_grad()
        sum(losses.values()).backward()
        torch.nn.utils.clip_grad_norm_(model.parameters(), clip)
        optimiser.step()
        step += 1
        follow(average, model, min(decay, step / (step + 20)))
        seen.append([loss.item() for loss in losses.values()])
        if step % report == 0:
            means = " ".join(f"{name} {value:.4f}" for name, value in zip(losses, np.mean(seen, 0)))
            print(f"step {step} {time.time() - begin:.0f} s rate {rate_at(progress, args.rate):.5f} {means}", flush=True)
            seen = []
            after_report()
        if time.time() - saved > CHECKPOINT_SECONDS:
            save(f"{args.out}/last.pt", model, average, optimiser, step, facts)
            saved = time.time()
    save(f"{args.out}/last.pt", model, average, optimiser, step, facts)


def parse(description, rate, batch, add=lambda parser: None):
    """the arguments that both networks share; one processor thread, everything seeded."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("shards")
    parser.add_argument("out")
    parser.add_argument("--minutes", type=float, required=True)
    parser.add_argument("--resume")
    parser.add_argument("--rate", type=float, default=rate)
    parser.add_argument("--batch", type=int, default=batch)
    parser.add_argument("--seed", type=int, default=1)
    add(parser)
    args = parser.parse_args()
    torch.set_num_threads(1)
    cv2.setNumThreads(1)
    torch.manual_seed(args.seed)
    return args
