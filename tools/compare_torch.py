#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Random weights and a random page through PyTorch and through our networks; prints the largest difference of each module.

usage: compare_torch.py mask-rcnn|sketch-parse --binary build/release/compare_torch [--size W H] [--seed 1] [--threads 1]
       compare_torch.py mask-rcnn|sketch-parse --tiny WEIGHTS.safetensors TRACE.safetensors       (the fixtures in testdata/)
Every module of ours is fed with the input that PyTorch's module got. Needs Debian's python3-torch and python3-torchvision.
"""
import argparse
import os
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np
import torch
import torchvision

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "train"))
import backbones
import sketch_parse
from export import write_safetensors


def scene(width, height, generator):
    """a page with a few bright and dark shapes: more to see than noise. (3, height, width) in [0, 1]."""
    page = torch.full((3, height, width), 0.95)
    for _ in range(8):
        x, y = int(torch.randint(0, width, (1,), generator=generator)), int(torch.randint(0, height, (1,), generator=generator))
        w, h = (int(torch.randint(s // 12, s // 3, (1,), generator=generator)) for s in (width, height))
        page[:, y:y + h, x:x + w] = torch.rand((3, 1, 1), generator=generator)
    return (page + 0.05 * torch.randn(page.shape, generator=generator)).clamp(0, 1)


def spread(model, generator):
    """random weights whose activations neither vanish nor explode, normalisations that do something, scores that spread."""
    for name, value in model.state_dict().items():
        if name.endswith("running_var"):
            value.copy_(0.5 + torch.rand(value.shape, generator=generator))
        elif name.endswith("running_mean") or name.endswith("bias"):
            value.copy_(0.1 * torch.randn(value.shape, generator=generator))
        elif value.dim() == 1:
            value.copy_(0.5 + 0.5 * torch.rand(value.shape, generator=generator))
        elif value.dim() > 1:
            fan = value[0].numel()
            value.copy_(torch.randn(value.shape, generator=generator) * (2.0 / fan) ** 0.5)


def capture(trace, module, name, outputs=True):
    """notes the module's output (or input) under name, or name0, name1 … when it is several tensors."""
    def note(_, inputs, output):
        value = output if outputs else inputs[0]
        if isinstance(value, dict):
            value = list(value.values())
        if isinstance(value, (list, tuple)):
            for i, v in enumerate(value):
                trace[f"{name}{i}"] = v
        else:
            trace[name] = value
    module.register_forward_hook(note)


@torch.no_grad()
def trace_mask_rcnn(model, image):
    trace = {"image": image}
    model.transform.register_forward_hook(lambda m, i, o: trace.__setitem__("transformed", o[0].tensors))
    capture(trace, model.backbone.body, "stage")
    capture(trace, model.backbone.fpn, "level")

    def note_head(module, inputs, output):
        for i, (logits, displacements) in enumerate(zip(*output)):
            trace[f"objectness{i}"], trace[f"displacements{i}"] = logits, displacements
    model.rpn.head.register_forward_hook(note_head)
    model.rpn.register_forward_hook(lambda m, i, o: trace.__setitem__("proposals", o[0][0]))
    capture(trace, model.roi_heads.box_roi_pool, "box_pooled")

    def note_predictor(module, inputs, output):
        trace["class_logits"], trace["box_displacements"] = output
    model.roi_heads.box_predictor.register_forward_hook(note_predictor)
    capture(trace, model.roi_heads.mask_roi_pool, "mask_pooled")
    capture(trace, model.roi_heads.mask_predictor, "mask_logits")
    model.roi_heads.register_forward_hook(lambda m, i, o: trace.__setitem__("found", o[0][0]["boxes"].clone()))
    begin = time.time()
    result = model([image])[0]
    seconds = time.time() - begin
    trace["boxes"], trace["masks"] = result["boxes"], (result["masks"] > 0.5).float()
    return {name: value.numpy().astype(np.float32) for name, value in trace.items()}, seconds


def make_mask_rcnn(tiny, generator):
    if tiny:
        model, facts = backbones.compact_mask_rcnn(widths=(6, 8, 10, 12), pyramid=8, hidden=24, mask_convs=2, shorter=96,
                                                   longer=160, proposals=40, detections=10)
    else:
        model = torchvision.models.detection.maskrcnn_resnet50_fpn(weights=None, weights_backbone=None, num_classes=2)
        facts = {}
    model.eval()
    spread(model, generator)
    # Residual sums grow from block to block; small displacements and well separated scores keep the end stable.
    state = model.state_dict()
    for name, value in state.items():
        if name.endswith("bn3.weight") or (tiny and name.endswith("bn2.weight") and "layer" in name):
            value.mul_(0.3)
    for name in ("rpn.head.cls_logits.weight", "roi_heads.box_predictor.cls_score.weight"):
        state[name].mul_(0.2)
    for name in ("rpn.head.bbox_pred.weight", "roi_heads.box_predictor.bbox_pred.weight"):
        state[name].mul_(0.02)
    return model, {"model": "pantin.mask_rcnn", "version": "1", **facts}


@torch.no_grad()
def trace_sketch_parse(model, image):
    trace = {}
    begin = time.time()
    model((255 * (image - 0.5))[None], trace)
    seconds = time.time() - begin
    return {name: value.numpy().astype(np.float32) for name, value in trace.items()}, seconds


def make_sketch_parse(tiny, generator):
    model = sketch_parse.SketchParse(2, (1, 1, 2, 2), (6, 5), 2, (12, 8, 6)) if tiny else sketch_parse.SketchParse()
    model.eval()
    spread(model, generator)
    for name, value in model.state_dict().items():
        if name.endswith("bn3.weight"):
            value.mul_(0.3)
        if "conv1.weight" in name and value.shape[1] == 3:
            value.mul_(0.02)                                     # the input's range is 255, not 1
    facts = {"model": "pantin.sketch_parse", "version": "1"}
    if tiny:
        facts |= {"input": "97", "experts": "land,air",
                  "parts": "background,head,body,limb,tail,wing;background,body,head,limb,wing"}
    return model, facts


def tensors_of(model):
    return {name: value.numpy().astype(np.float32) for name, value in model.state_dict().items()
            if not name.endswith("num_batches_tracked")}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("network", choices=["mask-rcnn", "sketch-parse"])
    parser.add_argument("--binary")
    parser.add_argument("--tiny", nargs=2, metavar=("WEIGHTS", "TRACE"))
    parser.add_argument("--size", nargs=2, type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threads", type=int, default=1)
    args = parser.parse_args()
    torch.set_num_threads(args.threads)
    generator = torch.Generator().manual_seed(args.seed)
    rcnn = args.network == "mask-rcnn"
    size = args.size or ((120, 80) if args.tiny and rcnn else (97, 81) if args.tiny else (640, 480) if rcnn else (321, 321))
    model, facts = (make_mask_rcnn if rcnn else make_sketch_parse)(bool(args.tiny), generator)
    trace, seconds = (trace_mask_rcnn if rcnn else trace_sketch_parse)(model, scene(*size, generator)[:1 if args.tiny and rcnn else 3])
    print(f"PyTorch: {seconds:.2f} s, peak {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024} MiB")
    if args.tiny:
        write_safetensors(args.tiny[0], tensors_of(model), facts)
        write_safetensors(args.tiny[1], trace, {})
        return 0
    with tempfile.TemporaryDirectory() as folder:
        weights, steps = f"{folder}/weights.safetensors", f"{folder}/trace.safetensors"
        write_safetensors(weights, tensors_of(model), facts)
        write_safetensors(steps, trace, {})
        return subprocess.run([args.binary, args.network, weights, steps, str(args.threads)]).returncode


if __name__ == "__main__":
    sys.exit(main())
