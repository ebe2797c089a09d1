#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Fits the constants of src/identification/evidence.cpp and judges them by five folds.

usage: fit_evidence.py TABLE.tsv... [--groups LABELLED.ndjson] [--ridge R] [--keep-out FOLD] [--wrong] [--judge OTHER.tsv]
TABLE.tsv: written by build/release/evaluate_identification. A drawing counts when its quality is at least 2 and it has
limbs or wings, tails alone do not identify anything; the fold of a drawing follows from its id, or from its group (all drawings of one
person) in the records of --groups. Fitted on four folds, reported on
the fifth: the confusion matrix of the three types beside the literal and the divided distance and two baselines without a
graph (wing -> flying, else quadruped; a regression on 11 label numbers). Then fitted on all, or all but one fold (--keep-out), and
printed as the table of the source. Each type weighs the same, and within it each folder of the tables, so that the largest set of drawings
does not decide alone.
--judge: instead, the drawings of fold 0 in another table (the labels of the pipeline) by the program's answer and the two baselines,
which are fitted on the other folds of the tables. A drawing counts there when it does in the tables.

Model: score(type) = g * divided distance + prior(type) + sum over traits of w(type, trait) * trait; probability proportional to
exp(-score): multinomial logistic regression, with a ridge on the weights of the standardised traits.
"""
import argparse
import csv
import hashlib
import json
import os
import sys

import numpy as np
from scipy.optimize import minimize

TYPES = ["humanoid", "quadruped", "flying"]
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from labels import NAMES  # noqa: E402

PARTS = NAMES[1:]


GROUPS = {}                                          # drawing -> group


def fold(drawing_id):
    if drawing_id in GROUPS:
        return hashlib.sha1(GROUPS[drawing_id].encode()).digest()[0] % 5
    return hashlib.sha1(drawing_id.encode()).digest()[1] % 5


def counts(row):
    return (row["type"] in TYPES and int(row["quality"]) >= 2 and
            int(row["limb"]) + int(row["wing"]) > 0.002 * sum(int(row[p]) for p in PARTS))


def read(files):
    rows = []
    for file in files:
        rows += csv.DictReader(open(file), delimiter="\t")
    return [r for r in rows if counts(r)]


def trait_names(rows):
    names = list(rows[0])
    return names[names.index("ggd_flying") + 1:names.index("plain_ends")]


def fit(traits, graph, truth, weight, ridge):
    """traits (n, t), graph (n, 3) or None, truth (n,) -> g, prior (3,), weights (3, t); smaller scores are better."""
    mean, deviation = traits.mean(0), traits.std(0) + 1e-9
    x = (traits - mean) / deviation
    n, t = x.shape
    centred = None if graph is None else graph - graph.mean(1, keepdims=True)

    def unpack(p):
        return p[0], p[1:4], p[4:].reshape(3, t)

    def loss(p):
        g, prior, w = unpack(p)
        score = prior + x @ w.T + (0 if centred is None else g * centred)
        low = score.min(1, keepdims=True)
        e = np.exp(low - score)
        probability = e / e.sum(1, keepdims=True)
        value = (weight * (score[np.arange(n), truth] - low[:, 0] + np.log(e.sum(1)))).sum() + ridge * (w ** 2).sum() + 1e-3 * (prior ** 2).sum()
        d = -probability * weight[:, None]
        d[np.arange(n), truth] += weight
        grad = np.concatenate([[0 if centred is None else (d * centred).sum()], d.sum(0) + 2e-3 * prior, (d.T @ x + 2 * ridge * w).ravel()])
        return value, grad

    p = minimize(loss, np.zeros(4 + 3 * t), jac=True, method="L-BFGS-B", options={"maxiter": 3000}).x
    g, prior, w = unpack(p)
    w = w / deviation
    return g, prior - w @ mean, w


def decide(model, traits, graph):
    g, prior, w = model
    return prior + traits @ w.T + (0 if graph is None else g * graph)


def confusion(title, truth, found, counts):
    matrix = np.zeros((3, 4), int)
    for t, f in zip(truth, found):
        matrix[t, f] += 1
    recall = [matrix[k, k] / max(1, matrix[k].sum()) for k in range(3)]
    print(f"{title}: {np.trace(matrix[:, :3])}/{len(truth)} = {np.trace(matrix[:, :3]) / len(truth):.3f}, recalls " + " ".join(f"{r:.2f}" for r in recall))
    for k in range(3):
        print(f"    {TYPES[k]:10s}" + "".join(f"{v:5d}" for v in matrix[k]))


def weights_of(rows, truth):
    """each type the same, within it each folder that has a few of it, within that each drawing."""
    folders = np.array([r["folder"] for r in rows])
    weight = np.zeros(len(rows))
    for kind in range(3):
        of_kind = truth == kind
        sets = [of_kind & (folders == f) for f in sorted(set(folders))]
        large = [s for s in sets if s.sum() >= 20] or [of_kind]
        for members in large:
            weight[members] = len(rows) / 3 / len(large) / members.sum()
        weight[of_kind & (weight == 0)] = len(rows) / 3 / of_kind.sum()
    return weight


def label_numbers_of(rows):
    numbers = np.array([[int(r[p]) for p in PARTS] for r in rows], float)
    share = numbers / np.maximum(1, numbers.sum(1, keepdims=True))
    return share, np.concatenate([share, np.sqrt(share), share[:, 4:] > 0.01], 1)


def judge(rows, file, ridge):
    known = {r["id"]: r for r in rows if fold(r["id"]) == 0}
    tests = [r for r in csv.DictReader(open(file), delimiter="\t") if r["id"] in known]
    train = [r for r in rows if fold(r["id"]) != 0]
    train_truth = np.array([TYPES.index(r["type"]) for r in train])
    truth = np.array([TYPES.index(r["type"]) for r in tests])
    weight = weights_of(train, train_truth)
    share, numbers = label_numbers_of(tests)
    model = fit(label_numbers_of(train)[1], None, train_truth, weight, ridge)
    found = {"the program": [TYPES.index(r["found"]) if r["status"] == "ok" and r["found"] in TYPES else 3 for r in tests],
             "wing -> flying, else quadruped": np.where(share[:, 4] > 0.01, 2, 1),
             "regression on 11 label numbers": decide(model, numbers, None).argmin(1)}
    for folder in ["all"] + sorted({known[r["id"]]["folder"] for r in tests}):
        part = np.array([folder in ("all", known[r["id"]]["folder"]) for r in tests])
        print(f"\n== {folder}: {part.sum()} drawings (columns: humanoid quadruped flying rejected)")
        for title, answers in found.items():
            confusion(title, truth[part], np.array(answers)[part], None)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tables", nargs="+")
    parser.add_argument("--ridge", type=float, default=2)
    parser.add_argument("--keep-out", type=int, default=-1, help="of the printed constants: a fold that they do not see")
    parser.add_argument("--wrong", action="store_true", help="list the drawings decided wrongly")
    parser.add_argument("--judge", help="a table of fold 0 made from other labels")
    parser.add_argument("--groups", help="records with an id and a group")
    o = parser.parse_args()
    if o.groups:
        GROUPS.update((r["id"], r["group"]) for r in map(json.loads, open(o.groups)))
    rows = read(o.tables)
    if o.judge:
        return judge(rows, o.judge, o.ridge)
    rejected = [r for r in rows if r["status"] != "ok"]
    names = trait_names(rows)
    print(f"{len(rows)} drawings, {len(rejected)} of them rejected")
    for r in rejected:
        print("   ", r["id"], r["class"], r["status"])
    truth = np.array([TYPES.index(r["type"]) for r in rows])
    ok = np.array([r["status"] == "ok" for r in rows])
    folds = np.array([fold(r["id"]) for r in rows])
    traits = np.array([[float(r[k] or 0) if r["status"] == "ok" else 0 for k in names] for r in rows])
    graph = np.array([[float(r["ggd_" + t]) if r["status"] == "ok" else 0 for t in TYPES] for r in rows])
    share, label_numbers = label_numbers_of(rows)
    weight = weights_of(rows, truth)
    forms = {"literal (thesis)": [], "divided distance": [], "wing -> flying, else quadruped": [], "regression on 11 label numbers": [],
             "traits alone": [], "graph and traits": []}
    found = {k: np.full(len(rows), 3) for k in forms}
    for k in range(5):
        train, test = ok & (folds != k), folds == k
        for title, x, g in (("regression on 11 label numbers", label_numbers, None), ("traits alone", traits, None), ("graph and traits", traits, graph)):
            model = fit(x[train], None if g is None else g[train], truth[train], weight[train], o.ridge)
            found[title][test] = decide(model, x[test], None if g is None else g[test]).argmin(1)
    found["wing -> flying, else quadruped"] = np.where(share[:, 4] > 0.01, 2, 1)
    for title, key in (("literal (thesis)", "thesis"), ("divided distance", "ratio")):
        found[title] = np.array([TYPES.index(r[key]) if r["status"] == "ok" else 3 for r in rows])
    for title in ("traits alone", "graph and traits"):
        found[title][~ok] = 3
    for folder in ["all"] + sorted({r["folder"] for r in rows}):
        part = np.array([folder in ("all", r["folder"]) for r in rows])
        print(f"\n== {folder}: {part.sum()} drawings (columns: humanoid quadruped flying rejected)")
        for title in forms:
            confusion(title, truth[part], found[title][part], None)
    if o.wrong:
        for i, r in enumerate(rows):
            if found["graph and traits"][i] != truth[i]:
                print(r["folder"], r["id"], r["class"], r["type"], "->", (TYPES + ["rejected"])[found["graph and traits"][i]])
    kept = ok & (folds != o.keep_out)
    weight = weights_of([r for r, k in zip(rows, kept) if k], truth[kept])
    g, prior, w = fit(traits[kept], graph[kept], truth[kept], weight, o.ridge)
    # Only differences between types matter: centre them, so that a positive weight speaks against a type.
    prior, w = prior - prior.mean(), w - w.mean(0)
    print(f"\nconstexpr double graph_weight = {g:.3f};\nconstexpr std::array<Row, 3> table = {{{{")
    for k in range(3):
        print(f'    {{"{TYPES[k]}", {prior[k]:.3f}, {{' + ", ".join(f"{v:.3f}" for v in w[k]) + "}},")
    print("}};")
    for j in range(len(names)):
        print(f"// {names[j]:18s}" + "".join(f"{w[k][j] * traits[ok][:, j].std():8.2f}" for k in range(3)))


if __name__ == "__main__":
    main()
