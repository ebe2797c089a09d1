# SPDX-License-Identifier: MIT
"""The segmentation network: shared stem, router, one expert decoder per kind of character, pose head.

Two levels as in SketchParse (Sarvadevabhatla et al. 2017): a router chooses the expert whose decoder labels the parts. The
decoders have skip connections from every stage (U-Net, Ronneberger et al. 2015), so that thin limbs survive. The names of
the modules are the names of the tensors in the weight file; src/segmentation reads them.
"""
import os
import sys

import torch
import torch.nn.functional as F
from torch import nn

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from labels import NAMES as LABELS  # noqa: E402

EXPERTS = ["ground", "winged"]
TYPES = ["humanoid", "quadruped", "flying", "other"]     # other: fish, insects, heads alone, things
TURNS = 4                # quarter turns clockwise that bring a drawing upright: 0, 1, 2, 3
POSES = ["E", "NE", "N", "NW", "W", "SW", "S", "SE"]
INPUT = 256
WIDTHS = (20, 40, 80, 112)
DECODER = (64, 40, 20)
CONTEXTS = (2, 4)      # dilations of the residual blocks on the coarsest stage
REFINE = (1, 1, 0)     # residual blocks after each decoder stage


class Block(nn.Module):
    """convolution without bias, batch norm, ReLU."""

    def __init__(self, inputs, outputs, kernel=3, stride=1):
        super().__init__()
        self.conv = nn.Conv2d(inputs, outputs, kernel, stride, kernel // 2, bias=False)
        self.norm = nn.BatchNorm2d(outputs)

    def forward(self, x):
        return F.relu(self.norm(self.conv(x)))


class ConvNorm(nn.Module):
    def __init__(self, width, dilation):
        super().__init__()
        self.conv = nn.Conv2d(width, width, 3, 1, dilation, dilation, bias=False)
        self.norm = nn.BatchNorm2d(width)

    def forward(self, x):
        return self.norm(self.conv(x))


class Residual(nn.Module):
    """relu(x + b(relu(a(x)))), a and b = convolution and batch norm."""

    def __init__(self, width, dilation=1):
        super().__init__()
        self.a = ConvNorm(width, dilation)
        self.b = ConvNorm(width, dilation)

    def forward(self, x):
        return F.relu(x + self.b(F.relu(self.a(x))))


class Stem(nn.Module):
    def __init__(self, widths):
        super().__init__()
        inputs = 1
        for i, width in enumerate(widths, 1):
            setattr(self, f"down{i}", Block(inputs, width, 5 if i == 1 else 3, 2))
            setattr(self, f"res{i}", Residual(width))
            inputs = width

    def forward(self, x):
        features = []
        for i in range(1, 5):
            x = getattr(self, f"res{i}")(getattr(self, f"down{i}")(x))
            features.append(x)
        return features


def double(x):
    """bilinear enlargement by 2 (half-pixel centres); in float32, which is faster backwards than bfloat16."""
    return F.interpolate(x.float(), scale_factor=2, mode="bilinear", align_corners=False).to(x.dtype)


class Logits(nn.Module):
    """transposed convolution, kernel 2, stride 2, computed as a 1x1 convolution and a pixel shuffle (the same, but faster)."""

    def __init__(self, inputs, outputs):
        super().__init__()
        self.weight = nn.Parameter(torch.empty(inputs, outputs, 2, 2))
        self.bias = nn.Parameter(torch.zeros(outputs))
        nn.init.kaiming_uniform_(self.weight, a=5 ** 0.5)

    def forward(self, x):
        inputs, outputs = self.weight.shape[:2]
        kernel = self.weight.permute(1, 2, 3, 0).reshape(4 * outputs, inputs, 1, 1)
        return F.pixel_shuffle(F.conv2d(x, kernel, self.bias.repeat_interleave(4)), 2)


class Expert(nn.Module):
    def __init__(self, widths, decoder, contexts, refine):
        super().__init__()
        self.context = nn.Sequential(*(Residual(widths[3], dilation) for dilation in contexts))
        self.up3 = Block(widths[3] + widths[2], decoder[0])
        self.up2 = Block(decoder[0] + widths[1], decoder[1])
        self.up1 = Block(decoder[1] + widths[0], decoder[2])
        for stage, (width, count) in enumerate(zip(decoder, refine)):
            setattr(self, f"refine{3 - stage}", nn.Sequential(*(Residual(width) for _ in range(count))))
        self.logits = Logits(decoder[2], len(LABELS))

    def forward(self, features):
        x = self.context(features[3])
        for up, refine, skip in ((self.up3, self.refine3, features[2]), (self.up2, self.refine2, features[1]),
                                 (self.up1, self.refine1, features[0])):
            x = refine(up(torch.cat([double(x), skip], 1)))
        return self.logits(x)


class Router(nn.Module):
    def __init__(self, width):
        super().__init__()
        self.linear = nn.Linear(2 * width, len(EXPERTS))

    def forward(self, x):
        return self.linear(torch.cat([x.mean((2, 3)), x.amax((2, 3))], 1))


class Pose(nn.Module):
    def __init__(self, inputs, width):
        super().__init__()
        self.conv = Block(inputs, width, 3, 2)
        self.linear = nn.Linear(width, len(POSES))

    def forward(self, x):
        return self.linear(self.conv(x).mean((2, 3)))


class Pooled(nn.Module):
    """a head on mean and maximum of what a block sees."""

    def __init__(self, inputs, width, outputs):
        super().__init__()
        self.conv = Block(inputs, width, 3, 2)
        self.linear = nn.Linear(2 * width, outputs)

    def forward(self, x):
        x = self.conv(x)
        return self.linear(torch.cat([x.mean((2, 3)), x.amax((2, 3))], 1))


class Segmenter(nn.Module):
    def __init__(self, widths=WIDTHS, decoder=DECODER, size=INPUT, contexts=CONTEXTS, refine=REFINE):
        super().__init__()
        self.widths, self.decoder, self.size = tuple(widths), tuple(decoder), size
        self.contexts, self.refine = tuple(contexts), tuple(refine)
        self.stem = Stem(widths)
        self.router = Router(widths[3])
        self.pose = Pose(widths[3], decoder[0])
        self.kind = Pooled(widths[3], decoder[0], len(TYPES))       # how it moves; `type` is a method of every module
        self.turn = Pooled(widths[3], decoder[0], TURNS)            # trained by train_turn.py, not by train.py
        self.knows_turn = False
        self.experts = nn.ModuleDict({name: Expert(widths, decoder, contexts, refine) for name in EXPERTS})

    def forward(self, ink, experts=None):
        """ink (n,1,h,w) -> part logits, router logits, pose logits, type logits.

        experts: index of the expert of each image (training: decoders see their own images only, the part logits come in
        the order of `order`); None: both experts for every image, {name: logits}.
        """
        features = self.stem(ink)
        heads = self.router(features[3]), self.pose(features[3]), self.kind(features[3])
        if experts is None:
            return {name: expert(features) for name, expert in self.experts.items()}, *heads
        parts = {name: self.experts[name]([f[experts == i] for f in features])
                 for i, name in enumerate(EXPERTS) if bool((experts == i).any())}
        return parts, *heads


def widen(state, model):
    """the state dictionary of a model with fewer blocks, for `model`: the new blocks begin as the identity, so that training goes on
    where it was."""
    result = dict(model.state_dict())
    for name, value in state.items():                            # a single context block was no sequence
        result[name.replace(".context.a.", ".context.0.a.").replace(".context.b.", ".context.0.b.")] = value
    for name in result:
        if name.endswith(".b.norm.weight") and name not in state and name.replace(".context.0.", ".context.") not in state:
            result[name] = torch.zeros_like(result[name])
    return result


def metadata(model):
    def listed(numbers):
        return ",".join(map(str, numbers))
    facts = {"model": "pantin.segmenter", "version": "2", "input": str(model.size), "widths": listed(model.widths),
            "decoder": listed(model.decoder), "contexts": listed(model.contexts), "refine": listed(model.refine),
            "experts": ",".join(EXPERTS), "labels": ",".join(LABELS),
            "poses": ",".join(POSES), "types": ",".join(TYPES)}
    return {**facts, "turns": ",".join(str(90 * k) for k in range(TURNS))} if model.knows_turn else facts
