# SPDX-License-Identifier: MIT
"""The full-size networks of the thesis for `--recipe thesis`: torchvision's Mask R-CNN with ResNet-50 and a feature pyramid, SketchParse
with two experts, and their losses. Their checkpoints are state dictionaries for ../convert_torch.py."""
import torch
import torch.nn.functional as F
from torch import nn

import sketch_parse
from model import EXPERTS, LABELS, POSES

DEPTHS = {"50": (3, 4, 6, 3), "101": (3, 4, 23, 3)}              # ResNet-50: the thesis's words; 101: the published code (ERRATA 32)
IGNORE = 255
PARTS = {"ground": LABELS[:5], "winged": LABELS}                 # channels of the experts (ERRATA 34); the wing is the last label
POSE_WEIGHT = 1.0                                                # λ of the public code's full variant (ERRATA 40)
assert LABELS[5] == "wing"


def mask_rcnn():
    """two classes, random weights; normalisations are trained."""
    from torchvision.models.detection import maskrcnn_resnet50_fpn     # here: SketchParse does without torchvision
    return maskrcnn_resnet50_fpn(weights=None, weights_backbone=None, num_classes=2)


def two_experts(depth="50", width=64, kernel=9, pose=(128, 64, 32)):
    return sketch_parse.SketchParse(width, DEPTHS[depth], [len(PARTS[name]) for name in EXPERTS], kernel, pose)


def facts():
    """metadata of the weight file (docs/formats.md, "Weights")."""
    return {"experts": ",".join(EXPERTS), "parts": ";".join(",".join(PARTS[name]) for name in EXPERTS), "poses": ",".join(POSES)}


def keep_normalisations(model):
    """as in the public code, which starts from trained weights: statistics and factors of the normalisations stay."""
    for module in model.modules():
        if isinstance(module, nn.BatchNorm2d):
            module.eval()
            for parameter in module.parameters():
                parameter.requires_grad = False


def shrunk(labels, size):
    return F.interpolate(labels[None, None].float(), size, mode="nearest")[0].long()


def sketch_parse_losses(model, ink, labels, expert, pose):
    """of one drawing, ink (side, side) in [0, 1]: cross-entropy of the three scales and of their largest scores, of the pose, and of the
    router, which the public code does not train (ERRATA 33). An unknown label, a wing in a network without one, is not judged."""
    image = (255 * (1 - ink))[None, None].expand(1, 3, -1, -1)
    labels = torch.where(labels < len(PARTS[EXPERTS[expert]]), labels, torch.full_like(labels, IGNORE))
    first = model.Scale1.shared(image)
    scores = [model.Scale1.scores(first, expert)]
    for k in (1, 2):
        scale = getattr(model, f"Scale{k + 1}")
        scores.append(scale.scores(scale.shared(sketch_parse.smaller(image, sketch_parse.SHARES[k])), expert))
    shape = scores[0].shape[2:]
    scores[1], third = (F.interpolate(s, shape, mode="bilinear", align_corners=True) for s in scores[1:])
    scores.append(torch.maximum(torch.maximum(scores[0], scores[1]), third))
    parts = sum(F.cross_entropy(s, shrunk(labels, s.shape[2:]), ignore_index=IGNORE) for s in scores)
    losses = {"parts": parts, "router": F.cross_entropy(model.router(first.mean((2, 3))), torch.tensor([expert]))}
    if pose != IGNORE:
        losses["pose"] = POSE_WEIGHT * F.cross_entropy(getattr(model, f"pose_r{expert}")(scores[3]), torch.tensor([pose]))
    return losses
