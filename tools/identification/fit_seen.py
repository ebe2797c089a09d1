#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""How much the type head of the segmentation network counts in the evidence (src/identification/evidence.cpp), fitted and judged by five folds.

usage: fit_seen.py TABLE.ndjson... [--groups LABELLED.ndjson]     (tables of tools/train/evaluate.py --pantin --table, drawings that the network
has never seen; records with an id and a group)
A drawing's score of a type is rest * (what the other evidence adds up to in the table) - weight * ln(p + floor), p the head's probability.
Both minimise the cross-entropy of the true type on four folds and are judged on the fifth, beside the evidence alone and the head
alone; drawings of one person are in one fold. The printed constants are fitted on all: `seen_weight`, and the factor by which the program's
present `rest_weight`, which is in the table already, would change.
"""
import argparse
import hashlib
import json

import numpy as np
from scipy.optimize import minimize

from fit_evidence import TYPES

FLOOR = 0.02


def read(files, people):
    """-> truth (n,), other evidence (n, 3), head's probabilities (n, 3), group and fold of each; drawings that were identified."""
    rows, lost = [], 0
    for file in files:
        for line in open(file):
            row = json.loads(line)
            if not row["judged"]:
                continue
            if "identification" not in row:
                lost += 1
                continue
            scores = {c["reference"]: sum(v for k, v in c["evidence"].items() if k != "seen") for c in row["identification"]["candidates"]}
            rows.append((TYPES.index(row["kind"]), [scores[t] for t in TYPES], [row["head"][t] for t in TYPES], row["group"],
                         hashlib.sha1(people.get(row["id"], row["id"]).encode()).digest()[2] % 5))
    truth, scores, head, groups, folds = map(np.array, zip(*rows))
    return truth, scores, head, groups, folds, lost


def combined(constants, scores, head):
    rest, weight = constants
    return rest * scores - weight * np.log(head + FLOOR)


def fit(truth, scores, head):
    balance = len(truth) / 3 / np.bincount(truth, minlength=3)[truth]

    def loss(constants):
        score = combined(constants, scores, head)
        low = score.min(1, keepdims=True)
        return (balance * (score[np.arange(len(truth)), truth] - low[:, 0] + np.log(np.exp(low - score).sum(1)))).sum()
    return minimize(loss, [1.0, 1.0], method="Nelder-Mead").x


def report(title, truth, found, groups):
    for group in ["all"] + sorted(set(groups)):
        part = np.ones(len(truth), bool) if group == "all" else groups == group
        recalls = [f"{(found[part & (truth == k)] == k).mean():.2f}" if (part & (truth == k)).any() else "–" for k in range(3)]
        print(f"{title:24s} {group:24s} {(found[part] == truth[part]).mean():.3f} of {part.sum()}, recalls {' '.join(recalls)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tables", nargs="+")
    parser.add_argument("--groups")
    args = parser.parse_args()
    people = {r["id"]: r["group"] for r in map(json.loads, open(args.groups))} if args.groups else {}
    truth, scores, head, groups, folds, lost = read(args.tables, people)
    print(f"{len(truth)} drawings, {lost} more were not identified")
    both = np.zeros(len(truth), int)
    for k in range(5):
        constants = fit(truth[folds != k], scores[folds != k], head[folds != k])
        both[folds == k] = combined(constants, scores[folds == k], head[folds == k]).argmin(1)
    for title, found in (("evidence without head", scores.argmin(1)), ("head alone", head.argmax(1)), ("both, five folds", both)):
        report(title, truth, found, groups)
    rest, weight = fit(truth, scores, head)
    print(f"seen_weight {weight:.3f}, rest_weight times {rest:.3f}")


if __name__ == "__main__":
    main()
