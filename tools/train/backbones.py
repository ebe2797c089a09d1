# SPDX-License-Identifier: MIT
"""A compact Mask R-CNN: torchvision's modules on a small residual network. Module names are those of torchvision's state dictionary,
so src/detection/mask_rcnn reads it as it reads the full-size network."""
import collections

import torch
import torch.nn.functional as F
from torch import nn
from torchvision.models.detection import MaskRCNN
from torchvision.models.detection.anchor_utils import AnchorGenerator
from torchvision.models.detection.faster_rcnn import FastRCNNPredictor, TwoMLPHead
from torchvision.models.detection.mask_rcnn import MaskRCNNHeads, MaskRCNNPredictor
from torchvision.models.resnet import BasicBlock
from torchvision.ops import FeaturePyramidNetwork, MultiScaleRoIAlign
from torchvision.ops.feature_pyramid_network import LastLevelMaxPool

STRIDES = (4, 8, 16, 32)


class Body(nn.Module):
    """ResNet with one basic block per layer (He et al. 2016), the four layers' outputs by name."""

    def __init__(self, widths, channels=3, blocks=1, stem=5):
        super().__init__()
        self.conv1 = nn.Conv2d(channels, widths[0], stem, 2, stem // 2, bias=False)
        self.bn1 = nn.BatchNorm2d(widths[0])
        before = widths[0]
        for number, width in enumerate(widths, 1):
            layer = []
            for block in range(blocks):
                stride = 2 if number > 1 and block == 0 else 1
                shortcut = None
                if stride > 1 or before != width:
                    shortcut = nn.Sequential(nn.Conv2d(before, width, 1, stride, bias=False), nn.BatchNorm2d(width))
                layer.append(BasicBlock(before, width, stride, shortcut))
                before = width
            setattr(self, f"layer{number}", nn.Sequential(*layer))

    def forward(self, x):
        x = F.max_pool2d(F.relu(self.bn1(self.conv1(x))), 3, 2, 1)
        stages = collections.OrderedDict()
        for number in range(1, 5):
            x = getattr(self, f"layer{number}")(x)
            stages[str(number - 1)] = x
        return stages


class Backbone(nn.Module):
    def __init__(self, widths, pyramid, **options):
        super().__init__()
        self.body = Body(widths, **options)
        self.fpn = FeaturePyramidNetwork(list(widths), pyramid, LastLevelMaxPool())
        self.out_channels = pyramid

    def forward(self, x):
        return self.fpn(self.body(x))


def compact_mask_rcnn(widths=(16, 32, 64, 96), pyramid=48, hidden=128, mask_convs=2, shorter=320, longer=448, proposals=200,
                      detections=64, blocks=1):
    """the network and the metadata that its weight file carries."""
    sizes, ratios = (16, 32, 64, 128, 256), (0.5, 1.0, 2.0)
    backbone = Backbone(widths, pyramid, channels=1, blocks=blocks)
    model = MaskRCNN(
        backbone, num_classes=None, min_size=shorter, max_size=longer, image_mean=[0.0], image_std=[1.0],
        rpn_anchor_generator=AnchorGenerator(tuple((s,) for s in sizes), (ratios,) * len(sizes)),
        rpn_pre_nms_top_n_test=proposals, rpn_post_nms_top_n_test=proposals, box_detections_per_img=detections,
        box_roi_pool=MultiScaleRoIAlign(["0", "1", "2", "3"], 7, 2, canonical_scale=112),
        box_head=TwoMLPHead(pyramid * 49, hidden), box_predictor=FastRCNNPredictor(hidden, 2),
        mask_roi_pool=MultiScaleRoIAlign(["0", "1", "2", "3"], 14, 2, canonical_scale=112),
        mask_head=MaskRCNNHeads(pyramid, (pyramid,) * mask_convs, 1), mask_predictor=MaskRCNNPredictor(pyramid, pyramid, 2))
    facts = {"min_size": str(shorter), "max_size": str(longer), "image_mean": "0", "image_std": "1",
             "anchor_sizes": ",".join(map(str, sizes)), "anchor_ratios": ",".join(map(str, ratios)),
             "rpn_pre_nms_top_n": str(proposals), "rpn_post_nms_top_n": str(proposals),
             "box_detections_per_img": str(detections), "canonical_scale": "112"}
    return model, facts
