#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The mean of the weights of two trainings from one start (Wortsman et al. 2022): average.py A.safetensors B.safetensors OUT.safetensors"""
import sys

import export
from model import metadata


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    first, second = (export.load(path) for path in sys.argv[1:3])
    other = second.state_dict()
    first.load_state_dict({name: (value + other[name]) / 2 if value.dtype.is_floating_point else value
                           for name, value in first.state_dict().items()})
    first.knows_turn = False                                    # it is trained on the stem that results
    export.write_safetensors(sys.argv[3], export.tensors_of(first, "F16"), metadata(first))


if __name__ == "__main__":
    main()
