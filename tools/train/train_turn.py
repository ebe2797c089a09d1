#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Trains the head that says by how many quarter turns a drawing has to be turned clockwise to stand upright, on the coarsest stage of the
trained stem, which stays as it is.

usage: train_turn.py SHARDS WEIGHTS OUT [--count 6000] [--epochs 30] [--seed 1] [--cache FEATURES]
WEIGHTS: a checkpoint or safetensors; OUT: the same network with the head, as safetensors. Every drawing is shown in all four turns; a
constant of the head is shared by none: what it says of the four views is compared by the program (src/segmentation/find_turn.cpp).
"""
import argparse
import os

import numpy as np
import torch
import torch.nn.functional as F

import dataset
import export
from model import TURNS, metadata
from train import IGNORE, SHARES


@torch.no_grad()
def features_of(model, shards, count, rng):
    """(count, 4, channels, h, w): the coarsest stage of drawings, turned clockwise by 0, 1, 2, 3 quarters."""
    result = []
    while len(result) < count:
        ink, labels, _, _, _ = dataset.augment(*dataset.example(shards, rng), rng, model.size)
        if (labels != IGNORE).all():                                                  # no thing, no scribble
            turned = np.stack([np.rot90(ink, -k) for k in range(TURNS)])
            result.append(model.stem(torch.from_numpy(turned)[:, None])[3].half())
    return torch.stack(result)


def train(head, features, epochs, rate, batch, seed):
    torch.manual_seed(seed)
    optimiser = torch.optim.AdamW(head.parameters(), lr=rate, weight_decay=0.05)
    steps = epochs * (len(features) // batch)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimiser, rate, steps)
    wanted = torch.arange(TURNS).neg().remainder(TURNS)                     # turned by k: 4 - k more bring it upright
    head.train()
    for step in range(steps):
        chosen = torch.randint(len(features), (batch,))
        x = features[chosen].float()
        scores = head(x.flatten(0, 1))
        loss = F.cross_entropy(scores, wanted.repeat(batch), label_smoothing=0.05)
        optimiser.zero_grad()
        loss.backward()
        optimiser.step()
        schedule.step()
        if (step + 1) % 200 == 0:
            print(f"step {step + 1} of {steps}: loss {loss.item():.4f}", flush=True)
    head.eval()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("shards")
    parser.add_argument("weights")
    parser.add_argument("out")
    parser.add_argument("--count", type=int, default=6000)
    parser.add_argument("--epochs", type=int, default=30)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--cache")
    args = parser.parse_args()
    torch.set_num_threads(1)
    model = export.load(args.weights)
    if args.cache and os.path.exists(args.cache):
        features = torch.load(args.cache)
    else:
        features = features_of(model, dataset.Shards(args.shards, SHARES), args.count, np.random.default_rng(args.seed))
        if args.cache:
            torch.save(features, args.cache)
    model.knows_turn = True
    train(model.turn, features, args.epochs, 2e-3, 32, args.seed)
    export.write_safetensors(args.out, export.tensors_of(model, "F16"), metadata(model))


if __name__ == "__main__":
    main()
