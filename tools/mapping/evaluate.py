#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""How often the end-effectors of a drawing meet the right end of the reference (check_set.tsv, judged by eye).

usage: evaluate.py [--pantin BINARY] [--preset default|thesis] [--keep FOLDER] --label-maps FOLDER --strokes FOLDER
FOLDER holds image/<id>.png and label/<id>.png: label_map_to_drawing.py makes the one of the label maps, strokes_to_regions.py that of
quickdraw-labelled.ndjson. Every drawing runs with its true labels and its true type (--labels, --reference), so that the mapping
is judged on its own. Needs numpy and OpenCV.

A tip belongs to the skeleton end nearest to it, within 0.12 of the diagonal of the silhouette's box; no end belongs to two tips, the
closest tip and end are joined first. A tip without an end is missed (a tip that expects none is then left out). Right: the end is paired
with an expected node, or with nothing where none is expected. Left and right of humanoids and flyers change places where the character
is mirrored. The rows of one drawing with the same nodes and none are one tip: right when one of them has a node and no one a wrong one.
Crossed: two legs of a drawing that are paired with reference legs in the opposite order (front to hind, left to right).
Wrong side: quadrupeds that face left and are mirrored, or face right and are not; all their legs are then likely wrong.
"""
import argparse
import csv
import itertools
import json
import math
import os
import subprocess
import sys
import tempfile

import cv2
import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
TYPES = ["humanoid", "quadruped", "flying"]
LEGS = ["leg_front_left", "leg_front_right", "leg_hind_left", "leg_hind_right", "foot_left", "foot_right"]
REACH = 0.12  # of the diagonal of the silhouette's box


def read_check_set():
    """id -> {"source", "type", "facing", "tips": [(x, y, set of names)]}"""
    with open(os.path.join(HERE, "check_set.tsv")) as file:
        rows = csv.DictReader((line for line in file if not line.startswith("#")), delimiter="\t")
        drawings = {}
        for row in rows:
            drawing = drawings.setdefault(row["id"], {"source": row["source"], "type": row["type"], "facing": row["facing"], "tips": []})
            drawing["tips"].append((float(row["x"]), float(row["y"]), frozenset(row["expected"].split("|"))))
    return drawings


def run_program(o, folder, name, drawing_type, out):
    """The folder of the character, or a line that says why there is none."""
    image, labels = (os.path.join(folder, part, name + ".png") for part in ("image", "label"))
    for path in (image, labels):
        if not os.path.exists(path):
            sys.exit(f"evaluate.py: {path}: not found")
    command = [o.pantin, "animate", image, "--labels", labels, "--reference", drawing_type, "--preset", o.preset,
               "--format", "bvh", "--threads", "1", "--quiet", "-o", out]
    try:
        result = subprocess.run(command, capture_output=True, text=True)
    except OSError as error:
        sys.exit(f"evaluate.py: {o.pantin}: {error.strerror}")
    if result.returncode not in (0, 7):
        sys.exit(f"evaluate.py: {name}: {(result.stderr.strip().splitlines() or ['exit code %d' % result.returncode])[-1]}")
    character = os.path.join(out, "character-1")
    if os.path.exists(os.path.join(character, "mapping.json")):
        return character, None
    return None, json.load(open(os.path.join(out, "page.json")))["characters"][0]["status"]


def read_character(folder, drawing_type):
    """The silhouette's box (x, y, width, height), the ends {vertex: (x, y)}, the pairs {vertex: name}, mirrored."""
    def load(name):
        return json.load(open(os.path.join(folder, name)))
    ys, xs = np.nonzero(cv2.imread(os.path.join(folder, "labels.png"), cv2.IMREAD_GRAYSCALE))
    box = (xs.min(), ys.min(), xs.max() + 1 - xs.min(), ys.max() + 1 - ys.min())
    ends = {v["id"]: (v["x"] + 0.5, v["y"] + 0.5) for v in load("skeleton.json")["vertices"] if v["kind"] == "end"}
    nodes = json.load(open(os.path.join(HERE, "../../references", drawing_type + ".json")))["nodes"]
    pairs = {p["end"]: nodes[p["reference_end"]]["name"] for p in load("mapping.json")["pairs"]}
    mirrored = next(c["mirrored"] for c in load("identification.json")["candidates"] if c["reference"] == drawing_type)
    return box, ends, pairs, mirrored


def ends_of_tips(tips, box, ends):
    """For each tip the end that belongs to it, or None: the closest tip and end first, each only once."""
    x, y, width, height = box
    reach = REACH * math.hypot(width, height)
    distances = sorted((math.hypot(ex - x - tip_x * width, ey - y - tip_y * height), i, e)
                       for i, (tip_x, tip_y, _) in enumerate(tips) for e, (ex, ey) in ends.items())
    found = [None] * len(tips)
    for distance, i, e in distances:
        if distance <= reach and found[i] is None and e not in found:
            found[i] = e
    return found


def other_side(name):
    if name.endswith("_left"):
        return name[:-4] + "right"
    return name[:-5] + "left" if name.endswith("_right") else name


def assigned_name(end, pairs, flip):
    if end is None:
        return None
    name = pairs.get(end, "none")
    return other_side(name) if flip else name


def groups_of(tips):
    """Indices of the rows that count as one tip."""
    groups = {}
    for i, (_, _, expected) in enumerate(tips):
        forked_tips = "none" in expected and len(expected) > 1
        groups.setdefault(expected if forked_tips else i, []).append(i)
    return list(groups.values())


def judge_group(group, tips, assigned):
    """"right", "wrong", "missed" or None, which does not count."""
    expected = tips[group[0]][2]
    names = [assigned[i] for i in group if assigned[i] is not None]
    if not names:
        return None if expected == {"none"} else "missed"
    if any(name not in expected for name in names):
        return "wrong"
    return "right" if expected == {"none"} or any(name != "none" for name in names) else "wrong"


def is_crossed(a, b):
    """a, b: (expected, assigned name) of two tips."""
    if a[1] not in LEGS or b[1] not in LEGS or not (a[0] | b[0]) <= set(LEGS):
        return False
    signs = {np.sign(LEGS.index(m) - LEGS.index(n)) for m in a[0] for n in b[0] if m != n}
    return len(signs) == 1 and LEGS.index(a[1]) != LEGS.index(b[1]) and np.sign(LEGS.index(a[1]) - LEGS.index(b[1])) not in signs


def judge(o, name, drawing, out):
    folder = o.label_maps if drawing["source"] == "label_maps" else o.strokes
    tips, facing = drawing["tips"], drawing["facing"]
    result = {"type": drawing["type"], "right": 0, "wrong": 0, "missed": 0, "crossed": 0, "wrong_side": 0, "lines": []}
    character, status = run_program(o, folder, name, drawing["type"], out)
    if character is None:
        result["missed"] = sum(tips[g[0]][2] != {"none"} for g in groups_of(tips))
        result["lines"].append(f"no mapping  {name} ({status})")
        return result
    box, ends, pairs, mirrored = read_character(character, drawing["type"])
    flip = mirrored and drawing["type"] != "quadruped"
    found = ends_of_tips(tips, box, ends)
    assigned = [assigned_name(e, pairs, flip) for e in found]
    for group in groups_of(tips):
        answer = judge_group(group, tips, assigned)
        if answer is None:
            continue
        result[answer] += 1
        if answer != "right":
            x, y, expected = tips[group[0]]
            got = ", ".join(f"end {found[i]} is {assigned[i]}" for i in group if found[i] is not None)
            result["lines"].append(f"{answer:6s} {name} ({x:g}, {y:g}) {'|'.join(sorted(expected))}{': ' if got else ''}{got}")
    result["crossed"] = sum(is_crossed(a, b) for a, b in itertools.combinations([(t[2], n) for t, n in zip(tips, assigned)], 2))
    if result["crossed"]:
        result["lines"].append(f"crossed {name}: {result['crossed']} pairs of legs")
    result["wrong_side"] = int(drawing["type"] == "quadruped" and facing in ("left", "right") and mirrored != (facing == "right"))
    if result["wrong_side"]:
        result["lines"].append(f"wrong side {name}: faces {facing}, mirrored: {str(mirrored).lower()}")
    return result


def wilson(right, count):
    if count == 0:
        return 0.0, 1.0
    z, share = 1.96, right / count
    middle = (share + z * z / (2 * count)) / (1 + z * z / count)
    half = z / (1 + z * z / count) * math.sqrt(share * (1 - share) / count + z * z / (4 * count * count))
    return max(0.0, middle - half), min(1.0, middle + half)


def print_table(results):
    print("type        drawings  tips  missed  with end  right  share  95 %          of all tips  crossed  wrong side")
    for kind in TYPES + ["all"]:
        part = [r for r in results if kind in (r["type"], "all")]
        right, wrong, missed, crossed, side = (sum(r[k] for r in part) for k in ("right", "wrong", "missed", "crossed", "wrong_side"))
        low, high = wilson(right, right + wrong)
        tips = right + wrong + missed
        print(f"{kind:12s}{len(part):8d}{tips:6d}{missed:8d}{right + wrong:10d}{right:7d}  {right / max(1, right + wrong):.3f}  [{low:.3f}, {high:.3f}]"
              f"{right / max(1, tips):13.3f}{crossed:9d}{side:12d}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pantin", default=os.path.join(HERE, "../../build/release/pantin"))
    parser.add_argument("--preset", choices=["default", "thesis"], default="default")
    parser.add_argument("--label-maps", required=True)
    parser.add_argument("--strokes", required=True)
    parser.add_argument("--keep", help="folder for the program's results, which are otherwise thrown away")
    o = parser.parse_args()
    results = []
    with tempfile.TemporaryDirectory() as scratch:
        for name, drawing in read_check_set().items():
            results.append(judge(o, name, drawing, os.path.join(o.keep or scratch, name)))
    print(f"preset {o.preset}")
    print_table(results)
    for kind in TYPES:
        print(f"\n{kind}")
        for line in itertools.chain.from_iterable(r["lines"] for r in results if r["type"] == kind):
            print("   ", line)


if __name__ == "__main__":
    main()
