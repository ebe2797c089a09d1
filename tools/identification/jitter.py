#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""How much identification depends on the exact coordinates of the references.

usage: jitter.py BINARY DRAWS FOLDER... (as for evaluate_identification)
Each draw moves every node of humanoid, quadruped and flying by N(0, 0.05) in x and in y (kept within [0, 1], seed = number of
the draw) and counts how many types are right, of the drawings that fit_evidence.py counts. Prints every draw, then the figures.
"""
import csv
import io
import json
import os
import subprocess
import sys
import tempfile

import numpy as np

from fit_evidence import TYPES, counts

REFERENCES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../references")


def share_right(binary, folders, references):
    command = [binary] + (["--references", references] if references else []) + folders
    rows = csv.DictReader(io.StringIO(subprocess.run(command, capture_output=True, text=True, check=True).stdout), delimiter="\t")
    rows = [r for r in rows if counts(r)]
    return np.mean([r["status"] == "ok" and r["found"] == r["type"] for r in rows]), len(rows)


def jittered(folder, seed):
    rng = np.random.default_rng(seed)
    for name in TYPES:
        reference = json.load(open(f"{REFERENCES}/{name}.json"))
        for node in reference["nodes"]:
            for axis in "xy":
                node[axis] = float(np.clip(node[axis] + rng.normal(0, 0.05), 0, 1))
        json.dump(reference, open(f"{folder}/{name}.json", "w"))


def main():
    binary, draws, folders = sys.argv[1], int(sys.argv[2]), sys.argv[3:]
    plain, count = share_right(binary, folders, None)
    print(f"as they are: {plain:.4f} of {count}", flush=True)
    shares = []
    for seed in range(draws):
        with tempfile.TemporaryDirectory() as folder:
            jittered(folder, seed)
            shares.append(share_right(binary, folders, folder)[0])
        print(f"draw {seed}: {shares[-1]:.4f}", flush=True)
    print(f"{draws} draws: mean {np.mean(shares):.4f} ({np.mean(shares) - plain:+.4f}), worst {min(shares):.4f} ({min(shares) - plain:+.4f})")


if __name__ == "__main__":
    main()
