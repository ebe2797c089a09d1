#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Training data: precomputed shards of (darkness, labels) pairs, and the augmentation that the training loop adds.

usage: dataset.py DATA OUT --source {label_maps,strokes,more,spg,doodle,people,others,scribbles,things} [--rounds N] [--seed S]
DATA is the folder of the real drawings (its README describes it); for doodle, people (its humanoids), others (fish, insects), scribbles and things the folder that tools/doodle wrote. Writes OUT/<source>_<k>.npy, uint8 (n, 2, 320, 320): darkness
(0 paper, 255 ink) and part labels (255: not judged), and OUT/<source>_<k>.json with expert, pose and type of each.
Drawings of fold 0 (DATA/split.py, held_out) never get in; those of more-labelled.ndjson are split by their group, and --without SOURCE
leaves all of one origin out.
"""
import argparse
import csv
import glob
import hashlib
import importlib.util
import json
import os

import cv2
import numpy as np

import render
import tone
from model import POSES, TYPES

SIZE = 320
GROUND, WINGED, UNKNOWN = 0, 1, 255
EXPERT = {"humanoid": GROUND, "quadruped": GROUND, "flying": WINGED}
FACING = {"left": "W", "right": "E", "front": "S", "back": "N"}
THINGS = ("sun", "moon", "star", "cloud", "rain", "rainbow", "balloon", "heart", "house", "tree", "fir", "flower", "grass line",
          "grass tuft", "hill", "mountain", "fence", "car", "boat", "ball", "table", "arrow", "frame", "word", "sentence", "scrawl",
          "signature")
SPG = {"pig": (GROUND, "quadruped", 400), "ant": (GROUND, "other", 220), "crab": (GROUND, "other", 150),
       "butterfly": (WINGED, "flying", 260), "duck": (WINGED, "flying", 300)}


def load_module(path):
    spec = importlib.util.spec_from_file_location(os.path.splitext(os.path.basename(path))[0], path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def pose_index(name):
    return POSES.index(name) if name in POSES else UNKNOWN


def type_index(name, labels):
    """how a character moves; a head alone is none of the types."""
    judged = (labels != UNKNOWN) & (labels > 0)
    if name not in TYPES or (labels == render.HEAD).sum() > 0.95 * judged.sum() > 0:
        return TYPES.index("other")
    return TYPES.index(name)


def from_label_maps(data, rng, rounds):
    held_out = load_module(f"{data}/split.py").held_out
    rows = [r for r in csv.DictReader(open(f"{data}/label_maps/index.csv")) if not held_out(r["id"])]
    rows += 2 * [r for r in rows if r["type"] == "flying"]            # one class of six: drawn three times as often
    for _ in range(rounds):
        for row in rng.permutation(np.array(rows, object)):
            labels = render.complete(cv2.imread(f"{data}/label_maps/{row['id']}.png", cv2.IMREAD_GRAYSCALE))
            if (labels > 0).sum() < 400:
                continue
            labels = render.deform(labels, rng, SIZE)
            yield render.draw(labels, rng), labels, EXPERT[row["type"]], pose_index(row["pose"]), type_index(row["type"], labels)


def frame(strokes, rng):
    """pen for a drawing whose box fills the frame."""
    pen = float(np.clip(np.exp(rng.normal(np.log(3.2), 0.3)), 1.6, 7))
    wobble = np.ones(len(strokes)) if rng.random() < 0.6 else rng.uniform(0.75, 1.3, len(strokes))
    return pen, wobble


def from_strokes(data, rng, rounds):
    held_out = load_module(f"{data}/split.py").held_out
    records = [json.loads(line) for line in open(f"{data}/strokes/quickdraw-labelled.ndjson")]
    yield from drawn_strokes(data, [r for r in records if not held_out(r["id"])], rng, rounds)


def from_more(data, rng, rounds, without=""):
    records = [json.loads(line) for line in open(f"{data}/strokes/more-labelled.ndjson")]
    yield from drawn_strokes(data, [r for r in records if group_fold(r) != 0 and r["quality"] > 1 and r["source"] != without], rng, rounds)


def group_fold(record):
    """fold of a drawing of more-labelled.ndjson: all of one person or one picture are in one."""
    return hashlib.sha1(record["group"].encode()).digest()[0] % 5


def expert_of(record):
    """of its type; of fish and insects, by whether they have wings."""
    parts = {piece if isinstance(piece, str) else piece[0]
             for part in record["parts"] for piece in ([part] if isinstance(part, str) else part)}
    return EXPERT.get(record["type"], WINGED if "wing" in parts else GROUND)


def drawn_strokes(data, records, rng, rounds):
    """each shape with three pens: its regions take a hundred times as long as its lines."""
    script = load_module(f"{data}/../tools/strokes_to_regions.py")
    for _ in range(rounds):
        for record in rng.permutation(np.array(records, object)):
            shape, margin, turn, info = jitter(record, rng), rng.uniform(8, 20), rng.normal(0, 7), {}
            pen = frame(shape["strokes"], rng)[0]
            placed, parts = script.place(shape, SIZE, margin, turn)
            labels = script.regions(placed, parts, SIZE, pen, info)
            if info.get("open"):
                continue
            for width in pen * np.array([1, rng.uniform(0.7, 0.9), rng.uniform(1.1, 1.4)]):
                image = script.render(placed, SIZE, width, frame(placed, rng)[1])
                yield 255 - image, labels, expert_of(record), pose_index(FACING.get(record["facing"])), type_index(record["type"], labels)


def jitter(record, rng):
    """the record with its strokes slightly stretched and, at times, a stroke's end cut off."""
    strokes = [np.asarray(s, float) * np.exp(rng.normal(0, 0.08, 2)[0] * np.array([1, -1])) for s in record["strokes"]]
    return {**record, "strokes": [s.tolist() for s in strokes]}


def from_spg(data, rng, rounds):
    convert = load_module(f"{data}/../tools/strokes_to_regions.py").convert
    held_out = load_module(f"{data}/split.py").held_out
    jobs = []
    for name, (expert, kind, limit) in SPG.items():
        records = [json.loads(line) for line in open(f"{data}/strokes/spg-{name}.ndjson")]
        records = [r for r in records if not held_out(r["id"])]
        if name == "pig":
            whole = [r for r in records if {"body", "limb"} <= set(map(str, r["parts"]))]
            records = whole + [r for r in records if r not in whole][:40]
        jobs += [(name, expert, kind, r) for r in records[:limit]]
    for _ in range(rounds):
        for k in rng.permutation(len(jobs)):
            name, expert, kind, record = jobs[k]
            pen, wobble = frame(record["strokes"], rng)
            info = {}
            image, labels = convert(jitter(record, rng), SIZE, rng.uniform(8, 20), pen, rng.normal(0, 6), wobble, True, info)
            if info.get("open") or not labels.any():
                continue
            yield 255 - image, unsure(name, labels), expert, UNKNOWN, type_index(kind, labels)


def unsure(name, labels):
    """what the labels of a class do not tell apart is not judged: a duck's wing and tail, a butterfly's head."""
    if name == "duck":
        return np.where(labels == render.BODY, UNKNOWN, labels).astype(np.uint8)
    if name == "butterfly":
        body = labels == render.BODY
        ys = np.nonzero(body)[0]
        if len(ys):
            body[int(ys.min() + 0.3 * np.ptp(ys)):] = False
            return np.where(body, UNKNOWN, labels).astype(np.uint8)
    return labels


def from_doodle(folder, rng, rounds):
    """what tools/doodle wrote into FOLDER; photographs and colours go through the same steps as in the program."""
    for line in open(f"{folder}/index.ndjson"):
        row = json.loads(line)
        picture = cv2.imread(f"{folder}/image/{row['id']}.png")[:, :, ::-1]
        labels = cv2.imread(f"{folder}/label/{row['id']}.png", cv2.IMREAD_GRAYSCALE)
        darkness = (tone.ink_darkness(picture) * 255 + 0.5).astype(np.uint8)
        if row["type"] == "thing":                                # no labels; the species in the place of the expert
            yield darkness, labels, THINGS.index(row["species"]), UNKNOWN, TYPES.index("other")
        else:
            yield darkness, labels, EXPERT.get(row["type"], GROUND), pose_index(row["pose"]), type_index(row["type"], labels)


SOURCES = {"label_maps": from_label_maps, "strokes": from_strokes, "more": from_more, "spg": from_spg, "doodle": from_doodle, "people": from_doodle,
           "others": from_doodle, "scribbles": from_doodle, "things": from_doodle}


def write_shards(out, source, samples, shard=250):
    images, facts, count = [], [], 0

    def flush():
        nonlocal count, images, facts
        base = f"{out}/{source}_{count:03d}"
        json.dump(facts, open(base + ".json", "w"))
        np.save(base + ".part.npy", np.stack(images))
        os.replace(base + ".part.npy", base + ".npy")
        count, images, facts = count + 1, [], []
        print(source, count, flush=True)

    for image, labels, *known in samples:
        images.append(np.stack([image, labels]).astype(np.uint8))
        facts.append([int(fact) for fact in known])
        if len(images) == shard:
            flush()
    if images:
        flush()


class Shards:
    """all shards of a folder (memory-mapped); `refresh` takes in what was written since."""

    def __init__(self, folder, shares):
        self.folder, self.shares, self.sources = folder, shares, {}
        self.refresh()

    def refresh(self):
        for path in sorted(glob.glob(f"{self.folder}/*_[0-9][0-9][0-9].npy")):
            source = os.path.basename(path).rsplit("_", 1)[0]
            known = self.sources.setdefault(source, {})
            if path not in known and source in self.shares:
                known[path] = (np.load(path, mmap_mode="r"), json.load(open(path[:-4] + ".json")))
        self.sources = {k: v for k, v in self.sources.items() if v}

    def draw(self, rng):
        names = sorted(self.sources)
        weights = np.array([self.shares[n] for n in names])
        shards = list(self.sources[names[rng.choice(len(names), p=weights / weights.sum())]].values())
        images, facts = shards[rng.integers(len(shards))]
        k = int(rng.integers(len(images)))
        if facts[k][0] == GROUND and rng.random() < 0.35:        # flyers are the rarer half: one more chance for them
            k = int(rng.integers(len(images)))
        return images[k, 0], images[k, 1], *facts[k]


def example(shards, rng):
    """of the segmenter: of things and scribbles the type alone is judged."""
    ink, labels, expert, pose, kind = shards.draw(rng)
    if expert in (GROUND, WINGED) and labels.any():
        return ink, labels, expert, pose, kind
    ys, xs = np.nonzero(ink > 60)
    unknown = np.zeros_like(labels)
    unknown[ys.min():ys.max() + 1, xs.min():xs.max() + 1] = UNKNOWN
    return ink, unknown, UNKNOWN, UNKNOWN, kind


def augment(ink, labels, expert, pose, kind, rng, size):
    """one training example: ink (size, size) float32 in [0, 1], labels (size, size) uint8, expert, pose, type."""
    flip = rng.random() < 0.5
    if size <= 0.65 * SIZE:                              # first to half size by area, so that no thin line is lost
        ink = cv2.resize(ink, (SIZE // 2, SIZE // 2), interpolation=cv2.INTER_AREA)
        labels = labels[::2, ::2]
    ys, xs = np.nonzero(labels)
    low, high = np.array([xs.min(), ys.min()]), np.array([xs.max() + 1, ys.max() + 1])
    angle = np.radians(rng.normal(0, 6) if rng.random() < 0.7 else rng.uniform(-32, 32))
    stretch = np.diag(np.exp(rng.normal(0, 0.07, 2))) @ (np.diag([-1, 1]) if flip else np.eye(2))
    forward = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]) @ stretch
    corners = np.array([[x, y] for x in (low[0], high[0]) for y in (low[1], high[1])]) @ forward.T
    if abs(angle) > np.radians(4):                       # the box of a turned drawing is smaller than its corners' box
        shrink = 1 - 0.8 * abs(np.sin(angle))
    else:
        shrink = 1
    extent = (corners.max(0) - corners.min(0)).max() * shrink
    scale = size * (1 - 2 * rng.uniform(0.0, 0.06)) / extent
    partial = rng.random() < 0.06                        # a character at the page's border: a part of it is not there
    if partial:
        scale *= rng.uniform(1.05, 1.3)
    forward = scale * forward
    shift = size / 2 - forward @ ((low + high) / 2) + rng.uniform(-0.015, 0.015, 2) * size * (10 if partial else 1)
    matrix = np.c_[forward, shift].astype(np.float32)
    if rng.random() < 0.5:
        inverse = cv2.invertAffineTransform(matrix)
        grid = np.stack(np.meshgrid(np.arange(size, dtype=np.float32), np.arange(size, dtype=np.float32)), -1)
        source = grid @ inverse[:, :2].T + inverse[:, 2]
        amplitude = abs(rng.normal(0, 3.0)) * ink.shape[0] / SIZE
        for axis in range(2):
            source[..., axis] += render.smooth_noise(rng, (size, size), int(rng.integers(4, 9)), amplitude)
        source = source.astype(np.float32)
        ink = cv2.remap(ink, source, None, cv2.INTER_LINEAR)
        labels = cv2.remap(labels, source, None, cv2.INTER_NEAREST)
    else:
        ink = cv2.warpAffine(ink, matrix, (size, size), flags=cv2.INTER_LINEAR)
        labels = cv2.warpAffine(labels, matrix, (size, size), flags=cv2.INTER_NEAREST)
    if flip and pose != UNKNOWN:
        pose = POSES.index(POSES[pose].translate(str.maketrans("EW", "WE")))
    return cut_out(as_photographed(ink, rng), rng), labels, expert, pose, kind


def cut_out(ink, rng):
    """at times a few small squares without ink: gaps in the outline anywhere."""
    if rng.random() < 0.2:
        size = ink.shape[0]
        for _ in range(int(rng.integers(1, 5))):
            side = int(rng.uniform(0.02, 0.09) * size)
            x, y = rng.integers(0, size - side, 2)
            ink[y:y + side, x:x + side] = 0
    return ink


def as_photographed(ink, rng):
    """pen width, strength, blur, residue of the paper: what is left of a photograph after it was normalised."""
    choice = rng.random()
    if choice < 0.12:
        ink = cv2.dilate(ink, np.ones((2, 2), np.uint8))
    elif choice < 0.17:
        ink = cv2.erode(ink, np.ones((2, 2), np.uint8))
    ink = ink.astype(np.float32) / 255
    if rng.random() < 0.3:
        ink = cv2.GaussianBlur(ink, (0, 0), rng.uniform(0.4, 1.1))
    if rng.random() < 0.5:
        ink = np.minimum(ink * rng.uniform(0.65, 1.6), 1) ** rng.uniform(0.7, 1.4)
    if rng.random() < 0.15:
        ink = ink * np.clip(1 + render.smooth_noise(rng, ink.shape, 20, 0.25), 0.3, 1.3)
    if rng.random() < 0.2:
        ink = ink + np.abs(render.smooth_noise(rng, ink.shape, int(rng.integers(3, 12)), rng.uniform(0, 0.08)))
        ink = ink + rng.normal(0, rng.uniform(0, 0.06), ink.shape).astype(np.float32)
    return np.clip(ink, 0, 1)


def batch(shards, count, rng, size):
    examples = [augment(*example(shards, rng), rng, size) for _ in range(count)]
    ink, labels, *facts = zip(*examples)
    return np.stack(ink)[:, None], np.stack(labels), *map(np.array, facts)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data")
    parser.add_argument("out")
    parser.add_argument("--source", choices=sorted(SOURCES), required=True)
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--without", help="of `more`: the origin that is left out")
    args = parser.parse_args()
    os.makedirs(args.out, exist_ok=True)
    rng = np.random.default_rng(args.seed)
    left_out = {"without": args.without} if args.without else {}
    write_shards(args.out, args.source, SOURCES[args.source](args.data, rng, args.rounds, **left_out))


if __name__ == "__main__":
    main()
