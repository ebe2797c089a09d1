# SPDX-License-Identifier: MIT
"""The arithmetic of networks on integers (docs/formats.md, "Weights"), after Jacob et al. 2018: an activation is a byte q and stands for
s·(q − z), s and z being one number each for a tensor; weights are −63 … 63 with one scale for each output channel. 7 bits of weight, so
that two products of a weight and a byte fit the 16 bits of the instructions that add them in pairs.

A layer adds weight·byte in 32 bits; its result is (sum·multiplier + residual·R + offset) >> shift in 64 bits, cut to a byte, or a
number with 16 fraction bits where a real one is wanted. No rounding is left to the machine.
"""
import collections

import numpy as np
import torch
import torch.nn.functional as F

WEIGHT_LIMIT = 63
BYTE = 255
FRACTION_BITS = 16                                  # of real results
SHIFTS = range(62, 0, -1)

Scale = collections.namedtuple("Scale", "step zero")     # real = step·(byte − zero)
REAL = Scale(2.0 ** -FRACTION_BITS, 0)                   # of a result that is no byte


def linear_map(weight, x, stride=1, dilation=1, transposed=False, padding=0):
    """the sums of a convolution (its border filled with `padding`, so that the size stays, over the stride), of a transposed convolution
    of kernel and stride 2, or of a matrix."""
    if weight.dim() == 2:
        return x.flatten(1) @ weight.T
    if transposed:
        return F.conv_transpose2d(x, weight, stride=2)
    border = weight.shape[-1] // 2 * dilation
    return F.conv2d(F.pad(x, 4 * [border], value=padding), weight, None, stride, 0, dilation)


def along(values, x):
    """one number for each channel, to be combined with x (n, channels, …)."""
    return values.view(-1, *(1,) * (x.dim() - 2))


def to_byte(values, scale):
    return np.clip(np.rint(values / scale.step) + scale.zero, 0, BYTE)


def byte_scale(values):
    """step and zero of least squared error for samples of a tensor. What is never negative has the zero 0. Clipping the rarest values
    can pay, because all others are told apart more finely."""
    low, high = min(0.0, float(values.min())), max(float(values.max()), 1e-6)
    cuts = np.geomspace(0.2, 1, 16 if low < 0 else 48)
    candidates = {}
    for top in cuts * high:
        for bottom in cuts * low if low < 0 else [0.0]:
            step = (top - bottom) / BYTE
            scale = Scale(step, int(np.rint(-bottom / step)))
            candidates[scale] = np.mean((step * (to_byte(values, scale) - scale.zero) - values) ** 2)
    return min(candidates, key=candidates.get)


def round_weights(rows):
    """rows (outputs, inputs) -> whole numbers and the step of each row, of least squared error among steps that reach the largest weight
    or fall short of it."""
    best, steps = np.full(len(rows), np.inf), np.zeros(len(rows))
    largest = np.abs(rows).max(1) / WEIGHT_LIMIT

    def rounded(steps):
        safe = np.where(steps > 0, steps, 1)[:, None]
        return np.clip(np.rint(rows / safe), -WEIGHT_LIMIT, WEIGHT_LIMIT)
    for share in np.linspace(0.5, 1.02, 53):
        error = ((share * largest[:, None] * rounded(share * largest) - rows) ** 2).sum(1)
        better = error < best
        best, steps = np.where(better, error, best), np.where(better, share * largest, steps)
    return rounded(steps).astype(np.int64), steps


def requantisation(weights, ratios, residual_ratio, constants, zero, residual_zero):
    """multiplier, R, offset and shift: the largest shift with which every number keeps its bounds. ratios: what a unit of the sum is in
    units of the result; constants: what a channel gets in any case, in the same units."""
    sums = weights.sum(1)
    largest = [BYTE * int(total) for total in np.abs(weights).sum(1)]
    assert max(largest) < 2 ** 31
    for shift in SHIFTS:
        one = 2.0 ** shift
        multiplier, residual = [int(round(ratio * one)) for ratio in ratios], int(round(residual_ratio * one))
        offset = [int(round(constant * one)) - m * zero * int(total) - residual * residual_zero + 2 ** (shift - 1)
                  for constant, m, total in zip(constants, multiplier, sums)]
        reach = max(a * m + BYTE * residual + abs(b) for a, m, b in zip(largest, multiplier, offset))
        if max(*multiplier, residual) < 2 ** 31 and reach < min(2 ** 62, 2 ** (31 + shift)):
            return multiplier, residual, offset, shift
    raise ValueError("no shift keeps the numbers of the layer within their bounds")


def quantised(weight, bias, inputs, result=REAL, residual=None, transposed=False):
    """the tensors of a layer: inputs are the scales of its input's channel groups and their numbers of channels, all of one zero."""
    weight = np.asarray(weight, np.float64)
    rows = np.swapaxes(weight, 0, 1) if transposed else weight
    step, zero = max(scale.step for scale, _ in inputs), inputs[0][0].zero
    assert all(scale.zero == zero for scale, _ in inputs)
    if len(inputs) > 1:                                  # side by side: the finer group's weights become smaller
        factors = np.concatenate([np.full(channels, scale.step / step) for scale, channels in inputs])
        rows = rows * factors.reshape(1, -1, *(1,) * (rows.ndim - 2))
    flat, steps = round_weights(rows.reshape(len(rows), -1))
    residual_ratio, residual_zero = (residual.step / result.step, residual.zero) if residual else (0.0, 0)
    multiplier, added, offset, shift = requantisation(flat, steps * step / result.step, residual_ratio,
                                                      np.asarray(bias, np.float64) / result.step + result.zero, zero, residual_zero)
    whole = flat.reshape(rows.shape)
    tensors = {"weight": (np.swapaxes(whole, 0, 1) if transposed else whole).astype(np.int8), "multiplier": np.array(multiplier, np.int32),
               "offset": np.array(offset, np.int64), "shift": np.array([shift], np.int32), "zero": np.array([zero], np.uint8)}
    return tensors | ({"residual": np.array([added], np.int32)} if residual else {})


class IntegerLayer:
    """a layer of an integer file, computed exactly: torch's convolutions want floats, so bytes and weights are whole numbers in float32
    where no sum can reach 2^24, else in float64."""

    def __init__(self, tensors):
        magnitudes = np.abs(tensors["weight"].astype(np.int64)).reshape(*tensors["weight"].shape[:2], -1).sum(2)
        reach = BYTE * max(magnitudes.sum(0).max(), magnitudes.sum(1).max())          # whichever axis the outputs are
        self.weight = torch.from_numpy(tensors["weight"].astype(np.float32 if reach < 2 ** 24 else np.float64))
        self.multiplier, self.offset = (torch.from_numpy(tensors[key].astype(np.int64)) for key in ("multiplier", "offset"))
        self.shift, self.zero = int(tensors["shift"][0]), int(tensors["zero"][0])
        self.residual = int(tensors["residual"][0]) if "residual" in tensors else None

    def forward(self, x, residual=None, real=False, **geometry):
        """bytes -> bytes, or numbers with 16 fraction bits."""
        assert (residual is None) == (self.residual is None)
        sums = linear_map(self.weight, x.to(self.weight.dtype), padding=self.zero, **geometry).to(torch.int64)
        total = sums * along(self.multiplier, sums) + along(self.offset, sums)
        if residual is not None:
            total = total + residual.to(torch.int64) * self.residual
        shifted = total >> self.shift
        return shifted if real else shifted.clamp(0, BYTE).float()
