#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""A state dictionary of PyTorch -> weights that pantin reads.

usage: convert_torch.py STATE_DICT.pth OUT.safetensors [--half] [--set KEY=VALUE ...]
Takes torchvision's maskrcnn_resnet50_fpn (names of 0.14 and of the versions before) and SketchParse (its authors' Scale1 … Scale3).
The metadata `model` says which, and the program chooses the network by it (docs/formats.md, "Weights").
SketchParse also gets `experts` and `parts`: those that a checkpoint of train/train.py --full carries, else those of its authors' five experts
unless --set gives them: parts=background,head,body;background,wing.
Checkpoints that hold the dictionary under "model" or "state_dict" are opened. --half stores F16. --set writes metadata that differs
from torchvision's defaults, for example norm_epsilon=0 for torchvision's own COCO weights, min_size=320, anchor_sizes=16,32,64,128,256.
"""
import argparse
import os
import re
import sys

import numpy as np
import torch

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "train"))
from export import write_safetensors

# Names before torchvision 0.13 -> names since.
OLD_NAMES = [(r"^backbone\.fpn\.(inner|layer)_blocks\.(\d+)\.(weight|bias)$", r"backbone.fpn.\1_blocks.\2.0.\3"),
             (r"^rpn\.head\.conv\.(weight|bias)$", r"rpn.head.conv.0.0.\1"),
             (r"^roi_heads\.mask_head\.mask_fcn(\d+)\.(weight|bias)$",
              lambda m: f"roi_heads.mask_head.{int(m[1]) - 1}.0.{m[2]}")]
KINDS = {"roi_heads.box_predictor.cls_score.weight": "pantin.mask_rcnn", "Scale1.conv1.weight": "pantin.sketch_parse"}

# The categories of the authors' experts and the label of each of their parts (exp-src/data/sketch-dataset/Cls2Part.m of their code, after the
# background; wheels as limbs, what else vehicles have as body).
AUTHORS_EXPERTS = {"cow_horse": "background,head,body,limb,tail", "cat_dog_sheep": "background,head,body,limb,tail",
                   "bus_car": "background,body,body,body,limb,body,body", "bicycle_motorbike": "background,limb,body,body,body",
                   "aeroplane_bird": "background,body,limb,tail,body,wing,head,limb,wing"}


def sketch_parse_facts(tensors):
    """experts and parts, when the tensors are of the authors' five experts."""
    widths = []
    while (name := f"Scale1.layer5_r{len(widths)}.conv2d_list.0.weight") in tensors:
        widths.append(tensors[name].shape[0])
    if widths != [parts.count(",") + 1 for parts in AUTHORS_EXPERTS.values()]:
        return {}
    return {"experts": ",".join(AUTHORS_EXPERTS), "parts": ";".join(AUTHORS_EXPERTS.values())}


def renamed(name):
    name = name.removeprefix("module.")
    for pattern, replacement in OLD_NAMES:
        name = re.sub(pattern, replacement, name)
    return name


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("state_dict")
    parser.add_argument("out")
    parser.add_argument("--half", action="store_true")
    parser.add_argument("--set", nargs="*", default=[], metavar="KEY=VALUE")
    args = parser.parse_args()
    state = torch.load(args.state_dict, map_location="cpu")
    carried = {key: state[key] for key in ("experts", "parts", "poses") if isinstance(state.get(key), str)}
    for key in ("model", "state_dict"):
        state = state[key] if key in state and isinstance(state[key], dict) else state
    tensors = {renamed(name): value.numpy().astype(np.float16 if args.half else np.float32) for name, value in state.items()
               if torch.is_tensor(value) and not name.endswith("num_batches_tracked")}
    kind = next((kind for name, kind in KINDS.items() if name in tensors), None)
    if kind is None:
        raise SystemExit(f"{args.state_dict}: neither a Mask R-CNN of torchvision nor SketchParse")
    facts = {"model": kind, "version": "1"}
    if kind == "pantin.sketch_parse":
        facts |= sketch_parse_facts(tensors)
    facts |= carried | dict(item.split("=", 1) for item in args.set)
    if kind == "pantin.sketch_parse" and not {"experts", "parts"} <= facts.keys():
        raise SystemExit(f"{args.state_dict}: not the authors' five experts, so --set must say experts=… and parts=…")
    write_safetensors(args.out, tensors, facts)
    print(f"{args.out}: {kind}, {len(tensors)} tensors, {sum(t.size for t in tensors.values()) / 1e6:.1f} million values")


if __name__ == "__main__":
    main()
