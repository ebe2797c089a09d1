#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes a checkpoint as safetensors: export.py CHECKPOINT OUT.safetensors [--type F16|F32] [--raw]
(the moving average of the weights; --raw: the last weights), or a small fixture with random weights for the tests of the C++ side:
export.py --fixture OUT_WEIGHTS OUT_EXPECTED."""
import argparse
import json
import struct

import numpy as np
import torch

from model import EXPERTS, Segmenter, metadata

TYPES = {"F32": np.dtype("<f4"), "F16": np.dtype("<f2")}
INTEGERS = {"I64": np.dtype("<i8"), "I32": np.dtype("<i4"), "I8": np.dtype("i1"), "U8": np.dtype("u1")}      # quantize.py


def write_safetensors(path, tensors, facts):
    """tensors: {name: array of a type of TYPES or INTEGERS}; 8 bytes length, JSON header padded to 8, data in the order of the names."""
    header, offset = {"__metadata__": facts}, 0
    arrays = {name: np.asarray(tensors[name], order="C") for name in sorted(tensors)}
    for name, array in arrays.items():
        kind = {v: k for k, v in (TYPES | INTEGERS).items()}[array.dtype]
        header[name] = {"dtype": kind, "shape": list(array.shape), "data_offsets": [offset, offset + array.nbytes]}
        offset += array.nbytes
    text = json.dumps(header, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 8)
    with open(path, "wb") as file:
        file.write(struct.pack("<Q", len(text)) + text)
        for array in arrays.values():
            file.write(array.tobytes())


def read_safetensors(path):
    """-> {name: array; integers as they are, other numbers as float32}, metadata"""
    data = open(path, "rb").read()
    length = struct.unpack("<Q", data[:8])[0]
    header = json.loads(data[8:8 + length])
    facts, body, tensors = header.pop("__metadata__", {}), data[8 + length:], {}
    for name, entry in header.items():
        begin, end = entry["data_offsets"]
        array = np.frombuffer(body[begin:end], (TYPES | INTEGERS)[entry["dtype"]]).reshape(entry["shape"])
        tensors[name] = array if entry["dtype"] in INTEGERS else array.astype(np.float32)
    return tensors, facts


def tensors_of(model, kind):
    return {name: value.numpy().astype(TYPES[kind]) for name, value in model.state_dict().items()
            if not name.endswith("num_batches_tracked") and (model.knows_turn or not name.startswith("turn."))}


def load(path, raw=False):
    """a Segmenter in evaluation mode, from a checkpoint of train.py or from a safetensors file."""
    if path.endswith(".safetensors"):
        tensors, facts = read_safetensors(path)
        widths, decoder, contexts, refine = (tuple(map(int, facts[key].split(","))) for key in ("widths", "decoder", "contexts", "refine"))
        model = Segmenter(widths, decoder, int(facts["input"]), contexts, refine)
        state = {name: torch.from_numpy(value.copy()) for name, value in tensors.items()}
        model.load_state_dict(state, strict=False)
        model.knows_turn = "turns" in facts
    else:
        checkpoint = torch.load(path, map_location="cpu")
        model = Segmenter(*(checkpoint[key] for key in ("widths", "decoder", "size", "contexts", "refine")))
        model.load_state_dict(checkpoint["model" if raw else "average"], strict=False)      # older ones have fewer heads
    return model.eval()


def fixture(weights, expected):
    """tiny widths, random weights and statistics; one input (48 x 48) and what both experts and the other heads say."""
    torch.manual_seed(7)
    model = Segmenter((4, 6, 8, 10), (8, 6, 4), 48, (2, 4), (1, 2, 0))
    model.knows_turn = True
    generator = torch.Generator().manual_seed(8)
    for name, value in model.state_dict().items():
        if name.endswith(("running_var", "norm.weight")):
            value.copy_(0.5 + torch.rand(value.shape, generator=generator))
        elif name.endswith(("running_mean", "bias")):
            value.copy_(0.4 * torch.randn(value.shape, generator=generator))
    model.eval()
    ink = (torch.rand(1, 1, 48, 48, generator=generator) > 0.7).float() * torch.rand(1, 1, 48, 48, generator=generator)
    with torch.no_grad():
        parts, router, pose, kind = model(ink)
        turn = model.turn(model.stem(ink)[3])
    facts = metadata(model)
    write_safetensors(weights, tensors_of(model, "F32"), facts)
    answers = {"input": ink, "router": router.softmax(1), "pose": pose.softmax(1), "type": kind.softmax(1),
               "turn": turn.softmax(1)}
    for name in EXPERTS:
        answers[f"probabilities.{name}"] = parts[name].softmax(1)
    write_safetensors(expected, {k: v.numpy().astype(np.float32) for k, v in answers.items()}, facts)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("source")
    parser.add_argument("out")
    parser.add_argument("--type", choices=sorted(TYPES), default="F16")
    parser.add_argument("--raw", action="store_true")
    parser.add_argument("--fixture", action="store_true", help="write the fixture: SOURCE = weights, OUT = expected")
    args = parser.parse_args()
    if args.fixture:
        fixture(args.source, args.out)
        return
    model = load(args.source, args.raw)
    write_safetensors(args.out, tensors_of(model, args.type), metadata(model))


if __name__ == "__main__":
    main()
