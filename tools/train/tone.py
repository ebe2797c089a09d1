# SPDX-License-Identifier: MIT
"""Picture to ink darkness in [0, 1], the same steps as ink_darkness() of src/image/tone.cpp: local paper brightness from block
percentiles, closing over filled areas, darkness relative to the paper and to the darkest strokes."""
import numpy as np
from scipy import ndimage as ndi

MIN_BLOCK, BLOCKS_PER_SIDE, PAPER_PERCENT = 8, 64, 80
FILL_RATIO, SHADOW_STEP = 0.7, 0.9
DARK_PIXEL, DARK_PERCENT, MIN_DARK_LEVEL = 0.15, 95, 0.25


def paper_blocks(grey, block):
    h, w = grey.shape
    padded = np.pad(grey.astype(np.int32), ((0, -h % block), (0, -w % block)), constant_values=999)       # 999 sorts last
    rows, columns = padded.shape[0] // block, padded.shape[1] // block
    values = np.sort(padded.reshape(rows, block, columns, block).swapaxes(1, 2).reshape(rows, columns, -1), -1)
    counts = (values < 999).sum(-1)
    brightness = np.take_along_axis(values, (-(-PAPER_PERCENT * counts // 100) - 1)[..., None], -1)[..., 0].astype(np.float32)
    window = 2 * max(1, max(brightness.shape) // 2) + 1
    closed = ndi.minimum_filter(ndi.maximum_filter(brightness, window, mode="nearest"), window, mode="nearest")
    paper, count = brightness >= FILL_RATIO * closed, -1
    while paper.sum() != count:                       # shadows fall off smoothly, filled areas begin with an edge
        count = paper.sum()
        lightest_step = ndi.minimum_filter(np.where(paper, brightness, np.inf), 3, mode="nearest")
        paper |= brightness >= SHADOW_STEP * lightest_step
    brightness = np.maximum(np.where(paper, brightness, closed), 1)
    return ndi.convolve(brightness, np.outer([1, 2, 1], [1, 2, 1]).astype(np.float32) / 16, mode="nearest")


def ink_darkness(picture):
    """(h, w) grey or (h, w, 3) RGB uint8 -> (h, w) float32, 0 paper, 1 the darkest strokes."""
    grey = picture if picture.ndim == 2 else (picture @ np.array([299, 587, 114]) + 500) // 1000
    h, w = grey.shape
    block = max(MIN_BLOCK, -(-max(h, w) // BLOCKS_PER_SIDE))
    blocks = paper_blocks(grey, block)
    ys, xs = ((np.arange(n) + 0.5) / block - 0.5 for n in (h, w))
    ys, xs = np.clip(ys, 0, blocks.shape[0] - 1), np.clip(xs, 0, blocks.shape[1] - 1)
    paper = ndi.map_coordinates(blocks, np.meshgrid(ys, xs, indexing="ij"), order=1, mode="nearest")
    darkness = np.clip(1 - grey / paper, 0, 1).astype(np.float32)
    strokes = darkness[darkness > DARK_PIXEL]
    level = max(MIN_DARK_LEVEL, np.percentile(strokes, DARK_PERCENT)) if len(strokes) else MIN_DARK_LEVEL
    return np.minimum(1, darkness / level)
