#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Turns the weights of the segmenter or of the compact detector into a file of integers (integers.py), with scales of least squared error
on training drawings.

usage: quantize.py SHARDS WEIGHTS.safetensors OUT.safetensors [--count 150] [--seed 1]
       quantize.py --fixture TESTDATA           (small integer networks and what they answer, for the tests of the C++ side)
SHARDS: what dataset.py wrote; fold 0 is not in it. The segmenter sees augmented drawings as in training, each expert those of its own kind;
the detector sees composed pages (pages.py), and where SHARDS has things, every second page with them (scenes.py).
"""
import argparse
import os

import cv2
import numpy as np
import torch

import dataset
import integers
import integer_networks as networks
import scenes
import train
import train_detector
from export import read_safetensors, write_safetensors
from model import EXPERTS
from pages import compose

MOST_SAMPLES = 400_000              # of a tensor, for its scale


def integer_tensors(run):
    """the tensors of the integer file, from what an Observed run has seen."""
    scales = {"input": integers.Scale(1 / integers.BYTE, 0)}
    for key, parts in run.samples.items():
        values = np.concatenate(parts)
        if len(values) > MOST_SAMPLES:
            values = values[run.rng.choice(len(values), MOST_SAMPLES, replace=False)]
        scales[key] = integers.byte_scale(values)
    tensors = {}
    for name, layer in run.layers.items():
        weight, bias = (part.numpy() for part in run.weights[name])
        inputs = [(scales[key], channels) for key, channels in layer.inputs]
        result = scales[layer.key] if layer.key else integers.REAL
        parts = integers.quantised(weight, bias, inputs, result, scales[layer.residual] if layer.residual else None, layer.transposed)
        tensors |= {f"{name}.{part}": value for part, value in parts.items()}
    for name, key in run.heads.items():
        weight, bias = (part.numpy() for part in run.weights[name])
        tensors |= {f"{name}.weight": weight * np.float32(scales[key].step), f"{name}.bias": bias}
    return tensors


def observe_segmenter(run, facts, examples):
    """examples: (ink (side, side) in [0, 1], expert or UNKNOWN)"""
    contexts, refine = (tuple(map(int, facts[key].split(","))) for key in ("contexts", "refine"))
    for ink, kind in examples:
        features = networks.stem(run, torch.from_numpy(ink)[None, None])
        networks.segmenter_heads(run, features[3])
        for number, name in enumerate(EXPERTS):
            if kind in (number, dataset.UNKNOWN):
                networks.expert(run, name, features, contexts, refine)


def training_drawings(shards, size, count, rng):
    shards = dataset.Shards(shards, train.SHARES)
    for _ in range(count):
        ink, _, kind, _, _ = dataset.augment(*dataset.example(shards, rng), rng, size)
        yield ink, kind


def training_pages(folder, count, rng):
    shards = dataset.Shards(folder, train_detector.SHARES)
    things = scenes.Things(folder) if "things" in dataset.Shards(folder, {"things": 1}).sources else None
    for number in range(count):
        yield (scenes.compose(shards, things, rng) if things and number % 2 else compose(shards, rng))[0]


@torch.no_grad()
def quantise(tensors, facts, examples, rng):
    """-> integer tensors, metadata. examples: of observe_segmenter, or pages (h, w) in [0, 1]."""
    run = networks.Observed(tensors, rng)
    if facts["model"] == "pantin.segmenter":
        observe_segmenter(run, facts, examples)
    else:
        model = networks.mask_rcnn(run, tensors, facts)
        for page in examples:
            model([torch.from_numpy(page)[None]])
    missed = [name for name in run.weights if name not in run.layers and name not in run.heads]
    if missed:
        raise SystemExit(f"no example reached {', '.join(missed)}")
    return integer_tensors(run), facts | {"arithmetic": "integer"}


# Fixtures: the small networks of testdata in integers, their scales from random inputs like those that they are tested with.

@torch.no_grad()
def segmenter_fixture(folder):
    rng = np.random.default_rng(5)
    tensors, facts = read_safetensors(f"{folder}/segmenter_tiny.safetensors")
    ink = read_safetensors(f"{folder}/segmenter_tiny_expected.safetensors")[0]["input"]
    inks = ((rng.random(ink.shape[2:]) > 0.7) * rng.random(ink.shape[2:]) for _ in range(20))
    whole, facts = quantise(tensors, facts, [(example.astype(np.float32), dataset.UNKNOWN) for example in inks], rng)
    trace = {}
    model = networks.IntegerSegmenter(whole, facts, trace)
    parts = model(torch.from_numpy(ink))[0]
    names = {"router": "router", "pose": "pose", "type": "kind", "turn": "turn"}
    answers = {"input": ink} | {name: model.heads[head].softmax(1).numpy() for name, head in names.items()}
    answers |= {f"probabilities.{name}": parts[name].softmax(1).numpy() for name in EXPERTS}
    write_safetensors(f"{folder}/segmenter_tiny_integer.safetensors", whole, facts)
    write_safetensors(f"{folder}/segmenter_tiny_integer_expected.safetensors", answers | trace, {})


@torch.no_grad()
def detector_fixture(folder):
    import compare_torch
    rng, generator = np.random.default_rng(6), torch.Generator().manual_seed(6)
    tensors, facts = read_safetensors(f"{folder}/mask_rcnn_tiny.safetensors")
    image = torch.from_numpy(read_safetensors(f"{folder}/mask_rcnn_tiny_trace.safetensors")[0]["image"])
    pages = [compare_torch.scene(image.shape[2], image.shape[1], generator)[0].numpy() for _ in range(12)]
    whole, facts = quantise(tensors, facts, pages, rng)
    run = networks.Emulated(whole)
    answers, _ = compare_torch.trace_mask_rcnn(networks.mask_rcnn(run, whole, facts), image)
    whole_numbers = {name: value.astype(np.uint8) for name, value in answers.items() if name.startswith(("stage", "level")) or "pooled" in name}
    write_safetensors(f"{folder}/mask_rcnn_tiny_integer.safetensors", whole, facts)
    del answers["masks"]                                         # pasted onto the page: nothing of it is integer
    write_safetensors(f"{folder}/mask_rcnn_tiny_integer_trace.safetensors", answers | whole_numbers, {})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="*", metavar="SHARDS WEIGHTS OUT")
    parser.add_argument("--count", type=int, default=150)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--fixture", metavar="TESTDATA")
    args = parser.parse_args()
    torch.set_num_threads(1)
    cv2.setNumThreads(1)
    if args.fixture:
        segmenter_fixture(args.fixture)
        return detector_fixture(args.fixture)
    shards, source, out = args.files
    tensors, facts = read_safetensors(source)
    rng = np.random.default_rng(args.seed)
    examples = training_drawings(shards, int(facts["input"]), args.count, rng) if facts["model"] == "pantin.segmenter" else \
        training_pages(shards, args.count, rng)
    whole, facts = quantise(tensors, facts, examples, rng)
    write_safetensors(out, whole, facts)
    print(f"{out}: {os.path.getsize(out)} bytes")


if __name__ == "__main__":
    main()
