# SPDX-License-Identifier: MIT
"""From a part label map to a drawing as a hand might have made it: many pens, open outlines, borders drawn only sometimes,
inner marks, light fills. The result is darkness (0 paper, 255 ink)."""
import cv2
import numpy as np
from scipy import ndimage as ndi

HEAD, BODY, LIMB, TAIL, WING = 1, 2, 3, 4, 5
FINE = 2                                          # the drawing is made at twice its size


def complete(labels):
    """closed silhouette, largest component, every pixel labelled (the convention of the ground truth)."""
    mask = cv2.morphologyEx((labels > 0).astype(np.uint8), cv2.MORPH_CLOSE, np.ones((5, 5), np.uint8))
    count, components, stats, _ = cv2.connectedComponentsWithStats(mask, connectivity=8)
    if count < 2:
        return np.zeros_like(labels)
    mask = ndi.binary_fill_holes(components == 1 + stats[1:, cv2.CC_STAT_AREA].argmax())
    nearest = ndi.distance_transform_edt(labels == 0, return_indices=True)[1]
    return np.where(mask, labels[tuple(nearest)], 0).astype(np.uint8)


def smooth_noise(rng, shape, cells, amplitude):
    grid = rng.normal(0, amplitude, (cells, cells)).astype(np.float32)
    return cv2.resize(grid, shape[::-1], interpolation=cv2.INTER_CUBIC)


def deform(labels, rng, size):
    """random shape: rotation, anisotropic scale, shear and a broad elastic warp; the box fills 84 to 97 % of a size x size frame."""
    ys, xs = np.nonzero(labels)
    centre = np.array([xs.min() + xs.max(), ys.min() + ys.max()]) / 2
    angle = np.radians(rng.normal(0, 6))
    stretch = np.diag(np.exp(rng.normal(0, 0.12, 2)))
    shear = np.array([[1, rng.normal(0, 0.08)], [rng.normal(0, 0.05), 1]])
    matrix = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]) @ shear @ stretch
    points = (np.stack([xs, ys], 1) - centre) @ matrix.T
    low, high = points.min(0), points.max(0)
    scale = size * rng.uniform(0.84, 0.95) / max(high - low)
    inverse = np.linalg.inv(matrix) / scale
    grid = np.stack(np.meshgrid(np.arange(size), np.arange(size)), -1).reshape(-1, 2) - size / 2
    source = (grid + scale * (low + high) / 2) @ inverse.T + centre
    source = source.reshape(size, size, 2).astype(np.float32)
    amplitude = abs(rng.normal(0, 0.012)) / scale * size
    for axis in range(2):
        source[..., axis] += smooth_noise(rng, (size, size), int(rng.integers(4, 7)), amplitude)
    smooth = [cv2.remap(cv2.GaussianBlur((labels == k).astype(np.float32), (0, 0), 1.0), source[..., 0], source[..., 1],
                        cv2.INTER_LINEAR) for k in range(6)]
    smooth[0] = cv2.remap(cv2.GaussianBlur((labels == 0).astype(np.float32), (0, 0), 1.0), source[..., 0], source[..., 1],
                          cv2.INTER_LINEAR, borderValue=1)
    return complete(np.argmax(smooth, 0).astype(np.uint8))


class Pen:
    """draws polylines with one pen's width, wobble and pressure on a fine canvas."""

    def __init__(self, rng, shape, width):
        self.rng, self.shape, self.width = rng, shape, width * FINE
        self.canvas = np.zeros(shape, np.uint8)
        self.jitter = rng.choice([0.0, 0.4, 0.8, 1.3], p=[0.15, 0.35, 0.35, 0.15]) * FINE
        self.pressure = rng.random() < 0.25
        self.renew()

    def renew(self):
        cells = int(self.rng.integers(7, 16))
        self.field = [smooth_noise(self.rng, self.shape, cells, self.jitter) for _ in range(2)]

    def line(self, points, closed=False, width=None, strength=255):
        p = np.asarray(points, np.float32).reshape(-1, 2)
        if len(p) == 0:
            return
        x = np.clip(p.astype(int), 0, np.array(self.shape[::-1]) - 1)
        p = p + np.stack([f[x[:, 1], x[:, 0]] for f in self.field], 1)
        width = self.width if width is None else width
        if not self.pressure or len(p) < 20:
            pieces, widths = [p], [width]
        else:
            count = max(1, len(p) // 40)
            pieces = [p[k * len(p) // count:(k + 1) * len(p) // count + 1] for k in range(count)]
            widths = width * np.clip(1 + 0.5 * np.convolve(self.rng.normal(0, 1, count + 4), np.ones(5) / 5, "valid"), 0.5, 1.6)
            if closed:
                pieces[-1] = np.concatenate([pieces[-1], p[:1]])
                closed = False
        for piece, w in zip(pieces, widths):
            q = np.round(piece * 16).astype(np.int32).reshape(-1, 1, 2)
            cv2.polylines(self.canvas, [q], closed, int(strength), max(1, int(round(w))), cv2.LINE_AA, 4)


def kept_runs(count, rng, erase, seeds=None):
    """[a, b) runs of a contour of `count` points that stay when `erase` of it is rubbed out (around `seeds` if given)."""
    keep = np.ones(count, bool)
    runs = int(rng.integers(1, 6)) if seeds is None else len(seeds)
    starts = rng.integers(0, count, runs) if seeds is None else seeds
    for start in starts:
        length = int(count * erase / max(runs, 1))
        keep[(start - (length // 2 if seeds is not None else 0) + np.arange(length)) % count] = False
    first = int(np.argmin(keep))
    flags = np.roll(keep, -first).astype(int)
    edges = np.diff(np.r_[0, flags, 0])
    return first, list(zip(np.flatnonzero(edges == 1), np.flatnonzero(edges == -1)))


def limb_ends(contour, labels, rng):
    """contour indices at the far ends of limbs and tails: hands, feet and tail tips are often left open."""
    p = contour.reshape(-1, 2)
    part = labels[p[:, 1], p[:, 0]]
    inside = np.isin(part, (LIMB, TAIL))
    if not inside.any() or inside.all():
        return []
    ends, (found, count) = [], ndi.label(inside)
    for k in range(1, count + 1):
        run = np.flatnonzero(found == k)
        if len(run) > 25 and rng.random() < 0.7:
            chord = p[run[[0, -1]]].mean(0)
            ends.append(run[np.hypot(*(p[run] - chord).T).argmax()])
    return ends


def outlines(pen, labels, rng):
    style = rng.choice(["whole", "erased", "ends"], p=[0.5, 0.35, 0.15])
    twice = rng.random() < 0.12
    for contour in cv2.findContours((labels > 0).astype(np.uint8), cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)[0]:
        seeds = limb_ends(contour, labels, rng) if style == "ends" else None
        if style == "whole" or len(contour) < 100 or seeds == []:
            pen.line(contour, True)
        else:
            erase = rng.uniform(0.02, 0.2) if style == "erased" else rng.uniform(0.03, 0.1)
            first, runs = kept_runs(len(contour), rng, erase, seeds)
            points = np.roll(contour, -first, 0)
            for a, b in runs:
                if b - a > 6:
                    pen.line(points[a:b])
        if twice:
            pen.renew()
            first, runs = kept_runs(len(contour), rng, 0.3)
            points = np.roll(contour, -first, 0)
            for a, b in runs:
                pen.line(points[a:b])


def borders(pen, labels, rng):
    chance = rng.choice([0.0, 0.3, 0.55, 0.8, 1.0], p=[0.15, 0.25, 0.3, 0.15, 0.15])
    for a in range(1, 6):
        for b in range(a + 1, 6):
            border = cv2.dilate((labels == a).astype(np.uint8), np.ones((3, 3))) & (labels == b)
            for piece in cv2.findContours(border, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)[0]:
                if rng.random() < chance:
                    pen.line(piece[: int(len(piece) * rng.uniform(0.5, 1))] if rng.random() < 0.2 else piece)


def inside_points(mask, rng, count, depth):
    """random points at least `depth` inside the mask."""
    inner = np.argwhere(cv2.distanceTransform(mask.astype(np.uint8), cv2.DIST_L2, 3) > depth)
    return inner[rng.integers(0, len(inner), count)][:, ::-1] if len(inner) else np.zeros((0, 2), int)


def face(pen, labels, rng):
    head = labels == HEAD
    area = head.sum()
    if area < 200 * FINE * FINE:
        return
    radius = np.sqrt(area / np.pi)
    for x, y in inside_points(head, rng, int(rng.integers(1, 3)), 0.3 * radius):
        r = radius * rng.uniform(0.05, 0.2)
        arc = np.linspace(0, 2 * np.pi, 20)
        circle = np.stack([x + r * np.cos(arc), y + r * np.sin(arc)], 1)
        if rng.random() < 0.6:
            cv2.circle(pen.canvas, (int(x), int(y)), max(1, int(r * 0.6)), 255, -1, cv2.LINE_AA)
        if rng.random() < 0.5:
            pen.line(circle, True, pen.width * 0.8)
    if rng.random() < 0.6:
        for x, y in inside_points(head, rng, 1, 0.2 * radius):
            t = np.linspace(-1, 1, 16)[:, None]
            bend = rng.normal(0, 0.2) * radius
            along = np.array([[np.cos(a := rng.uniform(-0.6, 0.6)), np.sin(a)]])
            pen.line(np.array([[x, y]]) + t * along * radius * rng.uniform(0.15, 0.4) + np.c_[0 * t, bend * t * t])


def marks(pen, labels, rng):
    """stripes, hatching, spots or loose curves, clipped to one part."""
    part = rng.choice([BODY, BODY, WING, HEAD, LIMB, TAIL])
    mask = labels == part
    if mask.sum() < 300 * FINE * FINE:
        return
    ys, xs = np.nonzero(mask)
    extent = np.array([np.ptp(xs), np.ptp(ys)])
    layer, pen.canvas = pen.canvas, np.zeros(pen.shape, np.uint8)
    kind = rng.choice(["stripes", "hatch", "spots", "curves"])
    if kind in ("stripes", "hatch"):
        angle, step = rng.uniform(0, np.pi), extent.max() * rng.uniform(0.05, 0.25)
        along, across = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
        middle, reach = np.array([xs.mean(), ys.mean()]), extent.max()
        t = np.linspace(-1, 1, 60)[:, None]
        for k in np.arange(-reach, reach, step):
            if rng.random() < 0.85:
                centre = middle + across * (k + rng.normal(0, step * 0.15)) + along * rng.normal(0, reach * 0.1)
                pen.line(centre + t * along * reach * (rng.uniform(0.05, 0.3) if kind == "hatch" else 1))
    else:
        for x, y in inside_points(mask, rng, int(rng.integers(2, 9)), 2):
            r = extent.max() * rng.uniform(0.02, 0.12)
            t = np.linspace(0, rng.uniform(2, 6.3), 24)[:, None] + rng.uniform(0, 6.3)
            curve = np.c_[x + r * np.cos(t), y + r * rng.uniform(0.4, 1) * np.sin(t)]
            pen.line(curve, kind == "spots" and rng.random() < 0.7)
    shrink = cv2.erode(mask.astype(np.uint8), np.ones((3, 3)))
    pen.canvas = np.maximum(layer, pen.canvas * shrink)


def shading(labels, rng):
    """light fill per part, as with crayon or a soft pencil; not always inside the lines."""
    fill = np.zeros(labels.shape, np.float32)
    base = rng.uniform(0.08, 0.5)
    for part in range(1, 6):
        if rng.random() < 0.8:
            level = np.clip(base + rng.normal(0, 0.12), 0, 0.65)
            fill[labels == part] = level
    if rng.random() < 0.6:
        angle = rng.uniform(0, np.pi)
        y, x = np.mgrid[:labels.shape[0], :labels.shape[1]]
        period = rng.uniform(4, 12) * FINE
        wave = np.sin((x * np.cos(angle) + y * np.sin(angle)) * 2 * np.pi / period + smooth_noise(rng, labels.shape, 9, 2))
        fill *= np.clip(0.6 + 0.6 * wave, 0, 1)
    fill *= np.clip(1 + smooth_noise(rng, labels.shape, 24, 0.3), 0.2, 1.5)
    shift = rng.integers(-4, 5, 2)
    return np.clip(np.roll(cv2.GaussianBlur(fill, (0, 0), 1.5), shift, (0, 1)) * 255, 0, 170).astype(np.uint8)


def draw(labels, rng):
    """silhouette-complete label map (h, w) -> darkness (h, w) uint8."""
    h, w = labels.shape
    big = cv2.resize(labels, (w * FINE, h * FINE), interpolation=cv2.INTER_NEAREST)
    softness = rng.uniform(0.8, 2.0) * FINE
    big = np.argmax([cv2.GaussianBlur((big == k).astype(np.float32), (0, 0), softness) for k in range(6)], 0).astype(np.uint8)
    width = float(np.clip(np.exp(rng.normal(np.log(2.9), 0.33)), 1.2, 8))
    pen = Pen(rng, big.shape, width)
    outlines(pen, big, rng)
    borders(pen, big, rng)
    if rng.random() < 0.35:
        face(pen, big, rng)
    for _ in range(int(rng.choice([0, 1, 2], p=[0.72, 0.2, 0.08]))):
        marks(pen, big, rng)
    canvas = pen.canvas
    if rng.random() < 0.12:
        canvas = np.maximum(canvas, shading(big, rng))
    return cv2.resize(canvas, (w, h), interpolation=cv2.INTER_AREA)
