#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Mean IoU over the parts present, with the 95 % interval of the mean, and the share of right types, on held-out drawings (fold 0) made and
labelled by the two shared scripts.

usage: evaluate.py DATA (--model CHECKPOINT_OR_SAFETENSORS [--raw] | --pantin BINARY) [--fold 0] [--erase 0.0] [--turn 0]
                   [--sheet OUT.png] [--report OUT.md] [--table OUT.ndjson]
       evaluate.py DATA --write DATASET [--count N] [--fold 0] [--erase 0.0]
DATA/../tools holds label_map_to_drawing.py and strokes_to_regions.py. For each drawing: IoU of every part that the truth has; its
mean is the drawing's score; tables give the mean of the drawings and of each part. --sheet: drawing | truth | answer.
With --pantin the drawing is a page for `pantin detect`, `segment`, `skeletonize` and `identify`; the largest character's labels are put back onto it.
--turn: the page is turned by so many degrees anticlockwise (90, 180, 270) before. --table: per drawing its scores, the type and the evidence.
--write: the drawings on which the type is judged (N of them, evenly chosen) as a dataset for `pantin evaluate`.
"type" is judged on drawings with limbs or wings of one of the three types: heads alone cannot be identified.
"""
import argparse
import collections
import csv
import hashlib
import json
import os
import subprocess
import tempfile

import cv2
import numpy as np
import torch

import dataset
import export
import integer_networks
from model import EXPERTS, LABELS, TYPES

COLOURS = np.array([[255, 255, 255], [60, 90, 220], [220, 60, 60], [60, 180, 75], [245, 130, 48], [240, 200, 0]], np.uint8)
PAD = 20                                            # paper added around a drawing, so that the page is larger than the character

Drawing = collections.namedtuple("Drawing", "name group kind category image truth")


def held_out_drawings(data, fold, erase):
    """label maps and labelled strokes of one fold, drawn as the shared scripts draw them."""
    scripts = {name: dataset.load_module(f"{data}/../tools/{name}.py") for name in ("label_map_to_drawing", "strokes_to_regions")}
    fold_of = dataset.load_module(f"{data}/split.py").fold
    drawings = []
    for row in csv.DictReader(open(f"{data}/label_maps/index.csv")):
        if fold_of(row["id"]) == fold:
            script = scripts["label_map_to_drawing"]
            truth = script.truth(cv2.imread(f"{data}/label_maps/{row['id']}.png", cv2.IMREAD_GRAYSCALE))
            seed = int.from_bytes(hashlib.sha1(row["id"].encode()).digest()[4:8], "big")
            if truth.any():
                drawings.append(Drawing(row["id"], "label maps", row["type"], row["class"], script.draw(truth, seed, erase), truth))
    for line in open(f"{data}/strokes/quickdraw-labelled.ndjson"):
        record = json.loads(line)
        if fold_of(record["id"]) == fold:
            image, truth = scripts["strokes_to_regions"].convert(record)
            drawings.append(Drawing(record["id"], "strokes", record["type"], record["class"], image, truth))
    for line in open(f"{data}/strokes/more-labelled.ndjson"):
        record = json.loads(line)
        if dataset.group_fold(record) == fold and record["quality"] > 1:
            info = {}
            image, truth = scripts["strokes_to_regions"].convert(record, info=info)
            if not info.get("open") and truth.any():
                drawings.append(Drawing(record["id"], f"more, {record['source']}", record["type"], record["class"], image, truth))
    return [d._replace(image=np.pad(d.image, PAD, constant_values=255), truth=np.pad(d.truth, PAD)) for d in drawings]


def network_of(path, raw):
    """of a checkpoint, or of a weight file of floats or of integers."""
    if path.endswith(".safetensors"):
        tensors, facts = export.read_safetensors(path)
        if facts.get("arithmetic") == "integer":
            return integer_networks.IntegerSegmenter(tensors, facts)
    return export.load(path, raw)


def crop_box(darkness):
    """box of the ink with its margin, cut at the page's border: x, y, width, height."""
    ys, xs = np.nonzero(darkness > 60)
    margin = max(4, int(round(0.02 * max(np.ptp(xs) + 1, np.ptp(ys) + 1))))
    x, y = max(0, xs.min() - margin), max(0, ys.min() - margin)
    return x, y, min(darkness.shape[1], xs.max() + 1 + margin) - x, min(darkness.shape[0], ys.max() + 1 + margin) - y


def letterbox(ink, size):
    """crop (h, w) in [0, 1] -> network input, and where the crop lies in it."""
    h, w = ink.shape
    scale = size / max(h, w)
    width, height = max(1, int(w * scale + 0.5)), max(1, int(h * scale + 0.5))
    small = cv2.resize(ink, (width, height), interpolation=cv2.INTER_AREA if scale < 1 else cv2.INTER_LINEAR)
    x, y = (size - width) // 2, (size - height) // 2
    page = np.zeros((size, size), np.float32)
    page[y:y + height, x:x + width] = small
    return page, (x, y, width, height)


@torch.no_grad()
def predict(model, image):
    """page (h, w), 0 ink, 255 paper -> label map of the page, {"expert", "type"}."""
    darkness = 255 - image
    x, y, w, h = crop_box(darkness)
    page, (left, top, width, height) = letterbox(darkness[y:y + h, x:x + w].astype(np.float32) / 255, model.size)
    parts, router, _, kind = model(torch.from_numpy(page)[None, None])
    expert = EXPERTS[int(router[0].argmax())]
    chances = parts[expert][0].softmax(0)[:, top:top + height, left:left + width].numpy()
    chances = np.stack([cv2.resize(c, (int(w), int(h)), interpolation=cv2.INTER_LINEAR) for c in chances])
    labels = np.zeros(image.shape, np.uint8)
    labels[y:y + h, x:x + w] = chances.argmax(0)
    return labels, {"expert": expert, "type": TYPES[int(kind[0, :3].argmax())], "types": kind[0].softmax(0).tolist()}


def run_pantin(binary, image):
    """page -> label map of the page by the program, and what it says of the character ("expert", "type", "rotate", …; {} when
    nothing was found)."""
    labels = np.zeros(image.shape, np.uint8)
    with tempfile.TemporaryDirectory() as folder:
        def step(name, *arguments):
            return subprocess.run([binary, name, *arguments, "--quiet"], stderr=subprocess.DEVNULL).returncode == 0
        cv2.imwrite(f"{folder}/page.png", image)
        if not step("detect", f"{folder}/page.png", "-o", f"{folder}/out"):
            return labels, {}
        page = json.load(open(f"{folder}/out/page.json"))
        turn = page.get("rotate", 0) // 90                        # the program turned the page clockwise
        labels = np.ascontiguousarray(np.rot90(labels, -turn))
        found = max(page["characters"], key=lambda c: c["box"][2] * c["box"][3])
        place = os.path.join(folder, "out", found["folder"])
        if not step("segment", place):
            return np.rot90(labels, turn), {}
        x, y, w, h = found["box"]
        answer = cv2.imread(f"{place}/labels.png", cv2.IMREAD_GRAYSCALE)
        labels[y:y + h, x:x + w] = cv2.resize(answer, (w, h), interpolation=cv2.INTER_NEAREST)
        labels = np.ascontiguousarray(np.rot90(labels, turn))
        facts = {**json.load(open(f"{place}/segmentation.json")), "rotate": 90 * turn}
        facts["head"] = facts.pop("type", None)
        if step("skeletonize", place) and step("identify", place):
            facts["identification"] = json.load(open(f"{place}/identification.json"))
            facts["type"] = facts["identification"]["type"]
        return labels, facts


def part_scores(truth, answer):
    """{part name: IoU} of the parts that the truth has, and "silhouette"."""
    scores = {}
    for part in range(1, len(LABELS)):
        a, b = truth == part, answer == part
        if a.any():
            scores[LABELS[part]] = (a & b).sum() / (a | b).sum()
    scores["silhouette"] = ((truth > 0) & (answer > 0)).sum() / max(1, ((truth > 0) | (answer > 0)).sum())
    return scores


def judged_type(drawing):
    """with limbs or wings, and one of the three types."""
    return drawing.kind in dataset.EXPERT and np.isin(drawing.truth, (3, 5)).sum() > 0.002 * (drawing.truth > 0).sum()


def wilson(right, n):
    """95 % interval of a share."""
    z, p = 1.96, right / n
    middle, half = p + z * z / (2 * n), z * np.sqrt(p * (1 - p) / n + z * z / (4 * n * n))
    return (middle - half) / (1 + z * z / n), (middle + half) / (1 + z * z / n)


def table(rows):
    """rows: list of (drawing, part scores, facts) -> lines of a Markdown table per group, type and class."""
    names = ["mean IoU"] + LABELS[1:] + ["silhouette", "router", "type"]
    lines = ["| drawings | n | " + " | ".join(names) + " |", "|---|---|" + "---|" * len(names)]
    groups = collections.OrderedDict()
    for row in rows:
        for key in ((row[0].group,), (row[0].group, row[0].kind), (row[0].group, row[0].kind, row[0].category)):
            groups.setdefault(key, []).append(row)
    for key in sorted(groups):
        members, cells = groups[key], []
        means = [np.mean([v for k, v in scores.items() if k != "silhouette"]) for _, scores, _ in members]
        spread = 1.96 * np.std(means, ddof=1) / np.sqrt(len(means)) if len(means) > 1 else 0
        cells.append(f"{np.mean(means):.3f} ± {spread:.3f}")
        for part in LABELS[1:] + ["silhouette"]:
            values = [scores[part] for _, scores, _ in members if part in scores]
            cells.append(f"{np.mean(values):.3f} ({len(values)})" if values and part != "silhouette" else
                         f"{np.mean(values):.3f}" if values else "–")
        routed = [EXPERTS.index(facts["expert"]) == dataset.EXPERT[d.kind] if facts else False for d, _, facts in members if d.kind in dataset.EXPERT]
        cells.append(f"{np.mean(routed):.2f}" if routed else "–")
        typed = [facts.get("type") == d.kind for d, _, facts in members if judged_type(d)]
        cells.append("{:.2f} [{:.2f}, {:.2f}] ({})".format(np.mean(typed), *wilson(sum(typed), len(typed)), len(typed)) if typed else "–")
        lines.append(f"| {', '.join(key)} | {len(members)} | " + " | ".join(cells) + " |")
    return lines


def picture(drawing, answer):
    grey = np.dstack([drawing.image] * 3)
    paint = [cv2.addWeighted(grey, 0.4, np.ascontiguousarray(COLOURS[labels][:, :, ::-1]), 0.6, 0) for labels in (drawing.truth, answer)]
    return cv2.resize(np.concatenate([grey] + paint, 1), (450, 150), interpolation=cv2.INTER_AREA)


def contact_sheet(tiles, path, columns=4):
    tiles = tiles + [np.full_like(tiles[0], 255)] * (-len(tiles) % columns)
    cv2.imwrite(path, np.concatenate([np.concatenate(tiles[k:k + columns], 1) for k in range(0, len(tiles), columns)], 0))


def write_dataset(drawings, folder):
    for part in ("image", "label"):
        os.makedirs(f"{folder}/{part}", exist_ok=True)
    with open(f"{folder}/index.ndjson", "w") as index:
        for number, d in enumerate(drawings):
            cv2.imwrite(f"{folder}/image/{number:03d}.png", d.image)
            cv2.imwrite(f"{folder}/label/{number:03d}.png", d.truth)
            index.write(json.dumps({"id": f"{number:03d}", "type": d.kind, "species": d.category, "drawing": d.name, "group": d.group}) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data")
    answerer = parser.add_mutually_exclusive_group(required=True)
    answerer.add_argument("--model")
    answerer.add_argument("--pantin")
    answerer.add_argument("--write")
    parser.add_argument("--count", type=int)
    parser.add_argument("--raw", action="store_true")
    parser.add_argument("--fold", type=int, default=0)
    parser.add_argument("--erase", type=float, default=0.0)
    parser.add_argument("--sheet")
    parser.add_argument("--report")
    parser.add_argument("--turn", type=int, choices=(0, 90, 180, 270), default=0)
    parser.add_argument("--table")
    args = parser.parse_args()
    if args.write:
        drawings = [d for d in held_out_drawings(args.data, args.fold, args.erase) if judged_type(d)]
        count = min(args.count or len(drawings), len(drawings))
        write_dataset([drawings[k * len(drawings) // count] for k in range(count)], args.write)
        return
    torch.set_num_threads(1)
    model = network_of(args.model, args.raw) if args.model else None
    rows, tiles = [], []
    for drawing in held_out_drawings(args.data, args.fold, args.erase):
        if args.turn:
            drawing = drawing._replace(**{key: np.ascontiguousarray(np.rot90(getattr(drawing, key), args.turn // 90)) for key in ("image", "truth")})
        answer, facts = predict(model, drawing.image) if model else run_pantin(args.pantin, drawing.image)
        scores = part_scores(drawing.truth, answer)
        rows.append((drawing, scores, facts))
        tile = picture(drawing, answer)
        score = np.mean(list(scores.values())[:-1])
        cv2.putText(tile, f"{drawing.name} {score:.2f} {facts.get('type')}", (3, 11), 0, 0.35, (0, 0, 0), 1, cv2.LINE_AA)
        tiles.append(tile)
    if args.table:
        with open(args.table, "w") as out:
            for d, scores, facts in rows:
                out.write(json.dumps({"id": d.name, "group": d.group, "kind": d.kind, "class": d.category, "judged": bool(judged_type(d)),
                                      "scores": {k: float(v) for k, v in scores.items()}, **facts}) + "\n")
    lines = table(rows)
    print("\n".join(lines))
    if args.report:
        open(args.report, "w").write("\n".join(lines) + "\n")
    if args.sheet:
        contact_sheet(tiles, args.sheet)


if __name__ == "__main__":
    main()
