# SPDX-License-Identifier: MIT
"""SketchParse (Sarvadevabhatla et al. 2017) in today's PyTorch, with the parameter names of its authors' state dictionary, and a router:
a linear layer on the mean of the first scale's shared features. For comparisons and for `--recipe thesis`; the network that is shipped is model.py."""
import torch
import torch.nn.functional as F
from torch import nn

SHARES = (1, 0.75, 0.5)


def smaller(image, share):
    size = [int((s - 1) * share + 1.5) for s in image.shape[2:]]
    return F.interpolate(image, size, mode="bilinear", align_corners=True)


class Bottleneck(nn.Module):
    def __init__(self, before, width, stride=1, dilation=1, shortcut=False):
        super().__init__()
        self.conv1, self.bn1 = nn.Conv2d(before, width, 1, stride, bias=False), nn.BatchNorm2d(width)
        self.conv2, self.bn2 = nn.Conv2d(width, width, 3, 1, dilation, dilation, bias=False), nn.BatchNorm2d(width)
        self.conv3, self.bn3 = nn.Conv2d(width, 4 * width, 1, bias=False), nn.BatchNorm2d(4 * width)
        if shortcut:
            self.downsample = nn.Sequential(nn.Conv2d(before, 4 * width, 1, stride, bias=False), nn.BatchNorm2d(4 * width))

    def forward(self, x):
        y = F.relu(self.bn1(self.conv1(x)))
        y = self.bn3(self.conv3(F.relu(self.bn2(self.conv2(y)))))
        return F.relu(y + (self.downsample(x) if hasattr(self, "downsample") else x))


class Classifiers(nn.Module):
    def __init__(self, width, parts):
        super().__init__()
        self.conv2d_list = nn.ModuleList(nn.Conv2d(width, parts, 3, 1, d, d) for d in (6, 12, 18, 24))

    def forward(self, x):
        return sum(conv(x) for conv in self.conv2d_list)


class Scale(nn.Module):
    def __init__(self, width, depths, parts):
        super().__init__()
        self.conv1, self.bn1 = nn.Conv2d(3, width, 7, 2, 3, bias=False), nn.BatchNorm2d(width)
        before = width
        for layer, (depth, stride, dilation) in enumerate(zip(depths, (1, 2, 1, 1), (1, 1, 2, 4)), 1):
            blocks, inner = [], width * 2 ** (layer - 1)
            for block in range(depth - (layer == 4)):
                blocks.append(Bottleneck(before, inner, stride if block == 0 else 1, dilation, block == 0))
                before = 4 * inner
            setattr(self, f"layer{layer}", nn.Sequential(*blocks))
        for expert, count in enumerate(parts):
            setattr(self, f"layer4_5_r{expert}", nn.Sequential(Bottleneck(before, before // 4, 1, 4)))
            setattr(self, f"layer5_r{expert}", Classifiers(before, count))
        self.width = before

    def shared(self, x):
        x = F.max_pool2d(F.relu(self.bn1(self.conv1(x))), 3, 2, 1, ceil_mode=True)
        return self.layer4(self.layer3(self.layer2(self.layer1(x))))

    def scores(self, shared, expert):
        return getattr(self, f"layer5_r{expert}")(getattr(self, f"layer4_5_r{expert}")(shared))


class Pose(nn.Module):
    def __init__(self, parts, kernel, widths):
        super().__init__()
        a, b, c = widths
        self.PoseC1 = nn.Sequential(nn.Conv2d(parts, a, 3, 2, 1, 2), nn.ReLU(), nn.Conv2d(a, b, 3, 2, 1, 2), nn.ReLU(),
                                    nn.Conv2d(b, c, kernel), nn.ReLU())
        self.PoseC2 = nn.Sequential(nn.Linear(c, 8))

    def forward(self, x):
        return self.PoseC2(self.PoseC1(x).flatten(1))


class SketchParse(nn.Module):
    def __init__(self, width=64, depths=(3, 4, 23, 3), parts=(5, 5, 7, 5, 9), kernel=9, pose=(128, 64, 32)):
        super().__init__()
        for scale in range(1, 4):
            setattr(self, f"Scale{scale}", Scale(width, depths, parts))
        for expert, count in enumerate(parts):
            setattr(self, f"pose_r{expert}", Pose(count, kernel, pose))
        self.router = nn.Linear(self.Scale1.width, len(parts))

    def forward(self, image, trace=None):
        """image (1, 3, h, w) -> fused scores, pose logits; trace: a dictionary that takes the steps."""
        trace = {} if trace is None else trace
        trace["image"] = image
        trace["shared0"] = self.Scale1.shared(image)
        trace["router"] = self.router(trace["shared0"].mean((2, 3))).softmax(1)
        expert = int(trace["router"].argmax())
        trace["expert"] = torch.tensor([float(expert)])
        fused = trace["scale0"] = self.Scale1.scores(trace["shared0"], expert)
        for k in (1, 2):
            scale = getattr(self, f"Scale{k + 1}")
            trace[f"input{k}"] = smaller(image, SHARES[k])
            trace[f"shared{k}"] = scale.shared(trace[f"input{k}"])
            trace[f"scale{k}"] = F.interpolate(scale.scores(trace[f"shared{k}"], expert), fused.shape[2:], mode="bilinear",
                                               align_corners=True)
            fused = torch.maximum(fused, trace[f"scale{k}"])
        trace["scores"] = fused
        trace["pose"] = getattr(self, f"pose_r{expert}")(fused)
        return fused, trace["pose"]
