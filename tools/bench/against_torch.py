#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The shipped segmentation network on our kernel, PyTorch and, where it is installed, onnxruntime (npm's onnxruntime-node), in turns.

usage: OPENBLAS_NUM_THREADS=1 against_torch.py BENCH SEGMENTER.safetensors [--threads 1] [--rounds 7] [--node MODULES]
BENCH: build/release/bench. One image, one expert, as the program runs it. Prints medians in ms and ratios to ours. MODULES: the
node_modules folder that holds onnxruntime-node.
"""
import argparse
import os
import re
import subprocess
import sys
import tempfile
import time

import numpy as np
import torch

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../train"))
import export  # noqa: E402

NODE = """
const ort = require('onnxruntime-node');
(async () => {
  const session = await ort.InferenceSession.create(process.argv[2],
      {intraOpNumThreads: +process.argv[3], interOpNumThreads: 1, executionMode: 'sequential'});
  const side = +process.argv[4], ink = new ort.Tensor('float32', new Float32Array(side * side).fill(0.5), [1, 1, side, side]);
  const times = [];
  for (let i = 0; i < 12; ++i) {
    const begin = process.hrtime.bigint();
    await session.run({ink});
    times.push(Number(process.hrtime.bigint() - begin) / 1e6);
  }
  console.log(times.sort((a, b) => a - b)[6]);
})();
"""


class OneExpert(torch.nn.Module):
    """router, pose and the first expert's probabilities."""

    def __init__(self, model):
        super().__init__()
        self.model = model
        self.expert = next(iter(model.experts.values()))

    def forward(self, ink):
        features = self.model.stem(ink)
        return (self.expert(features).softmax(1), self.model.router(features[3]).softmax(1), self.model.pose(features[3]).softmax(1))


def ours(binary, threads):
    text = subprocess.run([binary, "segmenter", "2"], capture_output=True, text=True, check=True).stdout
    return float(re.search(r"%s\s+([0-9.]+) ms" % ("one thread" if threads == 1 else "two threads"), text).group(1))


def torch_time(model, ink):
    times = []
    with torch.no_grad():
        for _ in range(12):
            begin = time.perf_counter()
            model(ink)
            times.append(1e3 * (time.perf_counter() - begin))
    return sorted(times)[6]


def node_time(modules, script, model, threads, side):
    text = subprocess.run(["node", script, model, str(threads), str(side)], capture_output=True, text=True, check=True,
                          env={**os.environ, "NODE_PATH": modules}).stdout
    return float(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bench")
    parser.add_argument("weights")
    parser.add_argument("--threads", type=int, choices=(1, 2), default=1)
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--node")
    args = parser.parse_args()
    torch.set_num_threads(args.threads)
    model = OneExpert(export.load(args.weights)).eval()
    side = model.model.size
    ink = torch.full((1, 1, side, side), 0.5)
    last = OneExpert(export.load(args.weights)).eval().to(memory_format=torch.channels_last)
    contenders = {"ours": lambda: ours(args.bench, args.threads), "PyTorch": lambda: torch_time(model, ink),
                  "PyTorch, channels last": lambda: torch_time(last, ink.to(memory_format=torch.channels_last))}
    with tempfile.TemporaryDirectory() as folder:
        if args.node:
            torch.onnx.export(model, ink, f"{folder}/model.onnx", input_names=["ink"], opset_version=13)
            with open(f"{folder}/time.js", "w") as script:
                script.write(NODE)
            contenders["onnxruntime"] = lambda: node_time(args.node, f"{folder}/time.js", f"{folder}/model.onnx", args.threads, side)
        times = {name: [] for name in contenders}
        for _ in range(args.rounds):
            for name, measure in contenders.items():
                times[name].append(measure())
    base = np.median(times["ours"])
    for name, values in times.items():
        print(f"{name:24} {np.median(values):8.1f} ms   x {np.median(values) / base:.2f}")


if __name__ == "__main__":
    main()
