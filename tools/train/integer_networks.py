# SPDX-License-Identifier: MIT
"""Both networks once, as a sequence of layers, and two ways to run it: Observed, on real numbers, which notes the values of every tensor
and what each layer was given; Emulated, on the integers of a weight file, whose every byte is the program's.

Layers have the names of the float file's tensors without ".weight".
"""
import collections
import re

import numpy as np
import torch
import torch.nn.functional as F
from torch import nn

import backbones
import integers
from model import double

NORM_EPSILON = 1e-5
LEVEL = "level"                  # the key of the pyramid's levels, which share a scale: the heads see all of them


# The networks. `run` is Observed or Emulated; what is handed from one layer to the next is its own affair.

def residual_block(run, name, x, dilation=1):
    inner = run.convolve(f"{name}.a.conv", x, dilation=dilation)
    return run.convolve(f"{name}.b.conv", inner, dilation=dilation, residual=x)


def stem(run, ink):
    x, features = run.input(ink), []
    for i in range(1, 5):
        x = residual_block(run, f"stem.res{i}", run.convolve(f"stem.down{i}.conv", x, stride=2))
        features.append(x)
    return features


def segmenter_heads(run, x):
    """logits by the head's name."""
    heads = {"router": run.head("router.linear", x)}
    for name in ("pose", "kind", "turn"):
        if f"{name}.linear" in run:
            heads[name] = run.head(f"{name}.linear", run.convolve(f"{name}.conv.conv", x, stride=2))
    return heads


def expert(run, name, features, contexts, refine):
    x, name = features[3], f"experts.{name}"
    for i, dilation in enumerate(contexts):
        x = residual_block(run, f"{name}.context.{i}", x, dilation)
    for i, blocks in enumerate(refine):
        stage = 3 - i
        x = run.convolve(f"{name}.up{stage}.conv", run.concatenate(run.double(x), features[stage - 1]))
        for k in range(blocks):
            x = residual_block(run, f"{name}.refine{stage}.{k}", x)
    return run.convolve(f"{name}.logits", x, real=True, transposed=True)


def basic_block(run, name, x, stride):
    shortcut = run.convolve(f"{name}.downsample.0", x, stride=stride, relu=False) if f"{name}.downsample.0" in run else x
    return run.convolve(f"{name}.conv2", run.convolve(f"{name}.conv1", x, stride=stride), residual=shortcut)


def detector_stages(run, page):
    x, stages = run.max_pool(run.convolve("backbone.body.conv1", run.input(page), stride=2)), []
    for number in range(1, 5):
        block = 0
        while f"backbone.body.layer{number}.{block}.conv1" in run:
            x = basic_block(run, f"backbone.body.layer{number}.{block}", x, 2 if number > 1 and block == 0 else 1)
            block += 1
        stages.append(x)
    return stages


def pyramid(run, stages):
    """the levels, finest first."""
    levels, merged = [], None
    for i in reversed(range(4)):
        above = None if merged is None else run.nearest(merged, stages[i])
        merged = run.convolve(f"backbone.fpn.inner_blocks.{i}.0", stages[i], relu=False, residual=above)
        levels.insert(0, run.convolve(f"backbone.fpn.layer_blocks.{i}.0", merged, relu=False, key=LEVEL))
    return levels + [run.every_second(levels[-1])]


def proposals(run, level):
    x = run.convolve("rpn.head.conv.0.0", level)
    return run.convolve("rpn.head.cls_logits", x, real=True), run.convolve("rpn.head.bbox_pred", x, real=True)


def box_features(run, pooled):
    return run.convolve("roi_heads.box_head.fc7", run.convolve("roi_heads.box_head.fc6", pooled))


def box_predictions(run, x):
    return tuple(run.convolve(f"roi_heads.box_predictor.{name}", x, real=True) for name in ("cls_score", "bbox_pred"))


def mask_logits(run, x):
    i = 0
    while f"roi_heads.mask_head.{i}.0" in run:
        x, i = run.convolve(f"roi_heads.mask_head.{i}.0", x), i + 1
    x = run.convolve("roi_heads.mask_predictor.conv5_mask", x, transposed=True)
    return run.convolve("roi_heads.mask_predictor.mask_fcn_logits", x, real=True)


# The two ways to run them.

def folded(tensors):
    """{layer: (weight, bias)} in float64, batch normalisation folded in (Ioffe & Szegedy 2015)."""
    layers = {}
    for name in (key.removesuffix(".weight") for key, value in tensors.items() if key.endswith(".weight") and value.ndim > 1):
        weight = tensors[f"{name}.weight"].astype(np.float64)
        candidates = re.sub("conv$", "norm", name), re.sub(r"conv(\d)$", r"bn\1", name), re.sub("0$", "1", name)
        norm = next((c for c in candidates if f"{c}.running_var" in tensors), None)
        if norm:
            gamma, beta, mean, variance = (tensors[f"{norm}.{key}"].astype(np.float64)
                                           for key in ("weight", "bias", "running_mean", "running_var"))
            gain = gamma / np.sqrt(variance + NORM_EPSILON)
            layers[name] = weight * gain.reshape(-1, *(1,) * (weight.ndim - 1)), beta - gain * mean
        else:
            layers[name] = weight, tensors[f"{name}.bias"].astype(np.float64)
    return layers


def pooled(x, columns):
    """mean of each channel, and its maximum where the head has columns for both."""
    mean = x.mean((2, 3))
    return mean if columns == x.shape[1] else torch.cat([mean, x.amax((2, 3))], 1)


Value = collections.namedtuple("Value", "data groups")             # groups: (key of the scale, channels), more than one side by side
Layer = collections.namedtuple("Layer", "inputs key residual transposed")


class Observed:
    """on real numbers. samples: {key: arrays of values}; layers: {name: Layer}; heads: {name: key of the input}."""

    def __init__(self, tensors, rng, samples_of_tensor=4096):
        self.weights = {name: tuple(torch.from_numpy(part.astype(np.float32)) for part in parts) for name, parts in folded(tensors).items()}
        self.rng, self.count = rng, samples_of_tensor
        self.samples, self.layers, self.heads = collections.defaultdict(list), {}, {}

    def __contains__(self, name):
        return name in self.weights

    def value(self, data, key):
        return Value(data, [(key, data.shape[1])])

    def input(self, x):
        return self.value(x, "input")

    def convolve(self, name, x, relu=True, residual=None, key=None, real=False, **geometry):
        weight, bias = self.weights[name]
        result = integers.linear_map(weight, x.data, **geometry)
        result = result + integers.along(bias, result)
        key = None if real else key or name
        self.layers[name] = Layer(x.groups, key, residual.groups[0][0] if residual else None, geometry.get("transposed", False))
        if real:
            return result
        if residual:
            result = result + residual.data
        result = F.relu(result) if relu else result
        flat = result.numpy().ravel()
        self.samples[key].append(flat[self.rng.integers(0, len(flat), self.count)] if len(flat) > self.count else flat.copy())
        return self.value(result, key)

    def head(self, name, x):
        weight, bias = self.weights[name]
        self.heads[name] = x.groups[0][0]
        return F.linear(pooled(x.data, weight.shape[1]), weight, bias)

    def double(self, x):
        return x._replace(data=double(x.data))

    def concatenate(self, *parts):
        return Value(torch.cat([part.data for part in parts], 1), [group for part in parts for group in part.groups])

    def nearest(self, x, like):
        return x._replace(data=F.interpolate(x.data, size=like.data.shape[-2:], mode="nearest"))

    def max_pool(self, x):
        return x._replace(data=F.max_pool2d(x.data, 3, 2, 1))

    def every_second(self, x):
        return x._replace(data=x.data[:, :, ::2, ::2])

    def tensor(self, x):
        return x.data

    def pool_regions(self, pool, levels, boxes, shapes):
        return pool(levels, boxes, shapes)


class Emulated:
    """on the integers of a file. trace: if a dictionary, the results of all layers, by name (name#2 of the second time)."""

    def __init__(self, tensors, trace=None):
        names = [key.removesuffix(".multiplier") for key in tensors if key.endswith(".multiplier")]
        parts = ("weight", "multiplier", "offset", "shift", "zero", "residual")
        self.layers = {name: integers.IntegerLayer({part: tensors[f"{name}.{part}"] for part in parts if f"{name}.{part}" in tensors})
                       for name in names}
        self.heads = {key.removesuffix(".weight"): tuple(torch.from_numpy(tensors[key.replace("weight", part)].copy()) for part in ("weight", "bias"))
                      for key in tensors if key.endswith(".linear.weight")}
        self.trace = trace

    def __contains__(self, name):
        return name in self.layers or name in self.heads

    def note(self, name, values):
        if self.trace is not None:
            times = sum(key.split("#")[0] == name for key in self.trace)
            self.trace[name if times == 0 else f"{name}#{times + 1}"] = values.numpy()

    def value(self, data, key):
        return data

    def input(self, x):
        result = torch.floor(integers.BYTE * x + 0.5).clamp(0, integers.BYTE)
        self.note("bytes.input", result.to(torch.uint8))
        return result

    def convolve(self, name, x, relu=True, residual=None, key=None, real=False, **geometry):
        """relu needs no step of its own: it is the cut at the byte 0 where 0 stands for zero."""
        result = self.layers[name].forward(x, residual, real, **geometry)
        self.note(f"fixed.{name}" if real else f"bytes.{name}", result.to(torch.int32 if real else torch.uint8))
        return result.float() * integers.REAL.step if real else result

    def head(self, name, x):
        weight, bias = self.heads[name]
        return F.linear(pooled(x, weight.shape[1]), weight, bias)

    def double(self, x):
        """(9a + 3b + 3c + d + 8) >> 4, a the nearest pixel; along one axis 3·near + far, pixels outside as the border's."""
        for axis in (2, 3):
            before, after = (x.index_select(axis, (torch.arange(x.shape[axis]) + by).clamp(0, x.shape[axis] - 1)) for by in (-1, 1))
            x = torch.stack([3 * x + before, 3 * x + after], axis + 1).flatten(axis, axis + 1)
        return torch.floor((x + 8) / 16)

    def concatenate(self, *parts):
        return torch.cat(parts, 1)

    def nearest(self, x, like):
        return F.interpolate(x, size=like.shape[-2:], mode="nearest")

    def max_pool(self, x):
        return F.max_pool2d(x, 3, 2, 1)

    def every_second(self, x):
        return x[:, :, ::2, ::2]

    def tensor(self, x):
        return x

    def pool_regions(self, pool, levels, boxes, shapes):
        """means of bilinear samples in float32, rounded to bytes; samples outside the page are the zero."""
        zero = self.layers["rpn.head.conv.0.0"].zero
        means = pool(collections.OrderedDict((name, level - zero) for name, level in levels.items()), boxes, shapes)
        return torch.floor(means + zero + 0.5).clamp(0, integers.BYTE)


class Decoded(dict):
    """what the experts say; each is run when it is asked."""

    def __init__(self, decode):
        super().__init__()
        self.decode = decode

    def __missing__(self, name):
        self[name] = self.decode(name)
        return self[name]


class IntegerSegmenter:
    """answers as model.Segmenter does."""

    def __init__(self, tensors, facts, trace=None):
        self.run, self.size = Emulated(tensors, trace), int(facts["input"])
        self.contexts, self.refine = (tuple(map(int, facts[key].split(","))) for key in ("contexts", "refine"))

    def __call__(self, ink):
        features = stem(self.run, ink)
        self.heads = segmenter_heads(self.run, features[3])
        parts = Decoded(lambda name: expert(self.run, name, features, self.contexts, self.refine))
        return parts, self.heads["router"], self.heads["pose"], self.heads["kind"]


class Call(nn.Module):
    """a function in a module's place."""

    def __init__(self, function):
        super().__init__()
        self.forward = function


def mask_rcnn(run, tensors, facts):
    """torchvision's Mask R-CNN with the layers of `run` in the place of its own; proposals, suppression and pasting stay torchvision's."""
    def extent(name, axis):
        return tensors[f"{name}.weight"].shape[axis]
    convs = sum(re.fullmatch(r"roi_heads\.mask_head\.\d+\.0\.weight", name) is not None for name in tensors)
    blocks = sum(re.fullmatch(r"backbone\.body\.layer1\.\d+\.conv1\.weight", name) is not None for name in tensors)
    model, _ = backbones.compact_mask_rcnn(
        [extent(f"backbone.body.layer{k}.0.conv2", 0) for k in range(1, 5)], extent("backbone.fpn.inner_blocks.0.0", 0),
        extent("roi_heads.box_head.fc6", 0), convs, int(facts["min_size"]), int(facts["max_size"]), int(facts["rpn_pre_nms_top_n"]),
        int(facts["box_detections_per_img"]), blocks)

    def named(values):
        return collections.OrderedDict(zip(("0", "1", "2", "3", "pool"), values))
    box_pool, mask_pool = model.roi_heads.box_roi_pool, model.roi_heads.mask_roi_pool
    model.backbone.body = Call(lambda pages: named(detector_stages(run, pages)))
    model.backbone.fpn = Call(lambda stages: named(map(run.tensor, pyramid(run, list(stages.values())))))
    model.rpn.head = Call(lambda levels: tuple(map(list, zip(*(proposals(run, run.value(level, LEVEL)) for level in levels)))))
    model.roi_heads.box_roi_pool = Call(lambda *seen: run.pool_regions(box_pool, *seen))
    model.roi_heads.box_head = Call(lambda x: box_features(run, run.value(x, LEVEL)))
    model.roi_heads.box_predictor = Call(lambda x: box_predictions(run, x))
    model.roi_heads.mask_roi_pool = Call(lambda *seen: run.pool_regions(mask_pool, *seen))
    model.roi_heads.mask_head = Call(lambda x: run.value(x, LEVEL))
    model.roi_heads.mask_predictor = Call(lambda x: mask_logits(run, x))
    return model.eval()
