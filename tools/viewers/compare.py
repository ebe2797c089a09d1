#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""character.glb in other programs beside Pantin's own frame: differences, and a picture ours | three.js | Blender.

usage: compare.py CHARACTER_DIR [CLIP] [--out PICTURE.png]

CHARACTER_DIR is a folder that `pantin animate PAGE -o OUT --format png` wrote (transparent background, no
--perspective, no --motion); CLIP is the first of the file unless given. The frame is the one nearest to a quarter of
the clip. A difference is the mean over pixels and channels of |theirs − ours| on white, as share of 255: over the
whole frame, and over the pixels that the character covers in either picture. What is left with three.js are edges:
alphaMode MASK cuts them hard, and textures are filtered in linear light; thin strokes have the most of them. Needs
numpy and OpenCV; a viewer that is not installed (Debian: nodejs, npm and chromium; blender) is left out.
"""
import argparse
import glob
import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile

import cv2
import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
PACKAGES = ["three@0.187.0", "playwright-core@1.65.1"]
MARGIN = 0.02  # of view_of in src/animation/skinning.cpp
TYPES = {5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class Glb:
    def __init__(self, path):
        data = open(path, "rb").read()
        length = struct.unpack_from("<I", data, 12)[0]
        self.json = json.loads(data[20:20 + length])
        self.binary = data[28 + length:]

    def array(self, index):
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        shape = accessor["count"], WIDTHS[accessor["type"]]
        kind = TYPES[accessor["componentType"]]
        return np.frombuffer(self.binary, kind, shape[0] * shape[1], view["byteOffset"]).reshape(shape)

    def clip(self, name):
        found = [a for a in self.json["animations"] if name in (None, a["name"])]
        if not found:
            sys.exit(f"compare: no clip {name} ({', '.join(a['name'] for a in self.json['animations'])})")
        return found[0]

    def times(self, clip):
        return self.array(clip["samplers"][0]["input"])[:, 0]


def local_matrix(translation, rotation):
    x, y, z, w = rotation / np.linalg.norm(rotation)
    matrix = np.eye(4)
    matrix[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                      [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                      [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    matrix[:3, 3] = translation
    return matrix


def world_matrices(model, values):
    """values: {(node, path): vector} of a key; nodes stand after their parents."""
    nodes = model.json["nodes"]
    parent = {child: i for i, node in enumerate(nodes) for child in node.get("children", [])}
    world = {}
    for i, node in enumerate(nodes):
        at = lambda path, rest: np.asarray(values.get((i, path), node.get(path, rest)), float)
        local = local_matrix(at("translation", [0, 0, 0]), at("rotation", [0, 0, 0, 1]))
        world[i] = world[parent[i]] @ local if i in parent else local
    return world


def skinned(model, values):
    attributes = model.json["meshes"][0]["primitives"][0]["attributes"]
    skin = model.json["skins"][0]
    position = model.array(attributes["POSITION"])
    joints, weights = model.array(attributes["JOINTS_0"]), model.array(attributes["WEIGHTS_0"])
    inverse = model.array(skin["inverseBindMatrices"]).reshape(-1, 4, 4).transpose(0, 2, 1)
    world = world_matrices(model, values)
    matrices = np.stack([world[j] for j in skin["joints"]]) @ inverse
    blended = np.einsum("vk,vkij->vij", weights, matrices[joints])
    return np.einsum("vij,vj->vi", blended, np.c_[position, np.ones(len(position))])[:, :3]


def poses(model):
    """The rest pose and every key of every clip: what view_of covers."""
    yield {}
    for clip in model.json["animations"]:
        channels = [((c["target"]["node"], c["target"]["path"]), model.array(clip["samplers"][c["sampler"]]["output"]))
                    for c in clip["channels"]]
        for key in range(len(model.times(clip))):
            yield {target: output[key] for target, output in channels}


def view_rectangle(model, width, height):
    """What a frame of width × height pixels shows: x0 y0 x1 y1. Pantin's view is the bounding box of all poses with a
    margin of its longer side; its longer side fills the frame's, the shorter one is rounded to whole pixels."""
    boxes = [(p.min(0), p.max(0)) for p in (skinned(model, values)[:, :2] for values in poses(model))]
    low, high = np.min([b[0] for b in boxes], 0), np.max([b[1] for b in boxes], 0)
    pad = MARGIN * (high - low).max()
    low, high = low - pad, high + pad
    pixel = (high - low).max() / max(width, height)
    return [low[0], low[1], low[0] + width * pixel, low[1] + height * pixel]


def read(path):
    image = cv2.imread(path, cv2.IMREAD_UNCHANGED)
    if image is None or image.ndim != 3 or image.shape[2] != 4 or image[:, :, 3].min() == 255:
        sys.exit(f"compare: {path}: no picture with transparent background")
    return image.astype(float)


def on_white(image):
    alpha = image[:, :, 3:] / 255
    return image[:, :, :3] * alpha + 255 * (1 - alpha)


def differences(ours, theirs):
    """In percent: over all pixels, over those that the character covers in either picture."""
    difference = np.abs(on_white(theirs) - on_white(ours)).mean(2) / 2.55
    covered = (ours[:, :, 3] > 0) | (theirs[:, :, 3] > 0)
    return difference.mean(), difference[covered].mean()


def three_command():
    for program in ("node", "npm", "chromium"):
        if not shutil.which(program):
            print(f"three.js: left out, {program} is not installed")
            return None
    if not all(os.path.exists(f"{HERE}/node_modules/{p.split('@')[0]}") for p in PACKAGES):
        subprocess.run(["npm", "install", "--prefix", HERE, "--ignore-scripts", "--no-save", "--no-package-lock",
                        "--no-audit", "--no-fund", "--silent", *PACKAGES], check=True)
    return ["node", f"{HERE}/three.mjs"]


def blender_command():
    if not shutil.which("blender"):
        print("Blender: left out, blender is not installed")
        return None
    return ["blender", "--background", "--factory-startup", "--python-exit-code", "1", "--python",
            f"{HERE}/blender.py", "--"]


def render_with(command, arguments, out):
    run = subprocess.run([*command, *map(str, arguments), out], capture_output=True, text=True)
    if run.returncode != 0 or not os.path.exists(out):
        sys.exit(f"compare: {command[0]} failed\n{run.stdout[-2000:]}{run.stderr[-2000:]}")
    return read(out)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("clip", nargs="?")
    parser.add_argument("--out", default="viewers.png")
    args = parser.parse_args()
    path = f"{args.folder}/character.glb"
    model = Glb(path)
    clip = model.clip(args.clip)
    frames = sorted(glob.glob(f"{args.folder}/frames/{clip['name']}/*.png"))
    if not frames:
        sys.exit(f"compare: no frames of {clip['name']} (pantin animate … --format png)")
    frame = round(len(frames) / 4)
    ours = read(frames[frame])
    height, width = ours.shape[:2]
    seconds = float(model.times(clip)[-1]) * frame / len(frames)
    arguments = [path, clip["name"], seconds, *view_rectangle(model, width, height), width, height]

    print(f"{args.folder}: {clip['name']}, frame {frame + 1} of {len(frames)}, {seconds:.3f} s, {width}×{height}")
    pictures = [on_white(ours)]
    print(f"{'viewer':<10}{'difference %':>14}{'of character %':>16}")
    with tempfile.TemporaryDirectory() as work:
        for name, command in (("three.js", three_command()), ("Blender", blender_command())):
            if not command:
                continue
            theirs = render_with(command, arguments, f"{work}/picture.png")
            print("{:<10}{:>14.3f}{:>16.3f}".format(name, *differences(ours, theirs)))
            pictures.append(on_white(theirs))
    cv2.imwrite(args.out, np.concatenate(pictures, 1).round().astype(np.uint8))


if __name__ == "__main__":
    main()
